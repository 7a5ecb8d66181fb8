#include "numeric/closed_form/parabola.hpp"
#include "numeric/closed_form/closed_form.hpp"
#include "numeric/riemann_hilbert/riemann_hilbert.hpp"
#include "support/numeric_test.hpp"
#include "support/problems.hpp"

namespace {

/// psi/c = x^2/(2 radius).
ContactProblem galin(const std::vector<Rational>& s, const std::vector<Rational>& jumps, const Rational& radius,
                     const Rational& load) {
  return reduced(s, jumps, one_piece(-100, 100, {0, 0, 1 / (2 * radius)}), load);
}

/// The two equations in terms of the angles only, for the ends a < b of any contact. They are summed by parts; the powers
/// are the jumps of alpha, and 1/2 at both ends:
///   mean = (a + b)/2 + int_a^b alpha dx = 0,   squares = (a^2 + b^2)/2 + 2 int_a^b x alpha dx = K.
std::pair<double, double> mean_and_squares(const std::vector<Rational>& s, const std::vector<Rational>& jumps, double a,
                                           double b) {
  double mean = (a + b) / 2;
  double squares = (a * a + b * b) / 2;
  for (std::size_t k = 0; k < s.size(); ++k) {
    const double left = k == 0 ? a : std::clamp(to_real<double>(jumps[k - 1]), a, b);
    const double right = k + 1 == s.size() ? b : std::clamp(to_real<double>(jumps[k]), a, b);
    const double part = to_real<double>(Exponent::angle(s[k])) * (right - left);
    mean += part;
    squares += part * (left + right);
  }
  return {mean, squares};
}

}  // namespace

TEST_CASE("one jump at the vertex: ends to 40 digits") {
  // Digits from outside this project. Two independent computations there agreed on 40 digits.
  struct Case {
    Rational rear, front;
    const char* left;
    const char* right;
  };
  const Case cases[] = {
      {0.1_r, 0.6_r, "-0.4003017752023082835874813713471545627373", "0.2789364365421476101051427811594294453144"},
      {0.6_r, 0.1_r, "-0.4900056280717151697542022236678901591541", "0.3022454527884637023227909724409309514227"},
  };
  for (const Case& c : cases) {
    const auto check = [&]<class R>(double tolerance) {
      using std::abs;
      const auto solution = closed_form<R>(galin({c.rear, c.front}, {0}, 0.2_r, 1)).solution;
      const ContactComponent<R> zone = solution->contact().front();
      CHECK(abs(zone.left.x.value - R(Real100(c.left))) < tolerance);
      CHECK(abs(zone.right.x.value - R(Real100(c.right))) < tolerance);
    };
    check.operator()<double>(2e-15);
    check.operator()<Real50>(6e-41);
    check.operator()<Real100>(6e-41);
  }
}

TEST_CASE("no jump: half-width, shifted zone and peak at -4 alpha a") {
  using std::abs, std::sqrt;
  for (const char* slope : {"0", "0.3", "2", "-0.7"}) {
    const Rational s = abs(parse_rational(slope));
    const auto problem = galin({s}, {}, Rational(3, 7), 2.5_r);
    // The sign of s comes from the direction of sliding.
    const ContactProblem directed = problem.with_sliding(slope[0] == '-' ? Sliding::minus_x : Sliding::plus_x);
    const Real50 alpha = to_real<Real50>(Exponent::angle(parse_rational(slope)));
    const Real50 a = sqrt(to_real<Real50>(Rational(15, 14)) / (2 * pi<Real50>() * (0.25 - alpha * alpha)));
    const auto data = std::get<ClosedFormData<Real50>>(closed_form_data<Real50>(directed));
    const FundamentalSolution<Real50>& y = data.traction.weight;
    CHECK(abs(y.point(0) + (1 + 2 * alpha) * a) < 1e-54);
    CHECK(abs(y.point(1) - (1 - 2 * alpha) * a) < 1e-54);
    // At the peak the logarithmic derivative of |t| vanishes and changes its sign.
    const auto slope_at = [&](const Real50& x) {
      return Real50(y.powers()[0].value / (x - y.point(0)) + y.powers()[1].value / (x - y.point(1)));
    };
    CHECK(abs(slope_at(Real50(-4 * alpha * a))) < 1e-53);
    CHECK(slope_at(Real50(-4 * alpha * a - a / 1000)) > 0);
    CHECK(slope_at(Real50(-4 * alpha * a + a / 1000)) < 0);
  }
}

TEST_CASE("the contact takes in one jump after the other as the load grows, without a break") {
  const std::vector<Rational> s{0.5_r, 0, 3, 0.1_r, 2};
  const std::vector<Rational> jumps{-1.5_r, Rational(-1, 3), 0.25_r, 0.8_r};
  std::size_t seen = 0;
  double left = 0, right = 0;
  for (double K = 1e-6; K < 100; K *= 1.01) {
    const ParabolaZone<double> zone = parabola_zone<double>(s, jumps, K);
    CHECK(zone.left < left);
    CHECK(zone.right > right);
    // No jump is missing, and none is included too early.
    for (std::size_t k = 0; k < jumps.size(); ++k) {
      const double c = to_real<double>(jumps[k]);
      const bool inside = zone.first <= k && k < zone.last;
      CHECK(inside == (zone.left < c && c < zone.right));
    }
    left = zone.left;
    right = zone.right;
    seen = std::max(seen, zone.last - zone.first);
  }
  CHECK(seen == jumps.size());
}

TEST_CASE("where no closed form applies, the reason is given") {
  const std::string shape = "the profile is neither flat nor a parabola that opens away from the body";
  const std::string edge = "the parabola's contact reaches an edge of the support";
  const Polynomial parabola({0, 0, 1});
  struct Case {
    Indenter indenter;
    Rational load;
    std::string reason;
    std::optional<Rational> load_at = std::nullopt;
    Elasticity elasticity = Elasticity(Solid(0.3_r, 1));
  };
  const Case cases[] = {{one_piece(-1, 1, {0, 1}), 1, shape},
                        {one_piece(-1, 1, {0, 0, -1}), 1, shape},
                        {Indenter(-1, {{0, Polynomial()}, {1, Polynomial::constant(1)}}), 1, shape},
                        {one_piece(-1, 1, {0, 0, 1}), 100, edge},
                        {one_piece(-1, 1, {0, 50, 1}), 1, edge},
                        {one_piece(-1, 1, {}), 1, "the indenter may tilt", 0},
                        {one_piece(-1, 1, {}), 1,
                         "a flat elastic indenter touches with its edges, where the half-plane idealisation fails",
                         std::nullopt, Elasticity(Solid(0, 1), Solid(0, 2))},
                        {Indenter(-1, {{0, parabola}, {1, parabola}}), 0.01_r, ""}};
  for (const Case& c : cases) {
    const ContactProblem problem(c.elasticity, FrictionProfile({0.5_r}), c.indenter, c.load, Sliding::plus_x,
                                 c.load_at);
    CHECK(closed_form<double>(problem).reason == c.reason);
  }
}

TEST_CASE("the ends that the solver finds fulfil the two sums, and moved ends do not") {
  for (const auto& [s, jumps] : {std::pair(std::vector{0.1_r, 0.6_r}, std::vector{0_r}),
                                 {std::vector{0.6_r, 0.1_r}, std::vector{0_r}},
                                 {std::vector{0.3_r, 2_r, 0_r, 1_r}, std::vector{-0.2_r, 0.05_r, 0.1_r}}}) {
    const auto solution = riemann_hilbert<double>(galin(s, jumps, 0.2_r, 1)).solution;
    const auto ends = solution->contact().front();
    const auto [mean, squares] = mean_and_squares(s, jumps, ends.left.x.value, ends.right.x.value);
    const double K = 2 * 0.2 / std::numbers::pi;
    CHECK(std::abs(mean) < 1e-13);
    CHECK(std::abs(squares - K) < 1e-13);
    const auto [moved_mean, moved_squares] = mean_and_squares(s, jumps, ends.left.x.value, ends.right.x.value + 1e-6);
    CHECK(std::abs(moved_mean) > 1e-8);
    CHECK(std::abs(moved_squares - K) > 1e-8);
  }
}
