#include "enclosure/contact/nodal_forces.hpp"

#include "model/invalid_data.hpp"

namespace steadyslide::enclosure {
namespace {

void check(const EnclosedSolution& solution, const std::vector<Rational>& nodes, std::size_t order) {
  if (order != 1 && order != 2) throw InvalidData("order", "wrong order", "it is 1 or 2", std::to_string(order));
  if (nodes.size() < order + 1 || (nodes.size() - 1) % order != 0) {
    throw InvalidData("nodes", "wrong number of nodes", "an element of order n has n + 1",
                      std::to_string(nodes.size()));
  }
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    if (nodes[i] <= nodes[i - 1])
      throw InvalidData("nodes", "nodes do not increase", "x_i < x_i+1", to_string(nodes[i]));
  }
  for (std::size_t i = 1; order == 2 && i < nodes.size(); i += 2) {
    if (nodes[i] * 2 == nodes[i - 1] + nodes[i + 1]) continue;
    throw InvalidData("nodes", "node off the middle of its element", "every second one is a midside node",
                      to_string(nodes[i]));
  }
  const auto contact = solution.contact();
  for (const Ball& end : {contact.front().first.x, contact.back().second.x}) {
    if (!(end < Ball(nodes.front(), end.bits())) && !(end > Ball(nodes.back(), end.bits()))) continue;
    throw InvalidData("nodes", "contact outside the mesh", "the mesh covers the contact", end.to_string(16));
  }
}

/// The shape functions of the element of these nodes, in xi.
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
  const auto step = static_cast<std::size_t>(order);
  check(solution, nodes, step);
  const ContactForm& form = solution.form();
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
      const std::optional<ContactPanel::Range> range = solution.range(segment, xi.front(), xi.back());
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
