#include "numeric/variational/variational_solution.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/solution/largest_pressure.hpp"
#include "numeric/variational/touching_state.hpp"

namespace steadyslide::numeric {
using variational::ActiveSetResult;

VariationalSolution::VariationalSolution(ContactProblem problem, variational::NestedResult found)
    : problem_(std::move(problem)),
      found_(std::move(found)),
      origin_(to_real<double>(mesh().frame().origin)),
      unit_(to_real<double>(mesh().frame().unit)),
      stress_(to_real<double>(problem_.load() / mesh().frame().unit)),
      height_(to_real<double>(problem_.elasticity().compliance() * problem_.load())),
      displacement_(discrete().size()) {
  const auto set = [this](const variational::MeshSolution& solution, auto& edges, auto& traction) {
    for (const double edge : solution.problem->mesh().edges()) edges.push_back(unit_ * edge);
    for (const double p : solution.found.state.pressure) traction.push_back(-stress_ * p);
  };
  set(found_.fine, edges_, traction_);
  set(found_.coarse, coarse_edges_, coarse_traction_);
  for (const auto* mesh : {&found_.fine, &found_.coarse}) meshes_.emplace_back(mesh->found.state);
  for (const variational::DiscreteState& coarser : found_.coarser) meshes_.emplace_back(coarser);
  if (discrete().is_galerkin()) {
    discrete().galerkin_operator().multiply(state().pressure, displacement_);
  } else {
    const variational::CellFriction means = cell_friction(problem_, mesh(), variational::FrictionRule::galerkin);
    variational::GalerkinOperator(mesh(), means, kernel()).multiply(state().pressure, displacement_);
  }
  find_runs();
  find_places();
  const auto is_exact = [](const SingularPlace& place) {
    return place.exact && place.exponent && place.exponent->sign() != 0;
  };
  // The pressure at a steep free end is nearly a step, whose place in its cell differs from mesh to mesh by chance.
  const auto is_steep = [](const SingularPlace& place) {
    if (place.kind != SingularKind::free || !place.exponent) return false;
    const auto power = to_real<double>(*place.exponent);
    return std::min(power, 1 - power) < 0.1;
  };
  constexpr std::size_t few = 32;
  const auto is_short = [](const Run& run) { return run.end - run.begin < few; };
  if (std::any_of(places_.begin(), places_.end(), is_exact) || std::any_of(places_.begin(), places_.end(), is_steep) ||
      std::any_of(runs_.begin(), runs_.end(), is_short))
    mesh_rate_ = 1;
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
  fills_period_ = mesh().frame().unit == problem_.body().period() && runs_.size() == 1 &&
                  runs_.front().end - runs_.front().begin == contact.size();
}

bool VariationalSolution::reaches_edge() const {
  return std::any_of(places_.begin(), places_.end(),
                     [](const SingularPlace& place) { return place.kind == SingularKind::edge; });
}

std::vector<double> VariationalSolution::touching_pressures() const {
  if (!kernel().is_half_plane() || mesh().frame().unit != variational::support_frame(problem_).unit) return {};
  std::vector<double> result = variational::touching_state(problem_, found_.fine).pressure;
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

LargestPressure<double> VariationalSolution::largest_pressure() const {
  std::vector<SolvedSingularPoint<double>> unbounded;
  for (const SingularPlace& place : places_) {
    if (place.exponent && place.exponent->sign() < 0) unbounded.push_back(solved_point(place));
  }
  if (const auto wedge = sharpest_wedge()) unbounded.push_back(*wedge);
  if (const auto infinite = infinite_pressure(unbounded)) return *infinite;
  const auto cell = static_cast<std::size_t>(std::min_element(traction_.begin(), traction_.end()) - traction_.begin());
  const auto coarse = static_cast<std::size_t>(std::min_element(coarse_traction_.begin(), coarse_traction_.end()) -
                                               coarse_traction_.begin());
  const double x = (edges_[cell] + edges_[cell + 1]) / 2;
  const double coarse_x = (coarse_edges_[coarse] + coarse_edges_[coarse + 1]) / 2;
  Estimate<double> value = -traction(cell);
  value.error = std::max(value.error, std::abs(traction_[cell] - coarse_traction_[coarse])) +
                value.value * estimated_error().traction;
  return {value, {origin_ + x, cell_length() + std::abs(x - coarse_x)}, std::nullopt};
}

double VariationalSolution::coarse_traction(std::size_t i) const {
  return coarse_traction_[(2 * i + 1) * coarse_traction_.size() / (2 * traction_.size())];
}

EstimatedError<double> VariationalSolution::errors() const {
  EstimatedError<double> result{0, 0, 0};
  if (runs_.empty()) return result;
  const double hull = mesh().right(runs_.back().end - 1) - mesh().left(runs_.front().begin);
  // If all ends are edges, the error of ends is still given as one cell.
  result.ends = mesh().length(0) / hull;
  for (const SingularPlace& place : places_) result.ends = std::max(result.ends, place.error / (unit_ * hull));
  // The mean over the load, because where t is singular the error is unbounded.
  for (std::size_t i = 0; i < traction_.size(); ++i) {
    result.traction += std::abs(traction_[i] - coarse_traction(i)) / stress_ * mesh().length(i);
  }
  result.resultants = resultant_error();
  return result;
}

Residuals<double> VariationalSolution::residuals() const {
  const variational::Certificate& c = found_.certificate;
  return {c.equation + c.product, std::max(c.load, c.moment), c.penetration, c.tension};
}

}  // namespace steadyslide::numeric
