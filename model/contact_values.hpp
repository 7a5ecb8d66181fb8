#pragma once
// The values of a solution at the ends of contact and at singular points. `Number` is an estimate or a ball.

#include <optional>

#include "model/exponent.hpp"
#include "model/singular_point.hpp"

namespace steadyslide {

template <class Number>
struct ContactEndOf {
  Number x;
  SingularKind kind;
  Exponent exponent;
  Number intensity;
};

template <class Number>
struct ContactComponentOf {
  ContactEndOf<Number> left;
  ContactEndOf<Number> right;
  Number width;  ///< from end to end; more accurate than the difference of their x
};

/// K in p ~ K (2 pi d)^lambda on each side of a point; with a wedge, p ~ constant + K (2 pi d)^lambda. Its unit is
/// force per length^(2 + lambda). At lambda = -1/2 it is the intensity factor of fracture mechanics. It is absent if
/// there is no contact on that side, and for a logarithm.
template <class Number>
struct StressIntensityOf {
  std::optional<Number> left;
  std::optional<Number> right;
};

/// A singular point inside the contact or at its ends.
template <class Number>
struct SingularPointOf {
  Number x;
  SingularKind kind;
  std::optional<Exponent> exponent;  ///< absent: logarithm
  Number intensity;
  Number constant;  ///< 0 at an end
  StressIntensityOf<Number> stress_intensity;
};

/// The limits from both sides. They are equal where the function is continuous and infinite where it blows up.
template <class Number>
struct TwoSidedOf {
  Number left;
  Number right;
};

}  // namespace steadyslide
