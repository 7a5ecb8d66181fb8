#include "numeric/riemann_hilbert/rounded_problem.hpp"
#include "model/singular_point.hpp"
#include "support/numeric_test.hpp"

namespace {

Rational random_rational(int size, int denominator) {
  return Rational(uniform(-size * denominator, size * denominator), denominator);
}

/// Three pieces on [-1, 2]: a step up at 0, a wedge at 1; friction jumps at -1/2 and 1.
template <class Choose>
ContactProblem some_problem(const Choose& choose) {
  const Polynomial a({choose(2, 7), choose(2, 5), choose(2, 3), choose(1, 9)});
  const Polynomial b = a + Polynomial({1});
  const Polynomial c = b + Polynomial({-1, 1}) * Polynomial({choose(3, 11), choose(3, 4), 7});
  return {Elasticity(Solid(0.2_r, 3.5_r)),
          FrictionProfile({Rational(1, 3), 2, 0}, {-0.5_r, 1}),
          Indenter(-1, {{0, a}, {1, b}, {2, c}}),
          Rational(5, 3),
          Sliding::minus_x,
          Rational(1, 7)};
}

Frame random_frame() { return {random_rational(3, 64), Rational(uniform(1, 2000), 128)}; }

template <Real R>
bool close(const R& found, const Rational& exact, const R& scale) {
  using std::abs;
  return abs(found - to_real<R>(exact)) <= 64 * epsilon<R>() * scale;
}

/// Returns the sum of the sizes of the polynomial's terms.
Rational size_at(const Polynomial& p, const Rational& x) {
  Rational sum = 0, power = 1;
  for (const Rational& c : p.coefficients()) {
    sum += abs(c) * power;
    power *= abs(x);
  }
  return sum;
}

}  // namespace

TEST_CASE_TEMPLATE("a frame changes no slope and no height", R, double, Real50) {
  CHECK(rc::check("frames", [] {
    const ContactProblem p = some_problem(random_rational);
    const Frame frame = random_frame();
    const RoundedProblem<R> reduced(p, frame);
    const Rational c = p.elasticity().compliance();
    RC_ASSERT(reduced.anchors().size() == 5U);
    RC_ASSERT(reduced.slopes().size() == 2U);  // a step without another slope
    for (std::size_t k = 0; k + 1 < reduced.anchors().size(); ++k) {
      const Rational width = reduced.place(k + 1) - reduced.place(k);
      RC_ASSERT(close(reduced.spacing(k), width / frame.unit, reduced.spacing(k)));
      const std::size_t piece = k < 2 ? 0 : k - 1;
      const Polynomial& profile = p.indenter().pieces()[piece].profile;
      const Polynomial slope = profile.derivative();
      // The effect of rounding is proportional to the terms in the frame, and its origin enters them.
      const Rational reach = abs(frame.origin) * 2 + 3;
      const R scale = to_real<R>(size_at(slope, reach) / c);
      for (int i = 0; i <= 8; ++i) {
        // Places that are exact in xi: multiples of 1/1024.
        const Rational at = (reduced.place(k) + width * i / 8 - frame.origin) / frame.unit;
        const Rational xi(static_cast<Integer>(numerator(at) * 1024 / denominator(at)), 1024);
        const Rational x = frame.origin + frame.unit * xi;
        RC_ASSERT(close(reduced.slope(reduced.slope_of(k), to_real<R>(xi)), slope(x) / c, scale));
        for (const Rational& step : {Rational(1, 1024), Rational(-1, 1048576), 1_r}) {
          const Rational rise = (profile(x + frame.unit * step) - profile(x)) / (c * frame.unit);
          // Rounding changes the rise over a short interval no more than the slope: there is no cancellation.
          const R found = reduced.profile_increment(reduced.slope_of(k), to_real<R>(xi), to_real<R>(step));
          const Rational far = reach + frame.unit;
          RC_ASSERT(close(found, rise, to_real<R>(abs(step) * size_at(slope, far) / c)));
        }
      }
    }
    RC_ASSERT(close(reduced.load(), p.load() / frame.unit, reduced.load()));
    RC_ASSERT(close(*reduced.load_at(), (*p.load_at() - frame.origin) / frame.unit, R(8 / to_real<R>(frame.unit))));
  }));
}

TEST_CASE("anchors: steps, wedges, friction to the left and to the right, and where edges may be") {
  const ContactProblem p = some_problem([](int size, int denominator) { return Rational(size, denominator); });
  const RoundedProblem<double> reduced(p, {0, 2});
  const auto& anchors = reduced.anchors();
  CHECK(anchors[2].step_sign == 1);
  CHECK(anchors[2].step * 2 * to_real<double>(p.elasticity().compliance()) == doctest::Approx(1).epsilon(1e-15));
  CHECK(!anchors[2].exact.wedge);
  CHECK(anchors[3].exact.wedge);
  CHECK(!anchors[1].is_break);
  for (std::size_t k = 0; k < 4; ++k) CHECK(reduced.friction_of(k) == (k < 1 ? 0 : k < 3 ? 1 : 2));
  // Sliding towards -x changes the sign of s.
  CHECK(reduced.s(1) < 0);
  CHECK(reduced.jump(1).exponent == jump_exponent(p.coupled_friction(0), p.coupled_friction(1)));
  CHECK(reduced.jump(2).exponent.sign() == 0);
  // The profile is higher, farther from the body, on the right of the step: its left side protrudes, and contact that
  // ends there has an edge as its right end.
  const auto edges = [&](std::size_t anchor) {
    return std::pair(reduced.edge_possible(End::left, anchor), reduced.edge_possible(End::right, anchor));
  };
  CHECK(edges(0) == std::pair(true, false));
  CHECK(edges(1) == std::pair(false, false));
  CHECK(edges(2) == std::pair(false, true));
  CHECK(edges(3) == std::pair(false, false));
  CHECK(edges(4) == std::pair(false, true));
}
