#include "numeric/closed_form/parabola.hpp"

#include <algorithm>
#include <optional>

#include "model/singular_point.hpp"

namespace steadyslide::numeric {
namespace {

/// The contact on the pieces first..last, which contains the jumps between them.
template <Real R>
class Candidate {
 public:
  Candidate(const std::vector<Rational>& s, const std::vector<Rational>& jumps, std::size_t first, std::size_t last)
      : s_(s), jumps_(jumps), first_(first), last_(last) {
    for (std::size_t k = first; k < last; ++k) add_jump(k);
  }

  void grow(Side side) {
    if (side == Side::left) {
      add_jump(--first_);
    } else {
      add_jump(last_++);
    }
  }

  /// Returns the K at which the end reaches the next jump on that side; absent if there is no such jump.
  std::optional<R> threshold(Side side) const {
    if (side == Side::left ? first_ == 0 : last_ + 1 == s_.size()) return std::nullopt;
    const R reached = to_real<R>(side == Side::left ? jumps_[first_ - 1] : jumps_[last_]);
    const R other = side == Side::left ? -(moment1_ + left_power() * reached) / right_power()
                                       : -(moment1_ + right_power() * reached) / left_power();
    const R a = side == Side::left ? reached : other;
    const R b = side == Side::left ? other : reached;
    return left_power() * a * a + right_power() * b * b + moment2_;
  }

  ParabolaZone<R> zone(const R& K) const {
    const R p0 = left_power();
    const R pe = right_power();
    const R q = p0 + pe;
    const R d = q * (K - moment2_) - moment1_ * moment1_;
    const R root = sqrt(p0 * pe * d);
    const R relative = 4 + (q * (K + abs(moment2_)) + moment1_ * moment1_) / d;
    const R rounding = epsilon<R>() * (abs(moment1_) / q + root * relative / (q * std::min(p0, pe)));
    return {-(moment1_ + root / p0) / q, -(moment1_ - root / pe) / q, 4 * rounding, first_, last_};
  }

 private:
  R left_power() const { return to_real<R>(free_exponent(End::left, s_[first_])); }
  R right_power() const { return to_real<R>(free_exponent(End::right, s_[last_])); }

  void add_jump(std::size_t k) {
    const R beta = to_real<R>(jump_exponent(s_[k], s_[k + 1]));
    const R c = to_real<R>(jumps_[k]);
    moment1_ += beta * c;
    moment2_ += beta * c * c;
  }

  const std::vector<Rational>& s_;
  const std::vector<Rational>& jumps_;
  std::size_t first_;
  std::size_t last_;
  R moment1_ = 0;
  R moment2_ = 0;
};

}  // namespace

template <Real R>
ParabolaZone<R> parabola_zone(const std::vector<Rational>& s, const std::vector<Rational>& jumps, const R& K) {
  // For the smallest load the contact is only the vertex. A jump exactly at the vertex lies inside the contact.
  const auto first =
      static_cast<std::size_t>(std::lower_bound(jumps.begin(), jumps.end(), Rational(0)) - jumps.begin());
  const auto last = static_cast<std::size_t>(std::upper_bound(jumps.begin(), jumps.end(), Rational(0)) - jumps.begin());
  Candidate<R> candidate(s, jumps, first, last);
  for (;;) {
    const std::optional<R> left = candidate.threshold(Side::left);
    const std::optional<R> right = candidate.threshold(Side::right);
    const bool left_is_next = left && (!right || *left <= *right);
    const std::optional<R>& next = left_is_next ? left : right;
    if (!next || K <= *next) return candidate.zone(K);
    candidate.grow(left_is_next ? Side::left : Side::right);
  }
}

#define STEADYSLIDE_INSTANTIATE(R) \
  template ParabolaZone<R> parabola_zone(const std::vector<Rational>&, const std::vector<Rational>&, const R&);
STEADYSLIDE_FOR_EACH_REAL(STEADYSLIDE_INSTANTIATE)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::numeric
