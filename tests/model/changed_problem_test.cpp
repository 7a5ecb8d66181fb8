// Problems made from others: one datum changes, and nothing else.

#include "broken_rule.hpp"
#include "support/random_problem.hpp"

namespace {

/// A place that is not among the places of a random problem.
Rational random_place() { return Rational(uniform(-999, 999), 1000) + Rational(1, 3000); }

Rational random_scale() { return Rational(*rc::gen::arbitrary<bool>() ? 1 : -1) * Rational(uniform(1, 20), 7); }

const ContactProblem tilting(Elasticity(Solid(0.3_r, 1)), FrictionProfile({1, 2}, {0}),
                             Indenter(-1, {{1, Polynomial({0, 0, 1})}}), 3, Sliding::minus_x, 0.25_r);

}  // namespace

TEST_CASE("one datum changes, the others are kept") {
  const Elasticity& body = tilting.elasticity();
  const FrictionProfile& friction = tilting.friction();
  const Indenter &indenter = tilting.indenter(), taller = indenter.scaled(2);
  const Sliding back = Sliding::minus_x, forth = Sliding::plus_x;
  const auto under = [&](const FrictionProfile& f) { return ContactProblem(body, f, indenter, 3, back, 0.25_r); };
  CHECK(tilting.with_load(5) == ContactProblem(body, friction, indenter, 5, back, 0.25_r));
  CHECK(tilting.with_indenter(taller) == ContactProblem(body, friction, taller, 3, back, 0.25_r));
  CHECK(tilting.with_sliding(forth) == ContactProblem(body, friction, indenter, 3, forth, 0.25_r));
  CHECK(tilting.with_friction(FrictionProfile({1, 3}, {0})) == under(FrictionProfile({1, 3}, {0})));
  CHECK(tilting.with_jump(0.5_r, 1) == under(FrictionProfile({1, 2, 3}, {0, 0.5_r})));
  CHECK(tilting.with_jump(-0.5_r, 1) == under(FrictionProfile({1, 2, 2}, {-0.5_r, 0})));
  CHECK(tilting.moved(1, 0) == tilting);
  CHECK(tilting.mirrored() == ContactProblem(tilting.elasticity(), FrictionProfile({2, 1}, {0}), tilting.indenter(), 3,
                                             Sliding::plus_x, -0.25_r));
}

TEST_CASE("a changed problem keeps the rules of a problem") {
  CHECK(refusal([] { tilting.with_load(0); }) == "load: load out of range; the load is positive; 0");
  CHECK(refusal([] { tilting.with_jump(0, 1); }) ==
        "friction.jumps[1]: jumps not in order; jumps increase from left to right; 0 after 0");
  CHECK(refusal([] { tilting.with_jump(2, 1); }) ==
        "friction.jumps[1]: jump outside the support; jumps lie in ]-1, 1[; 2");
  CHECK(refusal([] {
          tilting.with_indenter(Indenter(-2, {{0.25_r, Polynomial()}}));
        }) == "load_at: load outside the support; the load acts in ]-2, 0.25[; 0.25");
}

TEST_CASE("moves: identity, inverse, composition, and what stays at its place") {
  CHECK(rc::check([] {
    const ContactProblem problem = *coincidences();
    const Rational a = random_scale(), b = random_place(), c = random_scale(), d = random_place();
    RC_ASSERT(problem.moved(1, 0) == problem);
    RC_ASSERT(problem.mirrored().mirrored() == problem);
    RC_ASSERT(!(problem.mirrored() == problem));
    RC_ASSERT(problem.moved(a, b).moved(1 / a, -b / a) == problem);
    RC_ASSERT(problem.moved(a, b).moved(c, d) == problem.moved(a * c, c * b + d));

    const Rational x = random_place();
    const ContactProblem image = problem.moved(a, b);
    RC_ASSERT(image.load_at().has_value() == problem.load_at().has_value());
    for (const Side side : {Side::left, Side::right}) {
      const Side there = a > 0 ? side : opposite(side);
      RC_ASSERT(image.friction().at(a * x + b, there) == problem.friction().at(x, side));
      RC_ASSERT(image.indenter().profile(a * x + b, there)(a * x + b) == problem.indenter().profile(x, side)(x));
    }
    // The equation keeps s t. The integral changes its sign.
    for (std::size_t k = 0; k < problem.friction().values().size(); ++k) {
      const std::size_t there = a > 0 ? k : problem.friction().values().size() - 1 - k;
      RC_ASSERT(image.coupled_friction(there) == (a > 0 ? 1 : -1) * problem.coupled_friction(k));
    }
  }));
}

TEST_CASE("a further jump lifts the friction from there to the next jump") {
  CHECK(rc::check([] {
    const ContactProblem problem = *coincidences();
    const Rational c = random_place(), height = Rational(uniform(0, 9), 4), x = random_place();
    const FrictionProfile& friction = problem.friction();
    const FrictionProfile more = problem.with_jump(c, height).friction();
    RC_ASSERT(more.jumps().size() == friction.jumps().size() + 1);
    const bool lifted = x > c && friction.piece(x, Side::left) == friction.piece(c, Side::left);
    if (x != c) RC_ASSERT(more.at(x, Side::left) == friction.at(x, Side::left) + (lifted ? height : 0_r));
  }));
}

TEST_CASE("the pieces fill the support, each with its friction and its polynomial") {
  std::size_t most = 0;
  CHECK(rc::check([&] {
    const ContactProblem problem = *coincidences();
    const std::vector<ContactProblem::Piece> pieces = problem.pieces();
    most = std::max(most, pieces.size());
    RC_ASSERT(pieces.front().left == problem.indenter().left());
    RC_ASSERT(pieces.back().right == problem.indenter().right());
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      const Rational middle = (pieces[k].left + pieces[k].right) / 2;
      RC_ASSERT(pieces[k].left < pieces[k].right);
      for (const Rational& x : {pieces[k].left, middle, pieces[k].right}) {
        const Side side = x == pieces[k].right ? Side::left : Side::right;
        RC_ASSERT(pieces[k].friction == problem.friction().piece(x, side));
        RC_ASSERT(&problem.indenter().pieces()[pieces[k].profile].profile == &problem.indenter().profile(x, side));
      }
      if (k == 0) continue;
      RC_ASSERT(pieces[k].left == pieces[k - 1].right);
      RC_ASSERT(pieces[k].friction != pieces[k - 1].friction || pieces[k].profile != pieces[k - 1].profile);
    }
  }));
  CHECK(most > 4);
}

TEST_CASE("the body is dragged along: the shear's sign is that of sliding, against a pressure's") {
  CHECK(rc::check([] {
    const ContactProblem problem = *coincidences();
    for (std::size_t k = 0; k < problem.friction().values().size(); ++k) {
      const Rational ratio = problem.shear_ratio(k);
      RC_ASSERT(abs(ratio) == problem.friction().values()[k]);
      RC_ASSERT(ratio == 0 || sign(-ratio) == static_cast<int>(problem.sliding()));
      RC_ASSERT(problem.coupled_friction(k) == -problem.elasticity().gamma() * ratio);
    }
  }));
}
