#include "numeric/coarse/coarse_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "numeric/coarse/coarse_equilibrium.hpp"
#include "numeric/number/real.hpp"

namespace steadyslide::numeric::coarse {
namespace {

std::vector<SupportPiece> pieces_of(const ContactProblem& problem, const Rational& origin) {
  const std::vector<Indenter::Break> breaks = problem.indenter().breaks();
  const Polynomial per_compliance = Polynomial::constant(1 / problem.elasticity().compliance());
  std::vector<SupportPiece> pieces;
  std::vector<double> profile;
  std::size_t next = 0;
  for (const ContactProblem::Piece& piece : problem.pieces()) {
    int step = 0;
    if (piece.profile == next) {
      if (next > 0) step = sign(breaks[next - 1].step);
      profile = coefficients_of<double>(per_compliance * problem.indenter().pieces()[next].profile.composed(1, origin));
      ++next;
    }
    const double s = to_real<double>(problem.coupled_friction(piece.friction));
    const double turn = std::atan2(1, std::abs(s)) / std::numbers::pi;
    const double from = to_real<double>(Rational(piece.left - origin));
    const double to = to_real<double>(Rational(piece.right - origin));
    // Cuts that double cannot tell apart have no cell between them.
    if (from >= to) continue;
    pieces.push_back({from, to, s, s < 0 ? turn : 1 - turn, s < 0 ? 1 - turn : turn, profile, step});
  }
  return pieces;
}

/// int log|y| dy.
double log_integral(double y) { return y == 0 ? 0 : y * (std::log(std::abs(y)) - 1); }

}  // namespace

Mesh::Mesh(const ContactProblem& problem, const Rational& origin, int cells)
    : pieces_(pieces_of(problem, origin)), edges_{pieces_.front().left} {
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

const double* Mesh::column(std::size_t j) const {
  columns_.resize(size());
  if (!columns_[j].empty()) return columns_[j].data();
  const SupportPiece& piece = this->piece(j);
  for (std::size_t i = 0; i < size(); ++i) {
    const double distance = centre(j) - point(i);
    double mean;
    if (i == j) {
      mean = (log_integral(piece.behind * length(j)) + log_integral(piece.ahead * length(j))) / length(j);
    } else if (std::abs(distance) > 6 * length(j)) {
      const double r = length(j) * length(j) / (distance * distance);
      mean = std::log(std::abs(distance)) - r / 24 - r * r / 320;
    } else {
      mean = (log_integral(right(j) - point(i)) - log_integral(left(j) - point(i))) / length(j);
    }
    columns_[j].push_back(-mean / std::numbers::pi + (j < i ? piece.s : j == i ? piece.s * piece.ahead : 0));
  }
  return columns_[j].data();
}

int Mesh::step_before(std::size_t i) const { return i > 0 && piece_of_[i] != piece_of_[i - 1] ? piece(i).step : 0; }

// Where the cells of a coarse solution are too long.

namespace {

// Parts of a run's width: cells inside it, at its ends, where separation may hide (edges, wedges, jumps), beyond ends.
constexpr double inside = 1.0 / 8;
constexpr double at_end = 1.0 / 32;
constexpr double at_cut = 1.0 / 128;
constexpr double beyond_end = 1.0 / 16;
constexpr double between_runs = 1.0 / 3;
/// Where nothing says how long a cell should be, it is cut into this many; and never into more than `most_pieces`.
constexpr int by_default = 3;
constexpr int most_pieces = 8;
constexpr double steepest_grading = 4.5;
/// A face that stands back at a step is free next to it, over a length that may be as small a part of its contact.
constexpr double least_shadow = 1e-8;
/// Gaps that are a smaller part of the contact beside them are the mesh's.
constexpr double least_gap = 1e-3;

class Wishes {
 public:
  explicit Wishes(const Mesh& mesh) : mesh_(mesh), pieces_(mesh.size(), 1) {}

  void at_most(std::size_t cell, double length) {
    const double wanted = std::ceil(mesh_.length(cell) / length * (1 - 1e-6));
    into(cell, wanted < most_pieces ? static_cast<int>(wanted) : most_pieces);
  }
  void into(std::size_t cell, int pieces) {
    // Shorter cells than rounding of coordinates allows would have no points of their own.
    const double least = 1e-13 * std::max(std::abs(mesh_.edges().front()), std::abs(mesh_.edges().back()));
    if (mesh_.length(cell) > least * most_pieces) pieces_[cell] = std::max(pieces_[cell], pieces);
  }
  std::vector<int> take() { return std::move(pieces_); }

 private:
  const Mesh& mesh_;
  std::vector<int> pieces_;
};

/// Could there be contact within cell i although its point is free? Beside the contact u is concave: the chord through
/// the point and the next one on one side, prolonged, lies above u on the other side.
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

}  // namespace

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

std::vector<int> wanted_pieces(const Mesh& mesh, const Equilibrium& state) {
  Wishes wishes(mesh);
  const std::vector<Run> all = runs(mesh, state.active);
  for (std::size_t r = 0; r < all.size(); ++r) {
    const auto [first, last] = all[r];
    const double width = mesh.edges()[last] - mesh.edges()[first];
    for (std::size_t i = first; i < last; ++i) {
      wishes.at_most(i, width * (mesh.beside_cut(i) ? at_cut : inside));
    }
    for (std::size_t k = 0; k < std::min<std::size_t>(2, last - first); ++k) {
      wishes.at_most(first + k, width * at_end);
      wishes.at_most(last - 1 - k, width * at_end);
    }
    for (std::size_t k = 1; k <= 2; ++k) {
      if (first >= k && !state.active[first - k]) wishes.at_most(first - k, width * beyond_end);
      if (last - 1 + k < mesh.size() && !state.active[last - 1 + k]) wishes.at_most(last - 1 + k, width * beyond_end);
    }
    const auto seek_shadow = [&](std::size_t back, std::size_t front) {
      if (mesh.length(back) < least_shadow * width) return;
      wishes.into(back, most_pieces);
      if (mesh.length(front) > mesh.length(back) / most_pieces) wishes.into(front, most_pieces);
    };
    if (mesh.step_before(first) > 0) seek_shadow(first, first - 1);
    if (last < mesh.size() && mesh.step_before(last) < 0) seek_shadow(last - 1, last);
    if (r > 0) {
      const double between = mesh.edges()[first] - mesh.edges()[all[r - 1].last];
      for (std::size_t i = all[r - 1].last; i < first; ++i) wishes.at_most(i, between * between_runs);
    }
  }
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    // A long cell at the end of contact beside short free ones would show contact where there is none.
    const auto too_long_beside = [&](std::size_t k) {
      return mesh.length(i) > steepest_grading * mesh.length(k) && (state.active[i] || state.active[k]);
    };
    const bool beside_shorter = (i > 0 && too_long_beside(i - 1)) || (i + 1 < mesh.size() && too_long_beside(i + 1));
    // Next to a contact, the width of that contact has already said how long a cell may be.
    const bool beside_contact = (i > 0 && state.active[i - 1]) || (i + 1 < mesh.size() && state.active[i + 1]);
    const bool apart = !state.active[i] && !beside_contact;
    if (beside_shorter || (apart && may_hide_contact(mesh, state, i))) wishes.into(i, by_default);
  }
  return wishes.take();
}

}  // namespace steadyslide::numeric::coarse
