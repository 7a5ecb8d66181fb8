#include <boost/math/special_functions/jacobi.hpp>
#include <numbers>
#include <variant>

#include "proofs_checks/instruments/cells/dense_algebra.hpp"
#include "proofs_checks/instruments/operators/displacement_operator.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::sec_32_form_a {
namespace {

using numeric::Power;

/// The form on polynomials of degree below n.
struct Bounds {
  int n;
};
/// Displacements given by coefficients in Jacobi's polynomials.
struct Pair {
  std::vector<Rational> u;
  std::vector<Rational> v;
};

struct Case {
  Rational s;
  std::variant<Bounds, Pair> data;
};

std::string text_of(const Case& c) { return "s = " + to_string(c.s); }

CaseList<Case> cases(const Context& context) {
  Random random(context.seed, "sec-32-form-a");
  const Bounds bounds{context.quick ? 24 : 48};
  CaseList<Case> list{{{0, bounds}}, "random `s` of both signs and polynomials, seed " + std::to_string(context.seed)};
  for (int k = 0; k < (context.quick ? 2 : 10); ++k) {
    list.cases.push_back({random.between(Rational(1, 5), 3) * (k % 2 == 0 ? 1 : -1), bounds});
  }
  for (std::size_t k = 0; k < (context.quick ? 1 : 3); ++k) {
    const Rational s = random.between(Rational(1, 4), 3) * (k % 2 == 0 ? 1 : -1);
    Pair pair;
    for (auto* coefficients : {&pair.u, &pair.v}) *coefficients = random.between(-1, 1, 2 + k);
    list.cases.push_back({s, std::move(pair)});
  }
  return list;
}

/// The form a by (10), b with slip s, and the bounds of a relative to a_0.
struct FormA {
  InverseVariant inverse;
  int slip = 1;
  Number lower;  ///< smallest a(u,u)/a_0(u,u)
  Number upper;  ///< largest |a(v,u)|/(a_0(v,v) a_0(u,u))^{1/2}
  Number scale = 1;
};

FormA form_a(const Case& c) {
  const auto cosine = cos_pi_alpha<Number>(c.s);
  return {.inverse = {}, .lower = cosine * cosine, .upper = 1};
}

// Displacements with known tractions. With p = 1/2+alpha, q = 1/2-alpha and W = (1+x)^p (1-x)^q
//
//   u = (2/n) P_n^{(-p,-q)}   ->   L(u) = 2 cos(pi alpha) P_n^{(-q,-p)}/W,   n >= 1,
//
// (P_n^{(a,b)}: the power a belongs to x = 1, b to x = -1). Reason: u' = P_{n-1}^{(q,p)} [DLMF, 18.9.15]. By Plemelj's
// formulas, cos(pi alpha) A(P_n^{(-q,-p)}/W) is the polynomial part at infinity of P_n^{(-q,-p)} (z+1)^{-p} (z-1)^{-q}.
// This part has the degree n - 1. Its leading coefficient is that of P_n^{(-q,-p)}, half of that of P_{n-1}^{(q,p)}. It
// is orthogonal to lower degrees under W. Therefore it is P_{n-1}^{(q,p)}/2.

/// A displacement sum_n c_n u_n, n = 1, ..., c.size(), and W times its traction L.
template <class R>
struct JacobiPair {
  Rational s;
  std::vector<R> c;

  R displacement(const R& x) const { return sum(-(R(1) / 2 + angle()), x, false); }
  R traction(const R& x) const { return 2 * cos_pi_alpha<R>(s) * sum(angle() - R(1) / 2, x, true); }

 private:
  R angle() const { return to_real<R>(Exponent::angle(s)); }
  R sum(const R& at_right, const R& x, bool image) const {
    R total = 0;
    for (std::size_t k = 0; k < c.size(); ++k) {
      const auto n = static_cast<unsigned>(k + 1);
      total += c[k] * boost::math::jacobi<R>(n, at_right, R(-1 - at_right), x) * (image ? R(1) : R(2) / n);
    }
    return total;
  }
};

/// Returns -(1/pi) t * log|x| + (slip/2) t * sgn at a node, t = polynomial/W, integrated on the panels before and
/// behind it.
template <Real R>
R potential(const JacobiPair<R>& t, const Node<R>& at, const R& slip) {
  const Exponent angle = Exponent::angle(t.s);
  const auto left = Power<R>::of(-(half + angle));
  const auto right = Power<R>::of(-(half - angle));
  const Power<R> none{R(0), R(1)};
  const auto before = [&](const Node<R>& y) {
    using std::log, std::pow;
    return R(t.traction(y.x) * pow(R(y.from_right + at.from_right), right.value) *
             (slip / 2 - log(y.from_right) / numeric::pi<R>()));
  };
  const auto behind = [&](const Node<R>& y) {
    using std::log, std::pow;
    return R(t.traction(y.x) * pow(R(y.from_left + at.from_left), left.value) *
             (-slip / 2 - log(y.from_left) / numeric::pi<R>()));
  };
  return tanh_sinh::panel_integral<R>({{R(-1), at.x, at.from_left}, left, none, before}).value +
         tanh_sinh::panel_integral<R>({{at.x, R(1), at.from_right}, none, right, behind}).value;
}

template <Real R>
JacobiPair<R> jacobi_pair(const Rational& s, const std::vector<Rational>& coefficients) {
  JacobiPair<R> pair{s, {}};
  for (const Rational& c : coefficients) pair.c.push_back(to_real<R>(c));
  return pair;
}

/// Compares a(v, u) by (10) with b(L v, L u), where L comes from Jacobi's polynomials.
template <Real R>
void check_pair(Findings& findings, const FormA& form, const Rational& s, const Pair& pair) {
  using std::abs, std::max;
  const auto u = jacobi_pair<R>(s, pair.u);
  const auto v = jacobi_pair<R>(s, pair.v);
  const DisplacementOperator<R> a(s, static_cast<int>(pair.u.size()) + 1, form.inverse);
  std::vector<R> u_at;
  std::vector<R> v_at;
  std::vector<R> image;
  const R scale = numeric::pi<R>() / cos_pi_alpha<R>(s);
  for (std::size_t i = 0; i < a.size(); ++i) {
    u_at.push_back(u.displacement(a.node(i).x));
    v_at.push_back(v.displacement(a.node(i).x));
    image.push_back(a.tau(i) * scale * u.traction(a.node(i).x));
  }
  const std::vector<R> by_formula = a.forces(u_at);
  R error = 0;
  R size = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    error = max(error, R(abs(by_formula[i] - image[i])));
    size = max(size, R(abs(image[i])));
  }
  findings.compare("inverse", static_cast<double>(error / size));
  // b(L(v), L(u)) = <U, L(u)>, where U is the displacement under L(v). U is a polynomial, so Gauss's rule is exact.
  const R slip = form.slip * to_real<R>(s);
  R by_potential = 0;
  for (std::size_t i = 0; i < a.size(); ++i) by_potential += image[i] * potential(v, a.node(i), slip);
  findings.compare<R>("forms", R(form.scale) * a.form(v_at, u_at), by_potential);
}

/// Returns a in Chebyshev's polynomials T_1, ..., T_{n-1}, each divided by the square root of a_0(T_k, T_k) = pi k/2.
Eigen::MatrixXd scaled_form(const Rational& s, int n, const InverseVariant& variant) {
  const DisplacementOperator<double> a(s, n, variant);
  const std::size_t size = a.size();
  const Eigen::MatrixXd values = matrix_of(size, size - 1, [&](std::size_t i, std::size_t j) {
    const auto k = static_cast<double>(j + 1);
    return std::cos(k * std::acos(a.node(i).x)) / std::sqrt(std::numbers::pi * k / 2);
  });
  return values.transpose() * matrix_of(size, size, [&](std::size_t i, std::size_t j) { return a.force(i, j); }) *
         values;
}

void check_bounds(Findings& findings, const FormA& form, const Rational& s, int n) {
  const Eigen::MatrixXd scaled = scaled_form(s, n, form.inverse);
  if (s == 0) {
    findings.compare("identity", (scaled - Eigen::MatrixXd::Identity(n - 1, n - 1)).cwiseAbs().maxCoeff());
    return;
  }
  const Eigen::MatrixXd symmetric = (scaled + scaled.transpose()) / 2;
  const double least = eigenvalues(symmetric).minCoeff();
  const auto bound = static_cast<double>(form.lower);
  findings.compare("lower", std::max(bound - least, 0.0) / bound);
  findings.compare("sharp", std::abs(least - bound) / bound);
  findings.compare("upper", std::max(spectral_norm(scaled) - static_cast<double>(form.upper), 0.0));
}

}  // namespace

Claim claim() {
  return formula_claim<Case, FormA>("sec-32-form-a")
      .cases(cases)
      .precision(Precision::quick_in_double)
      .says(form_a)
      .checked([]<Real R>(Findings& findings, const FormA& form, const Case& c) {
        if (const auto* bounds = std::get_if<Bounds>(&c.data)) {
          check_bounds(findings, form, c.s, bounds->n);
        } else {
          check_pair<R>(findings, form, c.s, std::get<Pair>(c.data));
        }
      })
      .wrong("`L` with the printed `(1+x)^{1/2}`", [](FormA& form) { form.inverse.printed = true; })
      .wrong("`L` with the friction's sign reversed", [](FormA& form) { form.inverse.friction = -1; })
      .wrong("`L` with the integral's sign reversed", [](FormA& form) { form.inverse.integral = 1; })
      .wrong("`L` with `1/sqrt(1+s^2)`", [](FormA& form) { form.inverse.amplitude = true; })
      .wrong("`b` with the friction's sign reversed", &FormA::slip, -1)
      .wrong("the lower bound `1/sqrt(1+s^2)`", [](FormA& form) { form.lower = sqrt(form.lower); })
      .wrong("the upper bound `1/(1+s^2)`", [](FormA& form) { form.upper = form.lower; })
      .near_miss("a", [](FormA& form, const Number& step) { form.scale += step; });
}

}  // namespace steadyslide::proofs_checks::sec_32_form_a
