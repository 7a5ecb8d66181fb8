#include "numeric/number/estimate.hpp"
#include "numeric/number/polynomial.hpp"
#include "support/numeric_test.hpp"

namespace {

template <Real R>
R random_real() {
  return R(uniform(1, 1000)) / uniform(1, 999) * (uniform(0, 1) == 0 ? -1 : 1);
}

/// An estimate whose error is exactly its distance from the true value. The errors are small, so that terms of second
/// order hardly matter.
template <Real R>
struct Measured {
  R exact;
  Estimate<R> estimate;
};

template <Real R>
Measured<R> random_measured() {
  const R exact = random_real<R>(), off = random_real<R>() * R(1e-6);
  using std::abs;
  return {exact, {exact + off, abs(off), uniform(0, 9) == 0 ? Convergence::stalled : Convergence::reached}};
}

/// Checks that the error covers the difference, except for terms of second order and rounding.
template <Real R>
bool covers(const Estimate<R>& found, const R& exact) {
  using std::abs;
  return abs(found.value - exact) <= found.error * R(1.01) + 64 * epsilon<R>() * abs(exact);
}

}  // namespace

TEST_CASE_TEMPLATE("the error of a result covers what became of the errors", R, double, Real50, Real100) {
  CHECK(rc::check([] {
    const Measured<R> a = random_measured<R>(), b = random_measured<R>();
    const R c = random_real<R>();
    // The error is as large as the sizes of both terms require: the terms cancel, their rounding does not.
    const Estimate<R> rounding{R(0), 1e4 * epsilon<R>()};
    RC_ASSERT(covers<R>(a.estimate + b.estimate + rounding, a.exact + b.exact));
    RC_ASSERT(covers<R>(a.estimate - b.estimate + rounding, a.exact - b.exact));
    RC_ASSERT(covers<R>(-a.estimate, -a.exact));
    RC_ASSERT(covers<R>(c * a.estimate, c * a.exact));
    RC_ASSERT(covers<R>(a.estimate / c, a.exact / c));
    const bool stalled =
        a.estimate.convergence == Convergence::stalled || b.estimate.convergence == Convergence::stalled;
    for (const Estimate<R>& both : {a.estimate + b.estimate, a.estimate - b.estimate, a.estimate * b.estimate,
                                    a.estimate / b.estimate, b.estimate * a.estimate}) {
      RC_ASSERT((both.convergence == Convergence::stalled) == stalled);
    }
    RC_ASSERT((c * a.estimate).convergence == a.estimate.convergence);
    RC_ASSERT((a.estimate / c).convergence == a.estimate.convergence);
    RC_ASSERT(a.estimate.widened(c * c).convergence == a.estimate.convergence);
  }));
}

TEST_CASE("products and quotients, to first order") {
  const Estimate<double> a{-3, 0.25}, b{2, 0.5};
  Estimate<double> sum;
  for (int k = 0; k < 4; ++k) sum += a;
  for (const auto& [found, value, error] : {std::tuple(a * b, -6., 2.),
                                            {a / b, -1.5, 0.5},
                                            {-2 * a, 6., 0.5},
                                            {a / -2, 1.5, 0.125},
                                            {a - a, 0., 0.5},
                                            {a.widened(2), -3., 6.25},
                                            {sum, -12., 1.}}) {
    CHECK(found.value == value);
    CHECK(found.error == error);
  }
}

TEST_CASE_TEMPLATE("a polynomial at a real place", R, double, Real50, Real100) {
  CHECK(value_of(Polynomial(), R(3)) == 0);
  CHECK(value_of(Polynomial({1, -2, 3}), R(2)) == 9);
  CHECK(rc::check([] {
    std::vector<Rational> c;
    for (int k = uniform(0, 6); k > 0; --k) c.emplace_back(uniform(-99, 99), uniform(1, 64));
    const Polynomial p(c);
    const Rational x(uniform(-512, 512), 256);
    Rational size = 0;
    for (std::size_t k = c.size(); k-- > 0;) size = size * abs(x) + abs(c[k]);
    using std::abs;
    RC_ASSERT(abs(value_of(p, to_real<R>(x)) - to_real<R>(p(x))) <= 16 * epsilon<R>() * to_real<R>(size));
    RC_ASSERT(value_of(coefficients_of<R>(p), to_real<R>(x)) == value_of(p, to_real<R>(x)));
  }));
}
