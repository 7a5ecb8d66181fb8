// The conditions of contact, examined on solutions by a rule that found none of them. [Bal16, (3)]

#include <algorithm>

#include "numeric/cauchy/residuals.hpp"
#include "numeric/riemann_hilbert/riemann_hilbert.hpp"
#include "proofs_checks/instruments/cells/cells.hpp"
#include "proofs_checks/instruments/solutions/near.hpp"
#include "proofs_checks/instruments/solutions/trial.hpp"

namespace steadyslide::proofs_checks {
namespace {

using numeric::ContactSet;
using numeric::ContactState;
using numeric::RiemannHilbertForm;

/// Which traction is held to be the solution.
struct Candidate {
  enum class Which {
    solution,
    moved_end,    ///< the first free end elsewhere
    too_short,    ///< edges within the contact, the equation and the load kept
    too_long,     ///< edges beyond the contact, the equation and the load kept
    full_contact  ///< over the notch too, where no place shows that the corner pulls
  } which = Which::solution;
  bool near_miss = false;  ///< of an end; else a hundredth of the contact
  Rational factor = 1;     ///< of the traction
  bool factor_near_miss = false;
  bool with_unsolved = false;  ///< a problem among the others that has no solution in double
};

/// A notch over a rising jump, seven tenths of the load under which it closes; the power's amplitude pulls on 10^-11 of
/// a full contact. Without the jump, and under a heavy load, the gap would be shorter than any number.
ContactProblem notch(bool solvable) {
  const Rational flank(1, 5);
  return {Elasticity(Solid(Rational(1, 5), 1)),
          solvable ? FrictionProfile({Rational(1, 10), Rational(1, 2)}, {0}) : FrictionProfile({Rational(1, 2)}, {}),
          Indenter(-1, {{0, Polynomial({0, flank})}, {1, Polynomial({0, -flank})}}),
          solvable ? Rational(3029, 1000) : Rational(1000), Sliding::plus_x};
}

/// One well, or two under a small load: mostly two components then.
ContactProblem random_problem(Random& random, std::size_t k) {
  CellFrictionSteps steps = random_steps(random, Trend::any, 2, k == 0 ? 1 : 3);
  if (k % 2 == 1) steps = mirrored(steps);
  const bool two = k % 3 == 2;
  const Rational load = two ? random.between(Rational(1, 200), Rational(1, 50)) : random.between(Rational(1, 8), 1);
  const Polynomial wells({0, random.between(Rational(-1, 50), Rational(1, 50)), random.between(-2, -1), 0, 2});
  return cell_problem(steps, two ? wells : random_profile(random, true), load);
}

/// The problem on a shorter or longer support.
ContactProblem on_support(const ContactProblem& p, const Rational& left, const Rational& right) {
  const FrictionProfile& friction = p.friction();
  std::vector<Rational> jumps;
  std::vector<Rational> kept;
  for (std::size_t k = 0; k <= friction.jumps().size(); ++k) {
    const bool begins = k == 0 || friction.jumps()[k - 1] < right;
    const bool ends = k == friction.jumps().size() || friction.jumps()[k] > left;
    if (!begins || !ends) continue;
    if (!kept.empty()) jumps.push_back(friction.jumps()[k - 1]);
    kept.push_back(friction.values()[k]);
  }
  return {p.elasticity(),
          FrictionProfile(kept, jumps),
          Indenter(left, {{right, p.indenter().pieces().front().profile}}),
          p.load(),
          p.sliding(),
          p.load_at()};
}

/// A form with all that it points to.
template <class R>
struct Held {
  std::shared_ptr<const numeric::RiemannHilbertSolution<R>> solution;
  std::unique_ptr<ContactProblem> problem;
  std::unique_ptr<numeric::ReducedProblem<R>> reduced;
  numeric::JacobiRules<R> rules;
  std::optional<RiemannHilbertForm<R>> form;
};

template <Real R>
std::unique_ptr<Held<R>> hold(const ContactProblem& problem, const Candidate& candidate) {
  auto held = std::make_unique<Held<R>>();
  held->solution = solve<R>(problem);
  const RiemannHilbertForm<R>& form = held->solution->form();
  const bool whole = candidate.which == Candidate::Which::full_contact;
  if (whole && !problem.indenter().is_smooth()) {
    const auto& reduced = held->solution->problem();
    const double left = static_cast<double>(reduced.anchors().front().x);
    const double right = static_cast<double>(reduced.anchors().back().x);
    auto state = ContactState<R>::initial(reduced, ContactSet<R>(reduced, {{left, right, true, true}}), R(0));
    held->form.emplace(reduced, std::move(state.set), std::move(state.q), state.tilt, held->rules);
  } else if (whole || candidate.which == Candidate::Which::solution) {
    held->form.emplace(held->solution->problem(), form.set(), form.q(), form.tilt(), held->rules);
  } else if (candidate.which == Candidate::Which::moved_end) {
    ContactSet<R> set = form.set();
    std::vector<R> steps(set.movable().size(), R(0));
    steps.front() = set.span_length() * (candidate.near_miss ? near_miss<R>() : R(1) / 100);
    set.move(steps);
    held->form.emplace(held->solution->problem(), set, form.q(), form.tilt(), held->rules);
  } else {
    const auto contact = held->solution->contact();
    const double left = static_cast<double>(contact.front().left.x.value);
    const double right = static_cast<double>(contact.back().right.x.value);
    const double by = (right - left) * (candidate.which == Candidate::Which::too_long ? 0.01 : -0.01);
    held->problem = std::make_unique<ContactProblem>(on_support(problem, Rational(left - by), Rational(right + by)));
    held->reduced = std::make_unique<numeric::ReducedProblem<R>>(*held->problem, held->solution->problem().frame());
    const auto& frame = held->reduced->frame();
    const auto in_frame = [&](double x) { return numeric::to_real<double>((Rational(x) - frame.origin) / frame.unit); };
    auto state = ContactState<R>::initial(
        *held->reduced, ContactSet<R>(*held->reduced, {{in_frame(left - by), in_frame(right + by), true, true}}), R(0));
    held->form.emplace(*held->reduced, std::move(state.set), std::move(state.q), state.tilt, held->rules);
  }
  return held;
}

/// psi - u over c P beyond the end of panel k, `distance` from there in xi; both ends of it in the user's x.
template <Real R>
R opening(const numeric::SurfaceCheck<R>& check, const numeric::Panel<R>& panel, const RiemannHilbertForm<R>& form,
          const ContactProblem& problem, std::size_t k, Side side, const R& distance) {
  const numeric::Frame& frame = form.problem().frame();
  const R unit = numeric::to_real<R>(frame.unit);
  const R end = numeric::to_real<R>(frame.origin) + unit * (side == Side::left ? panel.left : panel.right);
  const R x = end + (side == Side::left ? R(-unit * distance) : R(unit * distance));
  const R rise = height<R>(problem, x, x) - height<R>(problem, end, end);
  return (rise - unit * check.displacement(k, side, distance)) / numeric::to_real<R>(problem.load());
}

/// How many sides of ends, jumps and wedges pull in the limit: read off the traction at a distance where the leading
/// term of any of its local forms has outgrown the others, by a factor 10^40 at 50 digits if |beta| > 10^-4.
template <Real R>
int pulling_sides(const RiemannHilbertForm<R>& form, const R& factor) {
  using std::abs, std::pow;
  const R d = pow(R(10), std::same_as<R, double> ? R(-300) : R(-1'000'000));
  const ContactSet<R>& set = form.set();
  int count = 0;
  for (std::size_t k = 0; k < set.segments(); ++k) {
    if (!set.in_contact(k)) continue;
    for (const bool left : {true, false}) {
      const R rest = set.length(k) - d;
      const numeric::Estimate<R> t =
          form.traction({static_cast<std::ptrdiff_t>(k), {set.x(left ? k : k + 1), left ? d : rest, left ? rest : d}});
      if (factor * t.value > 4 * abs(factor) * t.error) ++count;
    }
  }
  return count;
}

template <Real R>
void examine(Findings& findings, const ContactProblem& problem, const RiemannHilbertForm<R>& form, const R& factor) {
  using std::abs, std::max;
  const std::vector<std::string> nothing{"trapezoidal rule", "0"};
  const Quantity equation{
      "u_bar' = psi_bar' in the contact", {"A t by the trapezoidal rule", "psi_bar'"}, tolerance<R>()};
  const Quantity load{"int t", {"trapezoidal rule", "-P"}, tolerance<R>()};
  const Quantity tension{"t > 0 within the contact", nothing, tolerance<R>()};
  const Quantity limits{"t > 0 in the limit at an end, a jump or a wedge (sides)",
                        {"t as near as 10^-300 in double, 10^-1000000 with more digits", "0"},
                        0};
  const Quantity penetration{"u + C > psi off the contact, over c P", nothing, tolerance<R>()};
  const Quantity closure{
      "gap between two components, over c P", {"from the left one", "from the right one"}, tolerance<R>(), 0};
  const std::vector<std::size_t> segments = segments_of(form);
  numeric::PiecewiseDensity<R> density = traction_density(form);
  for (auto& panel : density) {
    panel.smooth = [smooth = panel.smooth, factor](const numeric::Node<R>& node) { return R(factor * smooth(node)); };
  }
  const R unit = numeric::to_real<R>(form.problem().frame().unit);
  const R origin = numeric::to_real<R>(form.problem().frame().origin);
  const auto profile_slope = [&](std::size_t, const numeric::Node<R>& node) {
    const R x = origin + unit * node.x;
    return slope<R>(problem, x, x);
  };
  const numeric::SurfaceCheck<R> check(density, friction_of(form), profile_slope);
  const R p = numeric::to_real<R>(problem.load()) / unit;
  findings.compare(load, relative_difference<R>(check.integral(), R(-p)));
  findings.compare(tension, static_cast<double>(R(max(check.highest_traction(), R(0)) * form.set().span_length() / p)));
  findings.compare(limits, pulling_sides<R>(form, factor));

  for (std::size_t k = 0; k < density.size(); ++k) {
    const numeric::Panel<R>& panel = density[k].panel;
    const R left = numeric::to_real<R>(problem.indenter().left());
    const R right = numeric::to_real<R>(problem.indenter().right());
    const auto look = [&](Side side, const R& length, int steps) {
      // Contact that reaches the support's end leaves nothing beyond but a rounding.
      if (!(length > 64 * numeric::epsilon<R>() * form.set().span_length())) return;
      for (int i = 1; i < steps; ++i) {
        // Denser towards the end of the contact.
        const R d = length * i * i * i * i / (steps * steps * steps * steps);
        const R gap = opening<R>(check, panel, form, problem, k, side, d);
        findings.compare(penetration, static_cast<double>(max(R(-gap), R(0))));
      }
    };
    if (k == 0) look(Side::left, R(panel.left - (left - origin) / unit), 6);
    if (k + 1 == density.size()) {
      look(Side::right, R((right - origin) / unit - panel.right), 6);
    } else if (density[k + 1].gap > 0) {
      look(Side::right, density[k + 1].gap, 6);
      // From both sides to the middle: at a component's end the rule has no value.
      const R half = density[k + 1].gap / 2;
      const R from_left = opening<R>(check, panel, form, problem, k, Side::right, half);
      const R from_right = opening<R>(check, density[k + 1].panel, form, problem, k + 1, Side::left, half);
      findings.compare(closure, static_cast<double>(R(abs(from_left - from_right))));
    }
  }
  // The dearest one last: controls fail before.
  findings.compare(equation, static_cast<double>(check.equation()));
}

std::vector<Evidence> check(const Context& context, const Candidate& candidate) {
  const numeric::Digits digits =
      context.quick ? numeric::Digits::sixteen : std::max(context.digits, numeric::Digits::fifty);
  const auto walk = [&]<Real R>() {
    Random random(context.seed, "eq-03-complementarity");
    Findings findings;
    const std::size_t count = context.quick ? 1 : 9;
    std::vector<ContactProblem> problems;
    for (std::size_t k = 0; k < count; ++k) problems.push_back(random_problem(random, k));
    problems.push_back(notch(true));
    if (candidate.with_unsolved) problems.push_back(notch(false));
    for (const ContactProblem& problem : problems) {
      findings.begin_case(text_of(problem));
      // What is not solved ends the walk, with the reason: no case is passed over.
      const auto held = hold<R>(problem, candidate);
      R factor = numeric::to_real<R>(candidate.factor);
      if (candidate.factor_near_miss) factor += near_miss<R>();
      examine<R>(findings, problem, *held->form, factor);
    }
    return findings.evidence("random frictions, profiles with one and two wells and loads, seed " +
                             std::to_string(context.seed) + "; a notch over a jump");
  };
  return gather([&] { return numeric::at_precision(digits, walk); });
}

Wrong<Candidate> wrong(std::string name, const Candidate& candidate) { return {std::move(name), candidate}; }

}  // namespace

Claim eq_03_complementarity() {
  using Which = Candidate::Which;
  return make_claim(
      claim_text("eq-03-complementarity"), check, Candidate{},
      std::vector<Wrong<Candidate>>{
          wrong("an end moved by a hundredth of the contact", {.which = Which::moved_end}),
          wrong("edges within the contact: equation and load right, but the surface penetrates",
                {.which = Which::too_short}),
          wrong("edges beyond the contact: equation and load right, but there is tension", {.which = Which::too_long}),
          wrong("full contact over a notch: equation and load right, but the corner pulls on 1e-11 of it",
                {.which = Which::full_contact}),
          wrong("a problem without solution among the others", {.with_unsolved = true}),
          wrong("the traction of another load", {.factor = Rational(11, 10)}),
          wrong("the traction of the other sign", {.factor = -1}),
          wrong("near miss: an end moved by ten times the tolerance", {.which = Which::moved_end, .near_miss = true}),
          wrong("near miss: the traction moved by ten times the tolerance", {.factor_near_miss = true})});
}

}  // namespace steadyslide::proofs_checks
