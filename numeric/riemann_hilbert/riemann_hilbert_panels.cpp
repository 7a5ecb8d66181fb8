// The quadrature panels of the Riemann-Hilbert form.

#include <cmath>

#include "numeric/riemann_hilbert/riemann_hilbert_form.hpp"

namespace steadyslide::numeric {

template <Real R>
int RiemannHilbertForm<R>::nodes_per_panel() const {
  // Bernstein's ellipse through a pole at half a panel's length, or a branch point at a whole one, has the parameter
  // 2 + sqrt 3 or more; half a node more for every degree of the polynomial.
  using std::log, std::sqrt;
  static const int geometric = static_cast<int>(-log(epsilon<R>()) / (2 * log(2 + sqrt(R(3))))) + 2;
  return geometric + (problem_->highest_degree() + 1) / 2;
}

template <Real R>
bool RiemannHilbertForm<R>::is_singular(std::size_t j, bool gap) const {
  if (weight_.powers()[j].value != 0) return true;
  // B_k is singular wherever the contact changes its polynomial.
  return gap && j > 0 && j < set_.segments() && (set_.in_contact(j) || set_.in_contact(j - 1));
}

template <Real R>
Surroundings<R> RiemannHilbertForm<R>::surroundings(std::size_t segment, bool gap) const {
  Surroundings<R> result{is_singular(segment, gap), is_singular(segment + 1, gap), infinity<R>(), infinity<R>()};
  R distance = 0;
  for (std::size_t j = segment; j-- > 0;) {
    distance += set_.length(j);
    if (!is_singular(j, gap)) continue;
    result.beyond_left = distance;
    break;
  }
  distance = 0;
  for (std::size_t j = segment + 2; j < set_.points().size(); ++j) {
    distance += set_.length(j - 1);
    if (!is_singular(j, gap)) continue;
    result.beyond_right = distance;
    break;
  }
  return result;
}

template <Real R>
SurfacePoint<R> RiemannHilbertForm<R>::Part::node(const ContactSet<R>& set, std::size_t i) const {
  const bool mirrored = singular_end == Side::right;
  const R left = from_left + length * (mirrored ? rule->from_right[i] : rule->from_left[i]);
  const R right = from_right + length * (mirrored ? rule->from_left[i] : rule->from_right[i]);
  return surface_point(set, segment, left, right);
}

template <Real R>
R RiemannHilbertForm<R>::Part::node_weight(std::size_t i) const {
  using std::pow;
  const R w = length * rule->weights[i];
  return power.value == 0 ? w : R(w / pow(rule->from_left[i], power.value));
}

template <Real R>
std::vector<typename RiemannHilbertForm<R>::Part> RiemannHilbertForm<R>::parts(
    std::size_t segment, const Stretch& stretch, Surroundings<R> around, int nodes,
    const std::function<Power<R>(std::size_t)>& power_of) const {
  if (stretch.from_left > 0) {
    around.beyond_left = around.left_singular ? stretch.from_left : R(stretch.from_left + around.beyond_left);
    around.left_singular = false;
  }
  if (stretch.from_right > 0) {
    around.beyond_right = around.right_singular ? stretch.from_right : R(stretch.from_right + around.beyond_right);
    around.right_singular = false;
  }
  std::vector<Part> result;
  for (const GradedPanel<R>& panel : graded_panels(stretch.length, around)) {
    Power<R> power{R(0), R(1)};
    if (panel.singular_end) power = power_of(*panel.singular_end == Side::left ? segment : segment + 1);
    result.push_back({segment, stretch.from_left + panel.from_left, stretch.from_right + panel.from_right, panel.length,
                      panel.singular_end, power, &rules_->get(power, {R(0), R(1)}, nodes)});
  }
  return result;
}

template <Real R>
void RiemannHilbertForm<R>::make_panels() {
  for (std::size_t segment = 0; segment < set_.segments(); ++segment) {
    first_panel_.push_back(panels_.size());
    if (!set_.in_contact(segment)) continue;
    const R amplitude = sign(static_cast<std::ptrdiff_t>(segment)) * problem_->cos_alpha(friction_at(segment));
    const auto power_of = [this](std::size_t j) {
      const R& p = weight_.powers()[j].value;
      return Power<R>{R(-p), R(1 - p)};
    };
    for (const Part& part : parts(segment, whole(segment), surroundings(segment, false), nodes_per_panel(), power_of)) {
      panels_.push_back({part, nodes_.size()});
      for (std::size_t i = 0; i < part.rule->size(); ++i) {
        nodes_.push_back(part.node(set_, i));
        node_weights_.push_back(amplitude * part.node_weight(i) / modulus(nodes_.back()));
      }
    }
  }
  first_panel_.push_back(panels_.size());
}

template <Real R>
const std::vector<R>& RiemannHilbertForm<R>::density(std::size_t slope) const {
  std::vector<R>& result = densities_[slope];
  if (!result.empty() || nodes_.empty()) return result;
  result.reserve(nodes_.size());
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const std::size_t own = slope_at(static_cast<std::size_t>(nodes_[i].segment));
    const R& x = nodes_[i].node.x;
    result.push_back(own == slope ? R(0) : R(node_weights_[i] * (problem_->slope(own, x) - problem_->slope(slope, x))));
  }
  return result;
}

#define STEADYSLIDE_INSTANTIATE(R)                                                                           \
  template int RiemannHilbertForm<R>::nodes_per_panel() const;                                               \
  template bool RiemannHilbertForm<R>::is_singular(std::size_t j, bool gap) const;                           \
  template Surroundings<R> RiemannHilbertForm<R>::surroundings(std::size_t segment, bool gap) const;         \
  template SurfacePoint<R> RiemannHilbertForm<R>::Part::node(const ContactSet<R>& set, std::size_t i) const; \
  template R RiemannHilbertForm<R>::Part::node_weight(std::size_t i) const;                                  \
  template std::vector<typename RiemannHilbertForm<R>::Part> RiemannHilbertForm<R>::parts(                   \
      std::size_t segment, const Stretch& stretch, Surroundings<R> around, int nodes,                        \
      const std::function<Power<R>(std::size_t)>& power_of) const;                                           \
  template void RiemannHilbertForm<R>::make_panels();                                                        \
  template const std::vector<R>& RiemannHilbertForm<R>::density(std::size_t slope) const;
STEADYSLIDE_INSTANTIATE(double)
STEADYSLIDE_INSTANTIATE(Real50)
STEADYSLIDE_INSTANTIATE(Real100)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::numeric
