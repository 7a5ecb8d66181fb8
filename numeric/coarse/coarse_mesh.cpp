#include "numeric/coarse/coarse_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "numeric/number/real.hpp"

namespace steadyslide::numeric::coarse {

namespace {

/// p(x + origin)/c, in double at last.
std::vector<double> shifted(const Polynomial& p, const Rational& origin, const Rational& compliance) {
  Polynomial result;
  const Polynomial x({origin, 1});
  for (std::size_t k = p.coefficients().size(); k-- > 0;) {
    result = result * x + Polynomial::constant(p.coefficient(k));
  }
  std::vector<double> coefficients;
  for (const Rational& a : result.coefficients()) coefficients.push_back(to_real<double>(Rational(a / compliance)));
  return coefficients;
}

std::vector<Stretch> stretches_of(const ContactProblem& problem, const Rational& origin) {
  const Indenter& indenter = problem.indenter();
  const std::vector<Rational>& jumps = problem.friction().jumps();
  const std::vector<Indenter::Break> breaks = indenter.breaks();
  std::vector<Stretch> stretches;
  std::size_t friction = 0;
  Rational left = indenter.left();
  for (std::size_t piece = 0; piece < indenter.pieces().size(); ++piece) {
    const Rational& end = indenter.pieces()[piece].to;
    const std::vector<double> profile =
        shifted(indenter.pieces()[piece].profile, origin, problem.elasticity().compliance());
    int step = piece > 0 ? sign(breaks[piece - 1].step) : 0;
    while (left < end) {
      while (friction < jumps.size() && jumps[friction] <= left) ++friction;
      const Rational right = friction < jumps.size() ? std::min(jumps[friction], end) : end;
      const double s = to_real<double>(problem.coupled_friction(friction));
      const double turn = std::atan2(1, std::abs(s)) / std::numbers::pi;
      const double from = to_real<double>(Rational(left - origin));
      const double to = to_real<double>(Rational(right - origin));
      // Cuts that double cannot tell apart have no cell between them.
      if (from < to)
        stretches.push_back({from, to, s, s < 0 ? turn : 1 - turn, s < 0 ? 1 - turn : turn, profile, step});
      step = 0;
      left = right;
    }
  }
  return stretches;
}

}  // namespace

double Stretch::profile_at(double x) const {
  double value = 0;
  for (std::size_t k = profile.size(); k-- > 0;) value = value * x + profile[k];
  return value;
}

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
