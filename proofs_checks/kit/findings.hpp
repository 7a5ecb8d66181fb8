#pragma once
// The results that a check collects from its cases. The first counterexample ends the check.

#include <string>
#include <type_traits>
#include <vector>

#include "proofs_checks/kit/claim.hpp"
#include "proofs_checks/kit/numbers.hpp"

namespace steadyslide::proofs_checks {

/// The exception by which Findings ends a check at a counterexample. gather() catches it.
struct Refutation {
  Counterexample counterexample;
};

/// Returns |a - b| / max(|a|, |b|).
template <Real R>
double relative_difference(const R& a, const R& b) {
  using std::abs, std::max;
  if (a == b) return 0;
  return static_cast<double>(R(abs(a - b) / max(R(abs(a)), R(abs(b)))));
}

class Findings {
 public:
  Findings() = default;
  /// Takes the quantities that are compared by name.
  explicit Findings(std::vector<Quantity> quantities) : quantities_(std::move(quantities)) {}

  const std::vector<Quantity>& quantities() const { return quantities_; }
  /// Returns the quantity of this name. Throws std::logic_error if there is none.
  const Quantity& quantity(std::string_view name) const;

  /// Begins the next case. It is not effective if the statement says nothing special there (a friction jump of height
  /// zero).
  void begin_case(std::string where, bool effective = true);

  /// Records a difference. Throws Refutation unless it is a number within the tolerance.
  void compare(const Quantity& quantity, double difference);
  template <Real R>
  void compare(const Quantity& quantity, const R& difference) {
    compare(quantity, static_cast<double>(difference));
  }
  template <Real R>
  void compare(std::string_view name, const R& difference) {
    compare(quantity(name), static_cast<double>(difference));
  }
  /// Compares two values in the way that the quantity prescribes.
  template <Real R>
  void compare(std::string_view name, const R& value, const R& other) {
    using std::abs;
    const Quantity& q = quantity(name);
    compare(q, q.at_most && value <= other ? 0
               : q.absolute                ? static_cast<double>(R(abs(value - other)))
                                           : relative_difference(value, other));
  }
  /// Compares two values by their difference over `size`; use it if a value may vanish.
  template <Real R>
  void compare(std::string_view name, const R& value, const R& other, const std::type_identity_t<R>& size) {
    using std::abs;
    compare(quantity(name), static_cast<double>(R(abs(value - other) / size)));
  }
  /// Records that a route has no value in this case. The case counts as one without effect.
  void skip(const Quantity& quantity);
  void skip(std::string_view name) { skip(quantity(name)); }
  /// Records an exact decision. Throws Refutation unless it holds.
  void decide(const std::string& statement, bool holds);
  /// Records a rate of convergence. Throws Refutation if the rate refutes.
  void measure(ConvergenceRate rate);
  /// Checks a requirement that is not evidence by itself. Throws Refutation unless it holds.
  void require(bool holds, const std::string& what_fails);

  /// Returns one piece of evidence for each quantity and each rate, and one for all exact decisions. `cases` describes
  /// the origin of the cases.
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
  /// Returns the quantity's tally after it has counted the current case, once.
  Tally& tally(const Quantity& quantity, bool effective);

  std::size_t case_number_ = 0;
  bool effective_ = true;
  std::string where_;
  std::vector<Tally> tallies_;  // few; in the order of their first comparison
  std::vector<std::pair<std::string, std::size_t>> decisions_;
  std::vector<ConvergenceRate> rates_;
};

/// Returns the evidence of a walk through cases, or the counterexample that ended it.
template <class Walk>
std::vector<Evidence> gather(Walk walk) {
  try {
    return walk();
  } catch (const Refutation& refutation) {
    return {refutation.counterexample};
  }
}

/// Returns two significant digits, "3.1e-52".
std::string short_text(double value);

/// Returns the relative tolerance of a quantity whose text gives none.
template <Real R>
double tolerance() {
  return std::same_as<R, double> ? 1e-12 : std::same_as<R, Real50> ? 1e-45 : 1e-95;
}

/// Returns the size of a near miss, ten times the tolerance.
template <Real R>
R near_miss() {
  return R(10) * R(tolerance<R>());
}

}  // namespace steadyslide::proofs_checks
