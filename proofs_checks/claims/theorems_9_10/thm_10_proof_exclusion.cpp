// Checks the last step in the proof of theorem 10: a free end has no edge singularity. [Bal16, theorem 10]

#include "numeric/riemann_hilbert/gap_integral.hpp"
#include "proofs_checks/instruments/solutions/local_behaviour.hpp"
#include "proofs_checks/instruments/solutions/trial.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::thm_10_proof_exclusion {
namespace {

/// A contact that is forced to end at 0 with an edge, where the profile is continuous. It is not a solution, but the
/// equation holds.
struct ForcedEnd {
  Side beyond;  ///< the side of 0 without contact
  double other_end;
  Rational slope;  ///< slope of the profile at 0
  int sign;        ///< the sign of a in this case
};

const Rational s(3, 4);

std::string text_of(const ForcedEnd& c) {
  return std::string("contact on the ") + (c.beyond == Side::left ? "right" : "left") +
         ", psi' = " + to_string(c.slope) + " at its end";
}

Trial trial_of(const ForcedEnd& c) {
  const Polynomial profile({0, c.slope, Rational(1, 2), Rational(1, 12)});
  const double place = Trial::in_frame(0);
  const ContactInterval zone = c.beyond == Side::left ? ContactInterval{place, c.other_end, true, false}
                                                      : ContactInterval{c.other_end, place, false, true};
  return {
      text_of(c),
      {Elasticity::reduced(Rational(1, 2)), FrictionProfile({2 * s}), Indenter(-4, {{0, profile}, {4, profile}}), 1},
      {zone},
      {1, 1},
      0};
}

Exponent edge_power(const ForcedEnd& c) {
  return c.beyond == Side::left ? -(half + Exponent::angle(s)) : -(half - Exponent::angle(s));
}

Number gap_over_a(const ForcedEnd& c) { return -1 / (cos_pi_alpha<Number>(s) * (to_real<Number>(edge_power(c)) + 1)); }

}  // namespace

Claim claim() {
  return compared<ForcedEnd>("thm-10-proof-exclusion")
      .cases(fixed_cases<ForcedEnd>({{Side::left, 0.4, Rational(-1, 4), 1},
                                     {Side::left, 0.4, Rational(1), 1},
                                     {Side::right, -0.4, Rational(1, 4), -1},
                                     {Side::right, -0.4, Rational(-1), 1},
                                     {Side::left, 1.1, Rational(-1, 2), 1}},
                                    3, "contacts made to end where the profile is continuous"))
      .precision(Precision::quick_in_double)
      .measured([]<Real R>(const ForcedEnd& c) -> Values {
        using std::pow;
        const TrialForm<R> trial(trial_of(c));
        const auto& form = trial.form();
        std::size_t j = 0;
        while (!(form.set().point(j).anchor && form.problem().place(*form.set().point(j).anchor) == 0)) ++j;
        const R unit = to_real<R>(Trial::frame().unit);
        const R d = asymptotic_distance<R>();
        const R p = to_real<R>(edge_power(c));
        const R a = -form.traction(beside(form, j, opposite(c.beyond), R(d * unit))).value / pow(d, p);
        const numeric::GapIntegral<R> beyond(form, j);
        const R gap = beyond.reduced_gap(beside(form, j, c.beyond, R(d * unit))).value / pow(d, R(p + 1));
        // A point at which no quantity is small.
        const R far = R(1) / 50;
        const auto at = beside(form, j, c.beyond, R(far * unit));
        const trapezoidal::Grid<R> grid(traction_density(form));
        const R by_rule = beyond.profile_increment(at) - grid.displacement(0, c.beyond, far);
        return {
            {"gap", R(gap / a)}, {"sign", Number(a > 0 ? 1 : -1)}, {"rule", R(by_rule / beyond.reduced_gap(at).value)}};
      })
      .predicted([](const ForcedEnd& c) -> Values {
        return {{"gap", gap_over_a(c)}, {"sign", Number(c.sign)}, {"rule", Number(1)}};
      })
      .wrong("the surface below the indenter for `a > 0`", scaled({"gap"}, -1))
      .wrong("`sqrt(1+s^2)` missing", scaled({"gap"}, cos_pi_alpha<Number>(s)))
      .wrong("`1/(1/2-alpha)` missing",
             [](Values& p, const ForcedEnd& c) { p["gap"] *= to_real<Number>(edge_power(c)) + 1; })
      .wrong("a of one sign in all cases", [](Values& p) { p["sign"] = 1; })
      .near_misses();
}

}  // namespace steadyslide::proofs_checks::thm_10_proof_exclusion
