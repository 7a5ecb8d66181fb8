#include "numeric/quadrature/gsl_quadrature.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>

#include <memory>
#include <mutex>
#include <numbers>

namespace steadyslide::numeric::gsl {
namespace {

constexpr std::size_t max_intervals = 400;
constexpr double relative_tolerance = 1e-13;

/// Returns the value of an adaptive rule for g, rule(function, workspace, value, error). If rounding prevents the
/// requested tolerance, this is not a failure: the error estimate gives the tolerance that was reached.
template <class G, class Rule>
Estimate<double> adaptive(const G& g, const Rule& rule) {
  // GSL aborts the process on an error unless its global error handler is off. Only this place switches it off.
  static std::once_flag once;
  std::call_once(once, [] { gsl_set_error_handler_off(); });
  const std::unique_ptr<gsl_integration_workspace, decltype(&gsl_integration_workspace_free)> workspace(
      gsl_integration_workspace_alloc(max_intervals), gsl_integration_workspace_free);
  gsl_function f{[](double x, void* data) { return (*static_cast<const G*>(data))(x); }, const_cast<G*>(&g)};
  double value = 0;
  double error = 0;
  const int status = rule(&f, workspace.get(), &value, &error);
  const bool reached = (status == GSL_SUCCESS || status == GSL_EROUND) && std::isfinite(value);
  return {value, error, reached ? Convergence::reached : Convergence::stalled};
}

/// Returns int_0^length d^power g(d) dd; 0 for an empty interval. QAWS requires power > -1; 1 + lambda may be below
/// 1e-16.
template <class G>
Estimate<double> qaws(double length, double power, const G& g) {
  if (length <= 0) return {};
  return adaptive(g, [&](gsl_function* f, gsl_integration_workspace* workspace, double* value, double* error) -> int {
    const std::unique_ptr<gsl_integration_qaws_table, decltype(&gsl_integration_qaws_table_free)> table(
        gsl_integration_qaws_table_alloc(power, 0, 0, 0), gsl_integration_qaws_table_free);
    if (!table) return GSL_EDOM;
    return gsl_integration_qaws(f, 0, length, table.get(), 0, relative_tolerance, max_intervals, workspace, value,
                                error);
  });
}

/// Returns PV int_{-radius}^{radius} g(y)/y dy.
template <class G>
Estimate<double> qawc(double radius, const G& g) {
  return adaptive(g, [&](gsl_function* f, gsl_integration_workspace* workspace, double* value, double* error) {
    return gsl_integration_qawc(f, -radius, radius, 0, 0, relative_tolerance, max_intervals, workspace, value, error);
  });
}

/// Integrates from each end to the middle. So a kernel that is nearly singular at an end gets the exact distance to
/// that end.
template <class Kernel>
Estimate<double> weighted_panel(const PanelDensity<double>& density, const Kernel& kernel) {
  Estimate<double> sum;
  for (const Side end : {Side::left, Side::right}) {
    sum += qaws(density.panel.length / 2, density.power(end).value, [&](double d) {
      const Node<double> node = density.panel.node_from(end, d);
      return density.without_power(end, node) * kernel(node);
    });
  }
  return sum;
}

Estimate<double> own_panel(const PanelDensity<double>& density, const Node<double>& at) {
  const double radius = std::min(at.from_left, at.from_right) / 2;  // so one of the two middle parts is empty
  const Panel<double>& panel = density.panel;
  Estimate<double> sum = qawc(radius, [&](double y) { return density(at.moved(y)); });
  // The parts left of x - radius and right of x + radius: half of each is measured from x, the other half from the end.
  sum += qaws(at.from_left / 2, density.left.value, [&](double d) {
    return density.without_power(Side::left, panel.node_from_left(d)) / (d - at.from_left);
  });
  for (const int away : {-1, 1}) {
    sum += qaws((away < 0 ? at.from_left : at.from_right) / 2 - radius, 0, [&](double y) {
      const double beyond = radius + y;
      return away * density(at.moved(away * beyond)) / beyond;
    });
  }
  sum += qaws(at.from_right / 2, density.right.value, [&](double d) {
    return density.without_power(Side::right, panel.node_from_right(d)) / (at.from_right - d);
  });
  return sum;
}

}  // namespace

Estimate<double> panel_integral(const PanelDensity<double>& density) {
  return weighted_panel(density, [](const Node<double>&) { return 1.0; });
}

Estimate<double> integral(const PiecewiseDensity<double>& density) {
  Estimate<double> sum;
  for (const PanelDensity<double>& panel : density) sum += panel_integral(panel);
  return sum;
}

Estimate<double> hilbert(const PiecewiseDensity<double>& density, const PanelPoint<double>& at) {
  Estimate<double> sum = own_panel(density[at.panel], at.node);
  for (std::size_t j = 0; j < density.size(); ++j) {
    if (j == at.panel) continue;
    const bool to_the_right = j > at.panel;
    const double between =
        (to_the_right ? at.node.from_right : at.node.from_left) + distance_between(density, j, at.panel);
    sum += weighted_panel(density[j], [&](const Node<double>& node) {
      return to_the_right ? 1 / (between + node.from_left) : -1 / (between + node.from_right);
    });
  }
  return sum / std::numbers::pi;
}

}  // namespace steadyslide::numeric::gsl
