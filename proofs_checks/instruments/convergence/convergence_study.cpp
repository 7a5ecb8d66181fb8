#include "proofs_checks/instruments/convergence/convergence_study.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <set>
#include <stdexcept>

#include "numeric/riemann_hilbert/riemann_hilbert.hpp"
#include "numeric/variational/variational_inequality.hpp"
#include "proofs_checks/instruments/solutions/local_behaviour.hpp"

namespace steadyslide::proofs_checks {
namespace {

using SingularPlace = VariationalSolution::SingularPlace;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

bool is_constant(const FrictionProfile& friction) {
  const std::vector<Rational>& values = friction.values();
  return std::adjacent_find(values.begin(), values.end(), std::not_equal_to<>()) == values.end();
}

std::vector<double> resultants_of(const ContactProblem& problem, const numeric::ContactSolution<double>& solution) {
  const numeric::Resultants<double> r = solution.resultants();
  std::vector<double> result;
  if (!is_constant(problem.friction())) {
    for (std::size_t k = 0; k + 1 < r.load_share.size(); ++k) result.push_back(r.load_share[k].value);
    result.push_back(r.effective_friction.value);
  }
  result.push_back(problem.load_at() ? solution.tilt()->value : r.centre_of_pressure.value);
  return result;
}

std::vector<double> intensities_of(const numeric::ContactSolution<double>& solution) {
  std::vector<double> result;
  for (const auto& point : solution.singular_points()) {
    result.push_back(std::isfinite(point.intensity.error) ? point.intensity.value : nan);
    if (!local_terms(point.kind).has_constant) continue;
    result.push_back(std::isfinite(point.constant.error) ? point.constant.value : nan);
  }
  return result;
}

std::shared_ptr<const VariationalSolution> on_cells(const ContactProblem& problem, std::size_t cells) {
  auto solution = std::dynamic_pointer_cast<const VariationalSolution>(
      numeric::variational_inequality(problem, {.cells = cells}).solution);
  if (!solution || !solution->failed_condition().empty()) {
    throw std::runtime_error("not solved on " + std::to_string(cells) + " cells");
  }
  return solution;
}

OnMesh on_mesh(const ContactProblem& problem, const VariationalSolution& solution, std::size_t cells) {
  OnMesh result{cells, solution.cell_length(), {{}, resultants_of(problem, solution), {}}};
  const auto middle = to_real<double>((problem.indenter().left() + problem.indenter().right()) / 2);
  for (const SingularPlace& place : solution.places()) {
    if (place.is_end()) result.solved.ends.push_back({middle + place.x, place.exact});
  }
  if (cells >= first_with_intensities) result.solved.intensities = intensities_of(solution);
  return result;
}

std::optional<enclosure::CellBound> proved_bound(const ContactProblem& problem, const VariationalSolution& solution) {
  enclosure::CellBound bound = enclosure::bound_cells(problem, solution.touching_pressures());
  if (!bound.proved) return std::nullopt;
  return bound;
}

/// Returns the exponent for friction with the opposite sign.
Exponent reversed(const SingularPlace& place, const ContactProblem& problem) {
  if (!place.is_end()) return -*place.exponent;
  const End end = opposite(place.contact);
  const Rational s = -problem.coupled_friction(place.friction_left);
  return place.kind == SingularKind::free ? free_exponent(end, s) : edge_exponent(end, s);
}

std::vector<ReadExponent> read_exponents(const ContactProblem& problem, const VariationalSolution& solution,
                                         StudyPlan::Exponents which) {
  std::vector<ReadExponent> result;
  if (which == StudyPlan::Exponents::none) return result;
  const auto middle = to_real<double>((problem.indenter().left() + problem.indenter().right()) / 2);
  std::set<SingularKind> kinds;
  for (const SingularPlace& place : solution.places()) {
    if (!place.exponent || place.exponent->sign() == 0) continue;
    for (const Side side : {Side::left, Side::right}) {
      if (place.is_end() && side != place.contact) continue;
      const bool another = !kinds.insert(place.kind).second;
      if (another && which == StudyPlan::Exponents::one_of_a_kind) continue;
      result.push_back(
          {middle + place.x, side, power_on_cells(solution, place, side), *place.exponent, reversed(place, problem)});
    }
  }
  return result;
}

double level_error(const MeshLevel& level, std::vector<double> SolvedQuantities::*values, double exact, double scale,
                   std::size_t k) {
  std::vector<double> errors;
  for (const OnMesh& mesh : level.meshes) {
    const std::vector<double>& found = mesh.solved.*values;
    errors.push_back(k < found.size() ? (found[k] - exact) / scale : nan);
  }
  return root_mean_square(errors);
}

}  // namespace

std::vector<std::string> resultant_names(const ContactProblem& problem) {
  std::vector<std::string> names;
  if (!is_constant(problem.friction())) {
    for (std::size_t k = 0; k < problem.friction().jumps().size(); ++k) {
      names.push_back("load share " + std::to_string(k + 1));
    }
    names.emplace_back("effective friction");
  }
  names.emplace_back(problem.load_at() ? "tilt" : "centre of pressure");
  return names;
}

SolvedReference reference(const ContactProblem& problem) {
  const auto solution = numeric::riemann_hilbert<double>(problem).solution;
  if (!solution || !solution->failed_condition().empty()) throw std::runtime_error("no Riemann-Hilbert solution");
  SolvedReference result{{{}, resultants_of(problem, *solution), intensities_of(*solution)}, {}};
  for (const auto& zone : solution->contact()) {
    for (const auto* end : {&zone.left, &zone.right}) {
      result.solved.ends.push_back({end->x.value, end->kind != SingularKind::free});
    }
  }
  for (const auto& point : solution->singular_points()) {
    char place[32];
    std::snprintf(place, sizeof place, "%.4f", point.x.value);
    result.intensity_names.push_back((point.exponent ? "theta at " : "log coefficient at ") + std::string(place));
    if (local_terms(point.kind).has_constant) result.intensity_names.push_back("constant at " + std::string(place));
  }
  return result;
}

ConvergenceStudy study(const ContactProblem& problem, const StudyPlan& plan) {
  const auto finest = on_cells(problem, plan.fine);
  ConvergenceStudy result{expected_rate(problem, finest->places()),
                          {},
                          on_mesh(problem, *finest, plan.fine),
                          read_exponents(problem, *finest, plan.exponents)};
  const std::size_t meshes = result.rate < 2 ? 7 : 21;
  for (std::size_t cells = 64; cells <= plan.last; cells *= 2) {
    MeshLevel level{cells, {}, {}};
    for (std::size_t n = cells; n < cells + meshes; ++n) {
      const auto solution = on_cells(problem, n);
      level.meshes.push_back(on_mesh(problem, *solution, n));
      if (n == cells) level.bound = proved_bound(problem, *solution);
    }
    result.levels.push_back(std::move(level));
  }
  return result;
}

const enclosure::Ball* proved_resultant(const enclosure::CellBound& bound, std::size_t k) {
  const std::size_t shares = bound.load_share.size() - 1;  // the last load share follows from the others
  if (shares == 0 || k > shares) return nullptr;
  return k < shares ? &bound.load_share[k] : &bound.effective_friction;
}

double resultant_error(const MeshLevel& level, const SolvedQuantities& exact, std::size_t k) {
  return level_error(level, &SolvedQuantities::resultants, exact.resultants[k], 1, k);
}

double intensity_error(const MeshLevel& level, const SolvedQuantities& exact, std::size_t k) {
  return level_error(level, &SolvedQuantities::intensities, exact.intensities[k], exact.intensities[k], k);
}

}  // namespace steadyslide::proofs_checks
