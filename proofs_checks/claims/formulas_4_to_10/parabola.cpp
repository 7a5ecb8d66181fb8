// Galin's parabola, under constant friction [Bal16, section 2] and with friction jumps inside the contact.

#include "numeric/closed_form/closed_form.hpp"
#include "proofs_checks/claims/claims.hpp"
#include "proofs_checks/instruments/parabola_cases.hpp"

namespace steadyslide::proofs_checks {
namespace {

/// Half-width, zone, traction and peak as printed; `quarter` is 1/4 - alpha^2.
ParabolaFormula constant_friction_formula() {
  return ParabolaFormula::from([]<Real R>(const ContactProblem& p) {
    using std::sqrt;
    const R angle = numeric::to_real<R>(alpha(p, 0));
    // 1/4 - alpha^2 as a product: alpha may be next to 1/2.
    const R quarter = numeric::to_real<R>(half - alpha(p, 0)) * numeric::to_real<R>(half + alpha(p, 0));
    const R load = numeric::to_real<R>(p.load());
    const R radius = numeric::to_real<R>(radius_of(p));
    const R a = sqrt(load * radius / (2 * numeric::pi<R>() * quarter));
    ParabolaForm<R> form;
    form.half_width = a;
    form.left_end = -2 * numeric::to_real<R>(half + alpha(p, 0)) * a;
    form.lengths = {R(2 * a)};
    form.exponents = {half - alpha(p, 0), half + alpha(p, 0)};
    for (const Exponent& exponent : form.exponents) form.powers.push_back(numeric::Power<R>::of(exponent));
    form.factor = load / (2 * numeric::pi<R>() * a * a * quarter);
    form.amplitudes = {R(-numeric::cos_pi_alpha<R>(p.coupled_friction(0)) / radius)};
    form.peak = -4 * angle * a;
    return form;
  });
}

/// The zone that the numeric layer finds; everything else is what the claim says of it.
ParabolaFormula jumps_formula() {
  return ParabolaFormula::from([]<Real R>(const ContactProblem& p) {
    const auto data = std::get<numeric::ClosedFormData<R>>(numeric::closed_form_data<R>(p));
    ParabolaForm<R> form;
    form.first_piece = data.first_piece;
    form.left_end = data.left_end;
    form.exponents = data.exponents;
    form.powers = data.traction.weight.powers();
    const R radius = numeric::to_real<R>(radius_of(p));
    for (std::size_t k = 0; k < data.traction.weight.panel_count(); ++k) {
      form.lengths.push_back(data.traction.weight.panel(k).length);
      form.amplitudes.push_back(-numeric::cos_pi_alpha<R>(p.coupled_friction(data.first_piece + k)) / radius);
    }
    return form;
  });
}

/// The largest pressure: where sum p_j/(x - r_j), the logarithmic derivative of t, changes its sign from + to -.
template <Real R>
void check_peak(Findings& findings, const ParabolaForm<R>& form, const ContactProblem& problem) {
  using std::abs;
  const Quantity peak{
      "place of the largest pressure", {"-4 alpha a", "zero of the logarithmic derivative of t"}, tolerance<R>()};
  const Quantity factor{"both printed factors of the traction", {"P/(2 pi a^2 (1/4-alpha^2))", "1/R"}, tolerance<R>()};
  const std::vector<R> r = form.points();
  const auto derivative = [&](const R& x) {
    return R(form.powers[0].value / (x - r[0]) + form.powers[1].value / (x - r[1]));
  };
  const R size = abs(R(form.powers[0].value / (form.peak - r[0])));
  findings.compare(peak, static_cast<double>(R(abs(derivative(form.peak)) / size)));
  const R before = (form.peak - r[0]) / 1000;
  const R after = (r[1] - form.peak) / 1000;
  findings.require(derivative(form.peak - before) > 0 && derivative(form.peak + after) < 0,
                   "the pressure has no maximum there");
  findings.compare(factor, relative_difference<R>(form.factor, R(1 / numeric::to_real<R>(radius_of(problem)))));
  if (problem.coupled_friction(0) > 0) {
    findings.require(form.peak < (r[0] + r[1]) / 2 && r[0] + r[1] < 0, "peak or zone is not shifted to the rear");
  }
}

ParabolaPoints points_for(const Context& context) { return {count_for(context, 9, 2, 2), context.quick ? 5 : 1}; }

std::vector<Evidence> check_constant_friction(const Context& context, const ParabolaFormula& formula) {
  const auto walk = [&]<Real R>() {
    std::vector<ContactProblem> problems;
    for (const Rational& nu : {Rational(3, 10), Rational(-9, 10), Rational(499, 1000)}) {
      for (const Rational& f : {Rational(2), Rational(1, 5), Rational(50), Rational(0)}) {
        problems.push_back(parabola(nu, {f}, {}, Rational(4, 5), Rational(3, 2)));
      }
    }
    if (context.quick) problems.erase(problems.begin() + 2, problems.end());
    const std::size_t fixed = problems.size();
    const std::size_t count = context.quick ? 1 : count_for(context, 20, 6, 3);
    Random random(context.seed, "parabola");
    for (std::size_t k = 0; k < count; ++k) {
      problems.push_back(parabola(random.poisson(), {random.friction(largest_friction(context))}, {},
                                  random.between(0, 10), random.between(0, 5)));
    }
    Findings findings;
    for (const ContactProblem& problem : problems) {
      findings.begin_case(text_of(problem), problem.coupled_friction(0) != 0);
      const ParabolaForm<R> form = formula.at<R>(problem);
      check_parabola(findings, form, problem, points_for(context));
      check_peak(findings, form, problem);
      check_parabola_by_numeric(findings, form, problem);
      check_parabola_by_cln(findings, form, problem);
    }
    return findings.evidence(std::to_string(fixed) + " of a grid, " + std::to_string(count) + " random with seed " +
                             std::to_string(context.seed));
  };
  return gather([&] { return numeric::at_precision(context.digits, walk); });
}

std::vector<Evidence> check_jumps(const Context& context, const ParabolaFormula& formula) {
  const auto walk = [&]<Real R>() {
    std::vector<ContactProblem> problems{
        parabola(Rational(3, 10), {Rational(1, 2), 3, 1}, {Rational(-1, 5), Rational(1, 10)}, 1, 1),
        parabola(Rational(3, 10), {Rational(1, 2), 2}, {0}, Rational(1, 5), 1),
        parabola(Rational(3, 10), {2, Rational(1, 2)}, {0}, Rational(1, 5), 1, Rational(1, 3), Sliding::minus_x),
        // The outer jumps stay outside of the contact.
        parabola(0, {1, 0, 2, Rational(1, 3)}, {-5, Rational(1, 20), 7}, Rational(1, 2), 1),
        parabola(Rational(-9, 10), {50, 1, 10}, {Rational(-3, 5), Rational(1, 7)}, 2, 2),
        parabola(Rational(499, 1000), {1, 50}, {Rational(-1, 9)}, 1, 3)};
    if (context.quick) problems.erase(problems.begin() + 2, problems.end());
    const std::size_t fixed = problems.size();
    const std::size_t count = context.quick ? 1 : count_for(context, 30, 6, 3);
    Random random(context.seed, "parabola-jumps");
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t m = 1 + random.below(4);
      std::vector<Rational> friction;
      for (std::size_t piece = 0; piece <= m; ++piece) friction.push_back(random.friction(largest_friction(context)));
      problems.push_back(
          parabola(random.poisson(), friction, random_jumps(random, m), random.between(0, 4), random.between(0, 4)));
    }
    Findings findings;
    for (const ContactProblem& problem : problems) {
      const ParabolaForm<R> form = formula.at<R>(problem);
      bool jumps_inside = false;
      for (std::size_t j = 1; j + 1 < form.exponents.size(); ++j) jumps_inside |= form.exponents[j].sign() != 0;
      findings.begin_case(text_of(problem), jumps_inside);
      check_parabola(findings, form, problem, points_for(context));
      check_parabola_by_cln(findings, form, problem);
    }
    return findings.evidence(std::to_string(fixed) + " of a grid, " + std::to_string(count) + " random with seed " +
                             std::to_string(context.seed));
  };
  return gather([&] { return numeric::at_precision(context.digits, walk); });
}

Claim constant_friction() {
  const ParabolaFormula right = constant_friction_formula();
  return make_claim(
      claim_text("parabola-galin"), check_constant_friction, right,
      std::vector<Wrong<ParabolaFormula>>{
          {"the zone shifted to the front", right.changed([](auto& form, const ContactProblem&) {
             form.left_end = -(form.left_end + form.lengths[0]);
           })},
          {"1/4 + alpha^2 in the half-width", right.changed([]<Real R>(ParabolaForm<R>& form, const ContactProblem& p) {
             using std::sqrt;
             const R angle = numeric::to_real<R>(alpha(p, 0));
             const R a = form.half_width * sqrt(R((1 - 4 * angle * angle) / (1 + 4 * angle * angle)));
             form.left_end = -(1 + 2 * angle) * a;
             form.lengths[0] = 2 * a;
             form.peak = -4 * angle * a;
           })},
          {"the powers of both free ends exchanged", right.changed([](auto& form, const ContactProblem& p) {
             form.set_exponent(0, half + alpha(p, 0));
             form.set_exponent(1, half - alpha(p, 0));
           })},
          {"pi missing in the half-width", right.changed([]<Real R>(ParabolaForm<R>& form, const ContactProblem&) {
             using std::sqrt;
             const R root = sqrt(numeric::pi<R>());
             form.left_end *= root;
             form.lengths[0] *= root;
             form.peak *= root;
           })},
          {"cos(pi alpha) missing", right.changed([]<Real R>(ParabolaForm<R>& form, const ContactProblem& p) {
             form.scale(1 / numeric::cos_pi_alpha<R>(p.coupled_friction(0)));
           })},
          {"the largest pressure at -2 alpha a, the middle of the zone",
           right.changed([](auto& form, const ContactProblem&) { form.peak /= 2; })},
          {"the largest pressure at +4 alpha a",
           right.changed([](auto& form, const ContactProblem&) { form.peak = -form.peak; })},
          {"P/(4 pi a^2 (1/4-alpha^2)) for the printed factor",
           right.changed([](auto& form, const ContactProblem&) { form.factor /= 2; })},
          {"near miss: the half-width moved by ten times the tolerance",
           right.changed([]<Real R>(ParabolaForm<R>& form, const ContactProblem&) {
             form.left_end *= 1 + near_miss<R>();
             form.lengths[0] *= 1 + near_miss<R>();
           })},
          {"near miss: the zone shifted by ten times the tolerance",
           right.changed([]<Real R>(ParabolaForm<R>& form, const ContactProblem&) {
             form.left_end += form.half_width * near_miss<R>();
           })},
          {"near miss: the peak moved by ten times the tolerance",
           right.changed([]<Real R>(ParabolaForm<R>& form, const ContactProblem&) {
             form.peak += form.half_width * near_miss<R>();
           })}});
}

Claim with_jumps() {
  const ParabolaFormula right = jumps_formula();
  return make_claim(
      claim_text("parabola-n-jumps"), check_jumps, right,
      std::vector<Wrong<ParabolaFormula>>{
          {"the zone shifted to the front",
           right.changed([](auto& form, const ContactProblem&) { form.left_end += form.lengths[0] / 20; })},
          {"the exponent of one jump missing",
           right.changed([](auto& form, const ContactProblem&) { form.set_exponent(1, Exponent(0)); })},
          {"every jump's exponent with the other sign", right.changed([](auto& form, const ContactProblem&) {
             for (std::size_t j = 1; j + 1 < form.exponents.size(); ++j) form.set_exponent(j, -form.exponents[j]);
           })},
          {"the powers of both free ends exchanged", right.changed([](auto& form, const ContactProblem&) {
             const Exponent rear = form.exponents.front();
             form.set_exponent(0, form.exponents.back());
             form.set_exponent(form.exponents.size() - 1, rear);
           })},
          {"one amplitude on all panels", right.changed([](auto& form, const ContactProblem&) {
             for (auto& amplitude : form.amplitudes) amplitude = form.amplitudes[0];
           })},
          {"the rear end moved outwards by a hundredth of its panel",
           right.changed([](auto& form, const ContactProblem&) {
             form.left_end -= form.lengths[0] / 100;
             form.lengths[0] += form.lengths[0] / 100;
           })},
          {"near miss: the rear end moved by ten times the tolerance",
           right.changed([]<Real R>(ParabolaForm<R>& form, const ContactProblem&) {
             const R step = form.lengths[0] * near_miss<R>();
             form.left_end -= step;
             form.lengths[0] += step;
           })},
          {"near miss: one jump's exponent moved by ten times the tolerance",
           right.changed(
               []<Real R>(ParabolaForm<R>& form, const ContactProblem&) { form.move_power(1, near_miss<R>()); })},
          {"near miss: the amplitude moved by ten times the tolerance",
           right.changed(
               []<Real R>(ParabolaForm<R>& form, const ContactProblem&) { form.scale(1 + near_miss<R>()); })}});
}

}  // namespace

std::vector<Claim> parabola_claims() { return {constant_friction(), with_jumps()}; }

}  // namespace steadyslide::proofs_checks
