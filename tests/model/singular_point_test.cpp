#include "model/singular_point.hpp"
#include "support/random_problem.hpp"

namespace {

std::string text_of(const SingularPoint& point) {
  std::string text = (point.x ? to_string(*point.x) : "anywhere") + " " + std::string(name_of(point.kind)) + " " +
                     std::string(name_of(point.contact));
  for (const Rational& f : point.friction) text += " " + to_string(f);
  return text + ": " + (point.exponent ? to_string(*point.exponent) : "log");
}

using Lines = std::vector<std::string>;

Lines text_of(const std::vector<SingularPoint>& points) {
  Lines lines;
  for (const SingularPoint& point : points) lines.push_back(text_of(point));
  return lines;
}

/// The points with gamma = 1/2 by default, so that s = f/2.
Lines points(FrictionProfile friction, std::vector<Indenter::Piece> pieces, Sliding sliding = Sliding::plus_x,
             const Rational& gamma = 0.5_r) {
  return text_of(possible_singular_points(
      ContactProblem(Elasticity::reduced(gamma), std::move(friction), Indenter(-1, std::move(pieces)), 1, sliding)));
}

const Polynomial level;

/// Edges and free ends under one friction coefficient of 1.
const Lines left_end{"-1 edge right 1: -1/2 - arctan(1/2)/pi", "-1 free right 1: 1/2 - arctan(1/2)/pi"};
const Lines right_end{"1 edge left 1: -1/2 + arctan(1/2)/pi", "1 free left 1: 1/2 + arctan(1/2)/pi"};
const Lines anywhere{"anywhere free right 1: 1/2 - arctan(1/2)/pi", "anywhere free left 1: 1/2 + arctan(1/2)/pi"};

/// The points for friction 1 at both ends, with `inside` between the ends.
Lines around(const Lines& inside) {
  Lines all;
  for (const Lines* part : {&left_end, &inside, &right_end, &anywhere})
    all.insert(all.end(), part->begin(), part->end());
  return all;
}

/// Returns the point of the problem that corresponds to a point of the mirrored problem.
SingularPoint mirrored(SingularPoint point) {
  if (point.x) point.x = -*point.x;
  if (point.contact != ContactSide::both) {
    point.contact = point.contact == ContactSide::left ? ContactSide::right : ContactSide::left;
  }
  std::reverse(point.friction.begin(), point.friction.end());
  return point;
}

bool same(const SingularPoint& a, const SingularPoint& b) {
  return a.x == b.x && a.kind == b.kind && a.contact == b.contact && a.friction == b.friction &&
         a.exponent.has_value() == b.exponent.has_value() && (!a.exponent || *a.exponent == *b.exponent);
}

}  // namespace

TEST_CASE("a flat punch: its edges and the free ends") {
  CHECK(points(FrictionProfile({1}), {{1, level}}) == around({}));
  // Breaks without a singular point: one without any change, and one at which only the curvature changes.
  CHECK(points(FrictionProfile({1}), {{0, level}, {1, level}}) == around({}));
  CHECK(points(FrictionProfile({1}), {{0, level}, {1, Polynomial({0, 0, 1})}}) == around({}));
  // A jump of height zero is not singular.
  CHECK(points(FrictionProfile({1, 1}, {0}), {{1, level}}) == around({}));
}

TEST_CASE("a wedge has a logarithm, on a jump of height zero too") {
  const Polynomial ramp({0, 1});
  CHECK(points(FrictionProfile({1}), {{0, level}, {1, ramp}}) == around({"0 wedge both 1 1: log"}));
  CHECK(points(FrictionProfile({1, 1}, {0}), {{0, level}, {1, ramp}}) == around({"0 wedge both 1 1: log"}));
}

TEST_CASE("a step ends the contact on its protruding side") {
  // psi is measured away from the body: at a step up (psi grows) the left side protrudes. A step with a wedge is also a
  // step.
  for (const auto& [right, step] : {std::pair(Polynomial({1}), "0 step left 1: -1/2 + arctan(1/2)/pi"),
                                    {Polynomial({-1}), "0 step right 1: -1/2 - arctan(1/2)/pi"},
                                    {Polynomial({1, 1}), "0 step left 1: -1/2 + arctan(1/2)/pi"}}) {
    CHECK(points(FrictionProfile({1}), {{0, level}, {1, right}}) == around({step}));
  }
}

TEST_CASE("jumps, wedges on jumps, and steps on jumps") {
  const FrictionProfile friction({1, 3, 1}, {0, 0.5_r});
  // Points before the jump down at 1/2, and the free ends under the friction between the jumps.
  const auto expected = [&](Lines before) {
    before.push_back("0.5 friction_jump both 3 1: arctan(3/2)/pi - arctan(1/2)/pi");
    Lines all = around(before);
    for (const char* end : {"right 3: 1/2 -", "left 3: 1/2 +"}) {
      all.push_back(std::string("anywhere free ") + end + " arctan(3/2)/pi");
    }
    return all;
  };
  const std::string up = " both 1 3: arctan(1/2)/pi - arctan(3/2)/pi";
  CHECK(points(friction, {{1, level}}) == expected({"0 friction_jump" + up}));
  CHECK(points(friction, {{0, level}, {1, Polynomial({0, 1})}}) == expected({"0 wedge_and_jump" + up}));
  CHECK(points(friction, {{0.25_r, level}, {1, Polynomial({-0.25_r, 1})}}) ==
        expected({"0 friction_jump" + up, "0.25 wedge both 3 3: log"}));
  // A step on a jump: the friction is that of the protruding side.
  CHECK(points(friction, {{0, level}, {1, Polynomial({-1})}}) == expected({"0 step right 3: -1/2 - arctan(3/2)/pi"}));
  CHECK(points(friction, {{0, level}, {1, Polynomial({1})}}) == expected({"0 step left 1: -1/2 + arctan(1/2)/pi"}));
}

TEST_CASE("without coupling nothing depends on friction, and jumps are singular nowhere") {
  const Lines expected{"-1 edge right 1: -1/2",     "-1 free right 1: 1/2",       "0 wedge both 1 3: log",
                       "1 edge left 3: -1/2",       "1 free left 3: 1/2",         "anywhere free right 1: 1/2",
                       "anywhere free left 1: 1/2", "anywhere free right 3: 1/2", "anywhere free left 3: 1/2"};
  CHECK(points(FrictionProfile({1, 3}, {0}), {{0, level}, {1, Polynomial({0, 1})}}, Sliding::plus_x, 0) == expected);
}

TEST_CASE("sliding the other way, and a negative gamma, change the sign of every angle") {
  const Lines expected{"-1 edge right 1: -1/2 + arctan(1/2)/pi",
                       "-1 free right 1: 1/2 + arctan(1/2)/pi",
                       "0 friction_jump both 1 3: -arctan(1/2)/pi + arctan(3/2)/pi",
                       "1 edge left 3: -1/2 - arctan(3/2)/pi",
                       "1 free left 3: 1/2 - arctan(3/2)/pi",
                       "anywhere free right 1: 1/2 + arctan(1/2)/pi",
                       "anywhere free left 1: 1/2 - arctan(1/2)/pi",
                       "anywhere free right 3: 1/2 + arctan(3/2)/pi",
                       "anywhere free left 3: 1/2 - arctan(3/2)/pi"};
  const FrictionProfile friction({1, 3}, {0});
  CHECK(points(friction, {{1, level}}, Sliding::minus_x) == expected);
  CHECK(points(friction, {{1, level}}, Sliding::plus_x, -0.5_r) == expected);
}

TEST_CASE("an elastic indenter has no edges of its own") {
  const Solid steel(0.3_r, 1);
  const ContactProblem problem(Elasticity(steel, Solid(0.3_r, 1)), FrictionProfile({1}),
                               Indenter(-1, {{1, Polynomial({0, 0, 1})}}), 1);
  CHECK(text_of(possible_singular_points(problem)) ==
        Lines{"-1 free right 1: 1/2", "1 free left 1: 1/2", "anywhere free right 1: 1/2", "anywhere free left 1: 1/2"});
}

TEST_CASE("the mirrored problem has the mirrored list") {
  int interior = 0;
  CHECK(rc::check([&] {
    const ContactProblem problem = *coincidences();
    const std::vector<SingularPoint> here = possible_singular_points(problem);
    const std::vector<SingularPoint> there = possible_singular_points(problem.mirrored());
    RC_ASSERT(here.size() == there.size());
    for (const SingularPoint& point : there) {
      const SingularPoint image = mirrored(point);
      interior += point.kind != SingularKind::edge && point.kind != SingularKind::free;
      RC_ASSERT(std::count_if(here.begin(), here.end(), [&](const SingularPoint& p) { return same(p, image); }) == 1);
    }
  }));
  CHECK(interior > 50);
}

TEST_CASE("powers: ranges and relations") {
  CHECK(rc::check([] {
    const auto random = [] { return Rational(uniform(-5000, 4999), uniform(1, 99)); };
    const Rational s = random(), t = random();
    const Exponent one(1);
    for (const End end : {End::left, End::right}) {
      RC_ASSERT(edge_exponent(end, s).sign() == -1);
      RC_ASSERT((edge_exponent(end, s) + one).sign() == 1);
      RC_ASSERT(free_exponent(end, s) == edge_exponent(end, s) + one);
      RC_ASSERT(edge_exponent(end, s) == edge_exponent(opposite(end), -s));
    }
    // A flat punch with one jump: the exponents sum to -1.
    RC_ASSERT(edge_exponent(End::left, s) + jump_exponent(s, t) + edge_exponent(End::right, t) == -one);
    RC_ASSERT(jump_exponent(s, t) == -jump_exponent(t, s));
    RC_ASSERT(jump_exponent(s, t).sign() == sign(Rational(s - t)));
    RC_ASSERT((jump_exponent(s, t) + one).sign() == 1);
  }));
}
