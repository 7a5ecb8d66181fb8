#include "numeric/coarse/coarse_contact.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "numeric/coarse/coarse_equilibrium.hpp"
#include "numeric/number/real.hpp"

namespace steadyslide::numeric {
namespace {

using namespace coarse;

constexpr int most_growth = 16;
constexpr int most_meshes = 40;

/// How far from the inner edge of the outermost cell a contact ends freely, where the traction is proportional to
/// d^power: forces within d are then to each other as d^{1+power}. At most halfway into the next cell.
double end_distance(const Mesh& mesh, const Equilibrium& state, double power, std::size_t last, std::size_t next,
                    double beyond) {
  const double outer = state.force[last];
  const double inner = state.force[next];
  if (!(outer > 0 && inner > 0)) return mesh.length(last);
  const double ratio = std::pow(outer / (outer + inner), 1 / (1 + power));
  return std::min(mesh.length(next) * ratio / (1 - ratio), mesh.length(last) + beyond / 2);
}

ContactInterval zone(const Mesh& mesh, const Equilibrium& state, const Run& run) {
  const auto [first, last] = run;
  ContactInterval zone{mesh.left(first), mesh.right(last - 1), first == 0 || mesh.step_before(first) < 0,
                       last == mesh.size() || mesh.step_before(last) > 0};
  if (last - first < 3) return zone;
  if (!zone.left_at_edge) {
    const double beyond = mesh.step_before(first) == 0 ? mesh.length(first - 1) : 0;
    zone.left = mesh.right(first) - end_distance(mesh, state, mesh.piece(first).behind, first, first + 1, beyond);
  }
  if (!zone.right_at_edge) {
    const double beyond = mesh.step_before(last) == 0 ? mesh.length(last) : 0;
    zone.right =
        mesh.left(last - 1) + end_distance(mesh, state, mesh.piece(last - 1).ahead, last - 1, last - 2, beyond);
  }
  return zone;
}

std::vector<char> inherited(const std::vector<char>& active, const std::vector<int>& pieces) {
  std::vector<char> result;
  for (std::size_t i = 0; i < active.size(); ++i) {
    result.insert(result.end(), static_cast<std::size_t>(pieces[i]), active[i]);
  }
  return result;
}

/// Even forces on cells are centred at a cell's centre: the load has to lie between the outermost ones.
Mesh around_load(Mesh mesh, double at) {
  std::vector<int> pieces(mesh.size(), 1);
  const auto parts = [](double length, double distance) {
    return static_cast<int>(std::min(length / distance + 1, 1e3));
  };
  if (at <= mesh.centre(0)) pieces.front() = parts(mesh.length(0), at - mesh.left(0));
  const std::size_t last = mesh.size() - 1;
  if (at >= mesh.centre(last)) pieces.back() = parts(mesh.length(last), mesh.right(last) - at);
  return mesh.refined(pieces);
}

}  // namespace

CoarseContact coarse_contact(const ContactProblem& problem, int cells) {
  CoarseContact result;
  const Indenter& indenter = problem.indenter();
  result.origin = (indenter.left() + indenter.right()) / 2;
  Load load{to_real<double>(problem.load()), std::nullopt};
  if (problem.load_at()) load.at = to_real<double>(Rational(*problem.load_at() - result.origin));

  Mesh mesh(problem, result.origin, cells);
  if (load.at) mesh = around_load(std::move(mesh), *load.at);
  const std::size_t most_cells = static_cast<std::size_t>(most_growth) * static_cast<std::size_t>(cells);
  Equilibrium state;
  std::vector<char> guess;
  for (int round = 0;; ++round) {
    state = equilibrium(mesh, load, std::move(guess));
    if (round == most_meshes) break;
    const std::vector<int> pieces = wanted_pieces(mesh, state);
    const auto count = static_cast<std::size_t>(std::accumulate(pieces.begin(), pieces.end(), 0));
    if (count == mesh.size() || count > most_cells) break;
    guess = inherited(state.active, pieces);
    mesh = mesh.refined(pieces);
  }

  for (const Run& run : runs(mesh, state.active)) result.zones.push_back(zone(mesh, state, run));
  result.tilt = state.tilt;
  result.cell_edges = mesh.edges();
  for (std::size_t i = 0; i < mesh.size(); ++i) result.traction.push_back(-state.force[i] / mesh.length(i));
  result.converged = state.converged;
  return result;
}

}  // namespace steadyslide::numeric
