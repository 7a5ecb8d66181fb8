#pragma once
// What a check gathers while it walks through its cases. The first counterexample ends the walk.

#include <string>
#include <type_traits>
#include <vector>

#include "proofs_checks/kit/claim.hpp"
#include "proofs_checks/kit/numbers.hpp"

namespace steadyslide::proofs_checks {

/// Thrown inside a check by Findings, caught by gather().
struct Refutation {
  Counterexample counterexample;
};

/// |a - b| / max(|a|, |b|).
template <Real R>
double relative_difference(const R& a, const R& b) {
  using std::abs, std::max;
  if (a == b) return 0;
  return static_cast<double>(R(abs(a - b) / max(R(abs(a)), R(abs(b)))));
}

class Findings {
 public:
  Findings() = default;
  /// These are compared by name.
  explicit Findings(std::vector<Quantity> quantities) : quantities_(std::move(quantities)) {}

  const std::vector<Quantity>& quantities() const { return quantities_; }
  /// Throws std::logic_error if there is none of this name.
  const Quantity& quantity(std::string_view name) const;

  /// The next case; not effective: the statement says nothing special there (a jump of height zero).
  void begin_case(std::string where, bool effective = true);

  /// A relative difference. Throws Refutation unless it is a number within the tolerance.
  void compare(const Quantity& quantity, double difference);
  template <Real R>
  void compare(const Quantity& quantity, const R& difference) {
    compare(quantity, static_cast<double>(difference));
  }
  template <Real R>
  void compare(std::string_view name, const R& difference) {
    compare(quantity(name), static_cast<double>(difference));
  }
  /// Two values, as the quantity says.
  template <Real R>
  void compare(std::string_view name, const R& value, const R& other) {
    using std::abs;
    const Quantity& q = quantity(name);
    compare(q, q.at_most && value <= other ? 0
               : q.absolute                ? static_cast<double>(R(abs(value - other)))
                                           : relative_difference(value, other));
  }
  /// Two values by their difference over `size`, where either may vanish.
  template <Real R>
  void compare(std::string_view name, const R& value, const R& other, const std::type_identity_t<R>& size) {
    using std::abs;
    compare(quantity(name), static_cast<double>(R(abs(value - other) / size)));
  }
  /// No value from a route in this case: it counts as a case without effect.
  void skip(const Quantity& quantity);
  void skip(std::string_view name) { skip(quantity(name)); }
  /// An exact decision. Throws Refutation unless it holds.
  void decide(const std::string& statement, bool holds);
  /// How fast an error falls. Throws Refutation if the rate refutes.
  void measure(ConvergenceRate rate);
  /// A requirement that is not evidence by itself. Throws Refutation unless it holds.
  void require(bool holds, const std::string& what_fails);

  /// One piece of evidence for each quantity and each rate, and one for all exact decisions; `cases` says where the
  /// cases come from.
  std::vector<Evidence> evidence(const std::string& cases) const;

 private:
  std::vector<Quantity> quantities_;
  struct Tally {
    double worst = 0;
    std::size_t cases = 0;
    std::size_t effective = 0;
    std::size_t last_case = 0;
    Quantity quantity;
  };
  /// Counts the case, once.
  Tally& tally(const Quantity& quantity, bool effective);

  std::size_t case_number_ = 0;
  bool effective_ = true;
  std::string where_;
  std::vector<Tally> tallies_;  // few: in the order in which they came
  std::vector<std::pair<std::string, std::size_t>> decisions_;
  std::vector<ConvergenceRate> rates_;
};

/// Runs a walk; its evidence, or the counterexample that ended it.
template <class Walk>
std::vector<Evidence> gather(Walk walk) {
  try {
    return walk();
  } catch (const Refutation& refutation) {
    return {refutation.counterexample};
  }
}

/// "3.1e-52"
std::string short_text(double value);

/// Relative tolerance of every numerical claim.
template <Real R>
double tolerance() {
  return std::same_as<R, double> ? 1e-12 : std::same_as<R, Real50> ? 1e-45 : 1e-95;
}

/// Ten times the tolerance: a near miss.
template <Real R>
R near_miss() {
  return R(10) * R(tolerance<R>());
}

}  // namespace steadyslide::proofs_checks
