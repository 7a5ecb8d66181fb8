#pragma once
// For which parameters something holds: a product of intervals with rational ends or none, "s in [0, oo[, P in ]0, oo[",
// brackets that look away from the interval leaving its end out. A parameter that is not named is any real number.

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "model/rational.hpp"

namespace steadyslide::proofs_checks {

struct Interval {
  std::optional<Rational> from, to;  ///< none: unbounded
  bool with_from = false, with_to = false;

  bool contains(const Rational& x) const;
  bool operator==(const Interval&) const = default;
};

using Box = std::map<std::string, Interval>;

/// Throw std::logic_error where the text is none, or the interval is empty.
Interval parse_interval(std::string_view text);
Box parse_box(std::string_view text);
std::string text_of(const Interval& interval);
std::string text_of(const Box& box);

/// Does each place of `whole` lie in one of the boxes? Decided: the ends of all intervals cut each axis into points and
/// open intervals, and one place of each of their products speaks for all.
bool covers(std::span<const Box> boxes, const Box& whole);

}  // namespace steadyslide::proofs_checks
