#include "numeric/riemann_hilbert/riemann_hilbert_form.hpp"
#include "numeric/riemann_hilbert/gap_integral.hpp"
#include "support/numeric_test.hpp"

namespace {

/// Contact from a step, where the traction blows up like d^-0.82, to a free end.
ContactProblem step() {
  const Polynomial profile({0, 1, 0.5_r});
  return {Elasticity(Solid(Rational(-5, 14), 1)), FrictionProfile({Rational(18, 7)}),
          Indenter(-4, {{Rational(-45, 14), profile}, {4, profile + Polynomial({-1})}}), 1};
}

/// The gap left of the step.
template <Real R>
std::vector<double> openings() {
  const ContactProblem problem = step();
  const ReducedProblem<R> reduced(problem, {0.125_r, 2});
  JacobiRules<R> rules;
  const RiemannHilbertForm<R> form(reduced, ContactSet<R>(reduced, {{-1.67, 0.7, true, false}}), {}, R(0), rules);
  std::vector<double> result;
  for (int i = 1; i < 1000; ++i) {
    const auto at = beside(form.set(), 0, Side::right, R(form.set().length(0) * i / 1000));
    result.push_back(static_cast<double>(GapIntegral(form, 1).reduced_gap(at).value));
  }
  return result;
}

}  // namespace

TEST_CASE("the gap beside an edge does not depend on how its place rounds") {
  const std::vector<double> rough = openings<double>();
  const std::vector<double> fine = openings<Real50>();
  for (std::size_t i = 0; i < fine.size(); ++i) CHECK_MESSAGE(rough[i] == doctest::Approx(fine[i]).epsilon(1e-12), i);
}
