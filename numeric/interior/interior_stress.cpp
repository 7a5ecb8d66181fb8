#include "numeric/interior/interior_stress.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "numeric/interior/half_plane_stress.hpp"
#include "numeric/quadrature/double_exponential_rule.hpp"

namespace steadyslide::numeric {

template <Real R>
int InteriorStress<R>::nodes_per_panel() const {
  // As for the panels of the form (a pole at the distance of a panel's length, also above it); more nodes because the
  // pole is a double one here.
  using std::log, std::sqrt;
  static const int geometric = static_cast<int>(-log(epsilon<R>()) / (2 * log(2 + sqrt(R(3))))) + 4;
  return geometric + (solution_->problem().highest_degree() + 1) / 2;
}

template <Real R>
Surroundings<R> InteriorStress<R>::surroundings(const OneSidedPart& part, const R& depth) const {
  using std::sqrt;
  const auto to_point = [&](const R& x) { return sqrt(x * x + depth * depth); };
  const RiemannHilbertForm<R>& form = solution_->form();
  Surroundings<R> around = numeric::surroundings<R>(
      form.set(), part.segment, [&](std::size_t j) { return form.power(j).value != 0 || form.changes_polynomial(j); });
  if (part.from_left > 0) {
    around.left_singular = false;
    around.beyond_left = part.from_left;
  }
  if (part.from_right > 0) {
    around.right_singular = false;
    around.beyond_right = part.from_right;
  }
  if (part.x_left <= 0) around.beyond_left = std::min(around.beyond_left, to_point(part.x_left));
  if (part.x_right >= 0) around.beyond_right = std::min(around.beyond_right, to_point(part.x_right));
  return around;
}

template <Real R>
const JacobiRule<R>& InteriorStress<R>::double_exponential(const Power<R>& power) const {
  const auto found = double_exponential_rules_.find(power.plus_one);
  if (found != double_exponential_rules_.end()) return found->second;
  return double_exponential_rules_.emplace(power.plus_one, double_exponential_rule(power.plus_one)).first->second;
}

template <Real R>
void InteriorStress<R>::add_force(const Estimate<R>& force, const R& ratio, const R& x, Sum& sum) const {
  using std::abs;
  StressState<R>& stress = sum.stress;
  const StressComponents<R> value = stress_of_force(force.value, ratio * force.value, x, sum.depth);
  stress.xx.value += value.xx;
  stress.zz.value += value.zz;
  stress.xz.value += value.xz;
  // As if the two forces' fields had the same sign: where they cancel, rounding does not.
  const R away = x < 0 ? -x : x;
  const StressComponents<R> error = stress_of_force(force.error, -abs(ratio) * force.error, away, sum.depth);
  stress.xx.error += error.xx;
  stress.zz.error += error.zz;
  stress.xz.error += error.xz;
}

template <Real R>
void InteriorStress<R>::add(const OneSidedPart& part, Sum& sum) const {
  using std::abs, std::pow;
  const RiemannHilbertForm<R>& form = solution_->form();
  const std::size_t segment = part.segment;
  const R ratio = solution_->shear_ratio(segment);
  for (const GradedPanel<R>& panel : graded_panels(part.length, surroundings(part, sum.depth))) {
    Power<R> power{R(0), R(1)};
    bool kinked = false;
    if (panel.singular_end) {
      const std::size_t j = *panel.singular_end == Side::left ? segment : segment + 1;
      power = form.power(j);
      kinked = form.changes_polynomial(j);
    }
    const JacobiRule<R>& rule = kinked ? double_exponential(power) : rules_.get(power, {R(0), R(1)}, nodes_per_panel());
    const bool mirrored = panel.singular_end == Side::right;
    for (std::size_t i = 0; i < rule.size(); ++i) {
      const R left = panel.from_left + panel.length * (mirrored ? rule.from_right[i] : rule.from_left[i]);
      const R right = panel.from_right + panel.length * (mirrored ? rule.from_left[i] : rule.from_right[i]);
      // From the end of the part from which less is lost: from x itself if it ends there.
      const bool by_left = abs(part.x_left) + left < abs(part.x_right) + right;
      const R x = by_left ? part.x_left - left : part.x_right + right;
      R weight = panel.length * rule.weights[i];
      if (!kinked && power.value != 0) weight /= pow(rule.from_left[i], power.value);
      const SurfacePoint<R> at = surface_point(form.set(), segment, part.from_left + left, part.from_right + right);
      const Estimate<R> t = form.traction(at);
      // The place of x among the free ends is as uncertain as they are: twice their error.
      const R relative = 16 * epsilon<R>() + 2 * solution_->relative_end_error(at);
      R error = weight * (t.error + relative * abs(t.value));
      if (kinked && i == 0) {
        // What lies between the end and the first node.
        const R missing = abs(t.value) * panel.length * rule.from_left[i] / std::min(R(1), power.plus_one);
        error += missing;
      }
      add_force({weight * t.value, error}, ratio, x, sum);
    }
  }
}

template <Real R>
StressState<R> InteriorStress<R>::at(const Rational& x, const Rational& z) const {
  using std::abs, std::sqrt;
  if (z <= 0) throw std::invalid_argument("the depth of a point below the surface is positive");
  const RiemannHilbertForm<R>& form = solution_->form();
  const ContactSet<R>& set = form.set();
  const SurfacePoint<R> above = solution_->locate(x);
  Sum sum{{}, to_real<R>(z / solution_->problem().frame().unit)};
  for (std::size_t k = 0; k < set.segments(); ++k) {
    if (!set.in_contact(k)) continue;
    const R& left = above.node.from_left;
    const R& right = above.node.from_right;
    if (static_cast<std::ptrdiff_t>(k) == above.segment && left > 0 && right > 0) {
      add({k, R(0), left, right, left, R(0)}, sum);
      add({k, left, right, R(0), R(0), -right}, sum);
    } else {
      add({k, R(0), set.length(k), R(0), form.distance(above, k), form.distance(above, k + 1)}, sum);
    }
  }
  StressState<R>& stress = sum.stress;
  const R scale = sqrt(epsilon<R>()) * (abs(stress.xx.value) + abs(stress.zz.value) + abs(stress.xz.value));
  for (Estimate<R>* part : {&stress.xx, &stress.zz, &stress.xz}) {
    if (!(part->error <= scale)) part->convergence = Convergence::stalled;
  }
  const Elasticity& elasticity = solution_->problem().problem().elasticity();
  if (elasticity.half_space()) {
    const R nu = elasticity.plane() == Plane::strain ? to_real<R>(elasticity.half_space()->poisson()) : R(0);
    stress.yy = nu * (stress.xx + stress.zz);
  }
  return stress;
}

template class InteriorStress<double>;
template class InteriorStress<Real50>;
template class InteriorStress<Real100>;

}  // namespace steadyslide::numeric
