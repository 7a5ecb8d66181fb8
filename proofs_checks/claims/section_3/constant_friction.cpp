// The form b under a constant friction coefficient: the function t_0, coercivity, and the inverse L.
// [Bal16, section 3.1, (8), (10)]

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>

#include "numeric/quadrature/tanh_sinh.hpp"
#include "proofs_checks/claims/section_3/form_parts.hpp"
#include "proofs_checks/instruments/angle_forms.hpp"
#include "proofs_checks/instruments/cells.hpp"
#include "proofs_checks/instruments/jacobi_traction.hpp"
#include "proofs_checks/instruments/punch.hpp"

namespace steadyslide::proofs_checks {
namespace {

/// s of either sign, as both directions of sliding have it.
std::vector<Rational> frictions(const Context& context, std::string_view stream) {
  std::vector<Rational> all{Rational(-3, 4), 2, 0, Rational(1, 10), 10};
  Random random(context.seed, stream);
  if (context.quick) return {random.between(Rational(1, 2), 2)};
  for (int k = 0; k < 6; ++k) all.push_back(random.between(-3, 3));
  return all;
}

/// t_0 with these exponents and this factor, and b(t_0, t) = constant <<t, 1>>.
template <class R>
struct UnitSaid {
  JacobiTraction<R> t;
  R s;  ///< in b
  R constant;
};
using UnitFormula = Formula<UnitSaid, Rational>;

/// -(log 2 + C + (psi(1/2+alpha) + psi(1/2-alpha))/2)/pi, C Euler's constant, psi the digamma function.
template <Real R>
R punch_constant(const Rational& s) {
  const R plus = numeric::to_real<R>(half + Exponent::angle(s));
  const R minus = numeric::to_real<R>(half - Exponent::angle(s));
  using std::log;
  return -(log(R(2)) + (digamma(plus) + digamma(minus)) / 2 - digamma(R(1))) / numeric::pi<R>();
}

std::vector<Evidence> check_unit(const Context& context, const UnitFormula& formula) {
  const numeric::Digits digits = std::max(context.digits, numeric::Digits::fifty);
  const auto walk = [&]<Real R>() {
    using std::abs;
    const Quantity mean{"int t_0", {"tanh-sinh with absorbed powers", "1"}, tolerance<R>()};
    const Quantity zero{"b(t_0, t) for t = T_k/sqrt(1-x^2)", {"Gauss-Jacobi", "0"}, tolerance<R>()};
    const Quantity powers{"b(t_0, t) for t = x^m", {"tanh-sinh", "constant times int t"}, tolerance<R>()};
    const std::vector<Rational> all = frictions(context, "sec-31-decomposition");
    Findings findings;
    for (const Rational& s : all) {
      findings.begin_case("s = " + to_string(s));
      const UnitSaid<R> said = formula.at<R>(s);
      for (int k = 1; k <= 4; ++k) {
        findings.compare(zero, static_cast<double>(R(abs(form_with_chebyshev(said.t, said.s, k)))));
      }
      findings.compare(mean, relative_difference<R>(integral(said.t), R(1)));
      for (int m = 0; m <= (context.quick ? 0 : 3); ++m) {
        const R whole = m % 2 == 0 ? R(2) / (m + 1) : R(0);
        findings.compare(powers,
                         static_cast<double>(R(abs(form_with_power(said.t, said.s, m) - said.constant * whole))));
      }
    }
    return findings.evidence("s of both signs, seed " + std::to_string(context.seed));
  };
  return gather([&] { return numeric::at_precision(digits, walk); });
}

Claim decomposition_claim() {
  const UnitFormula right = UnitFormula::from([]<Real R>(const Rational& s) {
    const Exponent alpha = Exponent::angle(s);
    JacobiTraction<R> t{numeric::Power<R>::of(-(half + alpha)),
                        numeric::Power<R>::of(-(half - alpha)),
                        {numeric::cos_pi_alpha<R>(s) / numeric::pi<R>()}};
    return UnitSaid<R>{std::move(t), numeric::to_real<R>(s), punch_constant<R>(s)};
  });
  const auto wrong = [&](std::string name, auto change) {
    return Wrong<UnitFormula>{std::move(name), right.changed(change)};
  };
  return make_claim(
      claim_text("sec-31-decomposition"), check_unit, right,
      std::vector<Wrong<UnitFormula>>{
          wrong("alpha's sign in t_0", [](auto& said, const Rational&) { std::swap(said.t.left, said.t.right); }),
          wrong("arguments exchanged: b(t_hat, t_0)", [](auto& said, const Rational&) { said.s = -said.s; }),
          wrong("t_0 of the frictionless punch",
                []<class R>(UnitSaid<R>& said, const Rational&) {
                  said.t.left = said.t.right = numeric::Power<R>::of(-half);
                }),
          wrong("cos(pi alpha) missing",
                []<class R>(UnitSaid<R>& said, const Rational&) { said.t.factor = {1 / numeric::pi<R>()}; }),
          wrong("b(t_0, t) = 0 for all t", [](auto& said, const Rational&) { said.constant = 0; }),
          wrong("K = log 2/pi whatever the friction",
                []<class R>(UnitSaid<R>& said, const Rational&) { said.constant = punch_constant<R>(Rational(0)); }),
          wrong("near miss: K moved by ten times the tolerance",
                []<class R>(UnitSaid<R>& said, const Rational&) { said.constant += near_miss<R>(); }),
          wrong("near miss: an exponent moved by a hundred times the tolerance",
                []<class R>(UnitSaid<R>& said, const Rational&) {
                  said.t.left.value += 10 * near_miss<R>();
                  said.t.left.plus_one += 10 * near_miss<R>();
                })});
}

/// b(t, t) = energy |t|^2/pi and |b(t_1, t_2)| <= sqrt(1+s^2) |t_1| |t_2|/pi on zero mean.
struct CoerciveSaid {
  int power = 0;  ///< of sqrt(1+s^2) in the energy
  Rational energy = 1;
  double miss = 0;
  bool jump = false;  ///< the friction on cells falls to zero at 1/7
  bool root = true;   ///< in the bound
};

using Forms = std::tuple<FormMatrix<double>, FormMatrix<Real50>, FormMatrix<Real100>>;

template <Real R>
void check_coefficients(Findings& findings, const CoerciveSaid& said, const Rational& s, Random& random,
                        std::pair<Forms, Forms>& forms) {
  using std::abs;
  const Quantity squares{"b(t, t)", {"quadrature in both angles", "|t|^2/pi from coefficients"}, tolerance<R>()};
  constexpr int highest = 4;
  auto& log_form = std::get<FormMatrix<R>>(forms.first);
  auto& sign_form = std::get<FormMatrix<R>>(forms.second);
  if (log_form.empty()) {
    log_form = log_form_by_quadrature<R>(highest, R(2));
    sign_form = sign_form_by_quadrature<R>(highest);
  }
  std::vector<R> c{R(0)};
  R value = 0;
  for (int k = 1; k <= highest; ++k) {
    c.push_back(numeric::to_real<R>(random.between(-2, 2)));
    value += numeric::pi<R>() * c.back() * c.back() / (2 * k);
  }
  value *= numeric::to_real<R>(said.energy) * (1 + R(said.miss) * near_miss<R>());
  for (int k = 0; k < said.power; ++k) value /= numeric::cos_pi_alpha<R>(s);
  const R b = value_of(log_form, c, c) / numeric::pi<R>() + numeric::to_real<R>(s) / 2 * value_of(sign_form, c, c);
  findings.compare(squares, relative_difference<R>(b, value));
}

void check_on_cells(Findings& findings, const CoerciveSaid& said, const Rational& s, Random& random) {
  const Quantity eigenvalues{"eigenvalues of b on zero mean, over |t|^2/pi", {"cells", "1"}, tolerance<double>()};
  const Quantity bound{"norm of b on zero mean, over sqrt(1+s^2)/pi less 1", {"cells", "at most 0"}, 0};
  // Friction of one sign, and a jump where the claim has none.
  const CellFrictionSteps steps{{s, said.jump ? Rational(0) : s}, {Rational(1, 7)}};
  const auto mesh = random_cells(random, cell_problem(steps), Cells::unequal, 24);
  const auto b = operator_of(steps, mesh);
  const Eigen::MatrixXd logarithm = on_zero_mean(symmetric_part(mesh, b, false));
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> pencil(on_zero_mean(symmetric_part(mesh, b, true)),
                                                                         logarithm, Eigen::EigenvaluesOnly);
  const double expected = numeric::to_real<double>(said.energy) *
                          std::pow(1 / numeric::cos_pi_alpha<double>(s), said.power) *
                          (1 + said.miss * near_miss<double>());
  findings.compare(eigenvalues, relative_difference(pencil.eigenvalues()(0), expected));
  findings.compare(eigenvalues, relative_difference(pencil.eigenvalues()(pencil.eigenvalues().size() - 1), expected));
  const auto n = static_cast<Eigen::Index>(mesh.size());
  Eigen::MatrixXd whole(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) {
      const auto k = static_cast<std::size_t>(j);
      whole(i, j) = b.entry(static_cast<std::size_t>(i), k) / mesh.length(k);
    }
  }
  const Eigen::LLT<Eigen::MatrixXd> factors(logarithm);
  const Eigen::MatrixXd part = factors.matrixL().solve(on_zero_mean(whole));
  const Eigen::MatrixXd scaled = factors.matrixL().solve(part.transpose());
  const double norm = Eigen::JacobiSVD<Eigen::MatrixXd>(scaled).singularValues()(0);
  const double largest = said.root ? 1 / numeric::cos_pi_alpha<double>(s) : 1;
  findings.compare(bound, std::max(0.0, norm / largest - 1 - tolerance<double>()));
}

std::vector<Evidence> check_coercive(const Context& context, const CoerciveSaid& said, std::pair<Forms, Forms>& forms) {
  const auto walk = [&]<Real R>() {
    Random random(context.seed, "sec-31-coercive-cells");
    const std::vector<Rational> all = frictions(context, "sec-31-coercive");
    Findings findings;
    for (const Rational& s : all) {
      findings.begin_case("s = " + to_string(s), s != 0);
      check_coefficients<R>(findings, said, s, random, forms);
      check_on_cells(findings, said, s, random);
    }
    return findings.evidence("s of both signs, random coefficients and cells, seed " + std::to_string(context.seed));
  };
  return gather([&] { return numeric::at_precision(context.digits, walk); });
}

Claim coercive_claim() {
  const auto wrong = [](std::string name, auto change) {
    return Wrong<CoerciveSaid>{std::move(name), changed<CoerciveSaid>(change)};
  };
  return make_claim(
      claim_text("sec-31-coercive"),
      [forms = std::make_shared<std::pair<Forms, Forms>>()](const Context& context, const CoerciveSaid& said) {
        return check_coercive(context, said, *forms);
      },
      CoerciveSaid{},
      std::vector<Wrong<CoerciveSaid>>{
          wrong("sqrt(1+s^2) in the energy", [](CoerciveSaid& s) { s.power = 1; }),
          wrong("twice the energy", [](CoerciveSaid& s) { s.energy = 2; }),
          wrong("friction that jumps", [](CoerciveSaid& s) { s.jump = true; }),
          wrong("the bound without friction", [](CoerciveSaid& s) { s.root = false; }),
          wrong("near miss: the energy moved by ten times the tolerance", [](CoerciveSaid& s) { s.miss = 1; })});
}

}  // namespace

std::vector<Claim> constant_friction_claims() { return {decomposition_claim(), coercive_claim()}; }

}  // namespace steadyslide::proofs_checks
