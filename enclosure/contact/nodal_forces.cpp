#include "enclosure/contact/nodal_forces.hpp"

#include "model/invalid_data.hpp"
#include "model/surface_mesh.hpp"

namespace steadyslide::enclosure {
namespace {

void check_contact(const EnclosedSolution& solution, const SurfaceMesh& mesh) {
  const auto refuse = [](const Ball& end, std::size_t node) {
    throw InvalidData("nodes[" + std::to_string(node) + "]", "contact outside the mesh", "the mesh covers the contact",
                      end.to_string(16));
  };
  const auto contact = solution.contact();
  const Ball& left = contact.front().left.x;
  const Ball& right = contact.back().right.x;
  if (left < Ball(mesh.nodes().front(), left.bits())) refuse(left, 0);
  if (right > Ball(mesh.nodes().back(), right.bits())) refuse(right, mesh.nodes().size() - 1);
}

/// Returns the shape functions of the element with these nodes, in xi.
std::vector<BallPolynomial> shape_functions(const std::vector<Rational>& xi, Bits bits) {
  std::vector<BallPolynomial> result;
  for (std::size_t i = 0; i < xi.size(); ++i) {
    Polynomial shape = Polynomial::constant(1);
    for (std::size_t j = 0; j < xi.size(); ++j) {
      if (j != i) shape = shape * Polynomial({-xi[j] / (xi[i] - xi[j]), 1 / (xi[i] - xi[j])});
    }
    result.push_back(in_balls(shape, bits));
  }
  return result;
}

}  // namespace

std::vector<NodalForce> nodal_forces(const EnclosedSolution& solution, const std::vector<Rational>& nodes, int order) {
  check_contact(solution, SurfaceMesh(nodes, order));
  const auto step = static_cast<std::size_t>(order);
  const TractionRepresentation& form = solution.form();
  const ContactSet& set = form.set();
  const Bits bits = set.bits();
  const Frame& frame = set.problem().frame;
  const ContactLoad load(form);
  std::vector<NodalForce> forces(nodes.size(), {Ball(0, bits), Ball(0, bits)});
  for (std::size_t first = 0; first + step < nodes.size(); first += step) {
    std::vector<Rational> xi;
    for (std::size_t i = 0; i <= step; ++i) xi.push_back((nodes[first + i] - frame.origin) / frame.unit);
    const std::vector<BallPolynomial> shapes = shape_functions(xi, bits);
    for (std::size_t segment = 0; segment < set.segments(); ++segment) {
      if (!set.in_contact(segment)) continue;
      const std::optional<ContactPanel::DistanceRange> range = solution.range(segment, xi.front(), xi.back());
      if (!range) continue;
      const Ball ratio(solution.shear_ratio(segment), bits);
      for (std::size_t i = 0; i <= step; ++i) {
        const Ball force = Ball(frame.unit, bits) * load.load_on(segment, *range, shapes[i]);
        forces[first + i].normal -= force;
        forces[first + i].tangential += ratio * force;
      }
    }
  }
  return forces;
}

}  // namespace steadyslide::enclosure
