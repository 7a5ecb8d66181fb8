#include "numeric/solution/nodal_forces.hpp"

#include <cmath>
#include <sstream>

#include "model/invalid_data.hpp"
#include "numeric/solution/mesh_error.hpp"

namespace steadyslide::numeric {
namespace {

/// Returns an element's shape functions at the given distances from its ends, which are fractions of its length.
template <Real R>
R shape_function(int order, int node, const R& from_left, const R& from_right) {
  if (order == 1) return node == 0 ? from_right : from_left;
  if (node == 1) return 4 * from_left * from_right;
  return node == 0 ? from_right * (from_right - from_left) : from_left * (from_left - from_right);
}

template <Real R>
struct Element {
  SurfacePlace<R> left;
  SurfacePlace<R> right;
  R length;
};

template <Real R>
std::vector<Element<R>> elements_of(const SurfaceMesh& mesh) {
  std::vector<Element<R>> result;
  for (std::size_t k = 0; k < mesh.elements(); ++k) {
    const Rational& left = mesh.nodes()[mesh.first_node(k)];
    const Rational& right = mesh.nodes()[mesh.first_node(k + 1)];
    result.push_back({SurfacePlace<R>::of(left), SurfacePlace<R>::of(right), to_real<R>(right - left)});
  }
  return result;
}

/// Adds the forces of the part of a panel that lies on an element.
template <Real R>
void add(const PiecewiseTraction<R>& traction, const TractionPanel<R>& panel, const Element<R>& element, int order,
         TractionNodes<R>& nodes, Estimate<R>* normal, Estimate<R>* tangential) {
  const R before = panel.left - element.left;
  const R behind = element.right - panel.right;
  PanelPart<R> part{before < 0 ? R(-before) : R(0), panel.length, behind < 0 ? R(-behind) : R(0)};
  if (before < 0 && behind < 0) part.length = element.length;
  if (before < 0 && behind >= 0) part.length = panel.right - element.left;
  if (before >= 0 && behind < 0) part.length = element.right - panel.left;
  if (part.length <= 0) return;
  nodes.clear();
  traction.append_nodes(panel, part, nodes);
  for (std::size_t i = 0; i < nodes.forces.size(); ++i) {
    const R relative_error = panel.error + panel.displaced(part, nodes.from_left[i], nodes.from_right[i], part.length);
    const R from_left = ((before > 0 ? before : R(0)) + nodes.from_left[i]) / element.length;
    const R from_right = ((behind > 0 ? behind : R(0)) + nodes.from_right[i]) / element.length;
    for (int n = 0; n <= order; ++n) {
      const R force = nodes.forces[i] * shape_function(order, n, from_left, from_right);
      const R error = relative_error * abs(force);
      normal[n] += Estimate<R>{-force, error};
      tangential[n] += Estimate<R>{panel.shear_ratio * force, abs(panel.shear_ratio) * error};
    }
  }
}

template <Real R>
void check_inside(const R& distance, const SurfacePlace<R>& end, std::size_t node) {
  if (distance >= 0) return;
  std::ostringstream x;
  x.precision(16);
  x << end.high;
  throw InvalidData("nodes[" + std::to_string(node) + "]", "contact outside the mesh", "the mesh covers the contact",
                    x.str());
}

/// Returns the nodal forces of one traction: the normal ones, then the tangential ones.
template <Real R>
std::vector<Estimate<R>> forces_of(const PiecewiseTraction<R>& traction, const SurfaceMesh& mesh) {
  const std::vector<Element<R>> elements = elements_of<R>(mesh);
  const std::size_t count = mesh.nodes().size();
  std::vector<Estimate<R>> forces(2 * count);
  TractionNodes<R> nodes;
  std::size_t k = 0;
  for (const TractionPanel<R>& panel : traction.panels()) {
    while (k + 1 < elements.size() && panel.left - elements[k].right >= 0) ++k;
    for (std::size_t on = k; on < elements.size() && panel.right - elements[on].left > 0; ++on) {
      Estimate<R>* normal = &forces[mesh.first_node(on)];
      add(traction, panel, elements[on], mesh.order(), nodes, normal, normal + count);
    }
  }
  return forces;
}

}  // namespace

template <Real R>
std::vector<NodalForce<R>> nodal_forces(const PiecewiseTraction<R>& traction, const SurfaceMesh& mesh) {
  std::vector<NodalForce<R>> result(mesh.nodes().size());
  const std::vector<TractionPanel<R>>& panels = traction.panels();
  if (panels.empty()) return result;
  check_inside(panels.front().left - SurfacePlace<R>::of(mesh.nodes().front()), panels.front().left, 0);
  check_inside(SurfacePlace<R>::of(mesh.nodes().back()) - panels.back().right, panels.back().right, result.size() - 1);
  std::vector<const PiecewiseTraction<R>*> meshes{&traction};
  for (const PiecewiseTraction<R>& coarser : traction.coarser()) meshes.push_back(&coarser);
  const std::vector<Estimate<R>> forces = on_nested_meshes(
      std::span<const PiecewiseTraction<R>* const>(meshes),
      [&](const PiecewiseTraction<R>* on_mesh) { return forces_of(*on_mesh, mesh); }, 1);
  for (std::size_t n = 0; n < result.size(); ++n) result[n] = {forces[n], forces[result.size() + n]};
  return result;
}

#define STEADYSLIDE_INSTANTIATE(R) \
  template std::vector<NodalForce<R>> nodal_forces(const PiecewiseTraction<R>&, const SurfaceMesh&);
STEADYSLIDE_FOR_EACH_REAL(STEADYSLIDE_INSTANTIATE)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::numeric
