// The largest average pressure, compared with formulas, with loads up to places all over the contact, and between
// methods and meshes.

#include "numeric/riemann_hilbert/riemann_hilbert.hpp"
#include "numeric/variational/variational_inequality.hpp"
#include "support/numeric_test.hpp"
#include "support/problems.hpp"

namespace {

/// Checks that no window on a grid of 1000 places, and none with an end at a singular point, has more than the largest
/// average, from the loads up to its ends, and that the window found has this average.
template <Real R>
void no_window_has_more(const ContactSolution<R>& solution, const Rational& length) {
  using std::abs;
  const auto contact = solution.contact();
  const Rational first(contact.front().left.x.value), width = Rational(contact.back().right.x.value) - first;
  const auto average = [&](const Rational& from) {
    const R load =
        solution.details_at(from + length).cumulative_load.value - solution.details_at(from).cumulative_load.value;
    return R(load / to_real<R>(length));
  };
  const AveragePressure<R> found = solution.largest_average_pressure(to_real<R>(length));
  // Windows with an end at a singular point have it exactly, because the load rises steeply there.
  std::vector<Rational> exact;
  for (const auto& point : solution.singular_points()) {
    const Rational x(point.x.value);
    for (const Rational& from : {x, Rational(x - length)}) {
      if (from >= first && from <= first + width - length) exact.push_back(from);
    }
  }
  R best = 0;
  for (const Rational& from : exact) best = std::max(best, average(from));
  for (int k = 0; k <= 1000; ++k) best = std::max(best, average(first + (width - length) * Rational(k, 1000)));
  CHECK(best <= found.value.value + 4 * found.value.error + R(1e-13) * best);
  CHECK(best >= found.value.value * R(0.98));
  Rational from = Rational(found.x.value) - length / 2;
  for (const Rational& end : exact) {
    if (abs(to_real<R>(from - end)) < R(1e-12)) from = end;
  }
  const R there = average(from);
  CHECK(abs(there - found.value.value) <= 4 * found.value.error + R(1e-9) * there);
}

}  // namespace

TEST_CASE_TEMPLATE("a window at the top of a parabola and at the edge of a punch: the formulas", R, double, Real50,
                   Real100) {
  using std::abs, std::asin, std::max, std::pow, std::sqrt;
  const R served = max(R(1000 * epsilon<R>()), R(pow(R(10), R(-digits_served<R> - 1))));
  // p = 2/(pi a) sqrt(1 - x^2/a^2) with a^2 = 2/pi.
  const R a = sqrt(2 / pi<R>()), h = R(0.125);
  const auto parabola = riemann_hilbert<R>(reduced({0}, {}, one_piece(-4, 4, {0, 0, 0.5_r}), 1)).solution;
  const AveragePressure<R> top = parabola->largest_average_pressure(2 * h);
  const R at_top = 2 / (pi<R>() * 2 * h) * (asin(h / a) + h / a * sqrt(1 - h * h / (a * a)));
  CHECK(abs(top.value.value - at_top) <= served * at_top);
  CHECK(abs(top.value.value - at_top) <= 10 * top.value.error + 100 * epsilon<R>() * at_top);
  CHECK(abs(top.x.value) <= sqrt(epsilon<R>()));
  // The control: the mean over a window that is longer by a hundredth.
  CHECK(abs(parabola->largest_average_pressure(2.02 * h).value.value - at_top) > 1e-5 * at_top);

  // p = 1/(pi sqrt(1 - x^2)).
  const auto punch = riemann_hilbert<R>(reduced({0}, {}, one_piece(-1, 1, {0}), 1)).solution;
  const AveragePressure<R> edge = punch->largest_average_pressure(2 * h);
  const R at_edge = (asin(R(1)) - asin(1 - 2 * h)) / (pi<R>() * 2 * h);
  CHECK(abs(edge.value.value - at_edge) <= served * at_edge);
  CHECK(abs(abs(edge.x.value) - (1 - h)) <= 10 * epsilon<R>());
  // A window that is longer than the contact.
  const AveragePressure<R> all = punch->largest_average_pressure(R(5));
  CHECK(abs(all.value.value - R(0.5)) <= served);
  CHECK(abs(all.x.value) <= 10 * epsilon<R>());
  CHECK_THROWS(punch->largest_average_pressure(R(0)));
}

TEST_CASE("several zones, corners and jumps of friction: no window has more, on cells neither") {
  // The pressure is largest left of the step, where the window ends.
  const Indenter stepped(-1, {{0, Polynomial()}, {2, Polynomial({1.1_r, -2, 1})}});
  const ContactProblem step = reduced({1}, {}, stepped, 1, std::nullopt, Sliding::minus_x);
  for (const ContactProblem& problem : {on_two_coatings(two_wells(), 0.4_r), on_two_coatings(two_wells(), 9),
                                        on_two_coatings(roof(-0.3_r, 0.4_r), 0.5_r),
                                        reduced({1, 0.2_r, 2}, {-0.4_r, 0.3_r}, one_piece(-1, 1, {0}), 1), step}) {
    const auto exact = riemann_hilbert<double>(problem).solution;
    for (const Rational& length : {0.02_r, 0.3_r}) {
      CAPTURE(to_string(length));
      no_window_has_more(*exact, length);
      const Estimate<double> truth = exact->largest_average_pressure(to_real<double>(length)).value;
      CHECK(truth.error <= 1e-9 * truth.value);
      for (const std::size_t cells : {1024U, 4096U, 65536U}) {
        const auto found = variational_inequality(problem, {.cells = cells}).solution;
        no_window_has_more(*found, length);
        const Estimate<double> on_cells = found->largest_average_pressure(to_real<double>(length)).value;
        CHECK(std::abs(on_cells.value - truth.value) <= on_cells.error + 1e-13 * truth.value);
        CHECK(on_cells.error <= (cells == 65536 ? 0.01 : 0.25) * truth.value);
      }
    }
  }
}
