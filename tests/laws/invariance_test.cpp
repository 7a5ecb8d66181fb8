// Changes of the problem that change the solution in a known way.

#include <doctest/doctest.h>

#include "numeric/closed_form/closed_form.hpp"
#include "support/random_problem.hpp"

using namespace steadyslide;
using namespace steadyslide::numeric;

namespace {

constexpr const char* positions[] = {"-0.4", "0.01", "0.27", "0.5", "0.83", "0.999", "1.3"};

std::shared_ptr<const ContactSolution<Real50>> solve(const ContactProblem& problem) {
  return closed_form<Real50>(problem).solution;
}

bool close(const Real50& a, const Real50& b, const Real50& scale = 0) {
  if (isinf(a) || isinf(b)) return a == b;
  return abs(a - b) <= 1e-44 * (abs(a) + abs(b) + scale);
}

/// Places in and around the contact, away from singular points, as rationals of the problem's own coordinate.
std::vector<Rational> places(const ContactProblem& problem) {
  const auto contact = closed_form<double>(problem).solution->contact().front();
  const Rational left(contact.left.x.value);
  const Rational width = Rational(contact.right.x.value) - left;
  std::vector<Rational> result;
  for (const char* position : positions) {
    const Rational x = left + width * parse_rational(position);
    const auto& jumps = problem.friction().jumps();
    if (std::find(jumps.begin(), jumps.end(), x) == jumps.end()) result.push_back(x);
  }
  return result;
}

/// Traction scales with 1/|scale| at equal load and, for a parabola, with a profile that keeps its height.
void moves_with(const ContactProblem& problem, const Rational& scale, const Rational& shift) {
  const auto before = solve(problem);
  const auto after = solve(problem.moved(scale, shift));
  const Real50 factor = to_real<Real50>(abs(scale));
  for (const Rational& x : places(problem)) {
    const Sample<Real50> a = before->at(x);
    const Sample<Real50> b = after->at(scale * x + shift);
    RC_ASSERT(close(a.traction.left.value, factor * b.traction.left.value));
    RC_ASSERT(close(a.slope.left.value, to_real<Real50>(scale) * b.slope.left.value));
    RC_ASSERT(a.gap.has_value() == b.gap.has_value());
    if (a.gap) RC_ASSERT(close(a.gap->value, b.gap->value));
    const int turn = scale < 0 ? -1 : 1;
    RC_ASSERT(close(a.shear.left.value, turn * factor * b.shear.left.value));
  }
  RC_ASSERT(close(before->resultants().effective_friction.value, after->resultants().effective_friction.value));
}

void invariances(const ContactProblem& problem) {
  moves_with(problem, -1, 0);                                        // mirror
  moves_with(problem, 1, *testing::rational(-5, 5, 7));              // translation
  moves_with(problem, *testing::rational(1, 9, 5), Rational(1, 3));  // dilation
}

}  // namespace

TEST_CASE("mirror, translation and dilation") {
  CHECK(rc::check("flat punches", [] { invariances(*testing::flat_punch(4)); }));
  CHECK(rc::check("parabolas", [] { invariances(*testing::parabola(4)); }));
}

TEST_CASE("load and profile scaled together scale the traction") {
  CHECK(rc::check("parabolas", [] {
    const ContactProblem p = *testing::parabola(4);
    const Rational factor = *testing::rational(1, 5, 3);
    const auto before = solve(p);
    const auto after = solve(p.with_indenter(p.indenter().scaled(factor)).with_load(factor * p.load()));
    for (const Rational& x : places(p)) {
      RC_ASSERT(close(to_real<Real50>(factor) * before->at(x).traction.left.value, after->at(x).traction.left.value));
    }
  }));
}

TEST_CASE("a jump of height zero changes nothing") {
  CHECK(rc::check("flat punches and parabolas", [] {
    const ContactProblem p = *rc::gen::oneOf(testing::flat_punch(3), testing::parabola(3));
    const Rational c = places(p)[static_cast<std::size_t>(*rc::gen::inRange(1, 4))];
    const auto before = solve(p);
    const auto after = solve(p.with_jump(c, 0));
    for (const Rational& x : places(p)) {
      RC_ASSERT(close(before->at(x).traction.left.value, after->at(x).traction.left.value));
    }
    RC_ASSERT(close(before->resultants().effective_friction.value, after->resultants().effective_friction.value));
    RC_ASSERT(before->singular_points().size() == after->singular_points().size());
  }));
}

TEST_CASE("control: mirroring without turning the sliding direction is not an invariance") {
  const ContactProblem p(Elasticity(Solid(0, 1)), FrictionProfile({1, 2}, {0}), Indenter(-1, {{1, Polynomial()}}), 1);
  const ContactProblem half_mirrored = p.mirrored().with_sliding(p.sliding());
  const Real50 a = solve(p)->at(Rational(1, 3)).traction.left.value;
  const Real50 b = solve(half_mirrored)->at(Rational(-1, 3)).traction.left.value;
  CHECK(!close(a, b));
}
