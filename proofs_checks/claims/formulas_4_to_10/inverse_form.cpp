// The inverse L of the operator under a constant friction coefficient. [Bal16, (10)]

#include <algorithm>

#include "numeric/number/polynomial.hpp"
#include "numeric/quadrature/trapezoidal.hpp"
#include "proofs_checks/claims/section_3/form_parts.hpp"
#include "proofs_checks/instruments/jacobi_traction.hpp"
#include "proofs_checks/instruments/punch.hpp"

namespace steadyslide::proofs_checks {
namespace {

struct InverseCase {
  Rational s;
  Polynomial slope;  ///< u'
};

/// L(u) = local u' - integral W (1/pi) PV int u'/(W (x'-x)) dx', W = (1+x)^left (1-x)^right.
template <class R>
struct InverseSaid {
  R local;
  R integral;
  numeric::Power<R> left;
  numeric::Power<R> right;
};
using InverseFormula = Formula<InverseSaid, InverseCase>;

std::vector<InverseCase> cases(const Context& context) {
  Random random(context.seed, "sec-31-inverse");
  std::vector<InverseCase> all;
  const std::vector<Rational> s{Rational(3, 4), -2, 0, 7, Rational(-1, 5)};
  for (std::size_t k = 0; k < (context.quick ? 1U : 10U); ++k) {
    std::vector<Rational> u;
    for (std::size_t i = 0; i <= k % 4; ++i) u.push_back(random.between(-2, 2));
    all.push_back({k < s.size() ? s[k] : random.between(-3, 3), Polynomial(u)});
  }
  return all;
}

/// c_n of (1+w)^p (1-w)^q = sum c_n w^n.
template <class R>
std::vector<R> binomial_product(const R& p, const R& q, std::size_t count) {
  std::vector<R> a{R(1)};
  std::vector<R> b{R(1)};
  for (std::size_t n = 1; n < count; ++n) {
    const auto k = static_cast<int>(n);
    a.push_back(a.back() * (p - (k - 1)) / k);
    b.push_back(-b.back() * (q - (k - 1)) / k);
  }
  std::vector<R> c(count, R(0));
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; i + j < count; ++j) c[i + j] += a[i] * b[j];
  }
  return c;
}

/// Coefficients of 1, z, ... of z^shift (sum p_k z^k) (sum c_n z^-n).
template <class R>
std::vector<R> polynomial_part(const std::vector<R>& p, const std::vector<R>& c, int shift) {
  std::vector<R> result(static_cast<std::size_t>(std::max<int>(static_cast<int>(p.size()) + shift, 0)), R(0));
  for (int k = 0; k < static_cast<int>(p.size()); ++k) {
    for (int n = 0; n <= k + shift; ++n) {
      result[static_cast<std::size_t>(k + shift - n)] +=
          p[static_cast<std::size_t>(k)] * c[static_cast<std::size_t>(n)];
    }
  }
  return result;
}

/// cos(pi alpha) W Q, Q the polynomial part at infinity of u' (z+1)^{1/2+alpha} (z-1)^{1/2-alpha}.
template <Real R>
JacobiTraction<R> without_integral(const InverseCase& c) {
  const Exponent alpha = Exponent::angle(c.s);
  const std::vector<R> u = numeric::coefficients_of<R>(c.slope);
  const std::vector<R> series =
      binomial_product<R>(numeric::to_real<R>(half + alpha), numeric::to_real<R>(half - alpha), u.size() + 2);
  std::vector<R> q = polynomial_part(u, series, 1);
  for (R& coefficient : q) coefficient *= numeric::cos_pi_alpha<R>(c.s);
  return {numeric::Power<R>::of(-(half + alpha)), numeric::Power<R>::of(-(half - alpha)), std::move(q)};
}

template <Real R>
R slope_at(const InverseCase& c, const R& x) {
  return numeric::value_of(c.slope, x);
}

/// int u T_k/sqrt(1-x^2) dx, k >= 1, in the angle: there the midpoint rule is exact.
template <Real R>
R pairing(const Polynomial& slope, int k) {
  using std::cos;
  const int nodes = slope.degree() + k + 4;
  R sum = 0;
  for (int i = 0; i < nodes; ++i) {
    const R angle = numeric::pi<R>() * (2 * i + 1) / (2 * nodes);
    const R x = cos(angle);
    R u = 0;
    for (int n = slope.degree(); n >= 0; --n) {
      u = u * x + numeric::to_real<R>(slope.coefficient(static_cast<std::size_t>(n))) / (n + 1);
    }
    sum += x * u * cos(R(k * angle));
  }
  return sum * numeric::pi<R>() / nodes;
}

template <Real R>
void check_formula(Findings& findings, const InverseSaid<R>& said, const InverseCase& c,
                   const JacobiTraction<R>& expected, bool quick) {
  using std::abs;
  const Quantity values{
      "L(u)", {"(10), principal values by staggered nodes", "polynomial part at infinity"}, tolerance<R>()};
  const auto opposite = [](const numeric::Power<R>& p) { return numeric::Power<R>{R(-p.value), R(1 - p.value)}; };
  const numeric::PanelDensity<R> density{
      {R(-1), R(1), R(2)}, opposite(said.left), opposite(said.right), [&](const numeric::Node<R>& node) {
        return slope_at<R>(c, node.x);
      }};
  const numeric::trapezoidal::Grid<R> grid({density});
  const numeric::PanelDensity<R> traction = density_of(expected);
  for (const int percent : {2, 35, 60, 99}) {
    if (quick && percent != 35) continue;
    const numeric::PanelPoint<R> at = grid.midpoint_near(0, R(percent) / 100);
    const R u = slope_at<R>(c, at.node.x);
    // 1/W is the density without u'.
    const R weight = u / density(at.node);
    const R integral = said.integral * weight * grid.hilbert(at);
    const R scale = abs(said.local * u) + abs(integral);
    findings.compare(values, static_cast<double>(R(abs(said.local * u - integral - traction(at.node)) / scale)));
  }
}

std::vector<Evidence> check(const Context& context, const InverseFormula& formula) {
  const numeric::Digits digits = std::max(context.digits, numeric::Digits::fifty);
  const auto walk = [&]<Real R>() {
    using std::abs, std::max;
    const Quantity weak{"b(L(u), t_hat), t_hat = T_k/sqrt(1-x^2)", {"Gauss-Jacobi", "<<u, t_hat>>"}, tolerance<R>()};
    const std::vector<InverseCase> all = cases(context);
    Findings findings;
    for (const InverseCase& c : all) {
      findings.begin_case("s = " + to_string(c.s) + ", u' = " + to_string(c.slope), c.s != 0);
      const JacobiTraction<R> t = without_integral<R>(c);
      check_formula<R>(findings, formula.at<R>(c), c, t, context.quick);
      const R s = numeric::to_real<R>(c.s);
      R size = 0;
      for (const R& coefficient : t.factor) size += abs(coefficient);
      for (int k = 1; k <= 4; ++k) {
        const R difference = form_with_chebyshev(t, s, k) - pairing<R>(c.slope, k);
        findings.compare(weak, static_cast<double>(R(abs(difference) / size)));
      }
      // A L(u) = u' and int L(u) = 0.
      const Surface<R> surface{{density_of(t)}, {s}, [&c](const R& x) { return slope_at<R>(c, x); }, R(0), size};
      check_surface(findings, surface, context.quick ? 0 : 2);
    }
    return findings.evidence("polynomials u of degree up to 4, s of both signs, seed " + std::to_string(context.seed));
  };
  return gather([&] { return numeric::at_precision(digits, walk); });
}

}  // namespace

Claim inverse_claim() {
  const InverseFormula right = InverseFormula::from([]<Real R>(const InverseCase& c) {
    const R share = numeric::to_real<R>(1 / (1 + c.s * c.s));
    const Exponent alpha = Exponent::angle(c.s);
    return InverseSaid<R>{numeric::to_real<R>(c.s) * share, share, numeric::Power<R>::of(-(half + alpha)),
                          numeric::Power<R>::of(-(half - alpha))};
  });
  const auto wrong = [&](std::string name, auto change) {
    return Wrong<InverseFormula>{std::move(name), right.changed(change)};
  };
  return make_claim(
      claim_text("sec-31-inverse"), check, right,
      std::vector<Wrong<InverseFormula>>{
          wrong("the sign of the integral", [](auto& said, const InverseCase&) { said.integral = -said.integral; }),
          wrong("the sign of s u'", [](auto& said, const InverseCase&) { said.local = -said.local; }),
          wrong("1/(1+s^2) missing before the integral", [](auto& said, const InverseCase&) { said.integral = 1; }),
          wrong("alpha's sign: edges exchanged",
                [](auto& said, const InverseCase&) { std::swap(said.left, said.right); }),
          wrong("the printed (1+x)^{1/2}",
                []<class R>(InverseSaid<R>& said, const InverseCase&) { said.left = numeric::Power<R>::of(-half); }),
          wrong("near miss: s u' moved by a hundred times the tolerance",
                []<class R>(InverseSaid<R>& said, const InverseCase&) { said.local *= 1 + 10 * near_miss<R>(); }),
          wrong("near miss: the integral moved by a hundred times the tolerance",
                []<class R>(InverseSaid<R>& said, const InverseCase&) { said.integral *= 1 + 10 * near_miss<R>(); })});
}

}  // namespace steadyslide::proofs_checks
