// Checks the decomposition of a solution in the proof of theorem 9. [Bal16, theorem 9]
//
//   t = L(phi) + L(psi - phi) + L(u - psi) - P t_0,   phi' = psi'(c-) left and psi'(c+) right of c.

#include "proofs_checks/instruments/operators/inverse_operator.hpp"
#include "proofs_checks/instruments/solutions/local_behaviour.hpp"
#include "proofs_checks/instruments/solutions/trial.hpp"
#include "proofs_checks/instruments/tractions/punch.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::thm_09_proof_decomposition {
namespace {

/// A reduced problem on [-1, 1] with a wedge at c and constant friction.
struct WedgeProblem {
  std::string name;
  ContactProblem problem;
  bool full_contact;

  Rational c() const { return problem.indenter().pieces().front().to; }
  Rational slope_at_c(std::size_t piece) const { return problem.indenter().pieces()[piece].profile.derivative()(c()); }
  Rational s() const { return s_of(problem, 0); }
};

CaseList<WedgeProblem> problems(const Context&) {
  const Rational c(1, 8);
  const Rational curve(1, 4);
  const Polynomial left({0, Rational(-1, 4), curve});
  const Polynomial right({0, Rational(1, 3), curve, Rational(1, 5)});
  const auto joined = [&](const Polynomial& p) { return p + Polynomial({-p(c)}); };
  return {{{"full contact",
            {Elasticity::reduced(Rational(1, 2)), FrictionProfile({2}),
             Indenter(-1, {{c, joined(left)}, {1, joined(right)}}), 20},
            true},
           {"free ends", cell_case("wedge"), false}},
          "a problem in full contact, one with free ends"};
}

/// The formula t = L(phi) + rest L(psi - phi) + beyond L(u - psi) + load P t_0; L(phi) ~ logarithm D/(1+s^2)
/// log|x-c|/pi.
struct Decomposition {
  int rest = 1;
  int beyond = 1;
  Number load = -1;
  int logarithm = 1;
  int step = 1;  ///< sign of the step of L(phi) at c
};

/// The terms at one point of the contact.
template <class R>
struct Terms {
  R phi;
  R rest;    ///< L(psi - phi)
  R beyond;  ///< L(u - psi)
  R load;    ///< P t_0
  R traction;
};
/// L(phi) close to c.
template <class R>
struct AtCorner {
  std::array<R, 2> logarithm;  ///< coefficients of the logarithm, left and right
  R step;
  double others;  ///< relative difference of the other terms across c
};
template <class R>
struct Measured {
  std::vector<Terms<R>> terms;
  std::optional<AtCorner<R>> at_corner;  ///< only in full contact
};

/// Returns t_0(x) from the distances to -1 and 1.
template <Real R>
R unit_solution(const Rational& s, const R& from_rear, const R& from_front) {
  using std::pow;
  const Exponent alpha = Exponent::angle(s);
  return cos_pi_alpha<R>(s) / numeric::pi<R>() * pow(from_rear, to_real<R>(-(half + alpha))) *
         pow(from_front, to_real<R>(-(half - alpha)));
}

template <Real R>
std::vector<SlopePanel<R>> panels_of(const RiemannHilbertSolution<R>& solution) {
  const auto& set = solution.form().set();
  const R unit = to_real<R>(solution.problem().frame().unit);
  std::vector<SlopePanel<R>> panels;
  R left = -1;
  for (std::size_t k = 0; k < set.segments(); ++k) {
    const R length = unit * set.length(k);
    panels.push_back({left, length, {R(0), R(1)}, {R(0), R(1)}, [](const auto&) { return R(0); }});
    left += length;
  }
  return panels;
}

/// Sets u' - psi' beyond the contact: a power at the contact's end, smooth at the end of the support.
template <Real R>
void set_beyond(SlopePanel<R>& panel, const RiemannHilbertSolution<R>& solution, std::size_t end, Side side) {
  const auto& form = solution.form();
  const numeric::Power<R> power = form.fundamental_solution().powers()[end];
  (side == Side::left ? panel.at_right : panel.at_left) = power;
  panel.smooth = [&form, end, side, power](const Node<R>& node) {
    using std::pow;
    const R d = side == Side::left ? node.from_right : node.from_left;
    const auto at = beside(form, end, side, d);
    const R slope = form.surface_slope(at).value -
                    form.problem().slope(form.slope_at(static_cast<std::size_t>(at.segment)), at.node.x);
    return R(slope / pow(d, power.value));
  };
}

template <Real R>
std::vector<Terms<R>> terms_of(const WedgeProblem& w, const RiemannHilbertSolution<R>& solution) {
  const auto& pieces = w.problem.indenter().pieces();
  const std::vector<SlopePanel<R>> empty = panels_of(solution);
  std::vector<SlopePanel<R>> phi = empty, rest = empty, beyond = empty;
  const std::size_t corner = point_at(solution, w.c());
  for (std::size_t k = 0; k < empty.size(); ++k) {
    const Polynomial slope = pieces[k < corner ? 0 : 1].profile.derivative();
    const R at_corner = to_real<R>(slope(w.c()));
    phi[k].smooth = [at_corner](const auto&) { return at_corner; };
    rest[k].smooth = [slope, at_corner](const Node<R>& node) { return R(value_of(slope, node.x) - at_corner); };
  }
  const std::size_t left = contact_end(solution, Side::left);
  const std::size_t right = contact_end(solution, Side::right);
  if (left > 0) set_beyond(beyond[left - 1], solution, left, Side::left);
  if (right < empty.size()) set_beyond(beyond[right], solution, right, Side::right);
  const InverseOperator<R> of_phi(w.s(), phi), of_rest(w.s(), rest), of_beyond(w.s(), beyond);
  std::vector<Terms<R>> terms;
  for (std::size_t k = left; k < right; ++k) {
    for (const int percent : {30, 98}) {
      const auto at = of_phi.point(k, R(percent) / 100);
      const R from_rear = at.node.from_left + (empty[k].left + 1);
      const R t = traction_beside(solution, k, Side::right, at.node.from_left);
      terms.push_back({of_phi.at(at), of_rest.at(at), left > 0 ? of_beyond.at(at) : R(0),
                       R(to_real<R>(w.problem.load()) * unit_solution<R>(w.s(), from_rear, R(2 - from_rear))), t});
    }
  }
  return terms;
}

/// Returns L(phi) close to c, from L(phi) on the whole of [-1, 1] as a Riemann-Hilbert form without load.
template <Real R>
AtCorner<R> at_corner(const WedgeProblem& w, const RiemannHilbertSolution<R>& solution) {
  using std::abs, std::log;
  const Rational c = w.c();
  const auto linear = [&](std::size_t k) { return Polynomial({-w.slope_at_c(k) * c, w.slope_at_c(k)}); };
  const ContactProblem of_phi = w.problem.with_indenter(Indenter(-1, {{c, linear(0)}, {1, linear(1)}})).with_load(1);
  const TrialForm<R> trial({"", of_phi, {{Trial::in_frame(-1), Trial::in_frame(1), true, true}}, {0}, 0});
  const std::size_t j = point_at(solution, c);
  const R d = asymptotic_distance<R>();
  const auto first = [&](Side side, const R& at) {
    return trial.form().traction(beside(trial.form(), j, side, at)).value;
  };
  const auto logarithm = [&](Side side) {
    return R(numeric::pi<R>() * (first(side, R(2 * d)) - first(side, d)) / log(R(2)));
  };
  const auto others = [&](Side side) { return R(traction_beside(solution, j, side, d) - first(side, d)); };
  const R left = others(Side::left);
  return {{logarithm(Side::left), logarithm(Side::right)},
          first(Side::right, d) - first(Side::left, d),
          static_cast<double>(abs(R(others(Side::right) - left)) / abs(left))};
}

template <Real R>
Measured<R> measure(const WedgeProblem& w) {
  const auto solution = solve<R>(w.problem);
  Measured<R> found{terms_of<R>(w, *solution), {}};
  if (w.full_contact) found.at_corner = at_corner<R>(w, *solution);
  return found;
}

template <Real R>
void check(Findings& findings, const Decomposition& said, const WedgeProblem& w, const Measured<R>& found) {
  using std::abs, std::max;
  for (const Terms<R>& term : found.terms) {
    const R sum = term.phi + said.rest * term.rest + said.beyond * term.beyond + R(said.load) * term.load;
    findings.compare("sum", sum, term.traction,
                     max({R(abs(term.phi)), R(abs(term.rest)), R(abs(term.load)), R(abs(term.traction))}));
  }
  if (!found.at_corner) return;
  const R s = to_real<R>(w.s());
  const R coefficient = said.logarithm * to_real<R>(w.slope_at_c(1) - w.slope_at_c(0)) / (1 + s * s);
  for (const R& logarithm : found.at_corner->logarithm) findings.compare("logarithm", logarithm, coefficient);
  findings.compare("step", found.at_corner->step, R(said.step * s * coefficient));
  findings.compare("others", found.at_corner->others);
}

}  // namespace

Claim claim() {
  return formula_claim<WedgeProblem, Decomposition>("thm-09-proof-decomposition")
      .cases(problems)
      .precision(Precision::quick_in_double)
      .checked([kept = std::make_shared<KeptForCases>()]<Real R>(Findings& findings, const Decomposition& said,
                                                                 const WedgeProblem& w) {
        check(findings, said, w, kept->at(w, [&] { return measure<R>(w); }));
      })
      .wrong("`P t_0` added", &Decomposition::load, 1)
      .wrong("`P t_0` left out", &Decomposition::load, 0)
      .wrong("`L(psi - phi)` left out", &Decomposition::rest, 0)
      .wrong("`L(u - psi)` left out", &Decomposition::beyond, 0)
      .wrong("the logarithm in another term", &Decomposition::logarithm, 0)
      .wrong("the step's sign", &Decomposition::step, -1)
      .near_miss("`P t_0`", &Decomposition::load);
}

}  // namespace steadyslide::proofs_checks::thm_09_proof_decomposition
