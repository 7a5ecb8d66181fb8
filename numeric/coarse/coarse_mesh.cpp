#include "numeric/coarse/coarse_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "numeric/number/real.hpp"

namespace steadyslide::numeric::coarse {

namespace {

std::vector<Stretch> stretches_of(const ContactProblem& problem, const Rational& origin) {
  const std::vector<Indenter::Break> breaks = problem.indenter().breaks();
  const Polynomial per_compliance = Polynomial::constant(1 / problem.elasticity().compliance());
  std::vector<Stretch> stretches;
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
    stretches.push_back({from, to, s, s < 0 ? turn : 1 - turn, s < 0 ? 1 - turn : turn, profile, step});
  }
  return stretches;
}

}  // namespace

Mesh::Mesh(const ContactProblem& problem, const Rational& origin, int cells)
    : stretches_(stretches_of(problem, origin)), edges_{stretches_.front().left} {
  const double width = stretches_.back().right - stretches_.front().left;
  const int least = stretches_.size() <= 4 * static_cast<std::size_t>(cells) ? 2 : 1;
  for (std::size_t k = 0; k < stretches_.size(); ++k) {
    const Stretch& stretch = stretches_[k];
    const double length = stretch.right - stretch.left;
    const int count = std::max(least, static_cast<int>(std::lround(cells * length / width)));
    for (int i = 1; i <= count; ++i) {
      edges_.push_back(i < count ? stretch.left + length * i / count : stretch.right);
      stretch_of_.push_back(k);
    }
  }
}

Mesh Mesh::refined(const std::vector<int>& pieces) const {
  Mesh result;
  result.stretches_ = stretches_;
  result.edges_.push_back(edges_.front());
  for (std::size_t i = 0; i < size(); ++i) {
    for (int k = 1; k <= pieces[i]; ++k) {
      result.edges_.push_back(k < pieces[i] ? left(i) + length(i) * k / pieces[i] : right(i));
      result.stretch_of_.push_back(stretch_of_[i]);
    }
  }
  return result;
}

bool Mesh::beside_cut(std::size_t i) const {
  return i == 0 || i + 1 == size() || stretch_of_[i] != stretch_of_[i - 1] || stretch_of_[i] != stretch_of_[i + 1];
}

int Mesh::step_before(std::size_t i) const {
  return i > 0 && stretch_of_[i] != stretch_of_[i - 1] ? stretch(i).step : 0;
}

}  // namespace steadyslide::numeric::coarse
