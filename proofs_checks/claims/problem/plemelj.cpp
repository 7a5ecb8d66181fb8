// The Riemann-Hilbert problem behind every closed form: the jump of the fundamental solution across the contact, and
// the traction as the jump of the Cauchy integral. [Bal16, theorem 36, reconstructed]

#include "proofs_checks/claims/claims.hpp"
#include "proofs_checks/instruments/punch.hpp"

namespace steadyslide::proofs_checks {
namespace {

using numeric::Bank;
using numeric::Complex;

/// Y by its powers, G per panel, and the factor of Y/i in Phi. `amplitudes` are those of t.
template <class R>
struct JumpForm : PowerForm<R> {
  std::vector<Complex<R>> ratios;
  R potential{};
};
using JumpFormula = Formula<JumpForm, ContactProblem>;

template <class R>
Complex<R> product(const Complex<R>& a, const Complex<R>& b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}

template <class R>
double distance(const Complex<R>& a, const Complex<R>& b, const R& size) {
  using std::sqrt;
  const R re = a.re - b.re;
  const R im = a.im - b.im;
  return static_cast<double>(R(sqrt(R(re * re + im * im)) / size));
}

JumpFormula plemelj_formula() {
  return JumpFormula::from([]<Real R>(const ContactProblem& p) {
    JumpForm<R> form;
    static_cast<PowerForm<R>&>(form) = punch_form<R>(p);
    for (std::size_t k = 0; k < p.friction().values().size(); ++k) {
      // (s-i)/(s+i) = (s-i)^2/(1+s^2)
      const Rational s = p.coupled_friction(k);
      const Rational scale = 1 + s * s;
      form.ratios.push_back({numeric::to_real<R>((s * s - 1) / scale), numeric::to_real<R>(-2 * s / scale)});
    }
    form.potential = numeric::to_real<R>(p.load()) / (2 * numeric::pi<R>());
    return form;
  });
}

template <Real R>
void check_case(Findings& findings, const JumpForm<R>& form, const ContactProblem& problem) {
  using std::abs, std::cos, std::sin;
  const Quantity jump{
      "Y^+ = G Y^- on the contact", {"Y on the upper bank", "(s-i)/(s+i) times Y on the lower bank"}, tolerance<R>()};
  const Quantity angle{"value of G", {"(s-i)/(s+i)", "-exp(2 pi i alpha)"}, tolerance<R>()};
  const Quantity traction{
      "value of the traction", {"Phi^+ - Phi^- with Phi = P Y/(2 pi i)", "closed form"}, tolerance<R>()};
  const Quantity limit{
      "Y on both banks of the contact", {"Y close to the real axis", "its boundary values"}, tolerance<R>()};
  const Quantity infinity{"z Phi(z) at infinity", {"far away", "P/(2 pi i)"}, tolerance<R>()};
  const numeric::PowerTraction<R> t = form.traction();
  const auto& y = t.weight;
  const R small = R(tolerance<R>()) / 1000;
  R shortest = y.panel(0).length;
  for (const R& length : form.lengths) shortest = std::min(shortest, length);

  for (std::size_t k = 0; k < y.panel_count(); ++k) {
    const numeric::Panel<R>& panel = y.panel(k);
    const R turn = 2 * numeric::pi<R>() * numeric::to_real<R>(alpha(problem, k));
    findings.compare(angle, distance<R>(form.ratios[k], {R(-cos(turn)), R(-sin(turn))}, R(1)));
    for (const int tenths : {3, 5, 8}) {
      const numeric::Node<R> node = panel.node_from_left(panel.length * tenths / 10);
      const Complex<R> above = y.boundary(k, node, Bank::above);
      const Complex<R> below = y.boundary(k, node, Bank::below);
      const R size = y.modulus(k, node);
      findings.compare(jump, distance(above, product(form.ratios[k], below), size));
      // Phi = potential Y/i, and (a + bi)/i = b - ai.
      const Complex<R> difference{form.potential * (above.im - below.im), form.potential * (below.re - above.re)};
      const R value = t(k, node);
      findings.compare(traction, distance<R>(difference, {value, R(0)}, R(abs(value))));
      // Off the axis distances are differences of coordinates: a short panel costs digits.
      const R height = small * shortest;
      findings.compare(limit, static_cast<double>(shortest) * distance(y.at({node.x, height}), above, size));
      findings.compare(limit, static_cast<double>(shortest) * distance(y.at({node.x, R(-height)}), below, size));
    }
  }
  const Complex<R> far{R(0), R(1 / small)};
  const Complex<R> zy = product(far, y.at(far));
  const R load = numeric::to_real<R>(problem.load()) / (2 * numeric::pi<R>());
  findings.compare(infinity, distance<R>({form.potential * zy.re, form.potential * zy.im}, {load, R(0)}, load));
}

std::vector<Evidence> check(const Context& context, const JumpFormula& formula) {
  const auto walk = [&]<Real R>() {
    std::vector<ContactProblem> grid{
        punch(Rational(3, 10), {Rational(1, 2), 2, 1}, {Rational(-1, 3), Rational(2, 5)}, 3),
        punch(Rational(3, 10), {Rational(3, 5)}),
        punch(Rational(-9, 10), {50, 0, 10}, {0, Rational(1, 2)}, 1, Sliding::minus_x),
        punch(Rational(499, 1000), {0, 50}, {Rational(-3, 4)})};
    const Cases cases =
        punch_cases(context, "plemelj", std::move(grid), 60, [](Random& random) { return random.below(6); });
    Findings findings;
    for (const ContactProblem& problem : cases.problems) {
      findings.begin_case(text_of(problem), has_friction(problem));
      check_case(findings, formula.at<R>(problem), problem);
    }
    return findings.evidence(cases.detail);
  };
  return gather([&] { return numeric::at_precision(context.digits, walk); });
}

}  // namespace

Claim plemelj() {
  const JumpFormula right = plemelj_formula();
  return make_claim(
      claim_text("plemelj"), check, right,
      std::vector<Wrong<JumpFormula>>{
          {"G = (s+i)/(s-i)", right.changed([](auto& form, const ContactProblem&) {
             for (auto& ratio : form.ratios) ratio.im = -ratio.im;
           })},
          {"G = -(s-i)/(s+i)", right.changed([](auto& form, const ContactProblem&) {
             for (auto& ratio : form.ratios) ratio = {-ratio.re, -ratio.im};
           })},
          {"the powers of both edges exchanged", right.changed([](auto& form, const ContactProblem&) {
             const Exponent rear = form.exponents.front();
             form.set_exponent(0, form.exponents.back());
             form.set_exponent(form.exponents.size() - 1, rear);
           })},
          {"the exponent of one jump missing",
           right.changed([](auto& form, const ContactProblem&) { form.set_exponent(1, Exponent(0)); })},
          {"Phi = P Y/(pi i)", right.changed([](auto& form, const ContactProblem&) { form.potential *= 2; })},
          {"cos(pi alpha) missing in t", right.changed([](auto& form, const ContactProblem&) {
             for (auto& amplitude : form.amplitudes) amplitude = -2 * form.potential;
           })},
          {"near miss: one jump's exponent moved by ten times the tolerance",
           right.changed([]<Real R>(JumpForm<R>& form, const ContactProblem&) { form.move_power(1, near_miss<R>()); })},
          {"near miss: Phi moved by ten times the tolerance",
           right.changed(
               []<Real R>(JumpForm<R>& form, const ContactProblem&) { form.potential *= 1 + near_miss<R>(); })}});
}

}  // namespace steadyslide::proofs_checks
