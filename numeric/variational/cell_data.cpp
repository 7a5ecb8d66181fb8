#include "numeric/variational/cell_data.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>

#include "numeric/number/polynomial.hpp"

namespace steadyslide::numeric::variational {
namespace {

/// Returns the distances of the cells' ends from 0 on one side, up to `end`.
std::vector<double> graded_distances(double end, double smallest, double ratio, double largest) {
  std::vector<double> result;
  double distance = 0;
  double length = smallest;
  // The last cell absorbs a remainder of less than half a cell.
  while (distance + 1.5 * length < end) {
    distance += length;
    result.push_back(distance);
    length = std::min(length * ratio, largest);
  }
  result.push_back(end);
  return result;
}

/// One piece of a piecewise function on an interval of the support, in xi.
struct Interval {
  double left;
  double right;
};

/// Calls f(cell, piece, part) for every piece of a subdivision in every cell, from left to right. `ends` are the right
/// ends of all pieces except the last one.
template <class F>
void for_each_part(const CellMesh& mesh, const std::vector<double>& ends, const F& f) {
  std::size_t piece = 0;
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    double left = mesh.left(i);
    while (piece < ends.size() && ends[piece] < mesh.right(i)) {
      if (ends[piece] > left) f(i, piece, Interval{left, ends[piece]});
      left = std::max(left, ends[piece++]);
    }
    f(i, piece, Interval{left, mesh.right(i)});
  }
}

/// Returns the places of the friction jumps, in xi.
std::vector<double> friction_ends(const ContactProblem& problem, const CellMesh& mesh) {
  std::vector<double> ends;
  for (const Rational& c : problem.friction().jumps()) ends.push_back(mesh.place(c));
  return ends;
}

Rational middle_of(const Indenter& indenter) { return (indenter.left() + indenter.right()) / 2; }

Rational height_at(const Indenter& indenter, const Rational& x) { return indenter.profile(x, Side::left)(x); }

}  // namespace

Frame frame_between(const Rational& left, const Rational& right) { return {(left + right) / 2, right - left}; }

Frame support_frame(const ContactProblem& problem) {
  return frame_between(problem.indenter().left(), problem.indenter().right());
}

CellMesh::CellMesh(Frame frame, std::size_t cells)
    : frame_(std::move(frame)), edges_(cells + 1), uniform_(true), length_(1 / static_cast<double>(cells)) {
  for (std::size_t i = 0; i <= cells; ++i) edges_[i] = static_cast<double>(i) / static_cast<double>(cells) - 0.5;
}

CellMesh::CellMesh(const ContactProblem& problem, const Rational& origin, std::vector<double> edges)
    : frame_{origin, support_frame(problem).unit}, edges_(std::move(edges)), uniform_(false) {
  if (edges_.size() < 2 || std::adjacent_find(edges_.begin(), edges_.end(), std::greater_equal<>()) != edges_.end()) {
    throw std::invalid_argument("cell edges do not increase");
  }
}

std::size_t CellMesh::cell_at(double xi) const {
  const auto after = std::upper_bound(edges_.begin() + 1, edges_.end() - 1, xi);
  return static_cast<std::size_t>(after - edges_.begin()) - 1;
}

std::vector<double> graded_edges(double left, double right, double smallest, double ratio, double largest) {
  std::vector<double> edges;
  const std::vector<double> before = graded_distances(-left, smallest, ratio, largest);
  for (auto distance = before.rbegin(); distance != before.rend(); ++distance) edges.push_back(-*distance);
  edges.push_back(0);
  const std::vector<double> after = graded_distances(right, smallest, ratio, largest);
  edges.insert(edges.end(), after.begin(), after.end());
  return edges;
}

CellFriction cell_friction(const ContactProblem& problem, const CellMesh& mesh, FrictionRule rule, double shift) {
  const std::vector<double> ends = friction_ends(problem, mesh);
  std::vector<double> s;
  for (std::size_t k = 0; k <= ends.size(); ++k) s.push_back(to_real<double>(problem.coupled_friction(k)) + shift);

  CellFriction result{std::vector<double>(mesh.size()), std::vector<double>(mesh.size()), 1, {}, shift};
  if (std::any_of(s.begin(), s.end(), [](double value) { return value < 0; })) result.sign = -1;
  if (!problem.body().is_half_plane()) result.signed_friction.resize(mesh.size());
  for_each_part(mesh, ends, [&](std::size_t i, std::size_t piece, const Interval& part) {
    const double length = part.right - part.left;
    const double middle = (part.left + part.right) / 2;
    // s at x' affects all x in the cell on its other side.
    const double reach = result.sign > 0 ? mesh.right(i) - middle : middle - mesh.left(i);
    result.whole[i] += s[piece] * length;
    if (!result.signed_friction.empty())
      result.signed_friction[i] -= to_real<double>(problem.shear_ratio(piece)) * length / mesh.length(i);
    result.own[i] += result.sign * s[piece] * length * reach / mesh.length(i);
  });
  const auto strong = [](double value) { return std::abs(value) > strong_friction; };
  if (rule == FrictionRule::galerkin || std::none_of(s.begin(), s.end(), strong)) return result;
  result.at_end.resize(mesh.size());
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    if (!strong(result.whole[i] / mesh.length(i))) continue;
    result.at_end[i] = 1;
    result.own[i] = std::abs(result.whole[i]);
  }
  return result;
}

std::vector<double> means_of_pieces(const ContactProblem& problem, const CellMesh& mesh,
                                    const std::vector<double>& values) {
  std::vector<double> result(mesh.size());
  for_each_part(mesh, friction_ends(problem, mesh), [&](std::size_t i, std::size_t piece, const Interval& part) {
    result[i] += values[piece] * (part.right - part.left) / mesh.length(i);
  });
  return result;
}

Rational profile_above_middle(const ContactProblem& problem, const Rational& x) {
  return height_at(problem.indenter(), x) - height_at(problem.indenter(), middle_of(problem.indenter()));
}

HarmonicSum harmonic_sum(const ContactProblem& problem, const Rational& x) {
  HarmonicSum sum{0, 0};
  const Indenter& indenter = problem.indenter();
  for (const Harmonic& term : indenter.harmonics()) {
    const Rational turns = term.n * (x - indenter.origin_of_harmonics()) / *problem.body().period();
    const double angle = 2 * std::numbers::pi * to_real<double>(turns);
    const double wave_number = 2 * std::numbers::pi * term.n / to_real<double>(*problem.body().period());
    const auto cosine = to_real<double>(term.cosine), sine = to_real<double>(term.sine);
    sum.height += cosine * std::cos(angle) + sine * std::sin(angle);
    sum.slope += wave_number * (sine * std::cos(angle) - cosine * std::sin(angle));
  }
  return sum;
}

double CellProfile::LocalPiece::operator()(double xi) const { return value_of(coefficients, xi - origin); }

/// Exact, because the rule has enough points for the degree.
double CellProfile::LocalPiece::integral(double left, double right) const {
  const auto by = [&]<unsigned points>() {
    return boost::math::quadrature::gauss<double, points>::integrate(*this, left, right);
  };
  if (coefficients.size() <= 2) return (right - left) * (*this)((left + right) / 2);
  if (coefficients.size() <= 14) return by.template operator()<7>();
  return by.template operator()<40>();
}

CellProfile::LocalPiece CellProfile::local_piece(const Polynomial& profile, const Rational& middle, const Frame& frame,
                                                 const Rational& height, const Rational& scale) {
  const Polynomial local = profile.composed(frame.unit, middle) - Polynomial::constant(height);
  return {to_real<double>((middle - frame.origin) / frame.unit),
          coefficients_of<double>(Polynomial::constant(1 / scale) * local)};
}

CellProfile::CellProfile(const ContactProblem& problem, const Frame& frame) {
  const Indenter& indenter = problem.indenter();
  const Rational scale = problem.elasticity().compliance() * problem.load();
  const Rational height = height_at(indenter, middle_of(indenter));
  Rational left = indenter.left();
  for (const Indenter::Piece& piece : indenter.pieces()) {
    pieces_.push_back(local_piece(piece.profile, (left + piece.to) / 2, frame, height, scale));
    ends_.push_back(to_real<double>((piece.to - frame.origin) / frame.unit));
    left = piece.to;
  }
  ends_.pop_back();
  for (const Harmonic& term : indenter.harmonics()) {
    const auto cosine = to_real<double>(term.cosine / scale), sine = to_real<double>(term.sine / scale);
    const double wave_number = 2 * std::numbers::pi * to_real<double>(term.n * frame.unit / *problem.body().period());
    const auto origin = to_real<double>((indenter.origin_of_harmonics() - frame.origin) / frame.unit);
    waves_.push_back({wave_number, origin + std::atan2(sine, cosine) / wave_number, std::hypot(cosine, sine)});
  }
}

double CellProfile::waves_at(double xi) const {
  double sum = 0;
  for (const Wave& wave : waves_) sum += wave.amplitude * std::cos(wave.wave_number * (xi - wave.crest));
  return sum;
}

double CellProfile::operator()(double xi, Side side) const {
  const auto end = side == Side::left ? std::lower_bound(ends_.begin(), ends_.end(), xi)
                                      : std::upper_bound(ends_.begin(), ends_.end(), xi);
  return pieces_[static_cast<std::size_t>(end - ends_.begin())](xi) + waves_at(xi);
}

std::vector<double> CellProfile::means(const CellMesh& mesh) const {
  std::vector<double> result(mesh.size());
  for_each_part(mesh, ends_, [&](std::size_t i, std::size_t piece, const Interval& part) {
    result[i] += pieces_[piece].integral(part.left, part.right) / mesh.length(i);
  });
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    for (const auto& [wave_number, crest, amplitude] : waves_) {
      const double half = wave_number * mesh.length(i) / 2;
      result[i] += amplitude * std::cos(wave_number * (mesh.centre(i) - crest)) * std::sin(half) / half;
    }
  }
  return result;
}

}  // namespace steadyslide::numeric::variational
