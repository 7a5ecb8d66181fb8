#pragma once
// The friction under a flat punch in full contact: strips from left to right, each with one s = +-gamma f. What depends on
// them does not change with the unit of length. Where a coordinate is needed it is y, -1 at the left end and 1 at the right:
//
//   alpha = arctan(s)/pi,   M_j = int_-1^1 y^j alpha(y) dy.
//
// Centre of pressure: y = -M_0. (u'/c = -(P/pi) Y beside the punch, and Y = exp(-int alpha dy/(x-y))/sqrt(x^2-1) =
// 1/x - M_0/x^2 + ..., while the Cauchy integral of t gives load and moment in these two places.)

#include <vector>

#include "model/contact_problem.hpp"
#include "numeric/number/real.hpp"

namespace steadyslide::numeric {

template <Real R>
struct FrictionStrip {
  R length;
  R from_left;   ///< from the punch's left end to the strip's
  R from_right;  ///< from the strip's right end to the punch's
  R alpha;
  R below_half;  ///< 1/2 - alpha, to full relative precision however large the friction is
  R above_half;  ///< 1/2 + alpha
};

template <Real R>
class FrictionLayout {
 public:
  /// One length > 0, as exactly as it is known, for each s. Throws std::invalid_argument.
  FrictionLayout(const std::vector<R>& lengths, const std::vector<Rational>& s);
  /// What lies under the whole support.
  static FrictionLayout of(const ContactProblem& problem);
  /// So many times the same strips: shares of a period, whose sum is 1.
  static FrictionLayout periodic(const std::vector<Rational>& shares, const std::vector<Rational>& s, int periods);

  const std::vector<FrictionStrip<R>>& strips() const { return strips_; }
  const R& length() const { return length_; }
  /// M_0 or M_1.
  R moment(int j) const;
  /// y of a strip's middle.
  R middle(const FrictionStrip<R>& strip) const { return (strip.from_left - strip.from_right) / length_; }

 private:
  std::vector<FrictionStrip<R>> strips_;
  R length_ = 0;
};

}  // namespace steadyslide::numeric
