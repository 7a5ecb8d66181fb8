#include "proofs_checks/instruments/punch.hpp"

#include <algorithm>

#include "numeric/closed_form/closed_form.hpp"
#include "symbolic/cln/cln_closed_form.hpp"

namespace steadyslide::proofs_checks {

ContactProblem punch(const Rational& nu, std::vector<Rational> friction, std::vector<Rational> jumps,
                     const Rational& load, Sliding sliding) {
  return ContactProblem(Elasticity(Solid(nu, 1)), FrictionProfile(std::move(friction), std::move(jumps)),
                        Indenter(-1, {{1, Polynomial()}}), load, sliding);
}

std::vector<Rational> random_jumps(Random& random, std::size_t m) {
  std::vector<Rational> jumps;
  while (jumps.size() < m) {
    Rational c = random.between(-1, 1);
    if (std::ranges::find(jumps, c) == jumps.end()) jumps.push_back(std::move(c));
  }
  std::ranges::sort(jumps);
  return jumps;
}

ContactProblem random_punch(const Context& context, Random& random, std::size_t jumps) {
  std::vector<Rational> friction;
  for (std::size_t piece = 0; piece <= jumps; ++piece) friction.push_back(random.friction(largest_friction(context)));
  const Rational nu = random.poisson();
  const Rational load = random.between(0, 100);
  return punch(nu, std::move(friction), random_jumps(random, jumps), load);
}

Cases punch_cases(const Context& context, std::string_view stream, std::vector<ContactProblem> grid,
                  std::size_t random_count, const std::function<std::size_t(Random&)>& jumps) {
  Cases cases;
  const std::size_t stride = !context.quick ? 1 : context.digits == numeric::Digits::sixteen ? 4 : 16;
  for (std::size_t k = 0; k < grid.size(); k += stride) cases.problems.push_back(std::move(grid[k]));
  const std::size_t fixed = cases.problems.size();
  if (context.quick) random_count = std::min<std::size_t>(random_count, 1);
  Random random(context.seed, stream);
  for (std::size_t k = 0; k < random_count; ++k) {
    cases.problems.push_back(random_punch(context, random, jumps(random)));
  }
  cases.detail = std::to_string(fixed) + " of a grid, " + std::to_string(random_count) + " random with seed " +
                 std::to_string(context.seed);
  return cases;
}

bool has_jump(const ContactProblem& problem) {
  for (std::size_t k = 1; k < problem.friction().values().size(); ++k) {
    if (problem.coupled_friction(k - 1) != problem.coupled_friction(k)) return true;
  }
  return false;
}

bool has_friction(const ContactProblem& problem) {
  for (std::size_t k = 0; k < problem.friction().values().size(); ++k) {
    if (problem.coupled_friction(k) != 0) return true;
  }
  return false;
}

Exponent alpha(const ContactProblem& problem, std::size_t piece) {
  return Exponent::angle(problem.coupled_friction(piece));
}

template <Real R>
void check_punch_values(Findings& findings, const PowerForm<R>& form, const ContactProblem& problem) {
  const Quantity by_cln{"values of the traction, in CLN", {"the formula", "closed form in CLN"}, tolerance<R>()};
  const Quantity by_numeric{
      "values of the traction, as solved", {"the formula", "the closed form that `solve` uses"}, tolerance<R>()};
  const auto cln = symbolic::ClnClosedForm::flat_punch(problem, numeric::digits_served<R> + 5);
  const auto data = numeric::closed_form_data<R>(problem);
  const auto* closed_form = std::get_if<numeric::ClosedFormData<R>>(&data);
  findings.require(closed_form != nullptr, "the numeric layer knows no closed form");
  findings.require(closed_form->exponents == form.exponents, "the numeric layer has other exponents");

  std::vector<Rational> points{problem.indenter().left()};
  for (const Rational& c : problem.friction().jumps()) points.push_back(c);
  points.push_back(problem.indenter().right());
  const numeric::PowerTraction<R> traction = form.traction();
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    for (const Rational& fraction : {Rational(1, 1'000'000), Rational(3, 7), Rational(999'999, 1'000'000)}) {
      const Rational x = points[k] + fraction * (points[k + 1] - points[k]);
      const numeric::Node<R> node{numeric::to_real<R>(x), numeric::to_real<R>(x - points[k]),
                                  numeric::to_real<R>(points[k + 1] - x)};
      const R t = traction(k, node);
      findings.compare(by_cln, relative_difference<R>(t, numeric::to_real<R>(cln.traction(x).value)));
      findings.compare(by_numeric, relative_difference<R>(t, closed_form->traction(k, node)));
    }
  }
}

Rational largest_friction(const Context& context) { return context.digits == numeric::Digits::sixteen ? 5 : 50; }

std::size_t count_for(const Context& context, std::size_t sixteen, std::size_t fifty, std::size_t hundred) {
  if (context.quick && context.digits != numeric::Digits::sixteen) return 1;
  switch (context.digits) {
    case numeric::Digits::sixteen: return sixteen;
    case numeric::Digits::fifty: return fifty;
    default: return hundred;
  }
}

template void check_punch_values(Findings&, const PowerForm<double>&, const ContactProblem&);
template void check_punch_values(Findings&, const PowerForm<Real50>&, const ContactProblem&);
template void check_punch_values(Findings&, const PowerForm<Real100>&, const ContactProblem&);

}  // namespace steadyslide::proofs_checks
