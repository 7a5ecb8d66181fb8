#include "symbolic/field/polynomial_sign.hpp"

#include <ginac/ginac.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "symbolic/field/expression.hpp"

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;
using GiNaC::numeric;
using GiNaC::symbol;

struct Axis {
  symbol x;
  ParameterRange range;
};

/// The polynomial in the new variables, which are positive: its numerator, and the variables that can be 0.
struct Carried {
  ex numerator;
  std::vector<symbol> variables;
  std::vector<bool> with_zero;
};

/// The caller must cut an axis that is unbounded on both sides.
Carried carried(const ex& polynomial, const std::vector<Axis>& axes) {
  Carried result{polynomial, {}, {}};
  for (const Axis& axis : axes) {
    const auto& [from, to, with_from, with_to] = axis.range;
    const symbol y;
    const int degree = result.numerator.degree(axis.x);
    if (from && to && *from == *to) {
      result.numerator = result.numerator.subs(axis.x == to_expression(*from)).expand();
      continue;
    }
    if (from && to) {
      // y = 0 at the left end. The right end is y = oo, where the leading coefficient alone would decide; so the caller
      // treats a closed right end separately.
      const ex inside = (to_expression(*from) + to_expression(*to) * y) / (1 + y);
      result.numerator = (result.numerator.subs(axis.x == inside) * GiNaC::pow(1 + y, degree)).normal().expand();
    } else {
      const ex inside = from ? to_expression(*from) + y : to_expression(*to) - y;
      result.numerator = result.numerator.subs(axis.x == inside).expand();
    }
    result.variables.push_back(y);
    result.with_zero.push_back(from ? with_from : with_to);
  }
  return result;
}

struct Signs {
  bool positive = false, negative = false;
};

Signs signs_of_coefficients(const ex& polynomial, const std::vector<symbol>& variables, std::size_t first = 0) {
  if (first == variables.size()) {
    if (!GiNaC::is_a<numeric>(polynomial)) throw std::domain_error("not a polynomial in the parameters");
    const numeric value = GiNaC::ex_to<numeric>(polynomial);
    return {value.is_positive(), value.is_negative()};
  }
  Signs all;
  for (int k = polynomial.ldegree(variables[first]); k <= polynomial.degree(variables[first]); ++k) {
    const Signs one = signs_of_coefficients(polynomial.coeff(variables[first], k), variables, first + 1);
    all.positive = all.positive || one.positive;
    all.negative = all.negative || one.negative;
  }
  return all;
}

/// True if the coefficients show that the polynomial is positive for all values of the new variables, including 0 where
/// it is allowed.
bool positive_by_coefficients(const Carried& carried) {
  const Signs signs = signs_of_coefficients(carried.numerator, carried.variables);
  if (signs.negative || !signs.positive) return false;
  // At least one monomial must remain if all variables that can be 0 are 0.
  ex face = carried.numerator;
  std::vector<symbol> left;
  for (std::size_t k = 0; k < carried.variables.size(); ++k) {
    if (carried.with_zero[k]) {
      face = face.subs(carried.variables[k] == 0).expand();
    } else {
      left.push_back(carried.variables[k]);
    }
  }
  return signs_of_coefficients(face, left).positive;
}

constexpr int most_boxes = 6000;

Rational middle(const ParameterRange& range) {
  if (range.from && range.to) return (*range.from + *range.to) / 2;
  if (range.from) return *range.from >= 0 ? Rational(2 * *range.from + 1) : Rational(0);
  if (range.to) return *range.to <= 0 ? Rational(2 * *range.to - 1) : Rational(0);
  return 0;
}

/// A product of intervals.
struct Box {
  std::vector<Axis> axes;
  int depth = 0;  ///< the number of halvings that led to it
};

/// Decides the sign in one box. Returns nothing if the box must be divided: then it appends the two parts to `boxes`.
std::optional<Truth> decide(const ex& polynomial, Box box, std::vector<Box>& boxes) {
  std::vector<Axis>& axes = box.axes;
  const auto halve = [&](std::size_t k) {
    const ParameterRange range = axes[k].range;
    const Rational cut = middle(range);
    ++box.depth;
    axes[k].range = {cut, range.to, false, range.with_to};
    boxes.push_back(box);
    axes[k].range = {range.from, cut, range.with_from, true};
    boxes.push_back(box);
  };
  // Treat as separate faces the closed right end of a bounded interval and one point of an axis that is unbounded on
  // both sides.
  for (Axis& axis : axes) {
    ParameterRange& range = axis.range;
    if (!range.from || !range.to || *range.from >= *range.to || !range.with_to) continue;
    range.with_to = false;
    boxes.push_back(box);
    range = {range.to, range.to, true, true};
    boxes.push_back(std::move(box));
    return std::nullopt;
  }
  for (std::size_t k = 0; k < axes.size(); ++k) {
    if (axes[k].range.from || axes[k].range.to) continue;
    halve(k);
    return std::nullopt;
  }
  const Carried here = carried(polynomial, axes);
  if (positive_by_coefficients(here)) return Truth::yes;
  // The polynomial is nowhere positive, or not positive in the corner that belongs to the box.
  if (!signs_of_coefficients(here.numerator, here.variables).positive) return Truth::no;
  if (std::ranges::all_of(here.with_zero, std::identity())) {
    ex corner = here.numerator;
    for (const symbol& y : here.variables) corner = corner.subs(y == 0).expand();
    if (!GiNaC::ex_to<numeric>(corner).is_positive()) return Truth::no;
  }
  // Halve the interval of a variable in a negative term; take these variables in turn.
  std::vector<std::size_t> open;
  for (std::size_t k = 0, y = 0; k < axes.size(); ++k) {
    const auto& [from, to, with_from, with_to] = axes[k].range;
    if (from && to && *from == *to) continue;
    const ex with_y = (here.numerator - here.numerator.subs(here.variables[y] == 0)).expand();
    if (signs_of_coefficients(with_y, here.variables).negative) open.push_back(k);
    ++y;
  }
  if (open.empty()) return Truth::unknown;
  halve(open[static_cast<std::size_t>(box.depth) % open.size()]);
  return std::nullopt;
}

/// Decides the last box first. Boxes can be halved thousands of times; recursion would need megabytes of stack.
Truth decide(const ex& polynomial, std::vector<Axis> axes) {
  std::vector<Box> boxes{{std::move(axes)}};
  for (int count = 0; !boxes.empty(); ++count) {
    if (count == most_boxes) return Truth::unknown;
    Box next = std::move(boxes.back());
    boxes.pop_back();
    const std::optional<Truth> truth = decide(polynomial, std::move(next), boxes);
    if (truth && *truth != Truth::yes) return *truth;
  }
  return Truth::yes;
}

}  // namespace

Truth is_positive(const std::string& polynomial, const std::map<std::string, ParameterRange>& ranges) {
  GiNaC::symtab table;
  std::vector<Axis> axes;
  for (const auto& [name, range] : ranges) {
    axes.push_back({symbol(name), range});
    table[name] = axes.back().x;
  }
  ex parsed;
  try {
    GiNaC::parser read(table, true);
    parsed = read(polynomial).expand();
  } catch (const std::exception& e) {
    throw std::domain_error("not a polynomial in parameters with ranges: " + polynomial);
  }
  GiNaC::lst names;
  for (const Axis& axis : axes) names.append(axis.x);
  if (!parsed.is_polynomial(names))
    throw std::domain_error("not a polynomial in parameters with ranges: " + polynomial);
  return decide(parsed, std::move(axes));
}

}  // namespace steadyslide::symbolic
