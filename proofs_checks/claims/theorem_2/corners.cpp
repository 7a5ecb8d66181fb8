// What the traction of a solved problem does next to a wedge, with and without a friction jump there, and next to the
// ends of the contact. Measured: what is left of t when the stated singularity is taken out is one analytic function,
// so that its values on one side give those on the other.

#include "proofs_checks/claims/claims.hpp"
#include "proofs_checks/instruments/punch.hpp"
#include "proofs_checks/instruments/trial.hpp"

namespace steadyslide::proofs_checks {
namespace {

using numeric::RiemannHilbertForm;
using numeric::RiemannHilbertSolution;
using numeric::SurfacePoint;

/// A profile of two pieces that meet at c, and where its contact may be.
struct Corner {
  std::string name;
  ContactProblem problem;
  std::vector<numeric::ContactInterval> zones;
  int theta;     ///< its sign, where t <= 0 leaves it open
  bool is_jump;  ///< does the friction jump at c?
};

Corner corner(std::string name, const Rational& rear, const Rational& front, const Polynomial& left,
              const Polynomial& right, const Rational& load, int theta = 1) {
  const Rational c(1, 8);
  const FrictionProfile friction = rear == front ? FrictionProfile({rear}) : FrictionProfile({rear, front}, {c});
  return {std::move(name),
          ContactProblem(Elasticity(Solid(Rational(3, 10), 1)), friction,
                         Indenter(-4, {{c, left.composed(1, -c)}, {4, right.composed(1, -c)}}), load),
          {{-0.7, 0.6, false, false}},
          theta,
          rear != front};
}

const Rational third(1, 3);

std::vector<Corner> jump_corners(const Context& context) {
  std::vector<Corner> all{
      corner("wedge, friction rises", third, 3, Polynomial({0, -1, 1}), Polynomial({0, third, 2}), 6),
      corner("wedge, friction falls", 3, third, Polynomial({0, -third, 1}), Polynomial({0, 1, 2}), 6)};
  if (context.quick) return all;
  all.push_back(
      corner("notch, friction rises", third, 3, Polynomial({0, Rational(1, 8), 1}), Polynomial({0, 0, 1}), 12));
  all.push_back(corner("wedge, friction falls, power of the other sign", 3, third, Polynomial({0, -3, 1}),
                       Polynomial({0, 3, 1}), 2, -1));
  all.push_back(corner("curvature, friction falls", 3, third, Polynomial({0, 0, 1}), Polynomial({0, 0, 2}), 6));
  return all;
}

std::vector<Corner> plain_corners(const Context& context) {
  std::vector<Corner> all{corner("wedge", 2, 2, Polynomial({0, -1, 1}), Polynomial({0, third, 2}), 6)};
  if (context.quick) return all;
  all.push_back(corner("wedge without friction", 0, 0, Polynomial({0, -third, 1, -third}), Polynomial({0, 1, 1}), 6));
  all.push_back(corner("curvature", 1, 1, Polynomial({0, 0, 1}), Polynomial({0, 0, 2}), 6));
  return all;
}

/// (t - D(x) (times (log d log_factor) + step)) / (cosine d^power), D = psi'_+ - psi'_- over c, goes to `limit` at c.
template <class R>
struct CornerSaid {
  std::shared_ptr<const RiemannHilbertSolution<R>> solution;
  numeric::SolvedSingularPoint<R> point;
  bool is_wedge = false;
  std::size_t j = 0;
  R power = 0;
  R log_factor = 0;
  R step[2] = {R(0), R(0)};
  R cosine[2] = {R(1), R(1)};
  R limit = 0;
  bool continued = true;  ///< D(x), not D(c)
};
using CornerFormula = Formula<CornerSaid, Corner>;

template <Real R>
CornerSaid<R> said_of(const Corner& c) {
  CornerSaid<R> said{solved<R>(c.problem, c.zones), {}};
  while (!said.solution->form().is_kinked(said.j)) ++said.j;
  const R x = numeric::to_real<R>(c.problem.indenter().pieces().front().to);
  said.point.x.value = x;
  for (const auto& point : said.solution->singular_points()) {
    if (point.x.value != x) continue;
    said.point = point;
    said.is_wedge = true;
  }
  return said;
}

CornerFormula jump_formula() {
  return CornerFormula::from([]<Real R>(const Corner& c) {
    CornerSaid<R> said = said_of<R>(c);
    const Rational rear = c.problem.coupled_friction(0);
    const Rational front = c.problem.coupled_friction(1);
    said.power = numeric::to_real<R>(Exponent::angle(rear) - Exponent::angle(front));
    said.step[0] = said.step[1] = numeric::to_real<R>(1 / (front - rear));
    said.cosine[0] = numeric::cos_pi_alpha<R>(rear);
    said.cosine[1] = numeric::cos_pi_alpha<R>(front);
    said.limit = -said.point.intensity.value;
    return said;
  });
}

CornerFormula plain_formula() {
  return CornerFormula::from([]<Real R>(const Corner& c) {
    CornerSaid<R> said = said_of<R>(c);
    const Rational s = c.problem.coupled_friction(0);
    const R over = numeric::to_real<R>(1 / (1 + s * s));
    said.log_factor = over / numeric::pi<R>();
    said.step[1] = numeric::to_real<R>(s) * over;
    // Where only the curvature jumps there is a value, and no entry in the list of singular points.
    said.limit = said.is_wedge ? said.point.constant.value
                               : said.solution->at(c.problem.indenter().pieces().front().to).traction.right.value;
    return said;
  });
}

/// What is left of t at the distance d from c.
template <Real R>
R regular_part(const CornerSaid<R>& said, Side side, const R& d) {
  using std::log, std::pow;
  const RiemannHilbertForm<R>& form = said.solution->form();
  const SurfacePoint<R> at = numeric::beside(form.set(), said.j, side, R(d / numeric::to_real<R>(Trial::frame().unit)));
  const ContactProblem& problem = form.problem().problem();
  const R& c = said.point.x.value;
  const R x = !said.continued ? c : side == Side::left ? R(c - d) : R(c + d);
  const R difference = slope<R>(problem, R(c + 1), x) - slope<R>(problem, R(c - 1), x);
  const std::size_t i = side == Side::left ? 0 : 1;
  R singular = said.step[i];
  if (said.log_factor != 0) singular += said.log_factor * log(d);
  return (form.traction(at).value - difference * singular) / (said.cosine[i] * pow(d, said.power));
}

template <Real R>
void check_corner(Findings& findings, const CornerSaid<R>& said) {
  using std::abs, std::max;
  const Quantity across{"t without its singular part, across c",
                        {"continued from one side by polynomials", "values on the other side"},
                        tolerance<R>()};
  const Quantity at_c{"t without its singular part, at c",
                      {"continued from both sides by polynomials", "-theta or the constant that the solver gives"},
                      tolerance<R>()};
  std::vector<R> left, right;
  for (int i = 1; i <= extrapolation_values<R>; ++i) {
    left.push_back(regular_part(said, Side::left, R(i * extrapolation_step<R>())));
    right.push_back(regular_part(said, Side::right, R(i * extrapolation_step<R>())));
  }
  const auto compare = [&](const Quantity& quantity, const R& a, const R& b) {
    findings.compare(quantity, static_cast<double>(R(abs(a - b) / max({R(abs(a)), R(abs(b)), R(1)}))));
  };
  compare(at_c, extrapolated(left, 0), said.limit);
  compare(at_c, extrapolated(right, 0), said.limit);
  for (const int to : {1, 2}) {
    compare(across, extrapolated(left, to), right[static_cast<std::size_t>(to - 1)]);
    compare(across, extrapolated(right, to), left[static_cast<std::size_t>(to - 1)]);
  }
}

/// The signs that t <= 0 forces.
template <Real R>
void check_signs(Findings& findings, const CornerSaid<R>& said, const Corner& c) {
  const R& x = said.point.x.value;
  const R d = slope<R>(c.problem, R(x + 1), x) - slope<R>(c.problem, R(x - 1), x);
  const R expected = d * said.step[1];
  if (!c.is_jump) {
    findings.require(d >= 0, "a wedge in the contact that points away from the body");
    return;
  }
  const R& theta = said.point.intensity.value;
  if (said.power < 0 || expected == 0) findings.require(theta >= 0, "theta < 0 where t <= 0 forbids it");
  if (said.power > 0) findings.require(expected <= 0, "a positive constant where t <= 0 forbids it");
  findings.require((theta > 0) == (c.theta > 0), "theta has not the sign that this case is to show");
}

std::vector<Evidence> check(const Context& context, const CornerFormula& formula, const std::vector<Corner>& corners) {
  const numeric::Digits digits = std::max(context.digits, numeric::Digits::fifty);
  const auto walk = [&]<Real R>() -> std::vector<Evidence> {
    if constexpr (std::same_as<R, double>) {
      return {};
    } else {
      Findings findings;
      for (const Corner& c : corners) {
        findings.begin_case(c.name + ": " + text_of(c.problem));
        const CornerSaid<R> said = formula.at<R>(c);
        check_corner(findings, said);
        check_signs(findings, said, c);
        // What is continued across c is the solver's own form: that it satisfies the equation, another rule says. In a
        // quick run in double: that rule costs more than all else.
        if (!context.quick) check_equation(findings, said.solution->form());
        if (context.quick) check_equation(findings, solved<double>(c.problem, c.zones)->form());
      }
      return findings.evidence(std::to_string(corners.size()) + " solved problems");
    }
  };
  return gather([&] { return numeric::at_precision(digits, walk); });
}

Claim wedge_and_jump() {
  const CornerFormula right = jump_formula();
  return make_claim(
      claim_text("thm-02-solved-wedge-and-jump"),
      [](const Context& context, const CornerFormula& formula) {
        return check(context, formula, jump_corners(context));
      },
      right,
      std::vector<Wrong<CornerFormula>>{
          {"[s] of the other sign", right.changed([](auto& said, const Corner&) {
             for (auto& s : said.step) s = -s;
           })},
          {"beta = alpha_+ - alpha_-", right.changed([](auto& said, const Corner&) { said.power = -said.power; })},
          {"the constant D/[s] missing",
           right.changed([](auto& said, const Corner&) { said.step[0] = said.step[1] = 0; })},
          {"cos(pi alpha) of the other side",
           right.changed([](auto& said, const Corner&) { std::swap(said.cosine[0], said.cosine[1]); })},
          {"D(c)/[s] instead of D(x)/[s]", right.changed([](auto& said, const Corner&) { said.continued = false; })},
          {"B(c) = +theta", right.changed([](auto& said, const Corner&) { said.limit = -said.limit; })},
          {"near miss: beta moved by ten times the tolerance",
           right.changed([]<class R>(CornerSaid<R>& said, const Corner&) { said.power += near_miss<R>(); })},
          {"near miss: theta moved by ten times the tolerance",
           right.changed([]<class R>(CornerSaid<R>& said, const Corner&) { said.limit *= 1 + near_miss<R>(); })}});
}

Claim wedge() {
  const CornerFormula right = plain_formula();
  return make_claim(
      claim_text("thm-09-solved-wedge"),
      [](const Context& context, const CornerFormula& formula) {
        return check(context, formula, plain_corners(context));
      },
      right,
      std::vector<Wrong<CornerFormula>>{
          {"H(c-x) instead of H(x-c)",
           right.changed([](auto& said, const Corner&) { std::swap(said.step[0], said.step[1]); })},
          {"1/(1+s^2) missing", right.changed([](auto& said, const Corner&) {
             const auto& s = said.solution->problem().s(0);
             said.log_factor *= 1 + s * s;
             said.step[1] *= 1 + s * s;
           })},
          {"the logarithm with the other sign",
           right.changed([](auto& said, const Corner&) { said.log_factor = -said.log_factor; })},
          {"1/pi missing",
           right.changed([]<class R>(CornerSaid<R>& said, const Corner&) { said.log_factor *= numeric::pi<R>(); })},
          {"D(c) instead of D(x)", right.changed([](auto& said, const Corner&) { said.continued = false; })},
          {"near miss: the logarithm moved by ten times the tolerance",
           right.changed([]<class R>(CornerSaid<R>& said, const Corner&) { said.log_factor *= 1 + near_miss<R>(); })},
          {"near miss: the constant moved by ten times the tolerance",
           right.changed([]<class R>(CornerSaid<R>& said, const Corner&) {
             said.limit += near_miss<R>() * std::max(R(1), R(-said.limit));
           })}});
}

}  // namespace

std::vector<Claim> corner_claims() { return {wedge_and_jump(), wedge()}; }

}  // namespace steadyslide::proofs_checks
