// Checks the conditions of contact on solutions by a rule that was not used to find them. [Bal16, (3)]

#include <algorithm>

#include "numeric/cauchy/residuals.hpp"
#include "numeric/riemann_hilbert/riemann_hilbert.hpp"
#include "proofs_checks/instruments/cells/cells.hpp"
#include "proofs_checks/instruments/solutions/local_behaviour.hpp"
#include "proofs_checks/instruments/solutions/trial.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::eq_03_complementarity {
namespace {

using numeric::ContactState;

/// The traction that is checked as the solution.
struct Candidate {
  enum class Which {
    solution,
    moved_end,     ///< the first free end in another position
    too_short,     ///< edges inside the contact; equation and load hold
    too_long,      ///< edges outside of the contact; equation and load hold
    full_contact,  ///< contact over the notch too; no sampled point shows that the corner pulls
    unsolved       ///< solution of a problem that has none in double
  } which = Which::solution;
  Number by = Number(1) / 100;  ///< distance by which an end moves, divided by the contact's length
  Number factor = 1;            ///< factor of the traction
};

/// Returns a notch over a rising friction jump, under seven tenths of the load that closes it. In full contact the
/// amplitude of the power would pull on 10^-11 of the contact. Without the jump, and under a heavy load, the gap would
/// be shorter than any number.
ContactProblem notch(bool solvable) {
  const Rational flank(1, 5);
  return {Elasticity(Solid(Rational(1, 5), 1)),
          solvable ? FrictionProfile({Rational(1, 10), Rational(1, 2)}, {0}) : FrictionProfile({Rational(1, 2)}, {}),
          Indenter(-1, {{0, Polynomial({0, flank})}, {1, Polynomial({0, -flank})}}),
          solvable ? Rational(3029, 1000) : Rational(1000), Sliding::plus_x};
}

/// Returns a profile with one well, or with two under a small load, which mostly gives two components.
ContactProblem random_problem(Random& random, std::size_t k) {
  CellFrictionSteps steps = random_steps(random, Trend::any, 2, k == 0 ? 1 : 3);
  if (k % 2 == 1) steps = mirrored(steps);
  const bool two = k % 3 == 2;
  const Rational load = two ? random.between(Rational(1, 200), Rational(1, 50)) : random.between(Rational(1, 8), 1);
  const Polynomial wells({0, random.between(Rational(-1, 50), Rational(1, 50)), random.between(-2, -1), 0, 2});
  return cell_problem(steps, two ? wells : random_profile(random, true), load);
}

CaseList<ContactProblem> problems(const Context& context) {
  auto list = random_cases(context, "eq-03-complementarity", 9, 1,
                           "random frictions, profiles with one and two wells and loads", random_problem);
  list.cases.push_back(notch(true));
  list.detail += "; a notch over a jump";
  return list;
}

/// Returns the problem on a shorter or longer support.
ContactProblem on_support(const ContactProblem& p, const Rational& left, const Rational& right) {
  const std::vector<Rational>& values = p.friction().values();
  const std::vector<Rational>& jumps = p.friction().jumps();
  const auto first = std::ranges::upper_bound(jumps, left) - jumps.begin();
  const auto last = std::ranges::lower_bound(jumps, right) - jumps.begin();
  return p
      .with_friction(FrictionProfile({values.begin() + first, values.begin() + last + 1},
                                     {jumps.begin() + first, jumps.begin() + last}))
      .with_indenter(Indenter(left, {{right, p.indenter().pieces().front().profile}}));
}

/// A form with all data that it points to.
template <class R>
struct Held {
  std::shared_ptr<const RiemannHilbertSolution<R>> solution;
  std::optional<ContactProblem> problem;  ///< the problem on another support
  std::optional<numeric::RoundedProblem<R>> reduced;
  numeric::JacobiRules<R> rules;
  std::optional<TractionRepresentation<R>> form;

  /// Puts the whole support in contact, with edges at both ends.
  void put_edges(const numeric::RoundedProblem<R>& on) {
    const auto left = static_cast<double>(on.anchors().front().x);
    const auto right = static_cast<double>(on.anchors().back().x);
    auto state = ContactState<R>::initial(on, ContactSet<R>(on, {{left, right, true, true}}), R(0));
    form.emplace(on, std::move(state.set), std::move(state.q), state.tilt, rules);
  }
};

template <Real R>
std::unique_ptr<Held<R>> hold(const ContactProblem& problem, const Candidate& candidate) {
  using Which = Candidate::Which;
  auto held = std::make_unique<Held<R>>();
  // A problem that is not solved ends the check with the reason. No case is left out.
  held->solution = solve<R>(candidate.which == Which::unsolved ? notch(false) : problem);
  const TractionRepresentation<R>& form = held->solution->form();
  if (candidate.which == Which::too_short || candidate.which == Which::too_long) {
    const auto contact = held->solution->contact();
    const auto left = static_cast<double>(contact.front().left.x.value);
    const auto right = static_cast<double>(contact.back().right.x.value);
    const double by = (right - left) * (candidate.which == Which::too_long ? 0.01 : -0.01);
    held->problem = on_support(problem, Rational(left - by), Rational(right + by));
    held->reduced.emplace(*held->problem, held->solution->problem().frame());
    held->put_edges(*held->reduced);
  } else if (candidate.which == Which::full_contact && !problem.indenter().is_smooth()) {
    held->put_edges(held->solution->problem());
  } else {
    ContactSet<R> set = form.set();
    if (candidate.which == Which::moved_end) {
      std::vector<R> steps(set.movable().size(), R(0));
      steps.front() = set.span_length() * R(candidate.by);
      set.move(steps);
    }
    held->form.emplace(held->solution->problem(), std::move(set), form.q(), form.tilt(), held->rules);
  }
  return held;
}

/// Returns (psi - u)/(c P) at `distance` in xi beyond an end of panel k, measured from this end.
template <Real R>
R opening(const numeric::SurfaceCheck<R>& check, const numeric::Panel<R>& panel, const TractionRepresentation<R>& form,
          const ContactProblem& problem, std::size_t k, Side side, const R& distance) {
  const Frame& frame = form.problem().frame();
  const R unit = to_real<R>(frame.unit);
  const R end = to_real<R>(frame.origin) + unit * (side == Side::left ? panel.left : panel.right);
  const R x = end + (side == Side::left ? R(-unit * distance) : R(unit * distance));
  const R rise = height<R>(problem, x, x) - height<R>(problem, end, end);
  return (rise - unit * check.displacement(k, side, distance)) / to_real<R>(problem.load());
}

/// Returns the number of sides of ends, jumps and wedges at which the traction pulls in the limit. The traction is
/// evaluated at a distance at which the leading term of each local form is larger than the others, at 50 digits by a
/// factor 10^40 if |beta| > 10^-4.
template <Real R>
int pulling_sides(const TractionRepresentation<R>& form, const R& factor) {
  using std::abs, std::pow;
  const R d = pow(R(10), std::same_as<R, double> ? R(-300) : R(-1'000'000));
  const ContactSet<R>& set = form.set();
  int count = 0;
  for (std::size_t k = 0; k < set.segments(); ++k) {
    if (!set.in_contact(k)) continue;
    for (const bool left : {true, false}) {
      const R rest = set.length(k) - d;
      const Estimate<R> t =
          form.traction({static_cast<std::ptrdiff_t>(k), {set.x(left ? k : k + 1), left ? d : rest, left ? rest : d}});
      if (factor * t.value > 4 * abs(factor) * t.error) ++count;
    }
  }
  return count;
}

template <Real R>
void examine(Findings& findings, const ContactProblem& problem, const Candidate& candidate) {
  using std::abs, std::max;
  const Quantity limits{"`t > 0` in the limit at an end, a jump or a wedge (sides)",
                        {"`t` as near as 10^-300 in double, 10^-1000000 with more digits", "0"},
                        0};
  const auto held = hold<R>(problem, candidate);
  const TractionRepresentation<R>& form = *held->form;
  const R factor(candidate.factor);
  PiecewiseDensity<R> density = traction_density(form);
  for (auto& panel : density) {
    panel.smooth = [smooth = panel.smooth, factor](const Node<R>& node) { return R(factor * smooth(node)); };
  }
  const R unit = to_real<R>(form.problem().frame().unit);
  const R origin = to_real<R>(form.problem().frame().origin);
  const auto profile_slope = [&](std::size_t, const Node<R>& node) {
    const R x = origin + unit * node.x;
    return slope<R>(problem, x, x);
  };
  const numeric::SurfaceCheck<R> check(density, friction_of(form), profile_slope);
  const R p = to_real<R>(problem.load()) / unit;
  findings.compare<R>("load", check.integral(), -p);
  findings.compare("tension", R(max(check.highest_traction(), R(0)) * form.set().span_length() / p));
  findings.compare(limits, pulling_sides<R>(form, factor));

  for (std::size_t k = 0; k < density.size(); ++k) {
    const numeric::Panel<R>& panel = density[k].panel;
    const R left = to_real<R>(problem.indenter().left());
    const R right = to_real<R>(problem.indenter().right());
    const auto look = [&](Side side, const R& length, int steps) {
      // If the contact reaches the end of the support, the rest is only rounding.
      if (!(length > 64 * numeric::epsilon<R>() * form.set().span_length())) return;
      for (int i = 1; i < steps; ++i) {
        // The points are denser towards the end of the contact.
        const R d = length * i * i * i * i / (steps * steps * steps * steps);
        const R gap = opening<R>(check, panel, form, problem, k, side, d);
        findings.compare("penetration", static_cast<double>(max(R(-gap), R(0))));
      }
    };
    if (k == 0) look(Side::left, R(panel.left - (left - origin) / unit), 6);
    if (k + 1 == density.size()) {
      look(Side::right, R((right - origin) / unit - panel.right), 6);
    } else if (density[k + 1].gap > 0) {
      look(Side::right, density[k + 1].gap, 6);
      // Both sides are continued to the middle, because the rule has no value at the end of a component.
      const R half = density[k + 1].gap / 2;
      const R from_left = opening<R>(check, panel, form, problem, k, Side::right, half);
      const R from_right = opening<R>(check, density[k + 1].panel, form, problem, k + 1, Side::left, half);
      findings.compare("closure", R(abs(from_left - from_right)));
    }
  }
  // The most expensive check comes last, because controls fail earlier.
  findings.compare("equation", static_cast<double>(check.equation()));
}

}  // namespace

Claim claim() {
  using Which = Candidate::Which;
  return formula_claim<ContactProblem, Candidate>("eq-03-complementarity")
      .cases(problems)
      .precision(Precision::quick_in_double)
      .checked([]<Real R>(Findings& findings, const Candidate& candidate, const ContactProblem& problem,
                          const Context& context) {
        // A full run examines all problems at 50 digits or more.
        if (std::same_as<R, double> && !context.quick) return examine<Real50>(findings, problem, candidate);
        examine<R>(findings, problem, candidate);
      })
      .wrong("an end moved by a hundredth of the contact", &Candidate::which, Which::moved_end)
      .wrong("edges within the contact: equation and load right, but the surface penetrates", &Candidate::which,
             Which::too_short)
      .wrong("edges beyond the contact: equation and load right, but there is tension", &Candidate::which,
             Which::too_long)
      .wrong("full contact over a notch: equation and load right, but the corner pulls on `1e-11` of it",
             &Candidate::which, Which::full_contact)
      .wrong("a problem without solution among the others", &Candidate::which, Which::unsolved)
      .wrong("the traction of another load", &Candidate::factor, Number(11) / 10)
      .wrong("the traction of the other sign", &Candidate::factor, -1)
      .near_miss("an end",
                 [](Candidate& candidate, const Number& step) {
                   candidate.which = Which::moved_end;
                   candidate.by = step;
                 })
      .near_miss("the traction", &Candidate::factor);
}

}  // namespace steadyslide::proofs_checks::eq_03_complementarity
