// The stresses below the surface by independent methods: the adaptive tanh-sinh rule and, for one friction value and
// one polynomial, potentials in closed form. Also their limits next to the surface and far from it.

#include <algorithm>
#include <random>

#include "numeric/closed_form/closed_form.hpp"
#include "numeric/interior/interior_stress.hpp"
#include "numeric/interior/interior_stress_problems.hpp"
#include "numeric/variational/variational_inequality.hpp"

using namespace steadyslide::numeric::stress_test;

namespace {

const char* const depths[] = {"1/2", "1/100", "1/10000", "1/100000000"};

/// C = g + tilt - Y B and its derivative for constant friction; then B needs no integral.
template <Real R>
StressComponents<R> by_potentials(const RiemannHilbertSolution<R>& solution, const Rational& x, const Rational& z) {
  using Z = Complex<R>;
  const auto times = [](const Z& a, const Z& b) { return Z{a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re}; };
  const TractionRepresentation<R>& form = solution.form();
  const Frame& frame = solution.problem().frame();
  const Z zeta{to_real<R>((x - frame.origin) / frame.unit), to_real<R>(z / frame.unit)};
  const std::vector<R>& g = solution.problem().slopes().front();
  REQUIRE(g.size() <= 2);
  const R linear = g.size() == 2 ? g[1] : R(0);
  // B is the load over -pi under a punch, and the curvature under a parabola.
  const R b = form.q().empty() ? linear : R(-form.q().front() / pi<R>());
  const Z y = form.fundamental_solution().at(zeta);
  Z logarithmic{R(0), R(0)};
  for (std::size_t j = 0; j < form.fundamental_solution().powers().size(); ++j) {
    const R re = zeta.re - form.fundamental_solution().point(j);
    const R p = form.fundamental_solution().powers()[j].value / (re * re + zeta.im * zeta.im);
    logarithmic = {logarithmic.re + p * re, logarithmic.im - p * zeta.im};
  }
  const Z slope = times(y, logarithmic);
  const R constant = g.empty() ? R(0) : g[0];
  const Potential<R> c{{constant + linear * zeta.re - b * y.re, linear * zeta.im - b * y.im},
                       {linear - b * slope.re, -b * slope.im}};
  const auto segment = static_cast<std::size_t>(form.set().all(ContactSet<R>::Kind::begins).front());
  const R r = solution.shear_ratio(segment);
  const Potential<R> shear{{r * c.value.re, r * c.value.im}, {r * c.derivative.re, r * c.derivative.im}};
  return stress_of_potentials(c, shear, zeta.im);
}

}  // namespace

TEST_CASE("closed potentials: constant friction under a punch and a parabola, at every depth") {
  using R = Real50;
  for (const Sliding sliding : {Sliding::plus_x, Sliding::minus_x}) {
    for (const ContactProblem& problem : {punch(sliding), parabola(sliding)}) {
      const Solved<R> solved(problem);
      for (const double fraction : {-0.5, 1e-9, 0.25, 0.5, 0.999, 1 + 1e-9, 1.25}) {
        for (const char* depth : depths) {
          CAPTURE(fraction);
          CAPTURE(std::string(depth));
          const Rational x = solved.place(fraction), z = parse_rational(depth);
          const StressState<R> found = solved.interior.at(x, z);
          const StressComponents<R> expected = by_potentials(solved.solution, x, z);
          CHECK(difference(components(found), expected) < R("1e-40") * size(expected));
          CHECK(found.xx.convergence == Convergence::reached);
        }
      }
    }
  }
}

TEST_CASE("quadrature of the tractions: jumps, wedges, edges, at every depth") {
  std::minstd_rand random(2016);
  std::uniform_real_distribution<double> between(-0.3, 1.3);
  for (const ContactProblem& problem : {jumps(), corners(), corners(Sliding::minus_x), punch()}) {
    const Solved<double> solved(problem);
    std::vector<Rational> places{0,      Rational(1e-9),     Rational(-1e-7),
                                 0.25_r, solved.place(1e-6), solved.place(1 - 1e-9)};
    for (int i = 0; i < 12; ++i) places.push_back(solved.place(between(random)));
    for (const Rational& x : places) {
      for (const char* depth : depths) {
        CAPTURE(to_real<double>(x));
        CAPTURE(std::string(depth));
        const Rational z = parse_rational(depth);
        const StressComponents<double> found = components(solved.interior.at(x, z));
        const StressComponents<double> expected = by_quadrature(solved.solution, x, z);
        CHECK(difference(found, expected) < 1e-10 * size(expected));
      }
      // Controls: the shear reversed, and one percent more of it.
      const Rational z(1, 2);
      const StressComponents<double> found = components(solved.interior.at(x, z));
      for (const double factor : {-1.0, 1.01}) {
        CHECK(difference(found, by_quadrature(solved.solution, x, z, factor)) > 1e-4 * size(found));
      }
    }
  }
}

TEST_CASE("under a gap that is shorter than the digits of its place show") {
  const Polynomial left({0, 0.01_r, 1}), right({0.002_r, -0.01_r, 1});
  const ContactProblem problem(body(), FrictionProfile({0.5_r}), Indenter(-2, {{0.1_r, left}, {2, right}}), 1);
  const Solved<double> solved(problem);
  REQUIRE(solved.solution.contact().size() == 2);
  const auto contact = solved.solution.contact();
  REQUIRE(contact[1].left.x.value - contact[0].right.x.value < 1e-40);
  const auto cells = variational_inequality(problem, {.cells = 4096}).solution;
  const InteriorStress<double> below(*cells);
  for (const double fraction : {-0.2, 0.3, 0.6, 1.2}) {
    const Rational x = solved.place(fraction), z = 0.2_r;
    const Estimate<double> found = *solved.interior.at(x, z).von_mises(), other = *below.at(x, z).von_mises();
    CHECK(found.error < 1e-8);
    CHECK(std::abs(found.value - other.value) <= other.error);
  }
}

TEST_CASE("next to a free end: in double as far from the closed potentials as the errors say, by both methods") {
  std::vector<double> ratios;
  int displaced = 0;
  for (const Sliding sliding : {Sliding::plus_x, Sliding::minus_x}) {
    const ContactProblem problem = parabola(sliding);
    const Solved<Real50> exact(problem);
    for (const auto& rough : {closed_form<double>(problem).solution, riemann_hilbert<double>(problem).solution}) {
      const InteriorStress<double> interior(*rough);
      for (const double from_end : {-1e-3, -1e-6, -1e-9, 1e-9, 1e-6, 1e-3}) {
        for (const double fraction : {from_end, 1 - from_end}) {
          for (const char* depth : depths) {
            CAPTURE(fraction);
            CAPTURE(std::string(depth));
            const Rational x = exact.place(fraction), z = parse_rational(depth);
            const StressState<double> found = interior.at(x, z);
            const StressComponents<Real50> expected = by_potentials(exact.solution, x, z);
            for (const auto& [a, b] :
                 {std::pair(found.xx, expected.xx), {found.zz, expected.zz}, {found.xz, expected.xz}}) {
              const double error = off_by(a, {b});
              CHECK(error <= a.error);
              ratios.push_back(a.error / error);
              if (error > 1e-12 * std::abs(a.value)) ++displaced;
            }
          }
        }
      }
    }
  }
  // The errors are not large. Rounding alone would not be enough: the place of an end matters.
  std::ranges::nth_element(ratios, ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2));
  CHECK(ratios[ratios.size() / 2] < 1000);
  CHECK(displaced > 10);
}

// Slow: 13 s of tanh-sinh rules at 50 digits.
TEST_CASE("slow: quadrature of the tractions at 50 digits, next to a jump and a wedge" * doctest::skip()) {
  using R = Real50;
  const Rational z = parse_rational("1/100000000"), x(1e-9);
  for (const ContactProblem& problem : {jumps(), corners()}) {
    const Solved<R> solved(problem);
    const StressComponents<R> found = components(solved.interior.at(x, z));
    CHECK(difference(found, by_quadrature(solved.solution, x, z)) < R(1e-40) * size(found));
    // Control: one percent more shear.
    CHECK(difference(found, by_quadrature(solved.solution, x, z, R(1.01))) > R(1e-4) * size(found));
  }
}

// Slow: 8 s of stresses at 50 digits.
TEST_CASE("slow: double agrees with 50 digits to what its errors say" * doctest::skip()) {
  std::minstd_rand random(36);
  std::uniform_real_distribution<double> between(-0.3, 1.3);
  for (const ContactProblem& problem : {jumps(), corners(), punch()}) {
    const Solved<double> rough(problem);
    const Solved<Real50> fine(problem);
    for (int i = 0; i < 6; ++i) {
      const double fraction = i == 0 ? 1e-9 : i == 1 ? 1 - 1e-7 : between(random);
      const Rational x = rough.place(fraction);
      for (const char* depth : depths) {
        CAPTURE(fraction);
        CAPTURE(std::string(depth));
        const Rational z = parse_rational(depth);
        const StressState<double> found = rough.interior.at(x, z);
        const StressState<Real50> expected = fine.interior.at(x, z);
        errors_cover(found, expected);
        const double scale = static_cast<double>(size(components(expected)));
        for (const Estimate<double>& number : numbers(found)) CHECK((i < 2 || number.error < 1e-10 * scale));
      }
    }
  }
}
