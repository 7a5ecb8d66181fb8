#include "numeric/variational/certificate.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/number/compensated_sum.hpp"

namespace steadyslide::numeric::variational {
namespace {

constexpr std::size_t all_rows_up_to = 2048;
constexpr std::size_t most_rows = 64;

/// Returns the rows to sum: first those where contact begins or ends, then cells distributed over the support.
std::vector<std::size_t> rows_to_sum(const std::vector<double>& pressure) {
  const std::size_t n = pressure.size();
  std::vector<std::size_t> rows;
  if (n <= all_rows_up_to) {
    for (std::size_t i = 0; i < n; ++i) rows.push_back(i);
    return rows;
  }
  for (std::size_t i = 0; i + 1 < n && rows.size() + 2 <= most_rows / 2; ++i) {
    if ((pressure[i] > 0) == (pressure[i + 1] > 0)) continue;
    rows.push_back(i);
    rows.push_back(i + 1);
  }
  const std::size_t others = most_rows - rows.size();
  for (std::size_t k = 0; k < others; ++k) rows.push_back(k * (n - 1) / (others - 1));
  return rows;
}

/// Returns the sum with compensation, because the rounding error of a million terms is not an error of the operator.
double row_sum(const GalerkinOperator& b, const std::vector<double>& p, std::size_t i) {
  CompensatedSum<double> sum;
  for (std::size_t j = 0; j < p.size(); ++j) {
    if (p[j] != 0) sum.add(b.entry(i, j) * p[j]);
  }
  return sum.value();
}

}  // namespace

bool Certificate::accepted() const {
  // A residual that is NaN is not below any limit.
  return natural <= allowed && equation <= allowed && load <= allowed && moment <= allowed && product <= allowed;
}

Certificate certify(const DiscreteProblem& problem, const DiscreteState& state) {
  const CellMesh& mesh = problem.mesh();
  const std::vector<double>& p = state.pressure;
  std::vector<double> displacement(p.size());
  problem.galerkin_operator().multiply(p, displacement);

  Certificate result;
  const std::vector<std::size_t> rows = rows_to_sum(p);
  result.rows = rows.size();
  for (const std::size_t i : rows) {
    result.product = std::max(result.product, std::abs(displacement[i] - row_sum(problem.galerkin_operator(), p, i)));
  }

  double contact_length = 0;
  double load = 0;
  double moment = 0;
  std::vector<std::size_t> cells;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p[i] == 0) continue;
    cells.push_back(i);
    contact_length += mesh.length(i);
    load += p[i] * mesh.length(i);
    moment += p[i] * mesh.length(i) * mesh.centre(i);
  }
  result.load = std::abs(load - 1);
  if (problem.load_at()) result.moment = std::abs(moment - *problem.load_at());
  result.allowed = 1e-10 * height_over(problem, cells);
  bool is_number = std::isfinite(state.approach) && std::isfinite(state.tilt) && std::isfinite(result.product);
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double gap = problem.profile()[i] + state.tilt * problem.place(i) + displacement[i] - state.approach;
    const double pressure = p[i] * contact_length;
    is_number = is_number && std::isfinite(gap) && std::isfinite(pressure);
    result.natural = std::max(result.natural, std::abs(std::min(pressure, gap)));
    result.penetration = std::max(result.penetration, -gap);
    result.tension = std::max(result.tension, -pressure);
    if (p[i] > 0) result.equation = std::max(result.equation, std::abs(gap));
  }
  result.natural = is_number ? result.natural + result.product : std::nan("");
  return result;
}

}  // namespace steadyslide::numeric::variational
