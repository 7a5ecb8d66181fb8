#include <boost/math/constants/constants.hpp>
#include <numbers>
#include <variant>

#include "proofs_checks/instruments/cells/cell_law.hpp"
#include "proofs_checks/instruments/cells/cells.hpp"
#include "proofs_checks/instruments/cells/dense_algebra.hpp"
#include "proofs_checks/instruments/operators/angle_forms.hpp"
#include "proofs_checks/kit/claim_builder.hpp"
#include "proofs_checks/kit/rate.hpp"

namespace steadyslide::proofs_checks::sec_31_sign_form {
namespace {

using std::numbers::pi;

/// The tractions T_j/sqrt(1-x^2) and T_k/sqrt(1-x^2).
struct Chebyshev {
  int j;
  int k;
};
/// The kernel sgn, or with `jump` 2 int_{-1}^x s in its place, with s = -1 left of 0 and 1 right of it.
struct OnCells {
  CellMesh mesh;
  bool jump;
};
/// The growth of T(0)^2 for an energy of 1. A friction jump adds a multiple of T(0)^2.
struct Growth {
  std::size_t most_cells;
};

struct Case {
  std::string name;
  std::variant<Chebyshev, OnCells, Growth> data;
};

CaseList<Case> cases(const Context& context, bool jump) {
  CaseList<Case> list{{}, "cells equal and unequal, seed " + std::to_string(context.seed)};
  for (int j = 0; j <= highest_angle; ++j) {
    for (int k = 0; k <= highest_angle; ++k) {
      list.cases.push_back({"Chebyshev functions " + std::to_string(j) + " and " + std::to_string(k), Chebyshev{j, k}});
    }
  }
  const ContactProblem problem = cell_problem({{0, 0}, {0}});
  for (const std::size_t cells : {16U, 32U, 64U, 128U}) {
    if (context.quick && cells > 32) break;
    list.cases.push_back({std::to_string(cells) + " equal cells", OnCells{CellMesh(problem, cells), jump}});
  }
  Random random(context.seed, "sec-31-sign-form");
  for (int k = 0; k < (context.quick ? 1 : 8); ++k) {
    list.cases.push_back({"random cells", OnCells{random_cells(random, problem, Cells::unequal, 32), jump}});
  }
  list.cases.push_back({"cells that meet at 0", Growth{context.quick ? 64U : 256U}});
  return list;
}

/// Returns sup <<.., t_2>>/(|t_1| |t_2|) for a form of forces.
double norm_of(const Eigen::MatrixXd& form, const Eigen::MatrixXd& logarithm) {
  return spectral_norm(in_metric(form, logarithm));
}

/// Returns <<t_1 * sgn, t_2>> as a form of forces, with t_1 along the columns. The jump lies between two cells.
Eigen::MatrixXd sign_on_cells(const OnCells& c) {
  return matrix_of(c.mesh.size(), c.mesh.size(), [&c](std::size_t i, std::size_t j) -> double {
    const int s = c.mesh.centre(j) < 0 ? -1 : 1;
    return c.jump ? (i > j ? 2 * s : i == j ? s : 0) : (i > j ? 1 : i == j ? 0 : -1);
  });
}

/// Returns -<<t * log|x|, t>> as a form of forces on the support [-1, 1].
Eigen::MatrixXd logarithm_on_cells(const CellMesh& mesh) {
  const Eigen::MatrixXd form = pi * symmetric_part(mesh, operator_of({{0, 0}, {0}}, mesh), false);
  return form - Eigen::MatrixXd::Constant(form.rows(), form.cols(), std::numbers::ln2);
}

Values measured(const OnCells& c) {
  const Eigen::MatrixXd form = sign_on_cells(c);
  const Eigen::MatrixXd logarithm = logarithm_on_cells(c.mesh);
  const double norm = norm_of(on_zero_mean(form), on_zero_mean(logarithm));
  return {{"zero mean", norm}, {"zero mean, nearly", norm}, {"all", norm_of(form, logarithm)}};
}

Values measured(const Growth& c) {
  std::vector<Level> levels;
  for (std::size_t cells = 16; cells <= c.most_cells; cells *= 2) {
    const CellMesh mesh(cell_problem({{0, 0}, {0}}), cells);
    const double value = largest_point_value(logarithm_on_cells(mesh) / pi, weights_of(mesh, 0), true);
    levels.push_back({static_cast<double>(cells), std::exp(-pi * value)});
  }
  const Rate growth = fitted_rate(levels);
  return {{"growth", Order{growth.value, growth.error_bar, "equal cells"}}};
}

template <Real R>
Values measured(const Chebyshev& c) {
  const FormMatrix<R>& form = sign_form_by_quadrature<R>();
  const auto j = static_cast<std::size_t>(c.j);
  const auto k = static_cast<std::size_t>(c.k);
  return {{"entry", form[j][k]}, {"exchanged", form[k][j]}};
}

Values predicted(const Case& c) {
  if (const auto* at = std::get_if<Chebyshev>(&c.data)) {
    const bool counts = (at->j + at->k) % 2 != 0;
    const Number entry = counts ? Number(4) / (at->k * at->k - at->j * at->j) : Number(0);
    return {{"entry", entry}, {"exchanged", Number(-entry)}};
  }
  if (std::holds_alternative<Growth>(c.data)) return {{"growth", Order{1}}};
  const double v = 28 * boost::math::constants::zeta_three<double>() / (std::pow(pi, 4) * std::numbers::ln2);
  return {{"zero mean", 2 / pi}, {"zero mean, nearly", 2 / pi}, {"all", 1 / pi + std::sqrt(1 / (pi * pi) + v)}};
}

}  // namespace

Claim claim() {
  return compared<Case>("sec-31-sign-form")
      .cases([](const Context& context) { return cases(context, false); })
      .measured([]<Real R>(const Case& c) {
        if (const auto* at = std::get_if<Chebyshev>(&c.data)) return measured<R>(*at);
        if (const auto* cells = std::get_if<OnCells>(&c.data)) return measured(*cells);
        return measured(std::get<Growth>(c.data));
      })
      .predicted(predicted)
      .wrong("symmetric", scaled({"exchanged"}, -1))
      .wrong("half of it", scaled({"entry", "exchanged"}, 0.5))
      .wrong("the other sign", scaled({"entry", "exchanged"}, -1))
      .wrong("terms with `j + k` even, too",
             [](Values& p, const Case& c) {
               const auto* at = std::get_if<Chebyshev>(&c.data);
               if (at && at->j != at->k) p.set("entry", Number(4) / (at->k * at->k - at->j * at->j));
             })
      .wrong("the bound `1/pi`", replaced({{"zero mean", 1 / pi}}))
      .wrong("the bound `2/pi` on all tractions", replaced({{"all", 2 / pi}}))
      .wrong("no growth at a jump", replaced({{"growth", Order{0}}}))
      .wrong_beyond("a jump of `s` within the bound", [](const Context& context) { return cases(context, true); })
      .near_misses();
}

}  // namespace steadyslide::proofs_checks::sec_31_sign_form
