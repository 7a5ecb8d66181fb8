// What the Riemann-Hilbert form says of the load, and how many unknowns and conditions it has.

#include "proofs_checks/claims/claims.hpp"
#include "proofs_checks/instruments/punch.hpp"
#include "proofs_checks/instruments/trial.hpp"

namespace steadyslide::proofs_checks {
namespace {

using numeric::RiemannHilbertForm;

/// int t and int xi t.
template <class R>
struct LoadSaid {
  std::shared_ptr<const TrialForm<R>> trial;
  R load;
  R moment;
};
using LoadFormula = Formula<LoadSaid, Trial>;

std::vector<Evidence> check_load(const Context& context, const LoadFormula& formula) {
  const auto walk = [&]<Real R>() {
    using std::abs, std::max;
    const Quantity load{"load int t", {"trapezoidal rule", "coefficient of 1/z at infinity"}, tolerance<R>()};
    const Quantity moment{"moment int x t", {"trapezoidal rule", "coefficient of 1/z^2 at infinity"}, tolerance<R>()};
    const Quantity given{
        "load where S < 0", {"coefficient of 1/z at infinity", "leading coefficient of q"}, tolerance<R>()};
    const Quantity part{
        "load on one segment of the contact", {"trapezoidal rule", "Gauss-Jacobi rule"}, tolerance<R>()};
    const std::vector<Trial> all = trials(context, "rh-load", count_for(context, 20, 2, 1));
    Findings findings;
    for (const Trial& trial : all) {
      findings.begin_case(trial.name + ": " + text_of(trial.problem));
      const LoadSaid<R> said = formula.at<R>(trial);
      const RiemannHilbertForm<R>& form = said.trial->form();
      const numeric::trapezoidal::Grid<R> grid(traction_density(form));
      const R scale = max(R(abs(grid.integral())), load_scale(form));
      findings.compare(load, static_cast<double>(R(abs(grid.integral() - said.load) / scale)));
      findings.compare(moment, static_cast<double>(R(abs(grid.moment(R(0)) - said.moment) / scale)));
      findings.compare(moment, static_cast<double>(R(abs(form.moment_of_load() + said.moment) / scale)));
      if (!form.q().empty()) findings.compare(given, relative_difference<R>(said.load, R(-form.q().back())));
      const std::vector<std::size_t> segments = segments_of(form);
      for (std::size_t k = 0; k < segments.size(); ++k) {
        if (form.is_kinked(segments[k]) || form.is_kinked(segments[k] + 1)) continue;
        const R difference = form.load_on(segments[k]).value - grid.panel_integral(k);
        findings.compare(part, static_cast<double>(R(abs(difference) / max(scale, R(abs(grid.panel_integral(k)))))));
      }
    }
    return findings.evidence(detail_of(context, all));
  };
  return gather([&] { return numeric::at_precision(context.digits, walk); });
}

Claim load_claim() {
  const LoadFormula right = LoadFormula::from([]<Real R>(const Trial& trial) {
    auto form = std::make_shared<const TrialForm<R>>(trial);
    const R minus_pi = -numeric::pi<R>();
    return LoadSaid<R>{form, R(minus_pi * coefficient_at_infinity(form->form(), -1)),
                       R(minus_pi * coefficient_at_infinity(form->form(), -2))};
  });
  return make_claim(
      claim_text("rh-load"), check_load, right,
      std::vector<Wrong<LoadFormula>>{
          {"Y's expansion cut after its first term", right.changed([]<class R>(LoadSaid<R>& said, const Trial&) {
             const RiemannHilbertForm<R>& form = said.trial->form();
             const int S = form.degree_at_infinity();
             said.moment = S >= -1 ? R(-numeric::pi<R>() * form.moments(static_cast<std::size_t>(S + 2)).back())
                                   : R(-form.q()[static_cast<std::size_t>(-S - 2)]);
           })},
          {"int t = -[z^-1], pi missing",
           right.changed([]<class R>(LoadSaid<R>& said, const Trial&) { said.load /= numeric::pi<R>(); })},
          {"int x t = +pi [z^-2]", right.changed([](auto& said, const Trial&) { said.moment = -said.moment; })},
          {"near miss: the load moved by ten times the tolerance",
           right.changed([]<class R>(LoadSaid<R>& said, const Trial&) { said.load *= 1 + near_miss<R>(); })},
          {"near miss: the moment moved by ten times the tolerance",
           right.changed(
               []<class R>(LoadSaid<R>& said, const Trial&) { said.moment += near_miss<R>() * said.load; })}});
}

/// Numbers of unknowns and conditions, from S, the number of components and that of free ends.
struct Count {
  int degree_of_q;  ///< plus S
  int moments;      ///< plus S
  int gaps;         ///< plus the number of components
};

std::vector<Evidence> check_count(const Context& context, const Count& count) {
  return gather([&] {
    Findings findings;
    for (std::size_t n = 1; n <= (context.quick ? 2 : 4); ++n) {
      for (std::size_t kinds = 0; kinds < (std::size_t{1} << (2 * n)); ++kinds) {
        std::vector<std::pair<bool, bool>> edges;
        for (std::size_t i = 0; i < n; ++i) edges.emplace_back((kinds >> (2 * i)) & 1U, (kinds >> (2 * i + 1)) & 1U);
        const TrialForm<double> trial(with_ends(edges));
        const RiemannHilbertForm<double>& form = trial.form();
        Exponent sum;
        int free = 0;
        for (std::size_t j = 0; j < form.set().points().size(); ++j) {
          const auto& point = form.set().point(j);
          const bool jump = !point.is_end() && form.weight().powers()[j].value != 0;
          if (point.is_end() || jump) sum += form.exponent(j);
          free += point.is_free() ? 1 : 0;
        }
        findings.begin_case(std::to_string(n) + " components, ends number " + std::to_string(kinds));
        const int S = form.degree_at_infinity();
        const int components = static_cast<int>(n);
        findings.decide("the exponents sum to S", sum == Exponent(S));
        findings.decide("S = (free ends) - (components)", S == free - components);
        const int coefficients = std::max(0, count.degree_of_q - S + 1);
        findings.decide("q has -S coefficients", coefficients == static_cast<int>(form.q().size()));
        const int conditions = 1 + std::max(0, S + count.moments) + components + count.gaps;
        findings.decide("as many unknowns as conditions", free + coefficients == conditions);
      }
    }
    return findings.evidence("every choice of edges and free ends, " +
                             std::string(context.quick ? "one or two" : "one to four") + " components");
  });
}

Claim count_claim() {
  return make_claim<Count>(claim_text("rh-count"), check_count, {-1, 0, -1},
                           {{"q of degree -S", {0, 0, -1}},
                            {"one moment too many", {-1, 1, -1}},
                            {"a condition for every component, not every gap", {-1, 0, 0}}});
}

}  // namespace

std::vector<Claim> contact_load_claims() { return {load_claim(), count_claim()}; }

}  // namespace steadyslide::proofs_checks
