// How the proof of theorem 9 takes a solution apart. [Bal16, theorem 9]
//
//   t = L(phi) + L(psi - phi) + L(u - psi) - P t_0,   phi' = psi'(c-) left and psi'(c+) right of c.

#include "numeric/number/polynomial.hpp"
#include "proofs_checks/instruments/operators/inverse_operator.hpp"
#include "proofs_checks/instruments/solutions/near.hpp"
#include "proofs_checks/instruments/solutions/trial.hpp"

namespace steadyslide::proofs_checks {
namespace {

/// Reduced, on [-1, 1], a wedge at c and constant friction.
struct WedgeProblem {
  std::string name;
  ContactProblem problem;
  Rational c;
};

std::vector<WedgeProblem> problems() {
  const Rational c(1, 8);
  const Rational curve(1, 4);
  const Polynomial left({0, Rational(-1, 4), curve});
  const Polynomial right({0, Rational(1, 3), curve, Rational(1, 5)});
  const auto joined = [&](const Polynomial& p) { return p + Polynomial({-p(c)}); };
  return {{"full contact",
           {Elasticity::reduced(Rational(1, 2)), FrictionProfile({2}),
            Indenter(-1, {{c, joined(left)}, {1, joined(right)}}), 20},
           c},
          {"free ends", cell_case("wedge"), Rational(-1, 7)}};
}

/// At one place of the contact.
template <class R>
struct Terms {
  R phi;
  R rest;    ///< L(psi - phi)
  R beyond;  ///< L(u - psi)
  R load;    ///< P t_0
  R traction;
};
template <class R>
struct Decomposition {
  std::string name;
  std::vector<Terms<R>> terms;
};
template <class R>
struct DecompositionFacts {
  std::vector<Decomposition<R>> problems;
  // Of the one in full contact, next to c.
  R wedge;
  R s;
  R logarithm[2];  ///< of L(phi)
  R step;
  R others;  ///< what the other terms differ by across c, over their size
};

/// t_0(x) with its distances to -1 and 1.
template <Real R>
R unit_solution(const Rational& s, const R& from_rear, const R& from_front) {
  using std::pow;
  const Exponent alpha = Exponent::angle(s);
  return numeric::cos_pi_alpha<R>(s) / numeric::pi<R>() * pow(from_rear, numeric::to_real<R>(-(half + alpha))) *
         pow(from_front, numeric::to_real<R>(-(half - alpha)));
}

template <Real R>
std::vector<SlopePanel<R>> panels_of(const numeric::RiemannHilbertSolution<R>& solution) {
  const auto& set = solution.form().set();
  const R unit = numeric::to_real<R>(solution.problem().frame().unit);
  std::vector<SlopePanel<R>> panels;
  R left = -1;
  for (std::size_t k = 0; k < set.segments(); ++k) {
    const R length = unit * set.length(k);
    panels.push_back({left, length, {R(0), R(1)}, {R(0), R(1)}, [](const auto&) { return R(0); }});
    left += length;
  }
  return panels;
}

/// u' - psi' beyond the contact: a power at its end, beside the support's own end where it is smooth.
template <Real R>
void set_beyond(SlopePanel<R>& panel, const numeric::RiemannHilbertSolution<R>& solution, std::size_t end, Side side) {
  const auto& form = solution.form();
  const numeric::Power<R> power = form.fundamental_solution().powers()[end];
  (side == Side::left ? panel.at_right : panel.at_left) = power;
  panel.smooth = [&form, end, side, power](const numeric::Node<R>& node) {
    using std::pow;
    const R d = side == Side::left ? node.from_right : node.from_left;
    const auto at = beside(form, end, side, d);
    const R slope = form.surface_slope(at).value -
                    form.problem().slope(form.slope_at(static_cast<std::size_t>(at.segment)), at.node.x);
    return R(slope / pow(d, power.value));
  };
}

template <Real R>
Decomposition<R> decompose(const WedgeProblem& w) {
  const auto solution = solve<R>(w.problem);
  const Rational s = w.problem.coupled_friction(0);
  const auto& pieces = w.problem.indenter().pieces();
  const std::vector<SlopePanel<R>> empty = panels_of(*solution);
  std::vector<SlopePanel<R>> phi = empty, rest = empty, beyond = empty;
  const std::size_t corner = point_at(*solution, w.c);
  for (std::size_t k = 0; k < empty.size(); ++k) {
    const Polynomial slope = pieces[k < corner ? 0 : 1].profile.derivative();
    const R at_corner = numeric::to_real<R>(slope(w.c));
    phi[k].smooth = [at_corner](const auto&) { return at_corner; };
    rest[k].smooth = [slope, at_corner](const numeric::Node<R>& node) {
      return R(numeric::value_of(slope, node.x) - at_corner);
    };
  }
  const std::size_t left = contact_end(*solution, Side::left);
  const std::size_t right = contact_end(*solution, Side::right);
  if (left > 0) set_beyond(beyond[left - 1], *solution, left, Side::left);
  if (right < empty.size()) set_beyond(beyond[right], *solution, right, Side::right);
  const InverseOperator<R> of_phi(s, phi), of_rest(s, rest), of_beyond(s, beyond);
  Decomposition<R> result{w.name, {}};
  for (std::size_t k = left; k < right; ++k) {
    for (const int percent : {30, 98}) {
      const auto at = of_phi.point(k, R(percent) / 100);
      const R from_rear = at.node.from_left + (empty[k].left + 1);
      const R t = traction_beside(*solution, k, Side::right, at.node.from_left);
      result.terms.push_back(
          {of_phi.at(at), of_rest.at(at), left > 0 ? of_beyond.at(at) : R(0),
           R(numeric::to_real<R>(w.problem.load()) * unit_solution<R>(s, from_rear, R(2 - from_rear))), t});
    }
  }
  return result;
}

/// L(v) on the whole of [-1, 1] as a Riemann-Hilbert form without load.
template <Real R>
void measure_logarithm(DecompositionFacts<R>& facts, const WedgeProblem& w) {
  using std::abs, std::log;
  const auto& pieces = w.problem.indenter().pieces();
  const auto linear = [&](std::size_t k) { return Polynomial({0, pieces[k].profile.derivative()(w.c)}); };
  const auto in_frame = [](const Rational& x) {
    return numeric::to_real<double>((x - Trial::frame().origin) / Trial::frame().unit);
  };
  const ContactProblem of_phi = w.problem
                                    .with_indenter(Indenter(-1, {{w.c, linear(0) + Polynomial({-linear(0)(w.c)})},
                                                                 {1, linear(1) + Polynomial({-linear(1)(w.c)})}}))
                                    .with_load(1);
  const TrialForm<R> trial({"", of_phi, {{in_frame(-1), in_frame(1), true, true}}, {0}, 0});
  const auto solution = solve<R>(w.problem);
  const std::size_t j = point_at(*solution, w.c);
  const R d = very_near<R>();
  const auto first = [&](Side side, const R& at) {
    return trial.form().traction(beside(trial.form(), j, side, at)).value;
  };
  const auto others = [&](Side side) { return R(traction_beside(*solution, j, side, d) - first(side, d)); };
  const Rational wedge = pieces[1].profile.derivative()(w.c) - pieces[0].profile.derivative()(w.c);
  facts.wedge = numeric::to_real<R>(wedge);
  facts.s = numeric::to_real<R>(w.problem.coupled_friction(0));
  for (const Side side : {Side::left, Side::right}) {
    facts.logarithm[side == Side::left ? 0 : 1] =
        numeric::pi<R>() * (first(side, R(2 * d)) - first(side, d)) / log(R(2));
  }
  facts.step = first(Side::right, d) - first(Side::left, d);
  facts.others = abs(R(others(Side::right) - others(Side::left))) / abs(others(Side::left));
}

struct DecompositionSaid {
  int load_sign = -1;
  bool rest = true;
  bool beyond = true;
  bool in_first = true;  ///< the logarithm
  int step_sign = 1;
  int miss = 0;
};

template <Real R>
void check_terms(Findings& findings, const Decomposition<R>& all, const DecompositionSaid& said) {
  using std::abs, std::max;
  const Quantity sum{"the four terms", {"(10) by quadrature", "t, solved"}, tolerance<R>()};
  findings.begin_case(all.name);
  for (const Terms<R>& term : all.terms) {
    R value = term.phi + said.load_sign * term.load * (1 + said.miss * R(tolerance<R>()));
    if (said.rest) value += term.rest;
    if (said.beyond) value += term.beyond;
    const R size = max({R(abs(term.phi)), R(abs(term.rest)), R(abs(term.load)), R(abs(term.traction))});
    findings.compare(sum, static_cast<double>(R(abs(value - term.traction) / size)));
  }
}

std::vector<Evidence> check(const Context& context, Once<DecompositionFacts>& once, const DecompositionSaid& said) {
  return gather_quick_in_double(context, [&]<Real R>() {
    const Quantity logarithm{
        "coefficient of log|x-c|/pi in L(phi)", {"its form without load", "D/(1+s^2)"}, tolerance<R>()};
    const Quantity step{"step of L(phi) at c", {"its form without load", "s D/(1+s^2)"}, tolerance<R>()};
    const Quantity others{"step of the other three terms at c", {"t - L(phi), solved", "0"}, tolerance<R>()};
    const DecompositionFacts<R>& facts = once.at<R>(context.quick, [] {
      DecompositionFacts<R> found;
      for (const WedgeProblem& w : problems()) found.problems.push_back(decompose<R>(w));
      measure_logarithm(found, problems().front());
      return found;
    });
    Findings findings;
    for (const Decomposition<R>& all : facts.problems) check_terms(findings, all, said);
    findings.begin_case("full contact, next to c");
    const R coefficient = said.in_first ? R(facts.wedge / (1 + facts.s * facts.s)) : R(0);
    for (const R& found : facts.logarithm) findings.compare(logarithm, relative_difference<R>(found, coefficient));
    findings.compare(step, relative_difference<R>(facts.step, R(said.step_sign * facts.s * coefficient)));
    findings.compare(others, static_cast<double>(facts.others));
    return findings.evidence("a problem in full contact, one with free ends");
  });
}

}  // namespace

// In its plain form: the terms to be added up are measured themselves, all on one solution.
Claim thm_09_proof_decomposition() {
  return make_claim(
      claim_text("thm-09-proof-decomposition"),
      [once = std::make_shared<Once<DecompositionFacts>>()](const Context& context, const DecompositionSaid& said) {
        return check(context, *once, said);
      },
      DecompositionSaid{},
      std::vector<Wrong<DecompositionSaid>>{
          {"P t_0 added", changed<DecompositionSaid>([](DecompositionSaid& said) { said.load_sign = 1; })},
          {"P t_0 left out", changed<DecompositionSaid>([](DecompositionSaid& said) { said.load_sign = 0; })},
          {"L(psi - phi) left out", changed<DecompositionSaid>([](DecompositionSaid& said) { said.rest = false; })},
          {"L(u - psi) left out", changed<DecompositionSaid>([](DecompositionSaid& said) { said.beyond = false; })},
          {"the logarithm in another term",
           changed<DecompositionSaid>([](DecompositionSaid& said) { said.in_first = false; })},
          {"the step's sign", changed<DecompositionSaid>([](DecompositionSaid& said) { said.step_sign = -1; })},
          {"near miss: P t_0 moved by ten times the tolerance",
           changed<DecompositionSaid>([](DecompositionSaid& said) { said.miss = 10; })}});
}

}  // namespace steadyslide::proofs_checks
