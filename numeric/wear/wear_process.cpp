#include "numeric/wear/wear_process.hpp"

#include <algorithm>
#include <cmath>

#include "model/invalid_data.hpp"
#include "numeric/periodic/repeated_contact.hpp"
#include "numeric/variational/lemke.hpp"
#include "numeric/variational/variational_solution.hpp"
#include "numeric/wear/run_in.hpp"

namespace steadyslide::numeric::wear {
namespace {

using variational::CellSet;
using variational::DiscreteProblem;

CellSet cells_under_pressure(const std::vector<double>& pressure) {
  CellSet contact(pressure.size());
  for (std::size_t i = 0; i < contact.size(); ++i) contact[i] = pressure[i] > 0;
  return contact;
}

/// Solves from the contact of a state.
variational::MeshSolution solved_from(std::shared_ptr<const DiscreteProblem> problem,
                                      const variational::DiscreteState& state, double scale) {
  variational::ActiveSetOptions options;
  options.tolerance *= scale;
  options.first_tolerance = std::max(0.05 * std::pow(static_cast<double>(problem->size()), -1.5), options.tolerance);
  return solve_on_cells(std::move(problem), cells_under_pressure(state.pressure), state, options);
}

bool is_solution(const variational::MeshSolution& found, double scale) {
  return found.found.outcome == variational::ActiveSetResult::Outcome::solved &&
         natural_residual(*found.problem, found.found.state) <= variational::complementary_within * scale;
}

constexpr const char* at_edge =
    "the contact of an elastic indenter reaches an edge, where the half-plane idealisation fails";
constexpr const char* not_solved = "the contact on cells is not solved, also not by complementary pivots";

}  // namespace

WearProcess::WearProcess(const ContactProblem& problem, const Wear& wear, std::size_t cells) : problem_(problem) {
  const VariationalSolution solution(problem, variational::solve_nested(problem, {.cells = cells}));
  failed_condition_ = solution.failed_condition();
  cells_ = solution.found().fine.problem;
  start_.contact = solution.found().fine.found.state;
  if (is_at_edge(start_.contact.pressure)) throw InvalidData(at_edge);
  start_.depth.resize(cells);
  const variational::CellMesh& mesh = cells_->mesh();
  const Rational& c = problem.elasticity().compliance();
  if (wear.body() > 0) {
    const Rational shift = (problem.sliding() == Sliding::plus_x ? -1 : 1) * wear.body() / c;
    cells_ = std::make_shared<DiscreteProblem>(problem, mesh, variational::FrictionRule::damped,
                                               cells_->galerkin_operator().kernel(), to_real<double>(shift));
    const variational::MeshSolution found = solved_from(cells_, start_.contact, 1);
    if (failed_condition_.empty() && !is_solution(found, 1)) failed_condition_ = not_solved;
    start_.contact = found.found.state;
  }
  origin_ = to_real<double>(mesh.frame().origin);
  unit_ = to_real<double>(mesh.frame().unit);
  stress_ = to_real<double>(problem.load() / mesh.frame().unit);
  height_ = to_real<double>(c * problem.load());
  std::vector<double> k, f;
  for (std::size_t piece = 0; piece < problem.friction().values().size(); ++piece) {
    k.push_back(to_real<double>(wear.coefficient(piece) / (c * mesh.frame().unit)));
    f.push_back(to_real<double>(problem.friction().values()[piece]));
  }
  const double largest = *std::max_element(k.begin(), k.end());
  natural_distance_ = 1 / largest;
  if (!(largest > 0 && std::isfinite(largest) && std::isfinite(natural_distance_)))
    throw InvalidData("wear.coefficients: values out of the range of double");
  k_ = means_of_pieces(problem, mesh, k);
  // A coating ends at the end of a cell up to rounding.
  for (double& value : k_) value = value < 1e-12 * largest ? 0 : value;
  friction_ = means_of_pieces(problem, mesh, f);
  run_in_ = run_in_pressure(*cells_, scaled(k_, natural_distance_));
}

WearProcess::Step WearProcess::advanced(const WearState& state, double step, int halvings) const {
  const std::size_t n = k_.size();
  const std::vector<double> diagonal = scaled(k_, step);
  const auto problem = std::make_shared<const DiscreteProblem>(*cells_, scaled(state.depth, -1), diagonal);
  // The rounding of the depth that the step takes off is relative to it.
  double scale = 1;
  for (std::size_t i = 0; i < n; ++i) scale = std::max(scale, diagonal[i] * state.contact.pressure[i]);
  variational::MeshSolution found = solved_from(problem, state.contact, scale);
  if (!is_solution(found, scale)) {
    Step half{state, 0, not_solved};
    if (halvings > 0) half = advanced(state, step / 2, halvings - 1);
    if (!half.failed_condition.empty()) return {state, 0, half.failed_condition};
    Step whole = advanced(half.state, step / 2, halvings - 1);
    whole.error += half.error;
    return whole;
  }
  Step result{state, 0, {}};
  result.state.distance += step;
  result.state.contact = std::move(found.found.state);
  std::vector<double> difference(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double p = result.state.contact.pressure[i];
    result.state.depth[i] += diagonal[i] * p;
    // The local error of implicit Euler, as the trapezoidal rule shows it.
    difference[i] = diagonal[i] * std::abs(p - state.contact.pressure[i]) / 2;
  }
  const double volume = integral(result.state.depth);
  result.error = volume > 0 ? integral(difference) / volume : 0;
  if (is_at_edge(result.state.contact.pressure)) return {state, 0, at_edge};
  return result;
}

bool WearProcess::is_at_edge(const std::vector<double>& pressure) const {
  return problem_.elasticity().indenter() && !is_without_edges(problem_) &&
         (pressure.front() > 0 || pressure.back() > 0);
}

WearRow WearProcess::row(const WearState& state, double step_error) const {
  const variational::CellMesh& mesh = cells_->mesh();
  const std::vector<double>& p = state.contact.pressure;
  WearRow row;
  row.distance = state.distance;
  std::vector<std::pair<double, double>> zones;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p[i] == 0) continue;
    if (i == 0 || p[i - 1] == 0) zones.emplace_back(origin_ + unit_ * mesh.left(i), 0);
    zones.back().second = origin_ + unit_ * mesh.right(i);
  }
  // Repeated contact is read from a gap on, as that of a solution.
  const Rational& left = problem_.indenter().left();
  const Rational begin = beginning_in_gap(problem_, zones);
  const std::size_t first =
      begin == left ? 0 : mesh.cell_at(mesh.place(moved_into(begin, left, *problem_.body().period())));
  double last_end = 0, centre = 0, friction = 0, rate = 0, from_run_in = 0;
  bool touched = false;
  for (std::size_t j = 0; j < p.size(); ++j) {
    const std::size_t i = (first + j) % p.size();
    const double moved = (i < first ? 1.0 : 0.0) - (begin < left ? 1.0 : 0.0);
    const double force = p[i] * mesh.length(i);
    centre += force * (mesh.centre(i) + moved);
    friction += force * friction_[i];
    rate += force * k_[i];
    if (run_in_) from_run_in += std::abs(p[i] - (*run_in_)[i]) * mesh.length(i);
    if (p[i] > 0 && row.zones == 0) row.left = origin_ + unit_ * (mesh.left(i) + moved);
    if (p[i] > 0 && !touched) ++row.zones;
    if (p[i] > 0) last_end = mesh.right(i) + moved;
    touched = p[i] > 0;
  }
  row.right = origin_ + unit_ * last_end;
  row.effective_friction = friction;
  row.centre_of_pressure = origin_ + unit_ * centre;
  if (problem_.load_at()) row.tilt = height_ / unit_ * state.contact.tilt;
  row.largest_pressure = stress_ * *std::max_element(p.begin(), p.end());
  row.wear_rate = rate * height_ * unit_;
  row.wear_volume = integral(state.depth) * height_ * unit_;
  if (run_in_) row.from_run_in = from_run_in;
  row.step_error = step_error;
  return row;
}

std::vector<double> WearProcess::run_in_pressures() const {
  return run_in_ ? scaled(*run_in_, stress_) : std::vector<double>();
}

std::vector<double> WearProcess::edges() const {
  std::vector<double> result = scaled(cells_->mesh().edges(), unit_);
  for (double& edge : result) edge += origin_;
  return result;
}

std::vector<double> WearProcess::data() const {
  std::vector<double> result{origin_, unit_, stress_, height_, problem_.load_at() ? *cells_->load_at() : 1};
  for (const auto& part :
       {k_, friction_, cells_->profile(), cells_->galerkin_operator().friction().whole, start_.contact.pressure}) {
    result.insert(result.end(), part.begin(), part.end());
  }
  return result;
}

std::vector<double> WearProcess::scaled(std::vector<double> values, double factor) {
  for (double& value : values) value *= factor;
  return values;
}

double WearProcess::integral(const std::vector<double>& values) const {
  double sum = 0;
  for (std::size_t i = 0; i < values.size(); ++i) sum += values[i] * cells_->mesh().length(i);
  return sum;
}

}  // namespace steadyslide::numeric::wear
