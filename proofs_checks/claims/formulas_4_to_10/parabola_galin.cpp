#include "proofs_checks/instruments/tractions/parabola_cases.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::parabola_galin {
namespace {

/// The printed formulas: the contact from `half_width`, the traction with the factor 1/R, and this factor from the
/// load.
struct Galin : ParabolaTraction {
  Number half_width;
  Number peak;
  Number factor;
};

CaseList<ContactProblem> parabolas(const Context& context) {
  std::vector<ContactProblem> grid;
  for (const Rational& nu : {Rational(3, 10), Rational(-9, 10), Rational(499, 1000)}) {
    for (const Rational& f : {Rational(2), Rational(1, 5), Rational(50), Rational(0)}) {
      grid.push_back(parabola(nu, {f}, {}, Rational(4, 5), Rational(3, 2)));
    }
  }
  return grid_and_random(context, "parabola", grid, {20, 6, 3}, [&](Random& random) {
    const Rational load = random.between(0, 5);
    const Rational radius = random.between(0, 10);
    const Rational f = random.friction(largest_friction(context));
    return parabola(random.poisson(), {f}, {}, radius, load);
  });
}

/// Sets the contact and the peak for a half-width.
void put_half_width(Galin& t, const Number& a, const ContactProblem& p) {
  t.half_width = a;
  t.left_end = -2 * to_real<Number>(half + alpha(p, 0)) * a;
  t.lengths = {2 * a};
  t.peak = -4 * to_real<Number>(alpha(p, 0)) * a;
}

Galin galin(const ContactProblem& p) {
  // 1/4 - alpha^2 is computed as a product, because alpha may be close to 1/2.
  const Number quarter = to_real<Number>(half - alpha(p, 0)) * to_real<Number>(half + alpha(p, 0));
  const auto load = to_real<Number>(p.load());
  const auto radius = to_real<Number>(radius_of(p));
  const auto pi = numeric::pi<Number>();
  Galin t;
  put_half_width(t, sqrt(Number(load * radius / (2 * pi * quarter))), p);
  t.exponents = {half - alpha(p, 0), half + alpha(p, 0)};
  t.amplitudes = {-cos_pi_alpha<Number>(p.coupled_friction(0)) / radius};
  t.factor = load / (2 * pi * t.half_width * t.half_width * quarter);
  return t;
}

/// Checks the largest pressure: there sum p_j/(x - r_j), the logarithmic derivative of t, changes its sign from + to -.
template <Real R>
void check_peak(Findings& findings, const Galin& t, const ContactProblem& problem) {
  using std::abs;
  const PowerForm<R> form = t.at<R>();
  const R peak(t.peak);
  const std::vector<R> r = form.points();
  const auto derivative = [&](const R& x) {
    return R(form.powers[0].value / (x - r[0]) + form.powers[1].value / (x - r[1]));
  };
  const R size = abs(R(form.powers[0].value / (peak - r[0])));
  findings.compare("place", R(abs(derivative(peak)) / size));
  const R before = (peak - r[0]) / 1000;
  const R after = (r[1] - peak) / 1000;
  findings.require(derivative(peak - before) > 0 && derivative(peak + after) < 0, "the pressure has no maximum there");
  findings.compare<R>("factor", R(t.factor), 1 / to_real<R>(radius_of(problem)));
  if (problem.coupled_friction(0) > 0) {
    findings.require(peak < (r[0] + r[1]) / 2 && r[0] + r[1] < 0, "peak or zone is not shifted to the rear");
  }
}

}  // namespace

Claim claim() {
  return formula_claim<ContactProblem, Galin>("parabola-galin")
      .cases(parabolas)
      .effective_where(has_friction)
      .says(galin)
      .checked([]<Real R>(Findings& findings, const Galin& t, const ContactProblem& p, const Context& context) {
        check_parabola<R>(findings, t, p, context);
        check_peak<R>(findings, t, p);
        check_parabola_by_numeric<R>(findings, t, p);
        check_parabola_by_cln<R>(findings, t, p);
      })
      .wrong("the zone shifted to the front", [](Galin& t) { t.left_end = -(t.left_end + t.lengths[0]); })
      .wrong("`1/4 + alpha^2` in the half-width",
             [](Galin& t, const ContactProblem& p) {
               const auto angle = to_real<Number>(alpha(p, 0));
               const Number ratio = (1 - 4 * angle * angle) / (1 + 4 * angle * angle);
               put_half_width(t, t.half_width * sqrt(ratio), p);
             })
      .wrong("the powers of both free ends exchanged", [](Galin& t) { std::ranges::reverse(t.exponents); })
      .wrong(
          "`pi` missing in the half-width",
          [](Galin& t, const ContactProblem& p) { put_half_width(t, t.half_width * sqrt(numeric::pi<Number>()), p); })
      .wrong("`cos(pi alpha)` missing",
             [](Galin& t, const ContactProblem& p) { t.scale(1 / cos_pi_alpha<Number>(p.coupled_friction(0))); })
      .wrong("the largest pressure at `-2 alpha a`, the middle of the zone", [](Galin& t) { t.peak /= 2; })
      .wrong("the largest pressure at `+4 alpha a`", [](Galin& t) { t.peak *= -1; })
      .wrong("`P/(4 pi a^2 (1/4-alpha^2))` for the printed factor", [](Galin& t) { t.factor /= 2; })
      .near_miss("the half-width",
                 [](Galin& t, const Number& step) {
                   t.left_end *= 1 + step;
                   t.lengths[0] *= 1 + step;
                 })
      .near_miss("the middle of the zone", [](Galin& t, const Number& step) { t.left_end += t.half_width * step; })
      .near_miss("the peak", [](Galin& t, const Number& step) { t.peak += t.half_width * step; });
}

}  // namespace steadyslide::proofs_checks::parabola_galin
