#include "symbolic/local/local_derivations.hpp"

#include <algorithm>

#include "model/singular_point.hpp"
#include "symbolic/field/expression.hpp"
#include "symbolic/local/local_form.hpp"

namespace steadyslide::symbolic {
namespace {

/// Returns the first three Taylor coefficients of psi_bar' at x.
std::vector<GiNaC::ex> slopes_at(const ContactProblem& problem, const Rational& x, Side side) {
  Polynomial derivative = problem.indenter().profile(x, side).derivative();
  std::vector<GiNaC::ex> slopes;
  Rational factorial = problem.elasticity().compliance();
  for (int n = 0; n < 3; ++n) {
    if (n > 1) factorial *= n;
    slopes.emplace_back(to_expression(Rational(derivative(x) / factorial)));
    derivative = derivative.derivative();
  }
  return slopes;
}

/// Returns +-gamma f, with the sign of the direction of sliding.
GiNaC::ex coupled(const ContactProblem& problem, const Rational& friction) {
  const Rational s = problem.elasticity().gamma() * friction;
  return to_expression(problem.sliding() == Sliding::plus_x ? s : Rational(-s));
}

LocalPlace place_of(const ContactProblem& problem, const SingularPoint& point) {
  const GiNaC::ex left = coupled(problem, point.friction.front());
  const GiNaC::ex right = coupled(problem, point.friction.back());
  LocalPlace place{point.contact, {left}, {right}};
  // The slope is continuous at a free end that can lie anywhere.
  if (point.x) {
    place.left.slopes = slopes_at(problem, *point.x, Side::left);
    place.right.slopes = slopes_at(problem, *point.x, Side::right);
  }
  if (point.kind == SingularKind::edge) place.beyond = Beyond::nothing;
  if (point.kind == SingularKind::step) place.beyond = Beyond::step;
  return place;
}

std::string where(const SingularPoint& point) {
  if (point.x) return ", `x = " + to_string(*point.x) + "`";
  return ", anywhere under `f = " + to_string(point.friction.front()) + "`";
}

}  // namespace

std::vector<Derivation> local_derivations(const ContactProblem& problem) {
  std::vector<Derivation> all;
  for (const SingularPoint& point : possible_singular_points(problem)) {
    all.push_back(derive_local_form(place_of(problem, point)).derivation);
    all.back().title += where(point);
  }
  return all;
}

}  // namespace steadyslide::symbolic
