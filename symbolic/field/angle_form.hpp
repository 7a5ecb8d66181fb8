#pragma once
// halves/2 + sum of times_k alpha_k: an exponent for frictions that are symbols, alpha_k = arctan(s_k)/pi in ]-1/2,
// 1/2[. Exact; does not use GiNaC.

#include <map>
#include <utility>
#include <vector>

#include "model/exponent.hpp"

namespace steadyslide::symbolic {

class AngleForm {
 public:
  AngleForm() = default;
  explicit AngleForm(int halves) : halves_(halves) {}
  AngleForm(int halves, std::map<std::size_t, int> times);

  int halves() const { return halves_; }
  /// Maps the index of a friction to its factor, which is not 0.
  const std::map<std::size_t, int>& times() const { return times_; }
  bool is_integer() const { return times_.empty() && halves_ % 2 == 0; }

  /// Returns twice the infimum and twice the supremum over all angles.
  std::pair<int, int> twice_bounds() const;
  /// Returns the same form with renumbered frictions: index k becomes index[k].
  AngleForm renamed(const std::vector<std::size_t>& index) const;
  /// Returns its value for given frictions s_k.
  Exponent exponent(const std::vector<Rational>& frictions) const;

  AngleForm& operator+=(const AngleForm& other);
  AngleForm operator-() const;
  friend AngleForm operator+(AngleForm a, const AngleForm& b) { return a += b; }
  friend AngleForm operator-(AngleForm a, const AngleForm& b) { return a += -b; }
  friend bool operator==(const AngleForm&, const AngleForm&) = default;

 private:
  int halves_ = 0;
  std::map<std::size_t, int> times_;
};

}  // namespace steadyslide::symbolic
