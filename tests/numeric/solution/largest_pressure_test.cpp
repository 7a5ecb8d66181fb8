// The largest pressure, compared with formulas, with the roots of a rational function, and with places all over the
// contact.

#include "numeric/interior/interior_stress_problems.hpp"
#include "numeric/solution/highest_peak.hpp"
#include "numeric/variational/variational_inequality.hpp"
#include "support/problems.hpp"

namespace {

/// Reduced problem: c = 1, psi = x^2/2, so that R = 1.
ContactProblem galin(const std::vector<Rational>& s, const std::vector<Rational>& jumps = {}) {
  return reduced(s, jumps, one_piece(-4, 4, {0, 0, 0.5_r}), 1);
}

/// Roots of sum of p_j/(x - e_j) = 0 between neighbouring points. A pressure prod |x - e_j|^p_j has its peaks there if
/// all p_j > 0, because the sum falls from +infinity to -infinity.
template <Real R>
R largest_by_roots(const ContactSolution<R>& solution, const ContactProblem& problem) {
  using std::abs, std::pow;
  const auto points = solution.singular_points();
  R largest = 0;
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    R low = points[k].x.value, high = points[k + 1].x.value;
    for (int step = 0; step < 4 * digits_served<R>; ++step) {
      const R middle = (low + high) / 2;
      R sum = 0;
      for (const auto& point : points) sum += to_real<R>(*point.exponent) / (middle - point.x.value);
      (sum > 0 ? low : high) = middle;
    }
    R pressure = cos_pi_alpha<R>(problem.coupled_friction(k));
    for (const auto& point : points) pressure *= pow(abs(low - point.x.value), to_real<R>(*point.exponent));
    largest = std::max(largest, pressure);
  }
  return largest;
}

template <Real R>
void no_place_has_more(const ContactSolution<R>& solution, const LargestPressure<R>& largest, double below) {
  using std::abs;
  R best = 0;
  for (const auto& component : solution.contact()) {
    for (int i = 1; i < 400; ++i) {
      const Rational x = Rational(component.left.x.value) + Rational(component.width.value) * Rational(i, 400);
      best = std::max(best, R(-solution.at(x).traction.right.value));
    }
  }
  CHECK(best <= largest.value.value * (1 + R(1e-12)));
  CHECK(best >= largest.value.value * (1 - R(below)));
  const R there = -solution.at(Rational(largest.x.value)).traction.right.value;
  CHECK(abs(there - largest.value.value) <= R(1e-9) * there);
}

}  // namespace

TEST_CASE_TEMPLATE("a parabola without jumps: the formulas", R, double, Real50, Real100) {
  using std::abs, std::pow, std::sqrt;
  for (const Rational& s : {Rational(0), 0.3_r, Rational(-2)}) {
    // a < x < b with powers 1/2 - alpha and 1/2 + alpha, whose sum is 1: the peak divides the width by them.
    const ContactProblem p = s < 0 ? galin({-s}).with_sliding(Sliding::minus_x) : galin({s});
    const R alpha = to_real<R>(Exponent::angle(s));
    const auto closed = closed_form<R>(p).solution;
    const R half = sqrt(R(1) / (2 * pi<R>() * (R(0.25) - alpha * alpha)));
    const R left = R(R(0.5) - alpha) * 2 * half, right = R(R(0.5) + alpha) * 2 * half;
    const R expected = pow(left, R(0.5) - alpha) * pow(right, R(0.5) + alpha) / sqrt(1 + to_real<R>(s) * to_real<R>(s));
    for (const auto& solution : {closed, riemann_hilbert<R>(p).solution}) {
      const LargestPressure<R> found = solution->largest_pressure();
      CHECK_FALSE(found.exponent);
      CHECK(abs(found.value.value - expected) <= 1000 * epsilon<R>() * expected);
      CHECK(abs(found.value.value - expected) <= 10 * found.value.error + 100 * epsilon<R>() * expected);
      const R x = solution->contact()[0].left.x.value + left;
      CHECK(abs(found.x.value - x) <= found.x.error + 100 * epsilon<R>());
      CHECK(found.x.error <= pow(epsilon<R>(), R(0.45)));
    }
  }
}

TEST_CASE("falling friction: each panel has its peak, and the largest is found") {
  for (const std::vector<Rational>& s : {std::vector<Rational>{2, 1, 0.1_r}, {3, 0.5_r, 0.4_r}}) {
    const ContactProblem p = galin(s, {-0.2_r, 0.3_r});
    const auto fine = closed_form<Real50>(p).solution;
    const Real50 expected = largest_by_roots(*fine, p);
    CHECK(abs(fine->largest_pressure().value.value - expected) < Real50("1e-44"));
    CHECK(abs(riemann_hilbert<Real50>(p).solution->largest_pressure().value.value - expected) < Real50("1e-42"));
    for (const auto& solution : {closed_form<double>(p).solution, riemann_hilbert<double>(p).solution}) {
      const LargestPressure<double> found = solution->largest_pressure();
      CHECK(std::abs(found.value.value - static_cast<double>(expected)) < 1e-13);
      no_place_has_more(*solution, found, 1e-3);
      CHECK(std::abs(found.x.value - static_cast<double>(fine->largest_pressure().x.value)) < 1e-8);
    }
  }
}

TEST_CASE("no place has more: polynomials, two zones, a change of curvature") {
  const Indenter bent(-2, {{0.1_r, Polynomial({0, 0, 1})}, {2, Polynomial({0.02_r, -0.4_r, 3})}});
  for (const ContactProblem& p : {reduced({0.3_r}, {}, two_wells(), 1), reduced({1, 0.3_r}, {0.1_r}, two_wells(0), 2),
                                  reduced({0.5_r}, {}, bent, 0.3_r)}) {
    const auto solution = riemann_hilbert<double>(p).solution;
    REQUIRE(solution->failed_condition() == "");
    no_place_has_more(*solution, solution->largest_pressure(), 1e-2);
  }
}

TEST_CASE("an infinite pressure has the lowest power, and its place") {
  const auto punch =
      closed_form<double>(reduced({0.3_r, 1}, {0}, one_piece(-1, 1, {0}), 1)).solution->largest_pressure();
  CHECK(std::isinf(punch.value.value));
  CHECK(punch.x.value == -1);
  CHECK((punch.exponent && *punch.exponent == edge_exponent(End::left, 0.3_r)));
  const ContactProblem wedge = reduced({0.5_r}, {}, roof(-0.5_r, 0.5_r), 0.1_r);
  for (const auto& solution : {riemann_hilbert<double>(wedge).solution, variational_inequality(wedge).solution}) {
    const auto tip = solution->largest_pressure();
    CHECK(std::isinf(tip.value.value));
    CHECK_FALSE(tip.exponent);
    CHECK(tip.x.value == 0);
  }
}

TEST_CASE("cells find the largest pressure to their error") {
  const ContactProblem p = galin({2, 1, 0.1_r}, {-0.2_r, 0.3_r});
  const auto exact = closed_form<double>(p).solution->largest_pressure();
  const auto cells = variational_inequality(p).solution->largest_pressure();
  CHECK(std::abs(cells.value.value - exact.value.value) <= cells.value.error);
  CHECK(std::abs(cells.x.value - exact.x.value) <= 0.05);
}

TEST_CASE("random functions with many peaks: none is missed") {
  CHECK(rc::check("poles on the axis beyond the panels [0, 1], [1, 2], and a kink between them", [] {
    const auto count = *rc::gen::inRange(1, 6);
    std::vector<std::array<double, 2>> poles;
    for (int i = 0; i < count; ++i) {
      const double beyond = std::pow(10.0, *rc::gen::inRange(-3000, 500) / 1000.0);
      const bool left = *rc::gen::inRange(0, 2) == 0;
      poles.push_back({left ? -beyond : 2 + beyond, (left ? beyond : -beyond) * *rc::gen::inRange(-100, 100)});
    }
    const auto f = [&](double x) {
      double sum = 1000 + 50 * std::sqrt(x * (2 - x)) - 30 * std::pow(std::abs(x - 1), 0.3);
      for (const auto& [place, strength] : poles) sum += strength / (x - place);
      return sum;
    };
    const PanelFunction<double> g = [&](std::size_t panel, const double& left, const double& right) {
      return Estimate<double>{f(panel == 0 ? left : 2 - right), 1e-13};
    };
    const auto peaks = highest_peaks<double>({1, 1}, g);
    RC_ASSERT(!peaks.empty());
    double best = 0;
    for (int i = 1; i < 20000; ++i) best = std::max(best, f(i / 10000.0));
    // At the kink the caller has to provide the limit.
    const double limit = std::max({f(0), f(1), f(2)});
    RC_ASSERT(best <= std::max(peaks[0].value.value, limit) * (1 + 1e-9));
    RC_ASSERT(peaks[0].value.value <= std::max(best, limit) * (1 + 1e-3));
    // If the floor is above all peaks, none is returned.
    RC_ASSERT(highest_peaks<double>({1, 1}, g, 10 * best).empty());
  }));
}

TEST_CASE("peaks of the same height are all found, on one panel or on two") {
  // 1 - d^2/4, d the distance from the nearest of 1, 2, 3, 4; lower from the second peak on
  const auto peaks_of = [](const std::vector<double>& lengths, double lower) {
    const PanelFunction<double> f = [&](std::size_t panel, const double& left, const double&) {
      const double x = left + (panel == 0 ? 0 : 3.5), d = x - std::max(std::round(x), 1.0);
      return Estimate<double>{1 - d * d / 4 - (x > 1.5 ? lower : 0), 1e-14};
    };
    return highest_peaks<double>(lengths, f);
  };
  for (const auto& [lengths, lower, count] : {std::tuple(std::vector{3.5}, 0.0, 3U),
                                              {std::vector{3.5, 1.0}, 0.0, 4U},
                                              {std::vector{3.5}, 1e-15, 3U},
                                              {std::vector{3.5}, 1e-12, 1U}}) {
    CHECK(peaks_of(lengths, lower).size() == count);
  }
}
