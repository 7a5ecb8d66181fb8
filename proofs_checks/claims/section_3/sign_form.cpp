// The form that friction adds: skew and bounded where it has no jump. [Bal16, section 3.1]

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>

#include "proofs_checks/claims/section_3/form_parts.hpp"
#include "proofs_checks/instruments/angle_forms.hpp"
#include "proofs_checks/instruments/cell_law.hpp"
#include "proofs_checks/instruments/cells.hpp"
#include "proofs_checks/instruments/power_form.hpp"
#include "proofs_checks/kit/findings.hpp"
#include "proofs_checks/kit/rate.hpp"

namespace steadyslide::proofs_checks {
namespace {

using numeric::variational::CellMesh;
using numeric::variational::GalerkinOperator;
using std::numbers::pi;

/// <<t_1 * sgn, t_2>> of T_j/sqrt(1-x^2) and T_k/sqrt(1-x^2) is factor (1 - (-1)^(j+k))/(k^2 - j^2), and at most
/// `bound` |t_1| |t_2|, |t|^2 = -<<t * log|x|, t>>, on zero mean; `bound_of_all` without that.
struct SignSaid {
  int factor = 2;
  int skew = -1;    ///< what exchanging the arguments does
  bool odd = true;  ///< j + k odd alone counts
  double bound = 2 / pi;
  std::optional<double> bound_of_all = std::nullopt;
  bool jump = false;  ///< sgn replaced by 2 int_{-1}^x s, s = -1 left of 0, 1 right of it
  double growth = 1;  ///< of pi T(0)^2/E with log N
  bool near_miss = false;
};

using SignForms = std::tuple<FormMatrix<double>, FormMatrix<Real50>, FormMatrix<Real100>>;

template <Real R>
void check_expansion(Findings& findings, const SignSaid& said, SignForms& forms) {
  using std::abs;
  const Quantity entries{"<<t_1 * sgn, t_2>>", {"quadrature in both angles", "coefficients"}, tolerance<R>()};
  const Quantity skew{"both arguments exchanged", {"quadrature in both angles", "the other sign"}, tolerance<R>()};
  constexpr int highest = 4;
  auto& form = std::get<FormMatrix<R>>(forms);
  if (form.empty()) form = sign_form_by_quadrature<R>(highest);
  for (int j = 0; j <= highest; ++j) {
    for (int k = 0; k <= highest; ++k) {
      const R found = form[static_cast<std::size_t>(j)][static_cast<std::size_t>(k)];
      const R exchanged = form[static_cast<std::size_t>(k)][static_cast<std::size_t>(j)];
      const bool counts = j != k && (!said.odd || (j + k) % 2 != 0);
      R value = counts ? R(2 * said.factor) / (k * k - j * j) : R(0);
      if (said.near_miss) value *= 1 + 10 * near_miss<R>();
      findings.compare(entries, static_cast<double>(R(abs(found - value))));
      findings.compare(skew, static_cast<double>(R(abs(found - said.skew * exchanged))));
    }
  }
}

/// sup <<.., t_2>>/(|t_1| |t_2|) of a form of forces.
double norm_of(const Eigen::MatrixXd& form, const Eigen::MatrixXd& logarithm) {
  const Eigen::LLT<Eigen::MatrixXd> factors(logarithm);
  const Eigen::MatrixXd half = factors.matrixL().solve(form);
  const Eigen::MatrixXd whole = factors.matrixL().solve(half.transpose());
  return std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(whole.transpose() * whole, Eigen::EigenvaluesOnly)
                       .eigenvalues()
                       .maxCoeff());
}

/// <<t_1 * sgn, t_2>> on forces, t_1 by columns; or with 2 int_{-1}^x s for s = -1, 1, where two cells meet at 0.
Eigen::MatrixXd sign_on_cells(const CellMesh& mesh, bool jump) {
  const auto n = static_cast<Eigen::Index>(mesh.size());
  Eigen::MatrixXd form(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) {
      const double s = mesh.centre(static_cast<std::size_t>(j)) < 0 ? -1 : 1;
      form(i, j) = jump ? (i > j ? 2 * s : i == j ? s : 0) : (i > j ? 1 : i == j ? 0 : -1);
    }
  }
  return form;
}

/// -<<t * log|x|, t>> on forces, the support [-1, 1].
Eigen::MatrixXd logarithm_on_cells(const CellMesh& mesh) {
  const Eigen::MatrixXd form = pi * symmetric_part(mesh, operator_of({{0, 0}, {0}}, mesh), false);
  return form - Eigen::MatrixXd::Constant(form.rows(), form.cols(), std::numbers::ln2);
}

void check_on_cells(Findings& findings, const SignSaid& said, const CellMesh& mesh) {
  const Quantity zero_mean{"norm of the form on zero mean, over 2/pi less 1", {"cells", "at most 0"}, 0};
  const Quantity all{"norm of the form on all tractions, over its bound less 1", {"cells", "at most 0"}, 0};
  const double v = 28 * boost::math::constants::zeta_three<double>() / (std::pow(pi, 4) * std::numbers::ln2);
  const double bound_of_all = said.bound_of_all.value_or(1 / pi + std::sqrt(1 / (pi * pi) + v));
  const Eigen::MatrixXd form = sign_on_cells(mesh, said.jump);
  const Eigen::MatrixXd logarithm = logarithm_on_cells(mesh);
  const double norm = norm_of(on_zero_mean(form), on_zero_mean(logarithm));
  findings.compare(zero_mean, std::max(0.0, norm / said.bound - 1));
  if (!said.jump) findings.compare(all, std::max(0.0, norm_of(form, logarithm) / bound_of_all - 1));
  findings.require(norm > 0.9 * said.bound, "on cells the form stays far below its bound");
}

/// How T(0)^2 grows with N for an energy of 1: what a jump of friction adds is a multiple of it.
void check_growth(Findings& findings, const SignSaid& said, bool quick) {
  std::vector<Level> levels;
  for (std::size_t cells = 16; cells <= (quick ? 64U : 256U); cells *= 2) {
    const CellMesh mesh(cell_problem({{0, 0}, {0}}), cells);
    const Eigen::MatrixXd energy = logarithm_on_cells(mesh) / pi;
    const double value = largest_point_value(energy, weights_of(mesh, 0), true);
    levels.push_back({static_cast<double>(cells), std::exp(-pi * value)});
  }
  const Rate growth = fitted_rate(levels);
  findings.measure({"growth of pi sup T(0)^2/E with log N: what a jump of friction at 0 adds", growth.value,
                    growth.error_bar, said.growth, 0.02, "equal cells"});
}

std::vector<Evidence> check(const Context& context, const SignSaid& said, SignForms& forms) {
  const auto walk = [&]<Real R>() {
    Random random(context.seed, "sec-31-sign-form");
    Findings findings;
    findings.begin_case("Chebyshev functions up to 4");
    check_expansion<R>(findings, said, forms);
    const ContactProblem problem = cell_problem({{0, 0}, {0}});
    for (const std::size_t cells : {16U, 32U, 64U, 128U}) {
      if (context.quick && cells > 32) break;
      findings.begin_case(std::to_string(cells) + " equal cells");
      check_on_cells(findings, said, CellMesh(problem, cells));
    }
    for (int k = 0; k < (context.quick ? 1 : 8); ++k) {
      findings.begin_case("random cells");
      check_on_cells(findings, said, random_cells(random, problem, Cells::unequal, 32));
    }
    findings.begin_case("cells that meet at 0");
    check_growth(findings, said, context.quick);
    return findings.evidence("cells equal and unequal, seed " + std::to_string(context.seed));
  };
  return gather([&] { return numeric::at_precision(context.digits, walk); });
}

template <class Change>
Wrong<SignSaid> wrong(std::string name, Change change) {
  return {std::move(name), changed<SignSaid>(change)};
}

}  // namespace

std::vector<Claim> sign_form_claims() {
  return {make_claim(
      claim_text("sec-31-sign-form"),
      [forms = std::make_shared<SignForms>()](const Context& context, const SignSaid& said) {
        return check(context, said, *forms);
      },
      SignSaid{},
      std::vector<Wrong<SignSaid>>{
          wrong("symmetric", [](SignSaid& s) { s.skew = 1; }), wrong("half of it", [](SignSaid& s) { s.factor = 1; }),
          wrong("the other sign", [](SignSaid& s) { s.factor = -2; }),
          wrong("terms with j + k even, too", [](SignSaid& s) { s.odd = false; }),
          wrong("the bound 1/pi", [](SignSaid& s) { s.bound = 1 / pi; }),
          wrong("the bound 2/pi on all tractions", [](SignSaid& s) { s.bound_of_all = 2 / pi; }),
          wrong("a jump of s within the bound", [](SignSaid& s) { s.jump = true; }),
          wrong("no growth at a jump", [](SignSaid& s) { s.growth = 0; }),
          wrong("near miss: the coefficients moved by a hundred times the tolerance",
                [](SignSaid& s) { s.near_miss = true; })})};
}

}  // namespace steadyslide::proofs_checks
