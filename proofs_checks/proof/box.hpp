#pragma once
// Ranges of parameters: a product of intervals, "s in [0, oo[, P in ]0, oo[". Ends are rational or infinite. A bracket
// that opens away from the interval excludes its end. A parameter that is not listed is any real number.

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "model/rational.hpp"

namespace steadyslide::proofs_checks {

struct Interval {
  std::optional<Rational> from, to;  ///< if empty, unbounded
  bool with_from = false, with_to = false;

  bool contains(const Rational& x) const;
  bool operator==(const Interval&) const = default;
};

using Box = std::map<std::string, Interval>;

/// Returns the interval or the box. Throws std::logic_error if the text is not one, or if an interval is empty.
Interval parse_interval(std::string_view text);
Box parse_box(std::string_view text);
std::string text_of(const Interval& interval);
std::string text_of(const Box& box);

/// True if each point of `whole` lies in one of the boxes. This is decided exactly: the ends of all intervals divide
/// each axis into points and open intervals, and one point of each product of these represents all its points.
bool covers(std::span<const Box> boxes, const Box& whole);

}  // namespace steadyslide::proofs_checks
