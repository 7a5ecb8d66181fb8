// Checks the load of the Riemann-Hilbert form.

#include "proofs_checks/instruments/solutions/trial.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::rh_load {
namespace {

/// Returns int t and int x t by quadrature, and the largest difference between the form's rule and quadrature on a
/// segment, all divided by the size of int |t|. They are compared with the values from infinity, and with those that
/// the solver uses.
template <Real R>
Values by_quadrature(const Trial& trial) {
  using std::abs, std::max;
  const TrialForm<R> tried(trial);
  const TractionRepresentation<R>& form = tried.form();
  const trapezoidal::Grid<R> grid(traction_density(form));
  const R scale = load_scale(form);
  Values values{{"load", R(grid.integral() / scale)},
                {"moment", R(grid.moment(R(0)) / scale)},
                {"moment, solver", R(grid.moment(R(0)) / scale)}};
  if (!form.q().empty()) values.add({"given", R(grid.integral() / scale)});
  R part = 0;
  const std::vector<std::size_t> segments = segments_of(form);
  for (std::size_t k = 0; k < segments.size(); ++k) {
    if (form.changes_polynomial(segments[k]) || form.changes_polynomial(segments[k] + 1)) continue;
    const R found = grid.panel_integral(k);
    part = max(part, R(abs(form.load_on(segments[k]).value - found) / max(scale, R(abs(found)))));
  }
  values.add({"part", part});
  return values;
}

/// Returns the values from the coefficients of u'/c at infinity. With only the first term of Y the moment is wrong.
template <Real R>
Values at_infinity(const Trial& trial, bool first_term_alone = false) {
  const TrialForm<R> tried(trial);
  const TractionRepresentation<R>& form = tried.form();
  const R minus_pi = -numeric::pi<R>() / load_scale(form);
  const int S = form.degree_at_infinity();
  const R moment = !first_term_alone ? coefficient_at_infinity(form, -2)
                   : S >= -1         ? form.moments(static_cast<std::size_t>(S + 2)).back().value
                                     : R(form.q()[static_cast<std::size_t>(-S - 2)] / numeric::pi<R>());
  Values values{{"load", R(minus_pi * coefficient_at_infinity(form, -1))},
                {"moment", R(minus_pi * moment)},
                {"moment, solver", R(-form.moment_of_load().value / load_scale(form))},
                {"part", Number(0)}};
  if (!form.q().empty()) values.add({"given", R(-form.q().back() / load_scale(form))});
  return values;
}

}  // namespace

Claim claim() {
  return compared<Trial>("rh-load")
      .cases(trials("rh-load", {20, 2, 1}))
      .measured([]<Real R>(const Trial& trial) { return by_quadrature<R>(trial); })
      .predicted([]<Real R>(const Trial& trial) { return at_infinity<R>(trial); })
      .wrong("`Y`'s expansion cut after its first term",
             [](Values& p, const Trial& trial) {
               const Values cut = at_infinity<double>(trial, true);
               p.set("moment", *cut.find("moment"));
             })
      .wrong("`int t = -[z^-1]`, `pi` missing", scaled({"load", "given"}, 1 / numeric::pi<Number>()))
      .wrong("`int x t = +pi [z^-2]`", scaled({"moment", "moment, solver"}, -1))
      .near_misses();
}

}  // namespace steadyslide::proofs_checks::rh_load
