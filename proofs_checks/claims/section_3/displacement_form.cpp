// The form a of problem I. [Bal16, section 3.2]

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <cmath>
#include <numbers>

#include "numeric/quadrature/tanh_sinh.hpp"
#include "proofs_checks/claims/section_3/dual_problem_parts.hpp"
#include "proofs_checks/instruments/cells.hpp"
#include "proofs_checks/instruments/displacement_operator.hpp"
#include "proofs_checks/instruments/jacobi_pair.hpp"
#include "proofs_checks/kit/findings.hpp"
#include "proofs_checks/kit/random.hpp"

namespace steadyslide::proofs_checks {
namespace {

using numeric::Node;
using numeric::Power;
using numeric::Real;

struct FormSaid {
  InverseSaid inverse;
  enum class Lower { cosine_squared, cosine } lower = Lower::cosine_squared;  ///< least a(u,u)/a_0(u,u)
  bool contracting = true;                                                    ///< |a| <= 1, else 1/(1+s^2), in a_0
  int second = 1;                                                             ///< the sign of s in b
  double moved = 0;
};

/// -(1/pi) t * log|x| + (s/2) t * sgn at a node, t = polynomial/W, on the panels before and behind it.
template <Real R>
R potential(const JacobiPair<R>& t, const Node<R>& at, int sign) {
  const Exponent angle = Exponent::angle(t.s);
  const auto left = Power<R>::of(-(half + angle));
  const auto right = Power<R>::of(-(half - angle));
  const R slip = sign * numeric::to_real<R>(t.s) / 2;
  const Power<R> none{R(0), R(1)};
  const auto before = [&](const Node<R>& y) {
    using std::log, std::pow;
    return R(t.traction(y.x) * pow(R(y.from_right + at.from_right), right.value) *
             (slip - log(y.from_right) / numeric::pi<R>()));
  };
  const auto behind = [&](const Node<R>& y) {
    using std::log, std::pow;
    return R(t.traction(y.x) * pow(R(y.from_left + at.from_left), left.value) *
             (-slip - log(y.from_left) / numeric::pi<R>()));
  };
  return numeric::tanh_sinh::panel_integral<R>({{R(-1), at.x, at.from_left}, left, none, before}).value +
         numeric::tanh_sinh::panel_integral<R>({{at.x, R(1), at.from_right}, none, right, behind}).value;
}

template <Real R>
JacobiPair<R> random_pair(Random& random, const Rational& s, std::size_t degree) {
  JacobiPair<R> pair{s, {}};
  for (std::size_t k = 0; k < degree; ++k) pair.c.push_back(numeric::to_real<R>(random.between(-1, 1)));
  return pair;
}

/// a(v, u) by (10) against b(L v, L u), L from Jacobi's polynomials.
template <Real R>
void check_forms(Findings& findings, Random& random, const Context& context, const FormSaid& said) {
  const Quantity inverse{
      "L(u) at the nodes", {"(10), Gauss-Jacobi and trapezoidal rule", "Jacobi's polynomials"}, tolerance<R>()};
  const Quantity forms{"a(v, u)", {"int v L(u) by (10)", "b(L(v), L(u)) by tanh-sinh"}, tolerance<R>()};
  const int count = context.quick ? 1 : 3;
  for (int k = 0; k < count; ++k) {
    const Rational s = random.between(Rational(1, 4), 3) * (k % 2 == 0 ? 1 : -1);
    const std::size_t degree = context.quick ? 2 : 2 + static_cast<std::size_t>(k);
    const auto u = random_pair<R>(random, s, degree);
    const auto v = random_pair<R>(random, s, degree);
    findings.begin_case("s = " + to_string(s));
    const DisplacementOperator<R> a(s, static_cast<int>(degree) + 1, said.inverse);
    std::vector<R> u_at;
    std::vector<R> v_at;
    std::vector<R> image;
    const R scale = 1 / numeric::cos_pi_alpha<R>(s) * numeric::pi<R>();
    for (std::size_t i = 0; i < a.size(); ++i) {
      u_at.push_back(u.displacement(a.node(i).x));
      v_at.push_back(v.displacement(a.node(i).x));
      image.push_back(a.tau(i) * scale * u.traction(a.node(i).x));
    }
    const std::vector<R> by_formula = a.forces(u_at);
    R error = 0;
    R size = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      using std::abs, std::max;
      error = max(error, R(abs(by_formula[i] - image[i])));
      size = max(size, R(abs(image[i])));
    }
    findings.compare(inverse, static_cast<double>(R(error / size)));
    // b(L(v), L(u)) = <U, L(u)>, U the displacement under L(v), a polynomial: Gauss's rule is exact.
    const R by_formula_form = a.form(v_at, u_at) * (1 + R(said.moved) * R(tolerance<R>()));
    R by_potential = 0;
    for (std::size_t i = 0; i < a.size(); ++i) by_potential += image[i] * potential(v, a.node(i), said.second);
    findings.compare(forms, relative_difference<R>(by_formula_form, by_potential));
  }
}

/// a in Chebyshev's polynomials T_1, ..., T_{n-1}, each divided by the root of a_0(T_k, T_k) = pi k/2.
Eigen::MatrixXd scaled_form(const Rational& s, int n, const InverseSaid& said) {
  const DisplacementOperator<double> a(s, n, said);
  Eigen::MatrixXd values(n, n - 1);
  Eigen::MatrixXd force(n, n);
  for (int i = 0; i < n; ++i) {
    const auto row = static_cast<std::size_t>(i);
    for (int j = 0; j < n; ++j) force(i, j) = a.force(row, static_cast<std::size_t>(j));
    for (int k = 1; k < n; ++k) {
      values(i, k - 1) = std::cos(k * std::acos(a.node(row).x)) / std::sqrt(std::numbers::pi * k / 2);
    }
  }
  return values.transpose() * force * values;
}

void check_bounds(Findings& findings, Random& random, const Context& context, const FormSaid& said) {
  const Quantity identity{"a_0(T_j, T_k) on degrees below n", {"(10) with s = 0", "pi k/2, orthogonal"}, 1e-11};
  const int n = context.quick ? 24 : 48;
  findings.begin_case("s = 0");
  const Eigen::MatrixXd none = scaled_form(0, n, said.inverse);
  findings.compare(identity, (none - Eigen::MatrixXd::Identity(n - 1, n - 1)).cwiseAbs().maxCoeff());

  const Quantity lower{"least a(u,u)/a_0(u,u), below 1/(1+s^2)", {"eigenvalue", "bound"}, 1e-11};
  const Quantity upper{"largest |a(v,u)|/(a_0(v,v) a_0(u,u))^{1/2}, above 1", {"singular value", "bound"}, 1e-11};
  const Quantity sharp{"least a(u,u)/a_0(u,u) on degrees below n", {"eigenvalue", "1/(1+s^2)"}, 1e-9};
  for (int k = 0; k < (context.quick ? 2 : 10); ++k) {
    const Rational s = random.between(Rational(1, 5), 3) * (k % 2 == 0 ? 1 : -1);
    findings.begin_case("s = " + to_string(s));
    const Eigen::MatrixXd form = scaled_form(s, n, said.inverse);
    const Eigen::MatrixXd symmetric = (form + form.transpose()) / 2;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(symmetric, Eigen::EigenvaluesOnly);
    const double least = solver.eigenvalues().minCoeff();
    const double cosine = numeric::cos_pi_alpha<double>(s);
    const double bound = said.lower == FormSaid::Lower::cosine ? cosine : cosine * cosine;
    findings.compare(lower, std::max(bound - least, 0.0) / bound);
    findings.compare(sharp, std::abs(least - bound) / bound);
    const double norm = Eigen::JacobiSVD<Eigen::MatrixXd>(form).singularValues().maxCoeff();
    findings.compare(upper, std::max(norm - (said.contracting ? 1 : cosine * cosine), 0.0));
  }
}

std::vector<Evidence> check(const Context& context, const FormSaid& said) {
  const auto walk = [&]<Real R>() {
    Random random(context.seed, "sec-32-form-a");
    Findings findings;
    check_bounds(findings, random, context, said);
    // Potentials at 50 digits take a second.
    if (context.quick) {
      check_forms<double>(findings, random, context, said);
    } else {
      check_forms<R>(findings, random, context, said);
    }
    return findings.evidence("random s of both signs and polynomials, seed " + std::to_string(context.seed));
  };
  return gather([&] { return numeric::at_precision(context.digits, walk); });
}

}  // namespace

Claim form_of_displacements_claim() {
  using F = FormSaid;
  return make_claim(
      claim_text("sec-32-form-a"), check, F(),
      std::vector<Wrong<F>>{
          {"L with the printed (1+x)^{1/2}", changed<F>([](F& said) { said.inverse.printed = true; })},
          {"L with the friction's sign reversed", changed<F>([](F& said) { said.inverse.friction = -1; })},
          {"L with the integral's sign reversed", changed<F>([](F& said) { said.inverse.integral = 1; })},
          {"L with 1/sqrt(1+s^2)", changed<F>([](F& said) { said.inverse.amplitude = true; })},
          {"b with the friction's sign reversed", changed<F>([](F& said) { said.second = -1; })},
          {"the lower bound 1/sqrt(1+s^2)", changed<F>([](F& said) { said.lower = F::Lower::cosine; })},
          {"the upper bound 1/(1+s^2)", changed<F>([](F& said) { said.contracting = false; })},
          {"near miss: a moved by ten times the tolerance", changed<F>([](F& said) { said.moved = 10; })}});
}

}  // namespace steadyslide::proofs_checks
