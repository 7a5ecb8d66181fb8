#include "numeric/interior/body_sums.hpp"

#include <algorithm>

namespace steadyslide::numeric {
namespace {

/// Fewer panels than this are summed one by one.
constexpr std::size_t fewest_panels_with_moments = 8;

/// Adds the sums of a panel's normal forces, whose sum is `force`, and the tangential sums that follow from them.
template <class Kernel, Real R>
void add_sums(const std::array<R, 4>& sums, const R& force, const TractionPanel<R>& panel, bool straddles,
              ForceSums<R>& to) {
  const std::array<R, 4> sizes = Kernel::sizes(sums, force, straddles);
  for (std::size_t j = 0; j < 4; ++j) {
    to.normal[j] += sums[j];
    to.tangential[j] += panel.shear_ratio * sums[j];
    const R error = (panel.error + 4 * epsilon<R>()) * sizes[j];
    to.normal_error[j] += error;
    to.tangential_error[j] += abs(panel.shear_ratio) * error;
  }
}

}  // namespace

template <Real R, class Kernel>
BodySums<R, Kernel>::BodySums(PiecewiseTraction<R> traction, const R& unit)
    : traction_(std::move(traction)), per_unit_(1 / unit) {
  TractionNodes<R> nodes;
  for (const TractionPanel<R>& panel : traction_.panels()) {
    first_force_.push_back(forces_.size());
    if (panel.count == 1) continue;
    nodes.clear();
    traction_.append_nodes(panel, nodes);
    forces_.insert(forces_.end(), nodes.forces.begin(), nodes.forces.end());
  }
  if (!traction_.panels().empty()) gather(0, traction_.panels().size());
}

template <Real R, class Kernel>
std::pair<const R*, R> BodySums<R, Kernel>::forces_on(std::size_t k) const {
  const TractionPanel<R>& panel = traction_.panels()[k];
  if (panel.count > 1) return {forces_.data() + first_force_[k], R(1)};
  return {panel.rule->weights.data(), traction_.constant(panel) * panel.length};
}

template <Real R, class Kernel>
void BodySums<R, Kernel>::add_panel_moments(std::size_t k, const Cell& cell, R* normal, R* tangential) const {
  const TractionPanel<R>& panel = traction_.panels()[k];
  const auto [forces, factor] = forces_on(k);
  const R left = panel.left - cell.centre;
  for (std::size_t i = 0; i < traction_.nodes_per_rule(); ++i) {
    const R u = (left + panel.length * from_left(panel, i)) / cell.half;
    R term = factor * forces[i];
    for (std::size_t m = 0; m < moment_count<R>(); ++m) {
      normal[m] += term;
      tangential[m] += panel.shear_ratio * term;
      term *= u;
    }
  }
}

template <Real R, class Kernel>
void BodySums<R, Kernel>::gather(std::size_t first, std::size_t end) {
  const auto& panels = traction_.panels();
  const std::size_t index = cells_.size();
  // Beside a short gap, panels can be shorter than the digits of their places show.
  R length = 0;
  for (std::size_t k = first; k < end; ++k) length += panels[k].length;
  const R half = std::max(R(panels[end - 1].right - panels[first].left), length) / 2;
  cells_.push_back({first, end, panels[first].left.moved(half), half, 0, moments_.size(), R(0), R(0)});
  if (end - first < fewest_panels_with_moments) return;
  const std::size_t count = moment_count<R>();
  moments_.resize(moments_.size() + 2 * count);
  const bool has_children = end - first >= 2 * fewest_panels_with_moments;
  if (has_children) {
    const std::size_t middle = first + (end - first) / 2;
    gather(first, middle);
    cells_[index].children = cells_.size();
    gather(middle, end);
  }
  Cell& cell = cells_[index];
  R* normal = moments_.data() + cell.moments;
  for (std::size_t k = first; k < end && !has_children; ++k) {
    add_panel_moments(k, cell, normal, normal + count);
    const auto [forces, factor] = forces_on(k);
    R size = 0;
    for (std::size_t i = 0; i < traction_.nodes_per_rule(); ++i) size += abs(factor * forces[i]);
    cell.normal_error += panels[k].error * size;
    cell.tangential_error += abs(panels[k].shear_ratio) * panels[k].error * size;
  }
  for (const std::size_t child : {index + 1, cell.children}) {
    if (!has_children) break;
    const Cell& part = cells_[child];
    const R scale = part.half / half;
    const R shift = (part.centre - cell.centre) / half;
    const R* moments = moments_.data() + part.moments;
    add_moments<R>(moments, scale, shift, normal);
    add_moments<R>(moments + count, scale, shift, normal + count);
    cell.normal_error += part.normal_error;
    cell.tangential_error += part.tangential_error;
  }
}

/// Returns the position of node i of a panel's rule, as a fraction of the panel.
template <Real R, class Kernel>
const R& BodySums<R, Kernel>::from_left(const TractionPanel<R>& panel, std::size_t i) {
  return panel.singular_end == Side::right ? panel.rule->from_right[i] : panel.rule->from_left[i];
}

template <Real R, class Kernel>
void BodySums<R, Kernel>::add(std::size_t index, const BodyPoint& point, Sums& sums) const {
  const Cell& cell = cells_[index];
  if (cell.end - cell.first >= fewest_panels_with_moments) {
    const R x = point.x - cell.centre;
    if (x * x + point.z * point.z >= 9 * cell.half * cell.half) {
      const R* normal = moments_.data() + cell.moments;
      const R z = point.z * per_unit_;
      Kernel::add_far(sums, normal, normal + moment_count<R>(), R(cell.half * per_unit_), R(x * per_unit_), z);
      // The largest horizontal distance in the cell.
      const R aside = std::max(R(abs(x)), cell.half) * per_unit_;
      std::array<R, 4> unit{};
      Kernel::add_force(unit, R(3), aside, z);
      const std::array<R, 4> sizes = Kernel::sizes(unit, R(3), false);
      for (std::size_t j = 0; j < 4; ++j) {
        sums.normal_error[j] += cell.normal_error * sizes[j];
        sums.tangential_error[j] += cell.tangential_error * sizes[j];
      }
      return;
    }
  }
  if (cell.children != 0) {
    add(index + 1, point, sums);
    add(cell.children, point, sums);
    return;
  }
  for (std::size_t k = cell.first; k < cell.end; ++k) add_panel(k, point, sums);
}

template <Real R, class Kernel>
void BodySums<R, Kernel>::add_panel(std::size_t k, const BodyPoint& point, Sums& sums) const {
  const TractionPanel<R>& panel = traction_.panels()[k];
  const R x_left = point.x - panel.left;
  const R x_right = point.x - panel.right;
  const R aside = std::max({R(-x_left), x_right, R(0)});
  if (aside * aside + point.z * point.z < panel.length * panel.length) {
    add_near(panel, x_left, x_right, point.z, sums);
    return;
  }
  const auto [forces, factor] = forces_on(k);
  std::array<R, 4> of_panel{};
  R all = 0;
  for (std::size_t i = 0; i < traction_.nodes_per_rule(); ++i) {
    const R force = factor * forces[i];
    Kernel::add_force(of_panel, force, R((x_left - panel.length * from_left(panel, i)) * per_unit_),
                      R(point.z * per_unit_));
    all += force;
  }
  add_sums<Kernel>(of_panel, all, panel, x_left > 0 && x_right < 0, sums);
}

/// `x_left` is x minus the left end of the part. `reach` is the distance from the panel's singular end to the point.
template <Real R, class Kernel>
void BodySums<R, Kernel>::add_part(const TractionPanel<R>& panel, const PanelPart<R>& part, const R& x_left,
                                   const R& x_right, const R& z, const R& reach, Sums& sums) const {
  sums.nodes.clear();
  traction_.append_nodes(panel, part, sums.nodes);
  std::array<R, 4> of_part{};
  std::array<R, 4> displaced{};
  R all = 0, moved = 0;
  const R least = Kernel::smallest_scale(z, panel.length, panel.power.value);
  // Measure from the nearer end of the part, which is x itself if the part ends there.
  const bool by_left = x_left <= 0;
  for (std::size_t i = 0; i < sums.nodes.forces.size(); ++i) {
    const R &left = sums.nodes.from_left[i], &right = sums.nodes.from_right[i], &force = sums.nodes.forces[i];
    const R x = (by_left ? x_left - left : x_right + right) * per_unit_, depth = z * per_unit_;
    Kernel::add_force(of_part, force, x, depth);
    all += force;
    if (abs(x) + depth <= least * per_unit_) {
      const R error = Kernel::unresolved(force);
      sums.normal_error[1] += error;
      sums.tangential_error[1] += abs(panel.shear_ratio) * error;
    }
    if (panel.end_error == 0) continue;
    const R change = force * panel.displaced(part, left, right, reach);
    Kernel::add_force(displaced, change, x, depth);
    moved += change;
  }
  add_sums<Kernel>(of_part, all, panel, false, sums);
  const std::array<R, 4> sizes = Kernel::sizes(displaced, moved, false);
  for (std::size_t j = 0; j < 4; ++j) {
    sums.normal_error[j] += sizes[j];
    sums.tangential_error[j] += abs(panel.shear_ratio) * sizes[j];
  }
}

template <Real R, class Kernel>
void BodySums<R, Kernel>::add_near(const TractionPanel<R>& panel, const R& x_left, const R& x_right, const R& z,
                                   Sums& sums) const {
  if (panel.count == 1) {
    std::array<R, 4> of_panel{};
    const R &t = traction_.constant(panel), length = panel.length * per_unit_;
    // The difference of the distances is exactly the length.
    const R left = x_left * per_unit_, right = left - length;
    if (Kernel::add_constant(of_panel, R(t / per_unit_), left, right, R(z * per_unit_))) {
      add_sums<Kernel>(of_panel, R(t * panel.length), panel, false, sums);
      return;
    }
  }
  const R least = Kernel::smallest_scale(z, panel.length, panel.power.value);
  const R& from_end = panel.singular_end == Side::right ? x_right : x_left;
  const R reach = sqrt(from_end * from_end + z * z);
  PanelPart<R> whole{R(0), panel.length, R(0)};
  if (x_left > 0 && x_right < 0) {
    const R behind = -x_right;
    add_part(panel, {R(0), x_left, behind, infinity<R>(), least}, x_left, R(0), z, reach, sums);
    add_part(panel, {x_left, behind, R(0), least, infinity<R>()}, R(0), x_right, z, reach, sums);
  } else if (x_left <= 0) {
    whole.beyond_left = std::max(R(sqrt(x_left * x_left + z * z)), least);
    add_part(panel, whole, x_left, x_right, z, reach, sums);
  } else {
    whole.beyond_right = std::max(R(sqrt(x_right * x_right + z * z)), least);
    add_part(panel, whole, x_left, x_right, z, reach, sums);
  }
}

template <Real R, class Kernel>
ForceSums<R> BodySums<R, Kernel>::at(const SurfacePlace<R>& x, const R& z, TractionNodes<R>& nodes) const {
  Sums sums{{}, nodes};
  if (!cells_.empty()) add(0, {x, z}, sums);
  return sums;
}

#define STEADYSLIDE_INSTANTIATE(R)             \
  template class BodySums<R, StressKernel<R>>; \
  template class BodySums<R, PotentialKernel<R>>;
STEADYSLIDE_FOR_EACH_REAL(STEADYSLIDE_INSTANTIATE)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::numeric
