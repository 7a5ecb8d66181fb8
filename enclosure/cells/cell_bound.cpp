#include "enclosure/cells/cell_bound.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "enclosure/cells/load_bounds.hpp"
#include "enclosure/cells/lowest_gap.hpp"

namespace steadyslide::enclosure {
namespace {

/// The rounding of H is far below any gap on cells.
constexpr Bits cell_bits = 128;

CellBound refused(std::string reason) {
  CellBound result;
  result.reason = std::move(reason);
  return result;
}

/// Returns value +/- error, cut to [low, high].
Ball enclosed(const Rational& value, const Ball& error, const Rational& low, const Rational& high) {
  const Ball x = Ball::plus_or_minus(Ball(value, cell_bits), error);
  return Ball::hull(max(x.lower(), Ball(low, cell_bits)).lower(), min(x.upper(), Ball(high, cell_bits)).upper());
}

/// Returns the exact fractions of the load of the cells left of the jumps.
std::vector<Rational> loads_before(const ContactProblem& problem, const CellPressures& pressures) {
  const Rational left = problem.indenter().left();
  const Rational h = (problem.indenter().right() - left) / Rational(pressures.size());
  std::vector<Rational> result{0};
  for (const Rational& c : problem.friction().jumps()) {
    result.push_back(pressures.load_before((c - left) / h) / Rational(pressures.total()));
  }
  result.emplace_back(1);
  return result;
}

void enclose_resultants(const ContactProblem& problem, const CellPressures& pressures, CellBound& bound) {
  const std::vector<Rational> loads = loads_before(problem, pressures);
  const LoadBounds known(problem, pressures, bound.energy);
  bound.reaches = known.reaches();
  const std::vector<Rational>& f = problem.friction().values();
  Rational friction = 0;
  std::vector<Rational> factors(f.size() - 1);
  for (std::size_t k = 0; k < f.size(); ++k) {
    const Rational share = loads[k + 1] - loads[k];
    friction += f[k] * share;
    std::vector<Rational> ends(f.size() - 1);
    if (k > 0) ends[k - 1] = -1;
    if (k + 1 < f.size()) ends[k] = 1;
    bound.load_share.push_back(enclosed(share, known.deviation(ends), 0, 1));
    if (k > 0) factors[k - 1] = f[k - 1] - f[k];
  }
  const auto [least, most] = std::minmax_element(f.begin(), f.end());
  bound.effective_friction = enclosed(friction, known.deviation(factors), *least, *most);
}

}  // namespace

std::string why_energy_bounds_nothing(const ContactProblem& problem) {
  if (problem.load_at()) return "the indenter may tilt, which the estimate does not cover";
  const std::vector<Rational>& jumps = problem.friction().jumps();
  for (std::size_t k = 0; k < jumps.size(); ++k) {
    const Rational left = problem.coupled_friction(k);
    const Rational right = problem.coupled_friction(k + 1);
    if (right < left) return "s = gamma f decreases towards the front at x = " + to_string(jumps[k]);
  }
  for (const Indenter::Break& at : problem.indenter().breaks()) {
    if (at.step != 0) return "the profile has a step at x = " + to_string(at.x) + ", which the estimate excludes";
  }
  return "";
}

CellBound bound_cells(const ContactProblem& problem, std::span<const double> pressures) {
  constexpr std::int64_t of_a_cell = 10'000;
  return bound_cells(problem, pressures,
                     WorkBudget(WorkBudget::usual + of_a_cell * static_cast<std::int64_t>(pressures.size())));
}

CellBound bound_cells(const ContactProblem& problem, std::span<const double> pressures, WorkBudget work) {
  if (const std::string why = why_energy_bounds_nothing(problem); !why.empty()) {
    return refused("the energy bounds no error: " + why);
  }
  std::optional<CellPressures> cells;
  try {
    cells.emplace(pressures);
  } catch (const std::invalid_argument& error) {
    return refused(error.what());
  }
  const Rational h = (problem.indenter().right() - problem.indenter().left()) / Rational(pressures.size());
  double sum = 0;
  for (const double p : pressures) sum += p;
  const auto load = static_cast<double>(Rational(problem.load() / h));
  if (!(std::abs(sum - load) <= 1e-6 * load)) {
    return refused("the pressures carry " + std::to_string(sum / load) + " of the load");
  }

  const CellGap gap(problem, *cells, cell_bits);
  Ball mean(0, cell_bits);
  std::optional<Ball> least, most;
  for (std::size_t i = 0; i < cells->size(); ++i) {
    const std::int64_t weight = cells->weights()[i];
    if (weight == 0) continue;
    const Ball here = gap.mean(i);
    mean += Ball(Rational(weight), cell_bits) * here;
    least = least ? min(*least, here) : here;
    most = most ? max(*most, here) : here;
  }
  mean /= Ball(Rational(cells->total()), cell_bits);
  const LowestGap lowest = lowest_gap(gap, mean, *least, work);
  if (lowest.unfinished) {
    const Rational x = problem.indenter().left() + Rational(*lowest.unfinished) * h;
    return refused("the budget of work is spent before the lowest gap is found; x = " + to_string(x));
  }

  CellBound result;
  result.cells = cells->size();
  // The search for the lowest gap stops at a relative accuracy of 1/256.
  result.energy = ((mean - lowest.bound) * Ball(Rational(257, 256), cell_bits)).upper();
  result.sharpness = max((mean - lowest.somewhere).lower(), Ball(0, cell_bits)).lower();
  result.largest_gap = (*most - lowest.bound).upper();
  if (!result.energy.is_finite()) return refused("the gap could not be enclosed");
  result.proved = true;
  result.weights = cells->weights();
  enclose_resultants(problem, *cells, result);
  return result;
}

}  // namespace steadyslide::enclosure
