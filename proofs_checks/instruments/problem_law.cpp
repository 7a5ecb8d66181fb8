#include "proofs_checks/instruments/problem_law.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/riemann_hilbert/riemann_hilbert.hpp"
#include "numeric/variational/variational_inequality.hpp"
#include "proofs_checks/instruments/cells.hpp"
#include "proofs_checks/instruments/power_form.hpp"
#include "proofs_checks/kit/findings.hpp"

namespace steadyslide::proofs_checks {
namespace {

using numeric::ContactSolution;

/// At this part of the last component, to a 1000th; the jumps of random problems have other denominators. Throws
/// Refutation if nothing is solved.
Rational place_in_contact(const ContactProblem& problem, double part) {
  const auto solution = numeric::riemann_hilbert<double>(problem).solution;
  if (!solution) throw Refutation{{"a problem to be changed", "not solved"}};
  const auto component = solution->contact().back();
  const double x = (1 - part) * component.left.x.value + part * component.right.x.value;
  return Rational(std::lround(1000 * x), 1000) + Rational(1, 10'007);
}

ContactProblem changed_problem(const ContactProblem& p, const Law& law) {
  if (law.jump) {
    Law rest = law;
    rest.jump.reset();
    return changed_problem(p.with_jump(place_in_contact(p, 0.3), *law.jump), rest);
  }
  const bool plus = (p.sliding() == Sliding::plus_x) != law.turned;
  const ContactProblem moved = p.moved(law.scale, law.shift)
                                   .with_sliding(plus ? Sliding::plus_x : Sliding::minus_x)
                                   .with_load(law.load * p.load());
  const Indenter scaled = moved.indenter().scaled(law.height);
  return moved.with_friction(law.keeps_friction ? p.friction() : moved.friction())
      .with_indenter(Indenter(scaled.left(), {{scaled.right(), scaled.pieces().front().profile + law.lift}}));
}

/// With a jump of friction in the contact: where there is none, mirrors know no difference.
ContactProblem random_problem(Random& random, std::size_t k) {
  CellFrictionSteps steps = random_steps(random, Trend::any, 2, 2);
  if (k % 2 == 1) steps = mirrored(steps);
  const ContactProblem problem =
      cell_problem(steps, random_profile(random, k % 3 != 2), random.between(Rational(1, 4), 2));
  return problem.with_jump(place_in_contact(problem, 0.4), random.between(Rational(1, 2), 1));
}

/// What is compared at one place.
struct Agreeing {
  const Quantity& traction;
  const Quantity& gap;
  const Quantity& slope;
};

/// Two solutions at x and at its image. `length` of the contact, `mean` traction.
template <class R>
void compare_at(Findings& findings, const Agreeing& quantities, const ContactSolution<R>& before,
                const ContactSolution<R>& after, const Law& law, const Rational& x, const R& mean, const R& height) {
  using std::abs;
  const numeric::Sample<R> a = before.at(x);
  const numeric::Sample<R> b = after.at(law.scale * x + law.shift);
  const R traction = numeric::to_real<R>(law.traction);
  const R t = (law.scale < 0 ? b.traction.right : b.traction.left).value;
  const R t_scale = traction * (mean + abs(a.traction.left.value));
  findings.compare(quantities.traction, static_cast<double>(R(abs(t - traction * a.traction.left.value) / t_scale)));
  const R gap = numeric::to_real<R>(law.gap);
  findings.compare(quantities.gap,
                   static_cast<double>(R(abs(b.gap->value - gap * a.gap->value) / (gap * (height + a.gap->value)))));
  const R slope = numeric::to_real<R>(law.gap / law.scale);
  const R u = (law.scale < 0 ? b.slope.right : b.slope.left).value;
  const R u_scale = abs(slope) * (mean + abs(a.slope.left.value));
  findings.compare(quantities.slope, static_cast<double>(R(abs(u - slope * a.slope.left.value) / u_scale)));
}

/// Places over the whole support, none of them a singular one.
std::vector<Rational> places(const ContactProblem& problem, int count) {
  std::vector<Rational> result;
  const Rational width = problem.indenter().right() - problem.indenter().left();
  for (int i = 0; i < count; ++i) {
    result.push_back(problem.indenter().left() + width * (2 * i + 1) / (2 * count) + Rational(i % 3 - 1, 10'007));
  }
  return result;
}

/// Two runs round differently.
template <Real R>
constexpr double allowed = std::same_as<R, double>   ? 1e-9
                           : std::same_as<R, Real50> ? 1e-45
                                                     : 1e-95;
constexpr double allowed_on_cells = 1e-11;

template <Real R>
void check_exactly(Findings& findings, const ContactProblem& problem, const ContactProblem& other, const Law& law) {
  using std::abs;
  const std::vector<std::string> routes{"solution of the changed problem", "solution changed by the law"};
  const Quantity ends{"ends of the contact", routes, allowed<R>};
  const Quantity traction{"traction", routes, allowed<R>};
  const Quantity gap{"gap", routes, allowed<R>};
  const Quantity slope{"u'", routes, allowed<R>};
  const auto a = numeric::riemann_hilbert<R>(problem).solution;
  const auto b = numeric::riemann_hilbert<R>(other).solution;
  if (!a || !b || !a->shortcoming().empty() || !b->shortcoming().empty()) {
    findings.skip(ends);
    return;
  }
  const auto before = a->contact();
  auto after = b->contact();
  findings.require(before.size() == after.size(), "another number of contact components");
  if (law.scale < 0) {
    std::ranges::reverse(after);
    for (auto& component : after) std::swap(component.left, component.right);
  }
  const R length = before.back().right.x.value - before.front().left.x.value;
  const R scale = numeric::to_real<R>(law.scale);
  const R shift = numeric::to_real<R>(law.shift);
  for (std::size_t k = 0; k < before.size(); ++k) {
    for (const auto end : {&numeric::ContactComponent<R>::left, &numeric::ContactComponent<R>::right}) {
      const R expected = scale * (before[k].*end).x.value + shift;
      findings.compare(ends, static_cast<double>(R(abs(expected - (after[k].*end).x.value) / abs(scale * length))));
    }
  }
  const R load = numeric::to_real<R>(problem.load());
  for (const Rational& x : places(problem, 7)) {
    compare_at<R>(findings, {traction, gap, slope}, *a, *b, law, x, load / length, load);
  }
}

void check_on_cells(Findings& findings, const ContactProblem& problem, const ContactProblem& other, const Law& law,
                    std::size_t cells) {
  const std::vector<std::string> routes{"solution of the changed problem", "solution changed by the law"};
  const Quantity traction{"traction on cells", routes, allowed_on_cells};
  const auto a = numeric::variational_inequality(problem, {.cells = cells}).solution;
  const auto b = numeric::variational_inequality(other, {.cells = cells}).solution;
  if (!a || !b || !a->shortcoming().empty() || !b->shortcoming().empty()) {
    findings.skip(traction);
    return;
  }
  const double mean = numeric::to_real<double>(problem.load()) / 2;
  const double factor =
      numeric::to_real<double>(law.traction) * (law.missed_on_cells ? 1 + 10 * allowed_on_cells : 1.0);
  const Rational width = problem.indenter().right() - problem.indenter().left();
  for (std::size_t i = 0; i < cells; ++i) {
    // In the middle of a cell.
    const Rational x = problem.indenter().left() + width * static_cast<long>(2 * i + 1) / static_cast<long>(2 * cells);
    const double t = factor * a->at(x).traction.left.value;
    const double found = b->at(law.scale * x + law.shift).traction.left.value;
    findings.compare(traction, std::abs(found - t) / (factor * mean + std::abs(t)));
  }
}

}  // namespace

std::vector<Evidence> check_law(const Context& context, const Law& said) {
  const auto walk = [&]<Real R>() {
    Law law = said;
    if (law.miss) law.miss(law, Rational(10 * allowed<R>));
    Random random(context.seed, "eq-03-laws");
    Findings findings;
    const std::size_t count = context.quick ? 1 : 12;
    for (std::size_t k = 0; k < count; ++k) {
      const ContactProblem problem = random_problem(random, k);
      const ContactProblem other = changed_problem(problem, law);
      findings.begin_case(to_string(problem.indenter().pieces().front().profile) + ", load " +
                          to_string(problem.load()));
      check_exactly<R>(findings, problem, other, law);
      check_on_cells(findings, problem, other, law, context.quick ? 32 : 128);
    }
    return findings.evidence("random frictions, profiles with one and two wells and loads, seed " +
                             std::to_string(context.seed));
  };
  return gather([&] { return numeric::at_precision(context.digits, walk); });
}

Claim law_claim(std::string_view id, const Law& right, std::vector<Wrong<Law>> wrong) {
  return make_claim(claim_text(id), check_law, right, std::move(wrong));
}

void miss_on_cells(Law& law) { law.missed_on_cells = true; }
void miss_of_load(Law& law) {
  law.miss = [](Law& l, const Rational& by) { l.load *= 1 + by; };
}
void miss_of_height(Law& law) {
  law.miss = [](Law& l, const Rational& by) { l.height *= 1 + by; };
}
void miss_of_traction(Law& law) {
  law.miss = [](Law& l, const Rational& by) { l.traction *= 1 + by; };
}
void miss_of_jump(Law& law) {
  law.miss = [](Law& l, const Rational& by) { l.jump = 100 * by; };
}

}  // namespace steadyslide::proofs_checks
