#include "numeric/coarse/coarse_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

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

}  // namespace steadyslide::numeric::coarse
