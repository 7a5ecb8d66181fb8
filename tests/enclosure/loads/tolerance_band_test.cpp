// Intervals of load shares and friction within a tolerance, against solutions of problems with other data.

#include "enclosure/loads/tolerance_band.hpp"

#include "numeric/riemann_hilbert/riemann_hilbert.hpp"
#include "support/numeric_test.hpp"
#include "support/problems.hpp"

namespace steadyslide::enclosure {
namespace {

struct Shares {
  std::vector<double> load_share;
  double effective_friction;
};

Shares solved(const ContactProblem& problem) {
  const auto found = numeric::riemann_hilbert<double>(problem).solution;
  REQUIRE(found);
  REQUIRE(found->failed_condition() == "");
  const auto forces = found->resultants();
  Shares result{{}, forces.effective_friction.value};
  for (const auto& share : forces.load_share) result.load_share.push_back(share.value);
  return result;
}

bool may_be(const Ball& interval, double value) {
  const Ball number = Ball::exactly(value, 64);
  return interval.lower() <= number && number <= interval.upper();
}

/// True if the band around the first problem contains shares and friction of the second one.
bool contains(const ToleranceBand& band, const Shares& own, const Shares& other) {
  for (std::size_t k = 0; k < own.load_share.size(); ++k) {
    if (!may_be(band.load_share(k, Ball::exactly(own.load_share[k], 64)), other.load_share[k])) return false;
  }
  return may_be(band.effective_friction(Ball::exactly(own.effective_friction, 64)), other.effective_friction);
}

/// A punch on [-1, 1], its left half raised by `step`, inclined by `slope`, with a bend of `bend` x^2/2.
Indenter punch(const Rational& step, const Rational& slope, const Rational& bend) {
  const Rational half_bend = bend / 2;
  return {-1, {{0, Polynomial({step, slope, half_bend})}, {1, Polynomial({0, slope, half_bend})}}};
}

}  // namespace

TEST_SUITE_BEGIN("tolerance_band");

TEST_CASE("the energy is 2 e/(c P) + gamma d") {
  const ContactProblem problem = testing::reduced({0.1_r, 0.3_r}, {0}, punch(0, 0, 0), 5);
  const ToleranceBand band(problem, 0.1_r, 0.02_r);  // 0.2/5 + 0.02/2
  CHECK(band.energy().contains(0.05_r));
  // One jump by 1/5 at an end of each strip: sqrt(2 E/(1/5)) = sqrt(1/2).
  const Ball share = band.load_share(0, Ball(0));
  CHECK(share.contains(0.707106_r));
  CHECK_FALSE(share.contains(0.707108_r));
  // f jumps by 2/5: sqrt(2 E (2/5)^2/(1/5)) + d, and f lies between 0.2 - d and 0.6 + d.
  const Ball friction = band.effective_friction(Ball(0.2_r, 64));
  CHECK(friction.contains(0.18_r));
  CHECK_FALSE(friction.contains(0.179_r));
  CHECK(friction.contains(0.502842_r));
  CHECK_FALSE(friction.contains(0.502844_r));
}

TEST_CASE("a friction that falls has no band") {
  const ContactProblem falling = testing::reduced({0.3_r, 0.1_r}, {0.25_r}, punch(0, 0, 0), 1);
  CHECK_THROWS_WITH(ToleranceBand(falling, 1, 0), "no bound where s = +-gamma f decreases towards +x, at x = 0.25");
  CHECK_NOTHROW(ToleranceBand(falling.with_sliding(Sliding::minus_x), 1, 0));
}

TEST_CASE("a jump of height zero says nothing of its loads") {
  const ContactProblem problem = testing::reduced({0.1_r, 0.1_r, 0.4_r}, {-0.5_r, 0.5_r}, punch(0, 0, 0), 1);
  const ToleranceBand band(problem, Rational(1, 10000), 0);
  for (const std::size_t k : {0U, 1U}) {
    CHECK(band.load_share(k, Ball(0.3_r, 64)).contains(Rational(0)));
    CHECK(band.load_share(k, Ball(0.3_r, 64)).contains(Rational(1)));
  }
  CHECK_FALSE(band.load_share(2, Ball(0.3_r, 64)).contains(Rational(0)));
}

// The left half of a punch moves up or down, which shifts the load most; or the punch is inclined or bent; the friction
// moves, too, so that it may fall.
TEST_CASE("shares and friction of other data within the tolerance lie in the band") {
  double largest = 0;
  for (const Rational& rise : {0.2_r, 1_r, 4_r}) {
    for (const Rational& e : {0.001_r, 0.02_r, 0.2_r}) {
      for (const Rational& d : {0_r, 0.1_r}) {
        const ContactProblem problem = testing::reduced({0.1_r, 0.1_r + rise}, {0}, punch(0, 0, 0.3_r), 1);
        const Shares own = solved(problem);
        const ToleranceBand band(problem, e, d);
        // The middle of profiles whose steps are 2 e is e away from both.
        for (const Indenter& shape :
             {punch(2 * e, 0, 0.3_r), punch(-2 * e, 0, 0.3_r), punch(0, e, 0.3_r), punch(0, 0, 0.3_r - 4 * e)}) {
          for (const int way : {1, -1}) {
            const Rational change = way * d / 2;  // of s = f/2
            const ContactProblem moved = testing::reduced({0.1_r - change / 2, 0.1_r + rise + change}, {0}, shape, 1);
            const Shares other = solved(moved);
            CAPTURE(rise);
            CAPTURE(e);
            CAPTURE(d);
            CAPTURE(way);
            CHECK(contains(band, own, other));
            const double bound = band.load_share(0, Ball(0)).upper().to_double();
            if (bound < 1) largest = std::max(largest, std::abs(other.load_share[0] - own.load_share[0]) / bound);
          }
        }
      }
    }
  }
  MESSAGE("largest change of a load share over its bound: ", largest);
  CHECK(largest > 0.1);  // a bound that is ten times smaller fails above
}

TEST_SUITE_END();

}  // namespace steadyslide::enclosure
