#include "numeric/interior/interior_stress.hpp"

#include <algorithm>
#include <stdexcept>

namespace steadyslide::numeric {
namespace {

/// Fewer panels than this are summed one by one.
constexpr std::size_t fewest_panels_with_moments = 8;

template <class Depth>
void check_below_surface(const Depth& z) {
  if (!(z > 0)) throw std::invalid_argument("the depth of a point below the surface is positive");
}

/// Adds the sums of a panel's normal forces and the tangential sums that follow from them. `error` is relative.
/// `straddles`: there are forces on both sides of x, at horizontal distances up to the depth, which cancel in the odd
/// sums.
template <Real R>
void add_sums(const std::array<R, 4>& sums, const TractionPanel<R>& panel, const R& error, bool straddles,
              ForceSums<R>& to) {
  const R tangential_error = abs(panel.shear_ratio) * error;
  for (std::size_t j = 0; j < 4; ++j) {
    R size = abs(sums[j]);
    if (straddles && j % 2 == 1) size = std::max(size, R(abs(sums[j - 1])));
    to.normal[j] += sums[j];
    to.tangential[j] += panel.shear_ratio * sums[j];
    to.normal_error[j] += error * size;
    to.tangential_error[j] += tangential_error * size;
  }
}

/// Adds the error that a displacement of forces at the distance d causes. `normal` and `tangential` are sums of force
/// times displacement. dM_j/dx is at most about 2 (z/d)^(3-j)/d^2.
template <Real R>
void add_displaced(const R& normal, const R& tangential, const R& d, const R& z, ForceSums<R>& to) {
  R part = 2 / (d * d);
  for (std::size_t j = 4; j-- > 0; part *= z / d) {
    to.normal_error[j] += normal * part;
    to.tangential_error[j] += tangential * part;
  }
}

}  // namespace

template <Real R>
InteriorStress<R>::InteriorStress(PiecewiseTraction<R> traction)
    : traction_(std::move(traction)), law_(traction_.elasticity()) {
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

template <Real R>
std::pair<const R*, R> InteriorStress<R>::forces_on(std::size_t k) const {
  const TractionPanel<R>& panel = traction_.panels()[k];
  if (panel.count > 1) return {forces_.data() + first_force_[k], R(1)};
  return {panel.rule->weights.data(), traction_.constant(panel) * panel.length};
}

template <Real R>
void InteriorStress<R>::add_panel_moments(std::size_t k, const Cell& cell, R* normal, R* tangential) const {
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

template <Real R>
void InteriorStress<R>::gather(std::size_t first, std::size_t end) {
  const auto& panels = traction_.panels();
  const std::size_t index = cells_.size();
  const R half = (panels[end - 1].right - panels[first].left) / 2;
  cells_.push_back({first, end, panels[first].left.moved(half), half, 0, moments_.size(), R(0), R(0), R(0), R(0)});
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
    cell.normal_error += panels[k].force_error * size;
    cell.tangential_error += abs(panels[k].shear_ratio) * panels[k].force_error * size;
    cell.normal_shift += panels[k].shift * size;
    cell.tangential_shift += abs(panels[k].shear_ratio) * panels[k].shift * size;
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
    cell.normal_shift += part.normal_shift;
    cell.tangential_shift += part.tangential_shift;
  }
}

/// Returns the position of node i of a panel's rule, as a fraction of the panel.
template <Real R>
const R& InteriorStress<R>::from_left(const TractionPanel<R>& panel, std::size_t i) {
  return panel.singular_end == Side::right ? panel.rule->from_right[i] : panel.rule->from_left[i];
}

template <Real R>
void InteriorStress<R>::add(std::size_t index, const BodyPoint& point, Sums& sums) const {
  const Cell& cell = cells_[index];
  if (cell.end - cell.first >= fewest_panels_with_moments) {
    const R x = point.x - cell.centre;
    if (x * x + point.z * point.z >= 9 * cell.half * cell.half) {
      const R* normal = moments_.data() + cell.moments;
      add_far_forces(sums, normal, normal + moment_count<R>(), cell.half, x, point.z);
      // The largest horizontal distance in the cell.
      const R aside = std::max(R(abs(x)), cell.half);
      add_force(sums.normal_error, R(3 * cell.normal_error), aside, point.z);
      add_force(sums.tangential_error, R(3 * cell.tangential_error), aside, point.z);
      if (cell.normal_shift > 0) {
        const R nearest = sqrt(x * x + point.z * point.z) * 2 / 3;
        add_displaced(cell.normal_shift, cell.tangential_shift, nearest, point.z, sums);
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

template <Real R>
void InteriorStress<R>::add_panel(std::size_t k, const BodyPoint& point, Sums& sums) const {
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
  for (std::size_t i = 0; i < traction_.nodes_per_rule(); ++i) {
    add_force(of_panel, forces[i], R(x_left - panel.length * from_left(panel, i)), point.z);
  }
  for (R& sum : of_panel) sum *= factor;
  add_sums(of_panel, panel, panel.force_error, x_left > 0 && x_right < 0, sums);
  if (panel.shift > 0) {
    const R displaced = abs(traction_.constant(panel)) * panel.length * panel.shift;
    const R d = sqrt(aside * aside + point.z * point.z);
    add_displaced(displaced, R(abs(panel.shear_ratio) * displaced), d, point.z, sums);
  }
}

/// `x_left` is x minus the left end of the part. `reach` is the distance from the panel's singular end to the point.
template <Real R>
void InteriorStress<R>::add_part(const TractionPanel<R>& panel, const PanelPart<R>& part, const R& x_left,
                                 const R& x_right, const R& z, const R& reach, Sums& sums) const {
  sums.nodes.clear();
  traction_.append_nodes(panel, part, sums.nodes);
  std::array<R, 4> of_part{};
  std::array<R, 4> displaced{};
  // Measure from the nearer end of the part, which is x itself if the part ends there.
  const bool by_left = x_left <= 0;
  for (std::size_t i = 0; i < sums.nodes.forces.size(); ++i) {
    const R &left = sums.nodes.from_left[i], &right = sums.nodes.from_right[i], &force = sums.nodes.forces[i];
    const R x = by_left ? x_left - left : x_right + right;
    add_force(of_part, force, x, z);
    if (panel.end_error > 0) add_force(displaced, R(force * panel.displaced(part, left, right, reach)), x, z);
  }
  add_sums(of_part, panel, panel.error, false, sums);
  for (std::size_t j = 0; j < 4; ++j) {
    sums.normal_error[j] += abs(displaced[j]);
    sums.tangential_error[j] += abs(panel.shear_ratio * displaced[j]);
  }
}

template <Real R>
void InteriorStress<R>::add_near(const TractionPanel<R>& panel, const R& x_left, const R& x_right, const R& z,
                                 Sums& sums) const {
  const R& from_end = panel.singular_end == Side::right ? x_right : x_left;
  const R reach = sqrt(from_end * from_end + z * z);
  PanelPart<R> whole{R(0), panel.length, R(0)};
  if (x_left > 0 && x_right < 0) {
    const R behind = -x_right;
    add_part(panel, {R(0), x_left, behind, infinity<R>(), z}, x_left, R(0), z, reach, sums);
    add_part(panel, {x_left, behind, R(0), z, infinity<R>()}, R(0), x_right, z, reach, sums);
  } else if (x_left <= 0) {
    whole.beyond_left = sqrt(x_left * x_left + z * z);
    add_part(panel, whole, x_left, x_right, z, reach, sums);
  } else {
    whole.beyond_right = sqrt(x_right * x_right + z * z);
    add_part(panel, whole, x_left, x_right, z, reach, sums);
  }
}

template <Real R>
StressState<R> InteriorStress<R>::state_of(const Sums& sums) const {
  const R factor = 2 / pi<R>();
  // Errors never cancel.
  const auto difference = [&](std::size_t j, std::size_t of_tangential) {
    return Estimate<R>{factor * (sums.normal[j] - sums.tangential[of_tangential]),
                       factor * (sums.normal_error[j] + sums.tangential_error[of_tangential])};
  };
  const auto sum = [](const std::array<R, 4>& n, const std::array<R, 4>& t) { return n[1] + n[3] + t[0] + t[2]; };
  return law_.completed(difference(2, 3), difference(0, 1), difference(1, 2),
                        {sum(sums.normal, sums.tangential), sum(sums.normal_error, sums.tangential_error)});
}

template <Real R>
StressState<R> InteriorStress<R>::at(const BodyPoint& point, Sums& sums) const {
  static_cast<ForceSums<R>&>(sums) = {};
  if (!reaches(point.z)) {
    sums.normal.fill(std::numeric_limits<R>::quiet_NaN());
    sums.normal_error.fill(infinity<R>());
  } else if (!cells_.empty()) {
    add(0, point, sums);
  }
  return state_of(sums);
}

template <Real R>
StressState<R> InteriorStress<R>::at(const Rational& x, const Rational& z) const {
  check_below_surface(z);
  Sums sums;
  return at({SurfacePlace<R>::of(x), to_real<R>(z)}, sums);
}

template <Real R>
void InteriorStress<R>::at(std::span<const R> x, std::span<const R> z, std::span<StressState<R>> states) const {
  Sums sums;
  for (std::size_t i = 0; i < x.size(); ++i) {
    check_below_surface(z[i]);
    states[i] = at({{x[i], R(0)}, z[i]}, sums);
  }
}

STEADYSLIDE_INSTANTIATE_CLASS(InteriorStress)

}  // namespace steadyslide::numeric
