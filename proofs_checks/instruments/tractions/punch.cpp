#include "proofs_checks/instruments/tractions/punch.hpp"

#include <algorithm>
#include <numeric>

#include "numeric/closed_form/closed_form.hpp"
#include "symbolic/riemann_hilbert/derived_contact.hpp"

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

bool has_jump(const ContactProblem& problem) {
  for (std::size_t k = 1; k < problem.friction().values().size(); ++k) {
    if (s_of(problem, k - 1) != s_of(problem, k)) return true;
  }
  return false;
}

bool has_friction(const ContactProblem& problem) {
  for (std::size_t k = 0; k < problem.friction().values().size(); ++k) {
    if (s_of(problem, k) != 0) return true;
  }
  return false;
}

Rational s_of(const ContactProblem& problem, std::size_t piece) {
  const Rational& f = problem.friction().values().at(piece);
  const Rational shear = problem.sliding() == Sliding::plus_x ? Rational(-f) : f;
  return -problem.elasticity().gamma() * shear;
}

Exponent alpha(const ContactProblem& problem, std::size_t piece) { return Exponent::angle(s_of(problem, piece)); }

std::vector<Exponent> punch_powers(const std::vector<Exponent>& alpha) {
  std::vector<Exponent> powers{-(half + alpha.front())};
  for (std::size_t k = 1; k < alpha.size(); ++k) powers.push_back(alpha[k - 1] - alpha[k]);
  powers.push_back(-(half - alpha.back()));
  return powers;
}

std::vector<Exponent> angles(const ContactProblem& problem) {
  std::vector<Exponent> all;
  for (std::size_t k = 0; k < problem.friction().values().size(); ++k) all.push_back(alpha(problem, k));
  return all;
}

PowerProduct punch_traction(const ContactProblem& problem) {
  std::vector<Rational> points = problem.friction().jumps();
  points.insert(points.begin(), problem.indenter().left());
  points.push_back(problem.indenter().right());
  std::vector<Number> amplitudes;
  for (std::size_t k = 0; k + 1 < points.size(); ++k) amplitudes.push_back(punch_amplitude<Number>(problem, k));
  return PowerProduct::on(points, punch_powers(angles(problem)), std::move(amplitudes));
}

template <Real R>
void check_punch_values(Findings& findings, const PowerForm<R>& form, const ContactProblem& problem) {
  const Quantity by_cln{
      "values of the traction, in CLN", {"the formula", "the derived contact in CLN"}, tolerance<R>()};
  const Quantity by_numeric{
      "values of the traction, as solved", {"the formula", "the closed form that `solve` uses"}, tolerance<R>()};
  const auto derived = symbolic::DerivedContact::all(problem, numeric::digits_served<R> + 5);
  findings.require(derived.size() == 1, "not one derived contact");
  const auto data = numeric::closed_form_data<R>(problem);
  const auto* closed_form = std::get_if<numeric::ClosedFormData<R>>(&data);
  findings.require(closed_form != nullptr, "the numeric layer knows no closed form");
  findings.require(closed_form->exponents == form.exponents, "the numeric layer has other exponents");

  const numeric::PowerTraction<R> traction = form.traction();
  const std::vector<ContactProblem::Piece> pieces = problem.pieces();
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const auto& [left, right, friction, profile] = pieces[k];
    for (const Rational& fraction : {Rational(1, 1'000'000), Rational(3, 7), Rational(999'999, 1'000'000)}) {
      const Rational x = left + fraction * (right - left);
      const Node<R> node{to_real<R>(x), to_real<R>(x - left), to_real<R>(right - x)};
      const R t = traction(k, node);
      findings.compare(by_cln, relative_difference<R>(t, to_real<R>(derived[0].traction(x).value)));
      findings.compare(by_numeric, relative_difference<R>(t, closed_form->traction(k, node)));
    }
  }
}

template <Real R>
void check_punch_traction(Findings& findings, const PowerProduct& t, const ContactProblem& problem,
                          std::size_t tanh_sinh_points) {
  check_surface(findings, surface_of<R>(t.at<R>(), problem, 0), tanh_sinh_points);
  check_surface_by_gsl(findings, surface_of<double>(t.at<double>(), problem, 0));
  check_punch_values(findings, t.at<R>(), problem);
  const Exponent sum = std::accumulate(t.exponents.begin(), t.exponents.end(), Exponent());
  findings.decide("the exponents sum to -1", sum == Exponent(-1));
}

Rational largest_friction(const Context& context) { return context.digits == numeric::Digits::sixteen ? 5 : 50; }

#define STEADYSLIDE_INSTANTIATE(R)                                                         \
  template void check_punch_values(Findings&, const PowerForm<R>&, const ContactProblem&); \
  template void check_punch_traction<R>(Findings&, const PowerProduct&, const ContactProblem&, std::size_t);
STEADYSLIDE_FOR_EACH_REAL(STEADYSLIDE_INSTANTIATE)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::proofs_checks
