#include "enclosure/cells/load_bounds.hpp"

#include <cmath>
#include <optional>

namespace steadyslide::enclosure {
namespace {

constexpr Bits load_bits = 64;
constexpr int most_tried = 200;

Ball agm_with_one(const Ball& x) { return made_by(arb_agm, load_bits, Ball(1).get(), x.get(), load_bits); }

}  // namespace

LoadBounds::LoadBounds(const ContactProblem& problem, const CellPressures& pressures, const Ball& energy)
    : energy_(energy.upper().at(load_bits)) {
  const Rational left = problem.indenter().left();
  const Rational h = (problem.indenter().right() - left) / Rational(pressures.size());
  for (std::size_t k = 0; k < problem.friction().jumps().size(); ++k) {
    const Rational c = (problem.friction().jumps()[k] - left) / h;
    rises_.push_back(problem.coupled_friction(k + 1) - problem.coupled_friction(k));
    capacities_.push_back({best(pressures, c, false), best(pressures, c, true)});
  }
}

LoadBounds::Capacity LoadBounds::best(const CellPressures& pressures, const Rational& c, bool right) const {
  const Rational end(pressures.size());
  const Rational total(pressures.total());
  // Distance from c to the support's end in the direction of eps, and to the other end.
  const Rational room = right ? Rational(end - c) : c;
  const Rational behind = right ? c : Rational(end - c);
  const Ball root = sqrt(energy_);
  std::optional<Capacity> result;
  for (int i = 1; i <= most_tried; ++i) {
    const Rational eps = room * Rational(std::pow(0.85, i));  // any value is admissible; it is exact
    const Rational far = right ? Rational(c + eps) : Rational(c - eps);
    const Rational load = abs(pressures.load_before(far) - pressures.load_before(c)) / total;
    const Rational k_squared = eps * end / ((behind + eps) * room);
    const Ball k = sqrt(Ball(k_squared, load_bits));
    const Ball other_k = sqrt(Ball(Rational(1 - k_squared), load_bits));
    Capacity found{eps, Ball(load, load_bits), sqrt(agm_with_one(other_k) / agm_with_one(k))};
    if (!result || found.load + found.root * root < result->load + result->root * root) result = std::move(found);
  }
  return *result;
}

std::vector<std::array<Rational, 2>> LoadBounds::reaches() const {
  std::vector<std::array<Rational, 2>> result;
  for (const auto& [left, right] : capacities_) result.push_back({left.reach, right.reach});
  return result;
}

Ball LoadBounds::deviation(const std::vector<Rational>& a) const {
  Rational sum = 0;
  bool bounded = true;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (a[k] == 0) continue;
    bounded = bounded && rises_[k] > 0;
    if (bounded) sum += a[k] * a[k] / rises_[k];
  }
  const auto by_jumps = [&](const Ball& beta) {
    return sqrt(Ball(2) * (energy_ - beta) * Ball(sum, load_bits)).upper();
  };
  const auto by_capacity = [&](const Ball& beta) {
    Ball bound(0, load_bits);
    for (std::size_t k = 0; k < a.size(); ++k) {
      const auto side = [&](const Capacity& c) { return c.load + c.root * sqrt(beta); };
      bound += Ball(Rational(abs(a[k])), load_bits) * max(side(capacities_[k][0]), side(capacities_[k][1]));
    }
    return bound.upper();
  };
  if (!bounded) return by_capacity(energy_);
  // Finds a value just right of the point where the two bounds are equal.
  Ball low(0, load_bits), beta = energy_;
  for (int i = 0; i < 40; ++i) {
    const Ball middle = ((low + beta) / Ball(2)).midpoint();
    (by_capacity(middle) >= by_jumps(middle) ? beta : low) = middle;
  }
  return min(by_jumps(Ball(0, load_bits)), max(by_jumps(beta), by_capacity(beta))).upper();
}

}  // namespace steadyslide::enclosure
