// The singular points of the traction of a solution on cells, and their intensities.

#include <algorithm>
#include <cmath>
#include <limits>

#include "numeric/variational/variational_solution.hpp"

namespace steadyslide::numeric {
namespace {

using variational::CellMesh;
using variational::FittedIntensity;
using variational::PlaceIs;

constexpr Estimate<double> unknown{0, std::numeric_limits<double>::infinity()};
/// Places closer to each other than this number of cells are not separated.
constexpr double fewest_between = 12;

/// Returns the fine value. Its error is that of the fit plus the difference from the next coarser mesh.
Estimate<double> known(const Estimate<double>& fine, const Estimate<double>& coarse) {
  const auto is_read = [](const Estimate<double>& fitted) {
    return fitted.convergence == Convergence::reached && std::isfinite(fitted.value) && std::isfinite(fitted.error);
  };
  if (!is_read(fine) || !is_read(coarse)) return unknown;
  return {fine.value, fine.error + std::abs(fine.value - coarse.value)};
}

}  // namespace

VariationalSolution::SingularPlace VariationalSolution::end_place(const Run& run, End end) const {
  const std::size_t cell = end == End::left ? run.begin : run.end - 1;
  const double boundary = end == End::left ? edges_[cell] : edges_[cell + 1];
  const Rational edge =
      mesh().frame().origin + mesh().frame().unit * Rational(end == End::left ? mesh().left(cell) : mesh().right(cell));
  // The friction piece on the contact's side of a place.
  const Side inside = opposite(end);
  const auto make = [&](double x, const Rational& exact, SingularKind kind) {
    const std::size_t piece = problem_.friction().piece(exact, inside);
    const Rational s = problem_.coupled_friction(piece);
    const Exponent exponent = kind == SingularKind::free ? free_exponent(end, s) : edge_exponent(end, s);
    return SingularPlace{x, kind, exponent, {x}, inside, piece, piece, -1, kind != SingularKind::free};
  };
  if (edge == (end == End::left ? problem_.indenter().left() : problem_.indenter().right())) {
    return make(boundary, edge, SingularKind::edge);
  }
  // A step in the cell next to the end, whose protruding side is in contact.
  const auto& pieces = problem_.indenter().pieces();
  const Rational low = mesh().frame().origin + mesh().frame().unit * Rational(mesh().left(cell - (end == End::left)));
  const auto first = std::lower_bound(pieces.begin(), pieces.end() - 1, low,
                                      [](const Indenter::Piece& p, const Rational& x) { return p.to < x; });
  for (auto piece = first; piece + 1 < pieces.end(); ++piece) {
    const double x = unit_ * mesh().place(piece->to);
    if (x > boundary + 1.01 * cell_length()) break;
    const Rational step = (piece + 1)->profile(piece->to) - piece->profile(piece->to);
    if ((end == End::left ? step < 0 : step > 0) && std::abs(x - boundary) <= 1.01 * cell_length()) {
      return make(x, piece->to, SingularKind::step);
    }
  }
  // Exact, because if friction jumps at a cell's edge, rounding would decide the side.
  return make(boundary, edge, SingularKind::free);
}

Indenter::Break VariationalSolution::break_between_periods() const {
  const Indenter& indenter = problem_.indenter();
  const Rational &left = indenter.left(), &right = indenter.right();
  const Polynomial &before = indenter.pieces().back().profile, &behind = indenter.pieces().front().profile;
  return {left, behind(left) - before(right), behind.derivative()(left) - before.derivative()(right)};
}

void VariationalSolution::find_places() {
  const std::vector<ContactProblem::Piece> pieces = problem_.pieces();
  const auto profile = [this](std::size_t k) -> const Polynomial& { return problem_.indenter().pieces()[k].profile; };
  if (fills_period_) {
    const std::size_t last = problem_.friction().jumps().size();
    const Exponent beta = jump_exponent(problem_.coupled_friction(last), problem_.coupled_friction(0));
    const auto kind = inner_kind(beta.sign() != 0, break_between_periods().derivative());
    // Its intensity is not fitted: no cells lie to its left.
    if (kind) {
      places_.push_back({edges_.front(), *kind, std::nullopt, {edges_.front(), 0}, Side::left, last, 0, -1, true});
      if (beta.sign() != 0) places_.back().exponent = beta;
    }
  }
  std::size_t next = 1;
  for (const Run& run : runs_) {
    if (!fills_period_) places_.push_back(end_place(run, End::left));
    // Places where two pieces meet strictly inside the run, with a cell of contact on both sides of the cell that
    // contains them.
    const double from = edges_[run.begin] + cell_length();
    const double to = edges_[run.end] - cell_length();
    for (; next < pieces.size(); ++next) {
      const ContactProblem::Piece& left = pieces[next - 1];
      const ContactProblem::Piece& right = pieces[next];
      const double x = unit_ * mesh().place(right.left);
      if (x > to) break;
      if (x < from) continue;
      const Polynomial slope = (profile(right.profile) - profile(left.profile)).derivative();
      const int derivative = problem_.indenter().break_at(right.left).derivative();
      const Exponent beta =
          jump_exponent(problem_.coupled_friction(left.friction), problem_.coupled_friction(right.friction));
      const SingularKind kind = inner_kind(beta.sign() != 0, derivative).value_or(SingularKind::wedge);
      SingularPlace place{x, kind, std::nullopt, {x}, Side::left, left.friction, right.friction, slope.degree(), true};
      if (beta.sign() != 0) {
        place.exponent = beta;
      } else if (derivative == 0) {
        place.exponent = Exponent(0);  // the traction neither blows up nor vanishes; the polynomial changes
      }
      const bool repeated = !places_.empty() && !places_.back().is_end() && places_.back().x == x;
      // Keep the last break of places that double cannot distinguish.
      if (repeated && place.wedge_degree < 0) continue;
      if (repeated) places_.pop_back();
      places_.push_back(place);
    }
    if (!fills_period_) places_.push_back(end_place(run, End::right));
  }
  for (std::size_t k = 0; k < places_.size(); ++k) {
    if (places_[k].is_end()) ends_.push_back(k);
    if (k > 0) places_[k].surroundings.left = places_[k].x - places_[k - 1].x;
    if (k + 1 < places_.size()) places_[k].surroundings.right = places_[k + 1].x - places_[k].x;
  }
}

void VariationalSolution::find_end_errors() {
  if (runs_.empty()) return;
  const double cell = cell_length();
  if (runs_.size() == 1 && runs_.front().end - runs_.front().begin == 1) {
    // If one cell carries all the load, the place of the ends is unknown.
    for (SingularPlace& place : places_) place.error = place.moved = place.is_end() && !place.exact ? unit_ : 0;
    return;
  }
  const variational::CellSet& coarse = found_.coarse.found.contact;
  // Returns the distance from x to the place where the coarser contact begins, or ends.
  const auto moved = [&](const SingularPlace& end) {
    double least = edges_.back() - edges_.front();
    for (std::size_t i = 0; i < coarse.size(); ++i) {
      const bool begins = end.contact == Side::right;
      const bool beyond = begins ? i > 0 && coarse[i - 1] : i + 1 < coarse.size() && coarse[i + 1];
      if (!coarse[i] || beyond) continue;
      least = std::min(least, std::abs(coarse_edges_[begins ? i : i + 1] - end.x));
    }
    return least;
  };
  // True if all cells between two places, and those beside them, are contact on the coarser mesh.
  const auto closed = [&](double from, double to) {
    const CellMesh& mesh = found_.coarse.problem->mesh();
    const std::size_t last = mesh.cell_at((to + cell) / unit_);
    for (std::size_t i = mesh.cell_at((from - cell) / unit_); i <= last; ++i) {
      if (!coarse[i]) return false;
    }
    return true;
  };
  std::vector<SingularPlace*> ends;
  for (const std::size_t end : ends_) ends.push_back(&places_[end]);
  // If the coarser mesh does not have a gap, its ends have moved by at most the length of the gap.
  std::vector<double> by(ends.size());
  std::vector<char> is_new(ends.size());
  for (std::size_t k = 1; k + 1 < ends.size(); k += 2) is_new[k] = is_new[k + 1] = closed(ends[k]->x, ends[k + 1]->x);
  for (std::size_t k = 0; k < ends.size(); ++k) {
    if (ends[k]->exact) continue;
    if (!is_new[k]) by[k] = moved(*ends[k]);
    ends[k]->moved = cell + std::max(by[k] - cell, 0.0);
  }
  const double elsewhere = moved_load() * (edges_[runs_.back().end] - edges_[runs_.front().begin]);
  for (SingularPlace* end : ends) {
    if (!end->exact) end->error = end->moved + elsewhere;
  }
  for (std::size_t k = 1; k + 1 < ends.size(); k += 2) {
    const double gap = ends[k + 1]->x - ends[k]->x;
    const bool may_be_none =
        is_new[k] || gap <= 4 * cell + 8 * (by[k] + by[k + 1]) || gap <= ends[k]->error + ends[k + 1]->error;
    for (SingularPlace* end : {ends[k], ends[k + 1]}) end->error = std::max(end->error, may_be_none ? gap + cell : 0);
  }
}

FittedIntensity VariationalSolution::fitted(const SingularPlace& place, const variational::Cells& cells) const {
  const auto s = [&](std::size_t piece) { return problem_.coupled_friction(piece); };
  if (place.is_end()) {
    return variational::fitted_end(cells, place.surroundings, place.contact, to_real<double>(*place.exponent),
                                   place.exact ? PlaceIs::exact : PlaceIs::to_one_cell);
  }
  if (!place.exponent) {
    return variational::fitted_wedge(cells, place.surroundings, to_real<double>(s(place.friction_left)),
                                     place.wedge_degree);
  }
  return variational::fitted_jump(cells, place.surroundings, to_real<double>(*place.exponent),
                                  cos_pi_alpha<double>(s(place.friction_left)),
                                  cos_pi_alpha<double>(s(place.friction_right)), place.wedge_degree);
}

SolvedSingularPoint<double> VariationalSolution::solved_point(const SingularPlace& place) const {
  const double error = 1e-15 * (std::abs(origin_) + unit_) + place.error;
  SolvedSingularPoint<double> result{{origin_ + place.x, error}, place.kind, place.exponent, unknown, {}, {}};
  const auto tell_stress_intensity = [&] {
    if (!place.exponent) return;
    const auto on_side = [&](std::size_t piece) {
      const double factor = place.is_end() ? 1 : cos_pi_alpha<double>(problem_.coupled_friction(piece));
      return stress_intensity_of<double>(factor * result.intensity, to_real<double>(*place.exponent));
    };
    if (!place.is_end() || place.contact == Side::left) result.stress_intensity.left = on_side(place.friction_left);
    if (!place.is_end() || place.contact == Side::right) result.stress_intensity.right = on_side(place.friction_right);
  };
  if (!place.is_end() && place.wedge_degree >= 0) result.constant = unknown;
  if (std::min(place.surroundings.left, place.surroundings.right) < fewest_between * cell_length()) {
    tell_stress_intensity();
    return result;
  }
  const FittedIntensity fine = fitted(place, cells());
  const FittedIntensity coarse = fitted(place, coarse_cells());
  result.intensity = known(fine.intensity, coarse.intensity);
  if (!place.is_end() && place.wedge_degree >= 0) result.constant = known(fine.constant, coarse.constant);
  tell_stress_intensity();
  return result;
}

std::optional<SolvedSingularPoint<double>> VariationalSolution::sharpest_wedge() const {
  std::optional<SolvedSingularPoint<double>> sharpest;
  const auto c = to_real<double>(problem_.elasticity().compliance());
  auto run = runs_.begin();
  const auto look = [&](const Indenter::Break& at, std::size_t left, std::size_t right) {
    const Rational s = problem_.coupled_friction(left);
    if (s != problem_.coupled_friction(right)) return;
    const double strength = to_real<double>(at.wedge) / (c * to_real<double>(Rational(1 + s * s)));
    if (sharpest && !(strength > sharpest->intensity.value)) return;
    const double error = 1e-15 * (std::abs(origin_) + unit_), x = origin_ + unit_ * mesh().place(at.x);
    sharpest = {{x, error}, SingularKind::wedge, std::nullopt, {strength, 1e-15 * strength}, {}, {}};
  };
  const auto is_convex = [](const Indenter::Break& at) { return at.step == 0 && at.wedge > 0; };
  if (fills_period_ && is_convex(break_between_periods()))
    look(break_between_periods(), problem_.friction().jumps().size(), 0);
  for (const Indenter::Break& at : problem_.indenter().breaks()) {
    if (!is_convex(at)) continue;
    const double xi = mesh().place(at.x);
    while (run != runs_.end() && mesh().right(run->end - 1) < xi) ++run;
    if (run == runs_.end()) break;
    if (xi < mesh().left(run->begin)) continue;
    look(at, problem_.friction().piece(at.x, Side::left), problem_.friction().piece(at.x, Side::right));
  }
  return sharpest;
}

std::vector<SolvedSingularPoint<double>> VariationalSolution::singular_points() const {
  std::vector<SolvedSingularPoint<double>> result;
  for (const SingularPlace& place : places_) {
    const bool logarithm = local_terms(place.kind).has_logarithm;
    // If only a curvature changes, nothing is singular. A measured profile has a wedge at every point; cells can show a
    // wedge only if it is isolated.
    if (logarithm && place.exponent) continue;
    const auto& around = place.surroundings;
    if (logarithm && std::min(around.left, around.right) < fewest_between * cell_length()) continue;
    result.push_back(solved_point(place));
  }
  return result;
}

std::vector<ContactComponent<double>> VariationalSolution::contact() const {
  if (fills_period_) {
    const Exponent power =
        jump_exponent(problem_.coupled_friction(problem_.friction().jumps().size()), problem_.coupled_friction(0));
    const double error = 1e-15 * (std::abs(origin_) + unit_);
    const auto end = [&](double x, const Estimate<double>& t) {
      return ContactEnd<double>{
          {origin_ + x, error}, SingularKind::friction_jump, power, power.sign() == 0 ? -t : unknown};
    };
    return {{end(edges_.front(), traction(0)), end(edges_.back(), traction(mesh().size() - 1)), {unit_, error}}};
  }
  std::vector<ContactComponent<double>> result;
  std::optional<ContactEnd<double>> left;
  for (const SingularPlace& place : places_) {
    if (!place.is_end()) continue;
    const SolvedSingularPoint<double> point = solved_point(place);
    ContactEnd<double> end{point.x, point.kind, *point.exponent, point.intensity};
    if (place.contact == Side::right) {
      left = std::move(end);
    } else {
      const Estimate<double> width = end.x - left->x;
      result.push_back({std::move(*left), std::move(end), width});
    }
  }
  return result;
}

}  // namespace steadyslide::numeric
