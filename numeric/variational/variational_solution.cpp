#include "numeric/variational/variational_solution.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "numeric/solution/largest_pressure.hpp"
#include "numeric/variational/touching_state.hpp"

namespace steadyslide::numeric {
namespace {

using variational::ActiveSetResult;
using variational::CellMesh;
using variational::DiscreteProblem;
using variational::DiscreteState;

/// The part of P under each friction value, and the centre of pressure in xi.
struct Shares {
  std::vector<double> loads;
  double centre = 0;
};

Shares shares(const ContactProblem& problem, const CellMesh& mesh, const DiscreteState& state) {
  const std::vector<Rational>& jumps = problem.friction().jumps();
  Shares result{std::vector<double>(jumps.size() + 1), 0};
  std::vector<double> ends;
  for (const Rational& c : jumps) ends.push_back(mesh.place(c));
  std::size_t piece = 0;
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    const double p = state.pressure[i];
    double left = mesh.left(i);
    for (; piece < ends.size() && ends[piece] <= mesh.right(i); ++piece) {
      result.loads[piece] += p * (ends[piece] - left);
      left = ends[piece];
    }
    result.loads[piece] += p * (mesh.right(i) - left);
    result.centre += p * mesh.length(i) * mesh.centre(i);
  }
  return result;
}

}  // namespace

VariationalSolution::VariationalSolution(ContactProblem problem, variational::NestedResult found)
    : problem_(std::move(problem)),
      found_(std::move(found)),
      origin_(to_real<double>(mesh().frame().origin)),
      unit_(to_real<double>(mesh().frame().unit)),
      stress_(to_real<double>(problem_.load() / mesh().frame().unit)),
      height_(to_real<double>(problem_.elasticity().compliance() * problem_.load())),
      displacement_(discrete().size()) {
  const auto set = [this](const variational::MeshSolution& solution, auto& edges, auto& traction, auto& load_before) {
    for (const double edge : solution.problem->mesh().edges()) edges.push_back(unit_ * edge);
    load_before.push_back(0);
    for (const double p : solution.found.state.pressure) {
      traction.push_back(-stress_ * p);
      load_before.push_back(load_before.back() + p * solution.problem->mesh().length(0));
    }
  };
  set(found_.fine, edges_, traction_, load_before_);
  set(found_.coarse, coarse_edges_, coarse_traction_, coarse_load_before_);
  if (discrete().is_galerkin()) {
    discrete().galerkin_operator().multiply(state().pressure, displacement_);
  } else {
    const variational::CellFriction means = cell_friction(problem_, mesh(), variational::FrictionRule::galerkin);
    variational::GalerkinOperator(mesh(), means).multiply(state().pressure, displacement_);
  }
  find_runs();
  find_places();
  find_end_errors();
}

void VariationalSolution::find_runs() {
  const variational::CellSet& contact = found_.fine.found.contact;
  for (std::size_t i = 0; i < contact.size(); ++i) {
    if (!contact[i]) continue;
    const std::size_t begin = i;
    while (i < contact.size() && contact[i]) ++i;
    runs_.push_back({begin, i});
  }
}

bool VariationalSolution::reaches_edge() const {
  return !runs_.empty() && (runs_.front().begin == 0 || runs_.back().end == mesh().size());
}

std::vector<double> VariationalSolution::touching_pressures() const {
  std::vector<double> result = variational::touching_state(problem_, found_.fine).state.pressure;
  for (double& p : result) p *= stress_;
  return result;
}

std::string VariationalSolution::failed_condition() const {
  const ActiveSetResult& last = found_.fine.found;
  if (found_.certificate.accepted()) return {};
  const std::string wrong =
      std::to_string(last.wrong.size()) + " of " + std::to_string(mesh().size()) + " cells are wrong";
  switch (last.outcome) {
    case ActiveSetResult::Outcome::out_of_steps:
      return "the active sets have not settled after " + std::to_string(last.steps) +
             (last.steps == 1 ? " iteration: " : " iterations: ") + wrong;
    case ActiveSetResult::Outcome::cycled:
      return "the active sets cycle, and complementary pivots do not end it: " + wrong;
    case ActiveSetResult::Outcome::solved: break;
  }
  return "the certificate does not accept what was found";
}

Resultants<double> VariationalSolution::resultants() const {
  const Shares fine = shares(problem_, mesh(), state());
  const Shares coarse = shares(problem_, found_.coarse.problem->mesh(), found_.coarse.found.state);
  const double load = to_real<double>(problem_.load());
  std::vector<Estimate<double>> loads;
  for (std::size_t k = 0; k < fine.loads.size(); ++k) {
    // The load itself is met; how it is shared is known to the difference between the meshes.
    loads.push_back({load * fine.loads[k], load * std::abs(fine.loads[k] - coarse.loads[k])});
  }
  Resultants<double> result = resultants_of(loads, problem_.friction().values());
  result.normal.error = load * (found_.certificate.load + 1e-15);
  for (const Run& run : runs_) {
    const double end = mesh().left(run.end - 1) + mesh().length(0);
    result.component_load.push_back(load_before(end) - load_before(mesh().left(run.begin)));
  }
  Estimate<double>& mu = result.effective_friction;
  double coarse_friction = 0;
  for (std::size_t k = 0; k < coarse.loads.size(); ++k) {
    coarse_friction += to_real<double>(problem_.friction().values()[k]) * coarse.loads[k];
  }
  mu.error = std::abs(mu.value - coarse_friction) + 1e-15 * mu.value;
  result.tangential.error = load * mu.error;
  for (std::size_t k = 0; k < fine.loads.size(); ++k) {
    result.load_share[k].error = std::abs(fine.loads[k] - coarse.loads[k]) + 1e-15;
  }
  result.centre_of_pressure = {origin_ + unit_ * fine.centre,
                               unit_ * std::abs(fine.centre - coarse.centre) + 1e-15 * (std::abs(origin_) + unit_)};
  return result;
}

LargestPressure<double> VariationalSolution::largest_pressure() const {
  if (const auto infinite = infinite_pressure(singular_points())) return *infinite;
  const auto cell = static_cast<std::size_t>(std::ranges::min_element(traction_) - traction_.begin());
  const auto coarse = static_cast<std::size_t>(std::ranges::min_element(coarse_traction_) - coarse_traction_.begin());
  const double x = (edges_[cell] + edges_[cell + 1]) / 2;
  const double coarse_x = (coarse_edges_[coarse] + coarse_edges_[coarse + 1]) / 2;
  Estimate<double> value = -traction(cell);
  value.error = std::max(value.error, std::abs(traction_[cell] - coarse_traction_[coarse])) +
                value.value * estimated_error().traction;
  return {value, {origin_ + x, cell_length() + std::abs(x - coarse_x)}, std::nullopt};
}

std::optional<Estimate<double>> VariationalSolution::tilt() const {
  if (!problem_.load_at()) return std::nullopt;
  const double scale = height_ / unit_;
  return Estimate<double>{scale * state().tilt, scale * std::abs(state().tilt - found_.coarse.found.state.tilt)};
}

double VariationalSolution::coarse_traction(std::size_t i) const {
  return coarse_traction_[(2 * i + 1) * coarse_traction_.size() / (2 * traction_.size())];
}

EstimatedError<double> VariationalSolution::estimated_error() const {
  EstimatedError<double> result{0, 0, 0};
  if (runs_.empty()) return result;
  const double hull = mesh().right(runs_.back().end - 1) - mesh().left(runs_.front().begin);
  // Everything may be at edges: then the cell is what ends are known to.
  result.ends = mesh().length(0) / hull;
  for (const Place& place : places_) result.ends = std::max(result.ends, place.error / (unit_ * hull));
  // In the mean over the load: where t is singular no number bounds it.
  for (std::size_t i = 0; i < traction_.size(); ++i) {
    result.traction += std::abs(traction_[i] - coarse_traction(i)) / stress_ * mesh().length(i);
  }
  result.resultants = resultant_error();
  return result;
}

double VariationalSolution::resultant_error() const {
  const Resultants<double> r = resultants();
  const double hull = edges_[runs_.back().end] - edges_[runs_.front().begin];
  double worst = r.centre_of_pressure.error / hull;
  for (const Estimate<double>& share : r.load_share) worst = std::max(worst, share.error);
  return worst;
}

Residuals<double> VariationalSolution::residuals() const {
  const variational::Certificate& c = found_.certificate;
  return {c.equation + c.product, std::max(c.load, c.moment), c.penetration, c.tension};
}

Attempt<double> variational_inequality(const ContactProblem& problem, const VariationalOptions& options) {
  if (options.cells < fewest_cells || options.cells > most_cells) throw std::invalid_argument("number of cells");
  auto solution = std::make_shared<VariationalSolution>(problem, variational::solve_nested(problem, options));
  if (problem.elasticity().indenter() && solution->reaches_edge()) {
    return {nullptr, "the contact of an elastic indenter reaches an edge, where the half-plane idealisation fails"};
  }
  return {std::move(solution), {}};
}

}  // namespace steadyslide::numeric
