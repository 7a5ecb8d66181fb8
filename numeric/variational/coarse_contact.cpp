#include "numeric/variational/coarse_contact.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>

#include "numeric/number/dense_lu.hpp"
#include "numeric/number/real.hpp"
#include "numeric/variational/lemke.hpp"

namespace steadyslide::numeric {
namespace coarse {
namespace {

std::vector<SupportPiece> pieces_of(const ContactProblem& problem, const Rational& origin) {
  const Polynomial per_compliance = Polynomial::constant(1 / problem.elasticity().compliance());
  std::vector<SupportPiece> pieces;
  std::vector<double> profile;
  std::size_t next = 0;
  for (const ContactProblem::Piece& piece : problem.pieces()) {
    const int step = sign(problem.indenter().break_at(piece.left).step);
    if (piece.profile == next) {
      profile = coefficients_of<double>(per_compliance * problem.indenter().pieces()[next].profile.composed(1, origin));
      ++next;
    }
    const auto s = to_real<double>(problem.coupled_friction(piece.friction));
    const double turn = std::atan2(1, std::abs(s)) / std::numbers::pi;
    const auto from = to_real<double>(Rational(piece.left - origin));
    const auto to = to_real<double>(Rational(piece.right - origin));
    // There is no cell between cuts that double cannot distinguish.
    if (from >= to) continue;
    pieces.push_back({from, to, s, s < 0 ? turn : 1 - turn, s < 0 ? 1 - turn : turn, profile, step});
  }
  return pieces;
}

constexpr int most_rounds = 40;

/// Returns the tolerance of signs as a multiple of the load, for the rounding of the forces and of the profile.
double sign_tolerance(const Mesh& mesh, const Load& load, const std::vector<char>& active) {
  double highest = 0;
  for (std::size_t i = 0; i < active.size(); ++i) {
    if (active[i]) highest = std::max(highest, std::abs(mesh.profile(i)));
  }
  return 1e-13 + 1e-15 * highest / load.force;
}

/// Returns the corrected contact: cells with tension leave, cells with overlap enter. If too few cells remain, those
/// with the largest forces stay.
std::vector<char> corrected(const Mesh& mesh, const Equilibrium& state, const Load& load) {
  const double tolerance = sign_tolerance(mesh, load, state.active) * load.force;
  const std::size_t least = load.at ? 2 : 1;
  std::vector<char> active(state.active.size());
  for (std::size_t i = 0; i < active.size(); ++i) {
    active[i] = state.active[i] ? state.force[i] >= -tolerance : state.gap[i] < -tolerance;
  }
  auto count = static_cast<std::size_t>(std::count(active.begin(), active.end(), 1));
  for (; count < std::min(least, active.size()); ++count) {
    std::size_t best = active.size();
    for (std::size_t i = 0; i < active.size(); ++i) {
      if (!active[i] &&
          (best == active.size() || state.force[i] - state.gap[i] > state.force[best] - state.gap[best])) {
        best = i;
      }
    }
    active[best] = 1;
  }
  return active;
}

/// Returns the cells that touch at zero load: the lowest one, or the two of the lower hull on both sides of the load
/// line.
std::vector<std::size_t> first_contact(const Mesh& mesh, const Load& load, const std::vector<double>& psi) {
  if (!load.at) return {static_cast<std::size_t>(std::min_element(psi.begin(), psi.end()) - psi.begin())};
  std::vector<std::size_t> hull;
  for (std::size_t i = 0; i < psi.size(); ++i) {
    const auto above = [&](std::size_t a, std::size_t b) {
      return (psi[b] - psi[a]) * (mesh.point(i) - mesh.point(a)) >= (psi[i] - psi[a]) * (mesh.point(b) - mesh.point(a));
    };
    while (hull.size() >= 2 && above(hull[hull.size() - 2], hull.back())) hull.pop_back();
    hull.push_back(i);
  }
  std::size_t k = 1;
  while (k + 1 < hull.size() && mesh.centre(hull[k]) < *load.at) ++k;
  return {hull[k - 1], hull[k]};
}

}  // namespace

Mesh::Mesh(const ContactProblem& problem, const Rational& origin, int cells, const variational::SurfaceKernel& kernel)
    : kernel_(kernel), pieces_(pieces_of(problem, origin)), edges_{pieces_.front().left} {
  const double width = pieces_.back().right - pieces_.front().left;
  const int least = pieces_.size() <= 4 * static_cast<std::size_t>(cells) ? 2 : 1;
  for (std::size_t k = 0; k < pieces_.size(); ++k) {
    const SupportPiece& piece = pieces_[k];
    const double length = piece.right - piece.left;
    const int count = std::max(least, static_cast<int>(std::lround(cells * length / width)));
    for (int i = 1; i <= count; ++i) {
      edges_.push_back(i < count ? piece.left + length * i / count : piece.right);
      piece_of_.push_back(k);
    }
  }
}

Mesh Mesh::refined(const std::vector<int>& pieces) const {
  Mesh result;
  result.kernel_ = kernel_;
  result.pieces_ = pieces_;
  result.edges_.push_back(edges_.front());
  for (std::size_t i = 0; i < size(); ++i) {
    for (int k = 1; k <= pieces[i]; ++k) {
      result.edges_.push_back(k < pieces[i] ? left(i) + length(i) * k / pieces[i] : right(i));
      result.piece_of_.push_back(piece_of_[i]);
    }
  }
  return result;
}

bool Mesh::beside_cut(std::size_t i) const {
  return i == 0 || i + 1 == size() || piece_of_[i] != piece_of_[i - 1] || piece_of_[i] != piece_of_[i + 1];
}

const Eigen::VectorXd& Mesh::column(std::size_t j) const {
  columns_.resize(size());
  Eigen::VectorXd& column = columns_[j];
  if (column.size() > 0) return column;
  column.resize(static_cast<Eigen::Index>(size()));
  const SupportPiece& piece = this->piece(j);
  for (std::size_t i = 0; i < size(); ++i) {
    const double mean = i == j ? kernel_.mean_within(piece.ahead * length(j), piece.behind * length(j), length(j))
                               : kernel_.mean_from_point(left(j), right(j), point(i));
    column(static_cast<Eigen::Index>(i)) = mean + (j < i ? piece.s : j == i ? piece.s * piece.ahead : 0);
  }
  return column;
}

int Mesh::step_before(std::size_t i) const { return i > 0 && piece_of_[i] != piece_of_[i - 1] ? piece(i).step : 0; }

Equilibrium with_contact_on(const Mesh& mesh, const Load& load, const std::vector<char>& active) {
  const Eigen::Index rest = load.at ? 2 : 1;  // unknowns C and tilt
  const std::vector<std::size_t> cells = variational::cells_of(active);
  const auto count = static_cast<Eigen::Index>(cells.size());
  const auto index_of = [&](Eigen::Index k) { return static_cast<Eigen::Index>(cells[static_cast<std::size_t>(k)]); };
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(count + rest, count + rest);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(count + rest);
  for (Eigen::Index k = 0; k < count; ++k) {
    const std::size_t j = cells[static_cast<std::size_t>(k)];
    const Eigen::VectorXd& column = mesh.column(j);
    for (Eigen::Index i = 0; i < count; ++i) matrix(i, k) = column(index_of(i));
    matrix(k, count) = -1;
    matrix(count, k) = 1;
    right(k) = -mesh.profile(j);
    if (!load.at) continue;
    matrix(k, count + 1) = mesh.point(j);
    matrix(count + 1, k) = mesh.centre(j) - *load.at;
  }
  right(count) = load.force;
  const Eigen::VectorXd solution = DenseLu(matrix).solve(right);

  Equilibrium state;
  state.active = active;
  state.force.assign(active.size(), 0);
  state.tilt = load.at ? solution(count + 1) : 0;
  Eigen::VectorXd gap(static_cast<Eigen::Index>(active.size()));
  for (std::size_t i = 0; i < active.size(); ++i) {
    gap(static_cast<Eigen::Index>(i)) = mesh.profile(i) - solution(count) + state.tilt * mesh.point(i);
  }
  for (Eigen::Index k = 0; k < count; ++k) {
    const std::size_t j = cells[static_cast<std::size_t>(k)];
    state.force[j] = solution(k);
    gap += solution(k) * mesh.column(j);
  }
  for (Eigen::Index k = 0; k < count; ++k) gap(index_of(k)) = 0;
  state.gap.assign(gap.begin(), gap.end());
  if (!solution.allFinite() || !gap.allFinite()) {
    state.violation = HUGE_VAL;
    return state;
  }
  const double worst = std::min(*std::min_element(state.force.begin(), state.force.end()), gap.minCoeff());
  state.violation = std::max(0.0, -worst / load.force);
  state.converged = state.violation <= sign_tolerance(mesh, load, active);
  return state;
}

std::vector<char> load_path(const Mesh& mesh, const Load& load) {
  // Forces are fractions of the load, gaps are in its unit, and the tilt is the rise over the whole support.
  using Eigen::Index;
  const auto n = static_cast<Index>(mesh.size());
  const double from = mesh.edges().front(), to = mesh.edges().back();
  std::vector<double> psi(mesh.size());
  Eigen::MatrixXd influence(n, n);
  Eigen::VectorXd heights(n);
  std::optional<variational::Levers> levers;
  if (load.at) levers = {Eigen::VectorXd(n), Eigen::VectorXd(n), to - from};
  for (Index j = 0; j < n; ++j) {
    const auto cell = static_cast<std::size_t>(j);
    psi[cell] = mesh.profile(cell) + variational::slight_curve(mesh.point(cell), from, to, 1e-8 * load.force);
    influence.col(j) = mesh.column(cell);
    heights(j) = psi[cell] / load.force;
    if (!levers) continue;
    levers->arm(j) = mesh.centre(cell) - *load.at;
    levers->point(j) = mesh.point(cell);
  }
  const std::vector<std::size_t> first = first_contact(mesh, load, psi);
  const variational::PivotPath path =
      variational::load_path(influence, heights, first, levers, 20 * static_cast<int>(n) + 100);
  return path.reached ? path.contact : std::vector<char>();
}

}  // namespace coarse

namespace {

using namespace coarse;

/// Returns the equilibrium by the primal-dual active-set method from a first guess, which may be empty. If the sets
/// cycle, it uses load_path().
Equilibrium equilibrium(const Mesh& mesh, const Load& load, std::vector<char> guess) {
  if (guess.empty()) guess.assign(mesh.size(), 1);
  Equilibrium best;
  best.violation = HUGE_VAL;
  std::set<std::vector<char>> seen;
  const auto settle = [&](std::vector<char> active) {
    for (int round = 0; round < most_rounds && seen.insert(active).second; ++round) {
      Equilibrium state = with_contact_on(mesh, load, active);
      if (state.violation < best.violation || best.active.empty()) best = state;
      if (state.converged || !std::isfinite(state.violation)) return;
      active = corrected(mesh, state, load);
    }
  };
  settle(std::move(guess));
  if (best.converged) return best;
  if (std::vector<char> reached = load_path(mesh, load); !reached.empty()) {
    seen.clear();
    settle(std::move(reached));
  }
  return best;
}

/// Cells [first, last[ in contact, divided at steps of the profile: a face that stands back is not in contact at the
/// step.
struct Run {
  std::size_t first;
  std::size_t last;
};

// Cell lengths as fractions of a run's width: inside it, at its ends, at places where a separation may be hidden
// (edges, wedges, jumps), and beyond its ends.
constexpr double inside = 1.0 / 8;
constexpr double at_end = 1.0 / 32;
constexpr double at_cut = 1.0 / 128;
constexpr double beyond_end = 1.0 / 16;
constexpr double between_runs = 1.0 / 3;
/// The number of pieces of a cell whose length has no limit. No cell is divided into more than `most_pieces`.
constexpr int by_default = 3;
constexpr int most_pieces = 8;
constexpr double steepest_grading = 4.5;
/// A face that stands back at a step is free next to it. The length of this free part may be as small as this fraction
/// of its contact.
constexpr double least_shadow = 1e-8;
/// Gaps below this fraction of the contact beside them are artefacts of the mesh.
constexpr double least_gap = 1e-3;

/// True if there could be contact inside cell i although its point is free. Beside the contact u is concave: the chord
/// through the point and the next one on one side, extended, lies above u on the other side.
bool may_hide_contact(const Mesh& mesh, const Equilibrium& state, std::size_t i) {
  const double x = mesh.point(i);
  const auto lowered = [&](std::size_t k) {
    return mesh.profile(k) + state.tilt * mesh.point(k) - state.gap[k];  // u + C
  };
  const double here = lowered(i);
  const double left_slope = i > 0 ? (here - lowered(i - 1)) / (x - mesh.point(i - 1)) : 0;
  const double right_slope = i + 1 < mesh.size() ? (lowered(i + 1) - here) / (mesh.point(i + 1) - x) : 0;
  const SupportPiece& piece = mesh.piece(i);
  const std::size_t samples = piece.profile.size() + 3;
  for (std::size_t k = 0; k <= samples; ++k) {
    const double y = mesh.left(i) + mesh.length(i) * static_cast<double>(k) / static_cast<double>(samples);
    const double slope = y < x ? right_slope : left_slope;
    if (piece.profile_at(y) + state.tilt * y < here + slope * (y - x)) return true;
  }
  return false;
}

/// Returns the runs of contact. Gaps that the mesh does not resolve count as contact: a long last cell beside short
/// free ones can cause one.
std::vector<Run> runs(const Mesh& mesh, const std::vector<char>& active) {
  std::vector<Run> result;
  const auto unresolved = [&](const Run& run, std::size_t next) {
    const double between = mesh.left(next) - mesh.edges()[run.last];
    const double width = mesh.edges()[run.last] - mesh.edges()[run.first];
    for (std::size_t i = run.last; i <= next; ++i) {
      if (mesh.step_before(i) != 0) return false;
    }
    return between < 0.75 * std::max(mesh.length(run.last - 1), mesh.length(next)) || between < least_gap * width;
  };
  for (std::size_t i = 0; i < active.size(); ++i) {
    if (!active[i]) continue;
    if (!result.empty() && unresolved(result.back(), i)) {
      result.back().last = i + 1;
    } else {
      result.push_back({i, i + 1});
    }
  }
  return result;
}

/// Returns the number of pieces into which each cell should be divided; all 1 if the mesh is fine enough.
std::vector<int> wanted_pieces(const Mesh& mesh, const Equilibrium& state) {
  std::vector<int> pieces(mesh.size(), 1);
  // Cells shorter than the rounding of coordinates would have no own points.
  const double least = 1e-13 * std::max(std::abs(mesh.edges().front()), std::abs(mesh.edges().back()));
  const auto into = [&](std::size_t cell, int wanted) {
    if (mesh.length(cell) > least * most_pieces) pieces[cell] = std::max(pieces[cell], wanted);
  };
  const auto at_most = [&](std::size_t cell, double length) {
    const double wanted = std::ceil(mesh.length(cell) / length * (1 - 1e-6));
    into(cell, wanted < most_pieces ? static_cast<int>(wanted) : most_pieces);
  };
  const std::vector<Run> all = runs(mesh, state.active);
  for (std::size_t r = 0; r < all.size(); ++r) {
    const auto [first, last] = all[r];
    const double width = mesh.edges()[last] - mesh.edges()[first];
    for (std::size_t i = first; i < last; ++i) {
      at_most(i, width * (mesh.beside_cut(i) ? at_cut : inside));
    }
    for (std::size_t k = 0; k < std::min<std::size_t>(2, last - first); ++k) {
      at_most(first + k, width * at_end);
      at_most(last - 1 - k, width * at_end);
    }
    for (std::size_t k = 1; k <= 2; ++k) {
      if (first >= k && !state.active[first - k]) at_most(first - k, width * beyond_end);
      if (last - 1 + k < mesh.size() && !state.active[last - 1 + k]) at_most(last - 1 + k, width * beyond_end);
    }
    const auto seek_shadow = [&](std::size_t receding, std::size_t protruding) {
      if (mesh.length(receding) < least_shadow * width) return;
      into(receding, most_pieces);
      if (mesh.length(protruding) > mesh.length(receding) / most_pieces) into(protruding, most_pieces);
    };
    if (mesh.step_before(first) > 0) seek_shadow(first, first - 1);
    if (last < mesh.size() && mesh.step_before(last) < 0) seek_shadow(last - 1, last);
    if (r > 0) {
      const double between = mesh.edges()[first] - mesh.edges()[all[r - 1].last];
      for (std::size_t i = all[r - 1].last; i < first; ++i) at_most(i, between * between_runs);
    }
  }
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    // A long cell at the end of contact beside short free ones would show false contact.
    const auto too_long_beside = [&](std::size_t k) {
      return mesh.length(i) > steepest_grading * mesh.length(k) && (state.active[i] || state.active[k]);
    };
    const bool beside_shorter = (i > 0 && too_long_beside(i - 1)) || (i + 1 < mesh.size() && too_long_beside(i + 1));
    // Next to a contact, the width of that contact already limits the length of a cell.
    const bool beside_contact = (i > 0 && state.active[i - 1]) || (i + 1 < mesh.size() && state.active[i + 1]);
    const bool apart = !state.active[i] && !beside_contact;
    if (beside_shorter || (apart && may_hide_contact(mesh, state, i))) into(i, by_default);
  }
  return pieces;
}

constexpr int most_growth = 16;
constexpr int most_meshes = 40;

/// Returns the distance of a free end of contact from the inner edge of the outermost cell. The traction is
/// proportional to d^power, so the force within d is proportional to d^{1+power}. The end is at most halfway into the
/// next cell.
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

/// A uniform force on a cell has its centre at the cell's centre. So the load must lie between the outermost centres.
Mesh around_load(const Mesh& mesh, double at) {
  std::vector<int> pieces(mesh.size(), 1);
  const auto parts = [](double length, double distance) {
    return static_cast<int>(std::min(length / distance + 1, 1e3));
  };
  if (at <= mesh.centre(0)) pieces.front() = parts(mesh.length(0), at - mesh.left(0));
  const std::size_t last = mesh.size() - 1;
  if (at >= mesh.centre(last)) pieces.back() = parts(mesh.length(last), mesh.right(last) - at);
  return mesh.refined(pieces);
}

CoarseContact contact_around(const Rational& origin, const ContactProblem& problem, int cells) {
  CoarseContact result;
  result.origin = origin;
  Load load{to_real<double>(problem.load()), std::nullopt};
  if (problem.load_at()) load.at = to_real<double>(Rational(*problem.load_at() - result.origin));

  Mesh mesh(problem, result.origin, cells);
  if (load.at) mesh = around_load(mesh, *load.at);
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

}  // namespace

CoarseContact coarse_contact(const ContactProblem& problem, int cells) {
  const Rational &left = problem.indenter().left(), &right = problem.indenter().right();
  CoarseContact found = contact_around((left + right) / 2, problem, cells);
  if (found.zones.empty()) return found;
  // Far from the origin, a polynomial in double is less accurate. A narrow contact has its own origin.
  const double from = found.zones.front().left, to = found.zones.back().right;
  if (to - from > 0.01 * to_real<double>(right - left)) return found;
  return contact_around(found.origin + Rational((from + to) / 2), problem, cells);
}

}  // namespace steadyslide::numeric
