#include "proofs_checks/instruments/solutions/problem_law.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/riemann_hilbert/riemann_hilbert.hpp"
#include "numeric/variational/variational_inequality.hpp"
#include "proofs_checks/instruments/cells/cells.hpp"

namespace steadyslide::proofs_checks {
namespace {

const std::vector<std::string> routes{"solution of the changed problem", "solution changed by the law"};

/// Returns the point at this part of the last contact component, rounded to 1/1000 and shifted by 1/10007. Friction
/// jumps of random problems have other denominators. Throws Refutation if the problem is not solved.
Rational place_in_contact(const ContactProblem& problem, double part) {
  const auto solution = numeric::riemann_hilbert<double>(problem).solution;
  if (!solution) throw Refutation{{"a problem to be changed", "not solved"}};
  const auto component = solution->contact().back();
  const double x = (1 - part) * component.left.x.value + part * component.right.x.value;
  return Rational(std::lround(1000 * x), 1000) + Rational(1, 10'007);
}

ContactProblem changed_problem(const ContactProblem& problem, const Law& law) {
  const ContactProblem p = law.jump ? problem.with_jump(place_in_contact(problem, 0.3), *law.jump) : problem;
  const bool plus = (p.sliding() == Sliding::plus_x) != law.turned;
  const ContactProblem moved = p.moved(law.scale, law.shift)
                                   .with_sliding(plus ? Sliding::plus_x : Sliding::minus_x)
                                   .with_load(law.load * p.load());
  const Indenter scaled = moved.indenter().scaled(law.height);
  return moved.with_friction(law.keeps_friction ? p.friction() : moved.friction())
      .with_indenter(Indenter(scaled.left(), {{scaled.right(), scaled.pieces().front().profile + law.lift}}));
}

/// Returns a problem with a friction jump in the contact. Without a jump a wrong mirror law would not be noticed.
ContactProblem random_problem(Random& random, std::size_t k) {
  CellFrictionSteps steps = random_steps(random, Trend::any, 2, 2);
  if (k % 2 == 1) steps = mirrored(steps);
  const Rational load = random.between(Rational(1, 4), 2);
  const ContactProblem problem = cell_problem(steps, random_profile(random, k % 3 != 2), load);
  return problem.with_jump(place_in_contact(problem, 0.4), random.between(Rational(1, 2), 1));
}

/// Two solutions round differently, so double has a larger tolerance.
template <Real R>
const double allowed = std::same_as<R, double> ? 1e-9 : tolerance<R>();
constexpr double allowed_on_cells = 1e-11;

template <Real R>
void check_exactly(Findings& findings, const ContactProblem& problem, const ContactProblem& other, const Law& law) {
  using std::abs;
  const Quantity ends{"ends of the contact", routes, allowed<R>};
  const Quantity traction{"traction", routes, allowed<R>};
  const Quantity gap{"gap", routes, allowed<R>};
  const Quantity slope{"`u'`", routes, allowed<R>};
  const auto a = numeric::riemann_hilbert<R>(problem).solution;
  const auto b = numeric::riemann_hilbert<R>(other).solution;
  if (!a || !b || !a->failed_condition().empty() || !b->failed_condition().empty()) return findings.skip(ends);
  const auto before = a->contact();
  auto after = b->contact();
  findings.require(before.size() == after.size(), "another number of contact components");
  if (law.scale < 0) {
    std::ranges::reverse(after);
    for (auto& component : after) std::swap(component.left, component.right);
  }
  /// Compares the difference |found - factor from| with |factor| (least + |from|).
  const auto compare = [&](const Quantity& quantity, const R& found, const Rational& factor, const R& from,
                           const R& least) {
    const R f = to_real<R>(factor);
    findings.compare(quantity, R(abs(found - f * from) / (abs(f) * (least + abs(from)))));
  };
  const R length = before.back().right.x.value - before.front().left.x.value;
  const R scale = to_real<R>(law.scale);
  const R shift = to_real<R>(law.shift);
  for (std::size_t k = 0; k < before.size(); ++k) {
    for (const auto end : {&numeric::ContactComponent<R>::left, &numeric::ContactComponent<R>::right}) {
      const R expected = scale * (before[k].*end).x.value + shift;
      findings.compare(ends, R(abs(expected - (after[k].*end).x.value) / abs(scale * length)));
    }
  }
  const R load = to_real<R>(problem.load());
  const Rational width = problem.indenter().right() - problem.indenter().left();
  // Points on the whole support, none of which is singular.
  for (int i = 0; i < 7; ++i) {
    const Rational x = problem.indenter().left() + width * (2 * i + 1) / 14 + Rational(i % 3 - 1, 10'007);
    const numeric::Sample<R> here = a->at(x);
    const numeric::Sample<R> there = b->at(law.scale * x + law.shift);
    const auto& [t, u] = law.scale < 0 ? std::pair(there.traction.right, there.slope.right)
                                       : std::pair(there.traction.left, there.slope.left);
    compare(traction, t.value, law.traction, here.traction.left.value, load / length);
    compare(gap, there.gap->value, law.gap, here.gap->value, load);
    compare(slope, u.value, law.gap / law.scale, here.slope.left.value, load / length);
  }
}

void check_on_cells(Findings& findings, const ContactProblem& problem, const ContactProblem& other, const Law& law,
                    std::size_t cells) {
  const Quantity traction{"traction on cells", routes, allowed_on_cells};
  const auto a = numeric::variational_inequality(problem, {.cells = cells}).solution;
  const auto b = numeric::variational_inequality(other, {.cells = cells}).solution;
  if (!a || !b || !a->failed_condition().empty() || !b->failed_condition().empty()) return findings.skip(traction);
  const double mean = to_real<double>(problem.load()) / 2;
  const double factor = to_real<double>(law.traction) * (law.missed_on_cells ? 1 + 10 * allowed_on_cells : 1.0);
  const Rational width = problem.indenter().right() - problem.indenter().left();
  for (std::size_t i = 0; i < cells; ++i) {
    // The middle of a cell.
    const Rational x = problem.indenter().left() + width * static_cast<long>(2 * i + 1) / static_cast<long>(2 * cells);
    const double t = factor * a->at(x).traction.left.value;
    const double found = b->at(law.scale * x + law.shift).traction.left.value;
    findings.compare(traction, std::abs(found - t) / (factor * mean + std::abs(t)));
  }
}

template <Real R>
void check(Findings& findings, Law law, const ContactProblem& problem, bool quick) {
  const Rational step(10 * allowed<R>);
  if (law.missed) law.*law.missed *= 1 + step;
  if (law.missed_jump) law.jump = 100 * step;
  const ContactProblem other = changed_problem(problem, law);
  check_exactly<R>(findings, problem, other, law);
  check_on_cells(findings, problem, other, law, quick ? 32 : 128);
}

}  // namespace

FormulaClaim<ContactProblem, Law> law_claim(std::string id, const Law& law) {
  return formula_claim<ContactProblem, Law>(std::move(id))
      .cases([](const Context& context) {
        return random_cases(context, "eq-03-laws", 12, 1, "random frictions, profiles with one and two wells and loads",
                            random_problem);
      })
      .says([law](const ContactProblem&) { return law; })
      .checked([]<Real R>(Findings& findings, const Law& said, const ContactProblem& problem, const Context& context) {
        check<R>(findings, said, problem, context.quick);
      });
}

}  // namespace steadyslide::proofs_checks
