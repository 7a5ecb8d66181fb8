#pragma once
// The quantities of an answer: one row each. Text, JSON, columns of sweeps, C++, Python and the Explorer read these rows.
// quantity_documents.py writes the schema, the fields of the Python module and the table of docs/results.md from them.
// docs/architecture.md says what a new row needs.
//
//   QUANTITY(type, key, unit, line, meaning, formula)
//
// type      a type named in ResultantsOf
// key       the name in every format; a text shows it with spaces
// unit      F is a force per unit of thickness, L a length, – no unit
// line      the position in the text, another one for each row; JSON and columns keep the order of this table
// meaning   one sentence, Markdown
// formula   computed from `solved`: a SolvedContact (library/answer/solved_contact.hpp) or an EnclosedContact
//           (library/answer/enclosed_contact.hpp)

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// clang-format off
#define STEADYSLIDE_QUANTITIES(QUANTITY)                                                                                  \
  QUANTITY(One, normal, "F", 1, "−∫t, as it comes out of the traction", solved.forces().normal)                           \
  QUANTITY(One, friction_force, "F", 2, "∫f∣t∣; it is also the work of friction per unit of sliding distance",            \
           solved.forces().tangential)                                                                                    \
  QUANTITY(One, centre_of_pressure, "L", 4, "∫x t / ∫t", solved.forces().centre_of_pressure)                              \
  QUANTITY(One, effective_friction, "–", 3, "friction force over load", solved.forces().effective_friction)               \
  QUANTITY(OfEachFriction, load_share, "–", 6,                                                                            \
           "part of the load under each friction value, left to right",                                                  \
           solved.forces().load_share)                                                                                    \
  QUANTITY(One, contact_width, "L", 9, "from the first end of contact to the last", solved.width())                       \
  QUANTITY(One, real_contact_length, "L", 10, "the sum of the components' widths", solved.length())                       \
  QUANTITY(One, mean_pressure, "F/L²", 8, "load over real contact length",                                                \
           solved.per_length(solved.forces().normal))                                                                     \
  QUANTITY(Largest, largest_pressure, "F/L², L, –", 7,                                                                    \
           "its `value`, its place `x`, and the `exponent` of an infinite one",                                            \
           solved.largest_pressure())                                                                                     \
  QUANTITY(Count, components, "–", 11, "how many", solved.components())                                                   \
  QUANTITY(IfAny, tilt, "–", 5, "where the indenter may tilt", solved.tilt())                                             \
  QUANTITY(IfAny, largest_average, "F/L²", 13,                                                                            \
           "with a window: the largest mean pressure over a window of its length inside the contact",                      \
           solved.average_pressure())                                                                                     \
  QUANTITY(IfAny, largest_average_at, "L", 14, "the centre of this window", solved.average_at())                          \
  QUANTITY(IfAny, approach, "L", 15,                                                                                     \
           "of layers on a rigid base: δ in u = ψ + tilt x − δ, where u tends to 0 far from the contact",                 \
           solved.approach())                                                                                             \
  QUANTITY(Interval, core, "L", 12, "of a flat punch, from its `left` end to its `right` end", solved.core())
// clang-format on

namespace steadyslide::answer {

template <class Number, class Power>
struct LargestPressureOf {
  Number value;
  Number x;
  Power exponent;  ///< absent if the value is finite
};

template <class Number>
struct IntervalOf {
  Number left;
  Number right;
};

/// The quantities in numbers of one type; `Power` is an exponent that may be absent.
template <class Number, class Power>
struct ResultantsOf {
  using One = Number;
  using OfEachFriction = std::vector<Number>;  ///< for each friction value, left to right
  using Largest = LargestPressureOf<Number, Power>;
  using Count = std::size_t;
  using IfAny = std::optional<Number>;
  using Interval = std::optional<IntervalOf<Number>>;

#define STEADYSLIDE_QUANTITY(type, key, unit, line, meaning, ...) type key{};
  STEADYSLIDE_QUANTITIES(STEADYSLIDE_QUANTITY)
#undef STEADYSLIDE_QUANTITY
};

/// A row of the table, without its formula.
struct Quantity {
  std::string_view type;
  std::string_view key;
  std::string_view unit;
  int line;
  std::string_view meaning;
};

/// Returns the key with spaces, as a text shows it.
inline std::string words(const Quantity& row) {
  std::string result(row.key);
  for (char& letter : result) letter = letter == '_' ? ' ' : letter;
  return result;
}

inline constexpr Quantity quantities[] = {
#define STEADYSLIDE_QUANTITY(type, key, unit, line, meaning, ...) {#type, #key, unit, line, meaning},
    STEADYSLIDE_QUANTITIES(STEADYSLIDE_QUANTITY)
#undef STEADYSLIDE_QUANTITY
};

/// True if every quantity has its own line: two quantities on one line would hide one of them.
constexpr bool have_lines_of_their_own() {
  for (const Quantity& row : quantities) {
    for (const Quantity* other = quantities; other != &row; ++other) {
      if (other->line == row.line) return false;
    }
  }
  return true;
}
static_assert(have_lines_of_their_own(), "two rows of STEADYSLIDE_QUANTITIES have the same line");

/// Calls visit(row, value) for each quantity, in the order of the table.
template <class Resultants, class Visit>
void for_each_quantity(Resultants& resultants, Visit visit) {
  const Quantity* row = quantities;
#define STEADYSLIDE_QUANTITY(type, key, ...) visit(*row++, resultants.key);
  STEADYSLIDE_QUANTITIES(STEADYSLIDE_QUANTITY)
#undef STEADYSLIDE_QUANTITY
}

/// Calls visit(row, value) with the value of each formula, in the order of the table.
template <class Solved, class Visit>
void for_each_value(const Solved& solved, Visit visit) {
  const Quantity* row = quantities;
#define STEADYSLIDE_QUANTITY(type, key, unit, line, meaning, ...) visit(*row++, __VA_ARGS__);
  STEADYSLIDE_QUANTITIES(STEADYSLIDE_QUANTITY)
#undef STEADYSLIDE_QUANTITY
}

// converted() changes the type of the numbers that a formula returns. `convert` takes a number or a largest pressure.
template <class Convert, class Value>
auto converted(Convert& convert, const Value& value) {
  return convert(value);
}
template <class Convert>
std::size_t converted(Convert&, std::size_t count) {
  return count;
}
template <class Convert, class Number>
auto converted(Convert& convert, const IntervalOf<Number>& interval) {
  return IntervalOf<decltype(converted(convert, interval.left))>{converted(convert, interval.left),
                                                                 converted(convert, interval.right)};
}
template <class Convert, class Value>
auto converted(Convert& convert, const std::optional<Value>& value) {
  return value ? std::optional(converted(convert, *value)) : std::nullopt;
}
template <class Convert, class Number>
auto converted(Convert& convert, const std::vector<Number>& values) {
  std::vector<decltype(converted(convert, values[0]))> result;
  for (const Number& value : values) result.push_back(converted(convert, value));
  return result;
}

/// Evaluates the formulas. `convert` makes a number of the result from a number, and a largest pressure from the solved
/// one.
template <class Resultants, class Solved, class Convert>
Resultants resultants_of(const Solved& solved, Convert&& convert) {
  Resultants result;
#define STEADYSLIDE_QUANTITY(type, key, unit, line, meaning, ...) result.key = converted(convert, __VA_ARGS__);
  STEADYSLIDE_QUANTITIES(STEADYSLIDE_QUANTITY)
#undef STEADYSLIDE_QUANTITY
  return result;
}

}  // namespace steadyslide::answer
