#include "proofs_checks/instruments/operators/log_form_claim.hpp"

#include <numbers>

#include "proofs_checks/instruments/cells/cells.hpp"
#include "proofs_checks/instruments/cells/dense_algebra.hpp"
#include "proofs_checks/instruments/operators/angle_forms.hpp"
#include "proofs_checks/kit/rate.hpp"

namespace steadyslide::proofs_checks {
namespace {

/// Returns the form of the forces on N equal cells of a unit interval.
Eigen::MatrixXd form_on_cells(std::size_t cells) {
  const CellFrictionSteps none{{0, 0}, {0}};
  const CellMesh mesh(cell_problem(none), cells);
  return std::numbers::pi * symmetric_part(mesh, operator_of(none, mesh), false);
}

double least_eigenvalue(const Eigen::MatrixXd& form, Eigen::Index k = 0) { return eigenvalues(form)(k); }

/// Returns the least energy of t with int t = 1.
double least_energy(const Eigen::MatrixXd& form) {
  return 1 / linear_solution(form, Eigen::VectorXd::Ones(form.rows())).sum();
}

Values definiteness(const Length& length) {
  bool always = true;
  bool ever = false;
  bool second = true;
  bool zero_mean = true;
  for (const std::size_t cells : {16U, 24U, 32U, 48U, 64U}) {
    Eigen::MatrixXd form = form_on_cells(cells);
    form.array() -= std::log(to_real<double>(length.value));
    const bool positive = least_eigenvalue(form) > 0;
    always = always && positive;
    ever = ever || positive;
    second = second && least_eigenvalue(form, 1) > 0;
    zero_mean = zero_mean && least_eigenvalue(on_zero_mean(form)) > 0;
  }
  return {{"positive on all meshes", always},
          {"positive on some mesh", ever},
          {"second eigenvalue", second},
          {"zero mean", zero_mean}};
}

/// Adds the critical length from the limit of the energy, and its rate of convergence. The rate is measured by the
/// differences between a mesh and the mesh with twice as many cells.
void add_least_energy(Values& values) {
  std::vector<Level> levels;
  double fine = 0;
  double coarse = 0;
  for (const std::size_t cells : {16U, 24U, 32U}) {
    coarse = least_energy(form_on_cells(cells));
    fine = least_energy(form_on_cells(2 * cells));
    levels.push_back({static_cast<double>(cells), std::abs(coarse - fine)});
  }
  const Rate rate = fitted_rate(levels);
  values.add({"rate", Order{rate.value, rate.error_bar, "16 to 64 equal cells"}});
  values.add({"critical", std::exp(2 * fine - coarse)});
}

template <Real R>
Values measured(const Length& length) {
  using std::abs, std::max;
  Values values = definiteness(length);
  const R pi = numeric::pi<R>();
  const FormMatrix<R> form = log_form_by_quadrature<R>(to_real<R>(length.value));
  R rest = 0;
  for (std::size_t j = 0; j < form.size(); ++j) {
    values.add({std::to_string(j), R(form[j][j] / (pi * pi))});
    for (std::size_t k = 0; k < form.size(); ++k) {
      if (j != k) rest = max(rest, R(abs(form[j][k])));
    }
  }
  values.add({"rest", rest});
  if (length.is_first) add_least_energy(values);
  return values;
}

}  // namespace

std::string text_of(const Length& length) { return "L = " + to_string(length.value); }

Values predicted_by(const LogForm& form, const Length& length) {
  const bool positive = length.value < form.critical;
  Values values{{"positive on all meshes", positive},
                {"positive on some mesh", positive},
                {"second eigenvalue", true},
                {"zero mean", true},
                {"0", Number(log(to_real<Number>(form.critical / length.value)))},
                {"rest", Number(0)}};
  for (int k = 1; k <= highest_angle; ++k) {
    Rational coefficient = form.first;
    for (int m = 0; m < form.power; ++m) coefficient /= k;
    values.add({std::to_string(k), to_real<Number>(coefficient)});
  }
  if (length.is_first) {
    values.add({"rate", Order{1}});
    values.add({"critical", to_real<Number>(form.critical)});
  }
  return values;
}

ComparedClaim<Length> log_form_claim(std::string id, std::vector<Rational> lengths) {
  return compared<Length>(std::move(id))
      .cases([lengths = std::move(lengths)](const Context& context) {
        CaseList<Length> list{{}, "intervals of " + std::to_string(lengths.size()) + " lengths"};
        for (const Rational& length : lengths) list.cases.push_back({length, list.cases.empty()});
        if (context.quick) list.cases.resize(1);
        return list;
      })
      .measured([]<Real R>(const Length& length) { return measured<R>(length); })
      .predicted([](const Length& length) { return predicted_by({}, length); })
      .near_misses();
}

}  // namespace steadyslide::proofs_checks
