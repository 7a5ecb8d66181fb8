// Contacts of indenters whose profile is a spline through points.

#include "library/problem_file/profile_trace.hpp"
#include "library/solve/method.hpp"
#include "numeric/closed_form/closed_form.hpp"
#include "numeric/riemann_hilbert/riemann_hilbert.hpp"
#include "numeric/variational/variational_inequality.hpp"
#include "support/problems.hpp"
#include "support/test.hpp"

using namespace steadyslide::library;

namespace {

using Solution = numeric::ContactSolution<double>;

template <class Profile>
Indenter spline_through(int points, Profile profile) {
  std::string text;
  for (int i = 0; i < points; ++i) {
    const Rational x = Rational(2 * i, points - 1) - 1;
    text += to_string(x) + "," + to_string(profile(x)) + "\n";
  }
  ProfileTrace trace = parse_trace(text, "t.csv", std::nullopt, {1, Detrend::none, {}, Interpolation::spline});
  return {trace.range.left, std::move(trace.pieces)};
}

ContactProblem under(const Indenter& indenter) { return reduced({0.1_r, 0.4_r}, {0.05_r}, indenter, 0.1_r); }

std::shared_ptr<const Solution> solved(const ContactProblem& problem) {
  auto solution = numeric::riemann_hilbert<double>(problem).solution;
  REQUIRE(solution);
  REQUIRE(solution->failed_condition() == "");
  return solution;
}

/// Returns the largest difference of the ends, of the effective friction and of the centre of pressure.
double difference(const Solution& a, const Solution& b) {
  const auto ends_a = a.contact(), ends_b = b.contact();
  REQUIRE(ends_a.size() == 1);
  REQUIRE(ends_b.size() == 1);
  const auto forces_a = a.resultants(), forces_b = b.resultants();
  return std::max({std::abs(ends_a[0].left.x.value - ends_b[0].left.x.value),
                   std::abs(ends_a[0].right.x.value - ends_b[0].right.x.value),
                   std::abs(forces_a.effective_friction.value - forces_b.effective_friction.value),
                   std::abs(forces_a.centre_of_pressure.value - forces_b.centre_of_pressure.value)});
}

}  // namespace

TEST_CASE("a spline through 400 points of a parabola is in contact like the parabola") {
  const auto with_one_friction = [](const Indenter& indenter) { return reduced({0.3_r}, {}, indenter, 0.1_r); };
  const Polynomial parabola({0, 0, 0.5_r});
  const auto found = solved(with_one_friction(spline_through(400, parabola)));
  const auto exact =
      numeric::closed_form<double>(with_one_friction(one_piece(-1, 1, parabola.coefficients()))).solution;
  REQUIRE(exact);
  CHECK(difference(*found, *exact) < 1e-10);
  const double peak = exact->largest_pressure().value.value;
  CHECK(std::abs(found->largest_pressure().value.value - peak) < 1e-9 * peak);
  // The control: with straight lines the ends differ by the square of their length.
  std::string text;
  for (int i = 0; i <= 40; ++i)
    text += to_string(Rational(i - 20, 20)) + "," + to_string(parabola(Rational(i - 20, 20))) + "\n";
  ProfileTrace lines = parse_trace(text, "t.csv", std::nullopt);
  CHECK(difference(*solved(with_one_friction(Indenter(-1, std::move(lines.pieces)))), *exact) > 1e-5);
}

// The error of a spline's slope is like h^4 at the points and like h^3, with changing sign, between them. An integral of
// it with the weight 1/sqrt(d) at an end is between both.
TEST_CASE("a contact under a spline tends to that of the smooth profile faster than the third power of the distance") {
  const Polynomial profile({0, 0.02_r, 0.5_r, 0.3_r, 2});
  const auto exact = solved(under(one_piece(-1, 1, profile.coefficients())));
  const auto error = [&](int points) { return difference(*solved(under(spline_through(points, profile))), *exact); };
  const double coarse = error(41), fine = error(161);
  const double rate = std::log2(coarse / fine) / 2;
  CAPTURE(coarse);
  CAPTURE(fine);
  CHECK(rate > 3);
  CHECK(rate < 4.5);
}

TEST_CASE("both methods agree under a spline, and auto takes the one that finds the ends") {
  const ContactProblem problem = under(spline_through(60, Polynomial({0, 0.02_r, 0.5_r, 0.3_r, 2})));
  const auto on_cells = numeric::variational_inequality(problem, {}).solution;
  REQUIRE(on_cells);
  CHECK(difference(*solved(problem), *on_cells) < 5e-4);  // a cell
  const Choice choice = choice_of(Method::automatic, problem, false);
  CHECK_FALSE(choice.on_cells);
  CHECK(choice.reason == "a formula if one applies; no rule asks for cells");
}

TEST_CASE("auto takes cells for many zones under a spline of many pieces, for 16 digits without a proof") {
  // Ridges on a parabola, a ridge on each ten points.
  const auto ridges = [](int points, const Rational& height) {
    return under(spline_through(points, [height, i = 0](const Rational& x) mutable {
      return Rational(x * x / 2 + (i++ / 5 % 2 == 0 ? height : Rational(0)));
    }));
  };
  const ContactProblem many = ridges(1202, 0.02_r);
  const Choice choice = choice_of(Method::automatic, many, false);
  CHECK(choice.on_cells);
  CHECK(choice.reason.ends_with("contact zones on 4096 cells, more than 10, of a profile of more than 1000 pieces"));
  CHECK_FALSE(choice_of(Method::automatic, many, false, 17).on_cells);
  CHECK_FALSE(choice_of(Method::riemann_hilbert, many, false).on_cells);
  CHECK_FALSE(choice_of(Method::automatic, ridges(1202, 0), false).on_cells);
  CHECK_FALSE(choice_of(Method::automatic, ridges(1000, 0.02_r), false).on_cells);
}
