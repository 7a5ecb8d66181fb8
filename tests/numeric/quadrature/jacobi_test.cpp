// Gauss-Jacobi rules, compared with closed forms.

#include <functional>

#include "numeric/quadrature/jacobi_rule.hpp"
#include "support/numeric_test.hpp"

namespace {

/// The power, of which 1 + a is given as a decimal.
template <Real R>
Power<R> power(const char* plus_one) {
  const Rational given = parse_rational(plus_one);
  return {to_real<R>(Rational(given - 1)), to_real<R>(given)};
}

/// |a - b| in units of epsilon max(|a|, |b|).
template <class R>
double distance(const R& a, const R& b) {
  const R size = std::max(size_of(a), size_of(b));
  return size == 0 ? 0.0 : static_cast<double>(R(size_of(R(a - b)) / (epsilon<R>() * size)));
}

template <class R>
R gamma_function(const R& x) {
  if constexpr (std::same_as<R, double>) {
    return std::tgamma(x);
  } else {
    R value;
    mpfr_gamma(value.backend().data(), x.backend().data(), MPFR_RNDN);
    return value;
  }
}

template <Real R>
R sum(const UnitRule<R>& rule, const std::function<R(const R& y, const R& z)>& f) {
  R result = 0;
  for (std::size_t i = 0; i < rule.size(); ++i) result += rule.weights[i] * f(rule.from_left[i], rule.from_right[i]);
  return result;
}

/// Returns the largest relative error, in epsilons, of the integrals of y^k and (1-y)^k with first <= k <= last.
template <Real R>
double moment_error(const UnitRule<R>& rule, const R& a, const R& b, int first, int last) {
  using std::max, std::pow;
  const R total = gamma_function(a) * gamma_function(b) / gamma_function(R(a + b));
  R from_left = total, from_right = total;
  double worst = 0;
  for (int k = 0; k <= last; ++k) {
    if (k >= first) {
      worst = max(worst, distance(sum<R>(rule, [k](const R& y, const R&) { return R(pow(y, k)); }), from_left));
      worst = max(worst, distance(sum<R>(rule, [k](const R&, const R& z) { return R(pow(z, k)); }), from_right));
    }
    from_left *= (a + k) / (a + b + k);
    from_right *= (b + k) / (a + b + k);
  }
  return worst;
}

/// 1 + a: evenly distributed, or, for every second one, down to 1e-12 or as near to 1.
template <Real R>
Power<R> random_power() {
  using std::pow;
  const R even = R(uniform(1, 199)) / 100, tiny = pow(R(10), R(-uniform(0, 240)) / 20);
  switch (uniform(0, 3)) {
    case 0: return {tiny - 1, tiny};
    case 1: return {-tiny / 2, 1 - tiny / 2};
    default: return {even - 1, even};
  }
}

}  // namespace

TEST_CASE_TEMPLATE("monomials of degree < 2n are integrated exactly, and one of degree 2n is not", R, double, Real50,
                   Real100) {
  const char* const powers[] = {"1e-6", "0.001", "0.5", "0.999999999", "1", "1.000000001", "1.3", "1.97"};
  double worst = 0;
  for (const char* left : powers) {
    for (const char* right : powers) {
      INFO("left = ", left, ", right = ", right);
      const Power<R> a = power<R>(left), b = power<R>(right);
      for (const int n : {1, 2, 3, 12}) {
        const UnitRule<R> rule = jacobi_rule(a, b, n);
        worst = std::max(worst, moment_error(rule, a.plus_one, b.plus_one, 0, 2 * n - 1));
        if (n <= 3) CHECK(moment_error(rule, a.plus_one, b.plus_one, 2 * n, 2 * n) > 1e6);
      }
    }
  }
  CHECK(worst < 60);
  MESSAGE("largest error in epsilons: " << worst);
}

TEST_CASE_TEMPLATE("random exponents, up to 150 nodes", R, double, Real50) {
  CHECK(rc::check("moments", [] {
    const Power<R> a = random_power<R>(), b = random_power<R>();
    const int n = uniform(0, 9) == 0 ? 150 : uniform(1, 40);
    RC_ASSERT(moment_error(jacobi_rule(a, b, n), a.plus_one, b.plus_one, 0, 2 * n - 1) < 50 + 5 * n);
  }));
  CHECK(rc::check("mirror", [] {
    const Power<R> a = random_power<R>(), b = random_power<R>();
    const std::size_t n = static_cast<std::size_t>(uniform(1, 60));
    const UnitRule<R> rule = jacobi_rule(a, b, static_cast<int>(n));
    const UnitRule<R> mirror = jacobi_rule(b, a, static_cast<int>(n));
    const double tolerance = 50 + 5 * static_cast<double>(n);
    for (std::size_t i = 0; i < n; ++i) {
      RC_ASSERT(distance(rule.from_left[i], mirror.from_right[n - 1 - i]) < tolerance);
      RC_ASSERT(distance(rule.weights[i], mirror.weights[n - 1 - i]) < tolerance);
      RC_ASSERT(rule.weights[i] > 0);
    }
  }));
}

TEST_CASE_TEMPLATE("Chebyshev's rules of the first, second and third kind", R, double, Real50, Real100) {
  using std::cos, std::sin;
  const Power<R> low = power<R>("0.5"), high = power<R>("1.5");
  for (const int n : {1, 2, 7, 40, 150}) {
    CAPTURE(n);
    const UnitRule<R> first = jacobi_rule(low, low, n), second = jacobi_rule(high, high, n);
    const UnitRule<R> third = jacobi_rule(low, high, n);
    double worst = 0;
    const auto compare = [&](const UnitRule<R>& rule, std::size_t i, const R& angle, const R& weight) {
      const R left = sin(angle / 2), right = cos(angle / 2);
      worst = std::max({worst, distance(rule.from_left[i], R(left * left)),
                        distance(rule.from_right[i], R(right * right)), distance(rule.weights[i], weight)});
    };
    for (int i = 0; i < n; ++i) {
      const auto at = static_cast<std::size_t>(i);
      compare(first, at, R((2 * i + 1) * pi<R>() / (2 * n)), R(pi<R>() / n));
      const R s = sin((i + 1) * pi<R>() / (n + 1));
      compare(second, at, R((i + 1) * pi<R>() / (n + 1)), R(pi<R>() / (4 * (n + 1)) * s * s));
      const R angle = (2 * i + 1) * pi<R>() / (2 * n + 1), c = cos(angle / 2);
      compare(third, at, angle, R(2 * pi<R>() / (2 * n + 1) * c * c));
    }
    // Here the cosine at the right end loses digits, too.
    CHECK(worst < 20 + 10 * n);
  }
}

TEST_CASE_TEMPLATE("Legendre's rule with five nodes", R, double, Real50, Real100) {
  using std::sqrt;
  const UnitRule<R> rule = jacobi_rule(power<R>("1"), power<R>("1"), 5);
  const R root = sqrt(R(70)), inner = sqrt(R(5) - 2 * sqrt(R(10) / 7)) / 3;
  const R outer = sqrt(R(5) + 2 * sqrt(R(10) / 7)) / 3;
  const R nodes[] = {(1 - outer) / 2, (1 - inner) / 2, R(1) / 2, (1 + inner) / 2, (1 + outer) / 2};
  const R weights[] = {(322 - 13 * root) / 1800, (322 + 13 * root) / 1800, R(64) / 225, (322 + 13 * root) / 1800,
                       (322 - 13 * root) / 1800};
  for (std::size_t i = 0; i < 5; ++i) {
    CHECK(distance(rule.from_left[i], nodes[i]) < 40);
    CHECK(distance(rule.weights[i], weights[i]) < 20);
  }
}

TEST_CASE_TEMPLATE("all but a part 1e-12 of the mass is in the first node, which is as near to the end", R, double,
                   Real50) {
  using std::abs;
  const Power<R> a = power<R>("1e-12");
  const UnitRule<R> rule = jacobi_rule(a, power<R>("1"), 20);
  CHECK(abs(rule.weights[0] * a.plus_one - 1) < 1e-11);
  // Newton's step from y = 0; the next term is smaller by 1e-12.
  CHECK(abs(rule.from_left[0] * 20 * 20 / a.plus_one - 1) < 1e-11);
  // The rest is an integral without the singularity: int_0^1 y^a y dy.
  R rest = 0;
  for (std::size_t i = 1; i < rule.size(); ++i) rest += rule.weights[i] * rule.from_left[i];
  CHECK(distance(R(rest + rule.weights[0] * rule.from_left[0]), R(1 / (1 + a.plus_one))) < 100);
  // Control: an exponent without its last digits, which 1 + a in the type would give.
  if constexpr (std::same_as<R, double>) {
    const double lost = 1 + a.value;
    CHECK(distance(jacobi_rule({a.value, lost}, power<R>("1"), 20).weights[0], rule.weights[0]) > 1e10);
  }
}

TEST_CASE("the published integral converges like (2 + sqrt 3)^(-2n)") {
  // int_{-1}^1 dx/((x-2) ((1-x)(1+x)^3)^(1/4)), x = 2y - 1.
  const Real100 expected = -pi<Real100>() * sqrt(Real100(2)) / pow(Real100(3), Real100(3) / 4);
  const auto error = [&](int n) {
    const auto rule = jacobi_rule(power<Real100>("0.25"), power<Real100>("0.75"), n);
    const Real100 value = sum<Real100>(rule, [](const Real100& y, const Real100&) { return Real100(1 / (2 * y - 3)); });
    return Real100(abs(value / expected - 1));
  };
  const Real100 rate = 2 + sqrt(Real100(3));
  for (const int n : {4, 8, 16, 32, 64}) {
    const auto scaled = static_cast<double>(Real100(error(n) * pow(rate, 2 * n)));
    CAPTURE(n);
    CHECK(scaled > 0.3);
    CHECK(scaled < 10);
  }
  CHECK(error(96) < 1e-108);
}

TEST_CASE("refused: no nodes, powers that are not integrable; the cache makes a rule once") {
  const Power<double> half{-0.5, 0.5};
  CHECK_THROWS_AS(jacobi_rule(half, half, 0), std::invalid_argument);
  CHECK_THROWS_AS(jacobi_rule(half, {-1, 0}, 3), std::invalid_argument);
  CHECK_THROWS_AS(jacobi_rule({std::nan(""), std::nan("")}, half, 3), std::invalid_argument);
  JacobiRules<double> rules;
  const auto& rule = rules.get(half, {0, 1}, 3);
  CHECK(&rule == &rules.get(half, {0, 1}, 3));
  CHECK(&rule != &rules.get({0, 1}, half, 3));
  CHECK(rules.get(half, {0, 1}, 4).size() == 4);
  CHECK(rule.weights == jacobi_rule(half, {0, 1}, 3).weights);
}
