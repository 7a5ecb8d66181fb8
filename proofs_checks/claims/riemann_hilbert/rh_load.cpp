// What the Riemann-Hilbert form says of the load.

#include "proofs_checks/instruments/solutions/trial.hpp"
#include "proofs_checks/instruments/tractions/punch.hpp"

namespace steadyslide::proofs_checks {
namespace {

using numeric::RiemannHilbertForm;

/// int t and int xi t.
template <class R>
struct Resultants {
  std::shared_ptr<const TrialForm<R>> trial;
  R load;
  R moment;
};
using LoadFormula = Formula<Resultants, Trial>;

std::vector<Evidence> check_load(const Context& context, const LoadFormula& formula) {
  const auto walk = [&]<Real R>() {
    using std::abs, std::max;
    const Quantity load{"load int t", {"trapezoidal rule", "coefficient of 1/z at infinity"}, tolerance<R>()};
    const Quantity moment{"moment int x t", {"trapezoidal rule", "coefficient of 1/z^2 at infinity"}, tolerance<R>()};
    const Quantity given{
        "load where S < 0", {"coefficient of 1/z at infinity", "leading coefficient of q"}, tolerance<R>()};
    const Quantity part{
        "load on one segment of the contact", {"trapezoidal rule", "Gauss-Jacobi rule"}, tolerance<R>()};
    const std::vector<Trial> all = trials(context, "rh-load", count_for(context, {20, 2, 1}));
    Findings findings;
    for (const Trial& trial : all) {
      findings.begin_case(trial.name + ": " + text_of(trial.problem));
      const Resultants<R> predicted = formula.at<R>(trial);
      const RiemannHilbertForm<R>& form = predicted.trial->form();
      const numeric::trapezoidal::Grid<R> grid(traction_density(form));
      const R scale = max(R(abs(grid.integral())), load_scale(form));
      findings.compare(load, static_cast<double>(R(abs(grid.integral() - predicted.load) / scale)));
      findings.compare(moment, static_cast<double>(R(abs(grid.moment(R(0)) - predicted.moment) / scale)));
      findings.compare(moment, static_cast<double>(R(abs(form.moment_of_load() + predicted.moment) / scale)));
      if (!form.q().empty()) findings.compare(given, relative_difference<R>(predicted.load, R(-form.q().back())));
      const std::vector<std::size_t> segments = segments_of(form);
      for (std::size_t k = 0; k < segments.size(); ++k) {
        if (form.changes_polynomial(segments[k]) || form.changes_polynomial(segments[k] + 1)) continue;
        const R difference = form.load_on(segments[k]).value - grid.panel_integral(k);
        findings.compare(part, static_cast<double>(R(abs(difference) / max(scale, R(abs(grid.panel_integral(k)))))));
      }
    }
    return findings.evidence(detail_of(context, all));
  };
  return gather([&] { return numeric::at_precision(context.digits, walk); });
}

}  // namespace

Claim rh_load() {
  // Plain: the formula is the solver's form, which lives at the number type it is examined in.
  const LoadFormula right = LoadFormula::from([]<Real R>(const Trial& trial) {
    auto form = std::make_shared<const TrialForm<R>>(trial);
    const R minus_pi = -numeric::pi<R>();
    return Resultants<R>{form, R(minus_pi * coefficient_at_infinity(form->form(), -1)),
                         R(minus_pi * coefficient_at_infinity(form->form(), -2))};
  });
  return make_claim(
      claim_text("rh-load"), check_load, right,
      std::vector<Wrong<LoadFormula>>{
          {"Y's expansion cut after its first term", right.changed([]<class R>(Resultants<R>& predicted, const Trial&) {
             const RiemannHilbertForm<R>& form = predicted.trial->form();
             const int S = form.degree_at_infinity();
             predicted.moment = S >= -1 ? R(-numeric::pi<R>() * form.moments(static_cast<std::size_t>(S + 2)).back())
                                        : R(-form.q()[static_cast<std::size_t>(-S - 2)]);
           })},
          {"int t = -[z^-1], pi missing",
           right.changed([]<class R>(Resultants<R>& predicted, const Trial&) { predicted.load /= numeric::pi<R>(); })},
          {"int x t = +pi [z^-2]",
           right.changed([](auto& predicted, const Trial&) { predicted.moment = -predicted.moment; })},
          {"near miss: the load moved by ten times the tolerance",
           right.changed(
               []<class R>(Resultants<R>& predicted, const Trial&) { predicted.load *= 1 + near_miss<R>(); })},
          {"near miss: the moment moved by ten times the tolerance",
           right.changed([]<class R>(Resultants<R>& predicted, const Trial&) {
             predicted.moment += near_miss<R>() * predicted.load;
           })}});
}

}  // namespace steadyslide::proofs_checks
