#include "model/contact_problem.hpp"
#include "broken_rule.hpp"

namespace {

const Polynomial flat;
const Polynomial slope({0, 1});
const Polynomial bowl({0, 0, 1});

const Elasticity rigid(Solid(0.3_r, 1)), elastic(Solid(0.3_r, 1), Solid(0.2_r, 2));
Indenter on_unit(const Polynomial& profile) { return Indenter(-1, {{1, profile}}); }

}  // namespace

TEST_CASE("friction profiles that do not exist") {
  const auto profile = [](std::vector<Rational> values, std::vector<Rational> jumps) {
    return refusal([&] { FrictionProfile(std::move(values), std::move(jumps)); });
  };
  CHECK(profile({}, {}) == "friction.values: no friction value; there is at least one; 0 values");
  CHECK(profile({1}, {0}) ==
        "friction.jumps: wrong number of jumps; there is one jump fewer than friction values; 1 values, 1 jumps");
  CHECK(profile({1, 2, 3}, {0}) ==
        "friction.jumps: wrong number of jumps; there is one jump fewer than friction values; 3 values, 1 jumps");
  CHECK(profile({1, -0.1_r}, {0}) ==
        "friction.values[1]: negative friction coefficient; a friction coefficient is at least 0; -0.1");
  CHECK(profile({1, 2, 3}, {0, 0}) ==
        "friction.jumps[1]: jumps not in order; jumps increase from left to right; 0 after 0");
  CHECK(profile({1, 2, 3, 4}, {0, Rational(1, 3), 0.25_r}) ==
        "friction.jumps[2]: jumps not in order; jumps increase from left to right; 0.25 after 1/3");
  CHECK(profile({0}, {}) == "accepted");
  CHECK(profile({1, 1}, {0}) == "accepted");
}

TEST_CASE("friction at a point and on both sides of a jump") {
  const FrictionProfile friction({1, 2, 3}, {0, 0.5_r});
  using Case = std::tuple<Rational, int, int>;  // a place, f on its left and on its right
  for (const auto& [x, left, right] : {Case{-5, 1, 1}, {0, 1, 2}, {0.25_r, 2, 2}, {0.5_r, 2, 3}, {5, 3, 3}}) {
    CHECK(friction.at(x, Side::left) == left);
    CHECK(friction.at(x, Side::right) == right);
    CHECK(friction.piece(x, Side::left) + 1 == static_cast<std::size_t>(left));
    CHECK(friction.piece(x, Side::right) + 1 == static_cast<std::size_t>(right));
  }
  CHECK(FrictionProfile({7}).at(0, Side::left) == 7);
}

TEST_CASE("indenters that do not exist") {
  const auto indenter = [](const Rational& left, std::vector<Indenter::Piece> pieces) {
    return refusal([&] { Indenter(left, std::move(pieces)); });
  };
  CHECK(indenter(0, {}) == "indenter.pieces: no piece; an indenter has at least one; 0 pieces");
  const std::string rule =
      "piece of no length; pieces follow each other from left to right, each with a positive length; ";
  CHECK(indenter(1, {{1, flat}}) == "indenter.pieces[0].to: " + rule + "from 1 to 1");
  CHECK(indenter(1, {{-1, flat}}) == "indenter.pieces[0].to: " + rule + "from 1 to -1");
  CHECK(indenter(-1, {{0, flat}, {0, flat}}) == "indenter.pieces[1].to: " + rule + "from 0 to 0");
  CHECK(indenter(-1, {{0, flat}, {1, flat}, {Rational(1, 3), flat}}) ==
        "indenter.pieces[2].to: " + rule + "from 1 to 1/3");
  CHECK(indenter(-1, {{1, flat}}) == "accepted");
}

TEST_CASE("breaks of an indenter: value and slope on the right minus those on the left") {
  // psi = -x/2 up to 1, then x^2 - 2 up to 2, then 3x - 3: at 1 value -1 - -1/2, slope 2 + 1/2; at 2 value 3 - 2, slope
  // 3 - 4.
  const Indenter indenter(0, {{1, Polynomial({0, -0.5_r})}, {2, Polynomial({-2, 0, 1})}, {3, Polynomial({-3, 3})}});
  std::vector<std::vector<Rational>> breaks;
  for (const auto& b : indenter.breaks()) breaks.push_back({b.x, b.step, b.wedge});
  CHECK(breaks == std::vector<std::vector<Rational>>{{1, -0.5_r, 2.5_r}, {2, 1, -1}});
  CHECK_FALSE(indenter.is_smooth());
  CHECK(indenter.left() == 0);
  CHECK(indenter.right() == 3);
  // Only the curvature changes: smooth.
  CHECK(Indenter(-1, {{0, flat}, {1, bowl}}).is_smooth());
  CHECK(Indenter(-1, {{1, bowl}}).is_smooth());
  CHECK_FALSE(Indenter(-1, {{0, flat}, {1, slope}}).is_smooth());
  CHECK_FALSE(Indenter(-1, {{0, flat}, {1, Polynomial({1})}}).is_smooth());
}

TEST_CASE("problems that do not exist") {
  const auto problem = [](Elasticity elasticity, FrictionProfile friction, Indenter indenter, Rational load,
                          std::optional<Rational> load_at = std::nullopt) {
    return refusal([&] {
      ContactProblem(std::move(elasticity), std::move(friction), std::move(indenter), std::move(load), Sliding::plus_x,
                     std::move(load_at));
    });
  };
  const FrictionProfile one({1});
  const auto jump_at = [](const Rational& c) { return FrictionProfile({1, 2}, {c}); };
  CHECK(problem(rigid, one, on_unit(flat), 0) == "load: load out of range; the load is positive; 0");
  CHECK(problem(rigid, one, on_unit(flat), -0.5_r) == "load: load out of range; the load is positive; -0.5");
  CHECK(problem(rigid, jump_at(1), on_unit(flat), 1) ==
        "friction.jumps[0]: jump outside the support; jumps lie in ]-1, 1[; 1");
  CHECK(problem(rigid, jump_at(-1), on_unit(flat), 1) ==
        "friction.jumps[0]: jump outside the support; jumps lie in ]-1, 1[; -1");
  CHECK(problem(rigid, FrictionProfile({1, 2, 3}, {0, 2}), on_unit(flat), 1) ==
        "friction.jumps[1]: jump outside the support; jumps lie in ]-1, 1[; 2");
  CHECK(problem(rigid, one, on_unit(flat), 1, 1) == "load_at: load outside the support; the load acts in ]-1, 1[; 1");
  CHECK(problem(rigid, one, on_unit(flat), 1, -1.5_r) ==
        "load_at: load outside the support; the load acts in ]-1, 1[; -1.5");
  CHECK(problem(elastic, one, Indenter(-1, {{0, flat}, {1, slope}}), 1) ==
        "indenter.pieces: elastic indenter with a wedge or a step; the profile of an elastic indenter is smooth; at x "
        "= 0");
  CHECK(problem(elastic, one, Indenter(-1, {{0, flat}, {0.5_r, bowl}, {1, flat}}), 1) ==
        "indenter.pieces: elastic indenter with a wedge or a step; the profile of an elastic indenter is smooth; at x "
        "= 0.5");
  CHECK(problem(elastic, one, Indenter(-1, {{0, flat}, {1, bowl}}), 1) == "accepted");
  CHECK(problem(rigid, one, Indenter(-1, {{0, flat}, {1, slope}}), 1, 0) == "accepted");
  CHECK(problem(rigid, jump_at(0.999_r), on_unit(flat), 1e-400_r) == "accepted");
}

TEST_CASE("coupled friction has the sign of gamma and of the direction") {
  const Rational gamma(2, 7);
  const ContactProblem right(Elasticity::reduced(gamma), FrictionProfile({1, 2}, {0}), on_unit(flat), 1);
  CHECK(right.sliding() == Sliding::plus_x);
  CHECK(right.coupled_friction(0) == gamma);
  CHECK(right.coupled_friction(1) == 2 * gamma);
  CHECK(right.with_sliding(Sliding::minus_x).coupled_friction(1) == -2 * gamma);
  const ContactProblem soft(Elasticity::reduced(-gamma), right.friction(), on_unit(flat), 1);
  CHECK(soft.coupled_friction(1) == -2 * gamma);
  CHECK_THROWS_AS(right.coupled_friction(2), std::out_of_range);
}
