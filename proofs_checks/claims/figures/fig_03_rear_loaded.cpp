#include "proofs_checks/instruments/operators/local_power.hpp"
#include "proofs_checks/instruments/solutions/extremes.hpp"
#include "proofs_checks/instruments/tractions/punch.hpp"
#include "proofs_checks/kit/claim_builder.hpp"
#include "proofs_checks/kit/special_numbers.hpp"

namespace steadyslide::proofs_checks::fig_03_rear_loaded {
namespace {

/// Returns a punch with friction f on both halves. A friction jump of height zero at 0 makes the solver return the load
/// share there.
ContactProblem halves(const Rational& nu, const Rational& f) { return punch(nu, {f, f}, {0}); }

/// Returns the integral of (4) over [-1, 0] under the load 1, by quadrature.
template <Real R>
R rear_load_by_quadrature(const ContactProblem& p) {
  const Number size = -punch_amplitude<Number>(p, 0);
  const PowerProduct t =
      PowerProduct::on({-1, 0, 1}, {-(half + alpha(p, 0)), Exponent(), -(half - alpha(p, 0))}, {size, size});
  return tanh_sinh::panel_integral<R>(t.at<R>().traction().density().front()).value;
}

/// Returns the predictions of (4) with this alpha; the minimum lies at `place` times alpha. The rear half has the share
///
///   (2 cos(pi alpha)/pi) int_0^1 v^{-2 alpha}/(1+v^2) dv,   v^2 = (1+x)/(1-x),
///     = (cos(pi alpha)/(2 pi)) (digamma(3/4 - alpha/2) - digamma(1/4 - alpha/2)).
Values rear_loaded(const Rational& s, const Number& alpha, int place = 2) {
  const auto cosine = cos_pi_alpha<Number>(s);
  const auto pi = numeric::pi<Number>();
  const Number share =
      cosine / (2 * pi) * (digamma(Number((3 - 2 * alpha) / 4)) - digamma(Number((1 - 2 * alpha) / 4)));
  const Number smallest =
      cosine / pi * pow(Number(1 + 2 * alpha), Number(-0.5 - alpha)) * pow(Number(1 - 2 * alpha), Number(alpha - 0.5));
  return {{"share, solved", share},
          {"share, quadrature", share},
          {"more than half", true},
          {"rear power", Number(-0.5 - alpha)},
          {"front power", Number(alpha - 0.5)},
          {"place", Number(place * alpha)},
          {"smallest", smallest}};
}

Number alpha_of(const ContactProblem& p) { return to_real<Number>(alpha(p, 0)); }

}  // namespace

Claim claim() {
  const Rational nu(3, 10);
  return compared<ContactProblem>("fig-03-rear-loaded")
      .cases(fixed_cases<ContactProblem>(
          {halves(nu, 2), halves(nu, Rational(1, 5)), halves(nu, 1), halves(nu, 50), halves(Rational(-9, 10), 2)}, 1,
          "solved flat punches"))
      .precision(Precision::at_least_fifty)
      .measured([]<Real R>(const ContactProblem& p) {
        const auto solution = solve<R>(p);
        const R share = solution->resultants().load_share.front().value;
        const R s = to_real<R>(p.coupled_friction(0));
        const auto pressure = [&](const R& x) {
          const std::size_t end = contact_end(*solution, x < 0 ? Side::left : Side::right);
          return x < 0 ? R(-traction_beside(*solution, end, Side::right, R(1 + x)))
                       : R(-traction_beside(*solution, end, Side::left, R(1 - x)));
        };
        Values values{{"share, solved", share},
                      {"share, quadrature", rear_load_by_quadrature<R>(p)},
                      {"more than half", share > R(1) / 2},
                      {"rear power", end_power<R>(Side::right, EndTraction::unbounded, s)},
                      {"front power", end_power<R>(Side::left, EndTraction::unbounded, s)}};
        // The pressure is unbounded at both ends, so a single extreme is the minimum.
        const std::vector<R> extremes = extremes_between<R>(pressure, R(-1), R(1));
        if (extremes.size() != 1) return values;
        values.add({"place", extremes.front()});
        values.add({"smallest", pressure(extremes.front())});
        return values;
      })
      .predicted([](const ContactProblem& p) { return rear_loaded(s_of(p, 0), alpha_of(p)); })
      .wrong("more at the front: `alpha`'s sign",
             [](Values& p, const ContactProblem& c) { p = rear_loaded(s_of(c, 0), -alpha_of(c)); })
      .wrong("half of the load on each half", [](Values& p) { p["share, solved"] = p["share, quadrature"] = 0.5; })
      .wrong("`cos(pi alpha)` missing in the share",
             scaled({"share, solved", "share, quadrature"},
                    [](const ContactProblem& c) { return 1 / cos_pi_alpha<Number>(s_of(c, 0)); }))
      .wrong("the minimum at the centre", [](Values& p) { p["place"] = 0; })
      .wrong("the minimum at `x = alpha`", [](Values& p) { p["place"] /= 2; })
      .near_misses();
}

}  // namespace steadyslide::proofs_checks::fig_03_rear_loaded
