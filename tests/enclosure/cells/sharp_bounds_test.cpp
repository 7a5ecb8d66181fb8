// Bounds for pressures on cells, each in a case whose error nearly reaches it.

#include "support/sharp_bounds.hpp"

#include "enclosure/cells/cell_gap.hpp"
#include "enclosure/cells/lowest_gap.hpp"
#include "support/problems.hpp"

namespace steadyslide::sharp_cells {

using namespace steadyslide::enclosure;

constexpr Bits bits = 200;

double ratio(const Ball& error, const Ball& bound) { return (abs(error) / bound).to_double(); }

/// One far node, as near as far nodes are. The place in the cell was found by a scan.
double far_node() {
  // Seen from cell 3, node 0 is far and node 1 is near.
  const CellPressures pressures(std::vector<double>{1, 0, 0, 0, 0, 0});
  const ContactProblem problem = reduced({0}, {}, one_piece(-1, 1, {}), 1);
  const CellGap gap(problem, pressures, bits);
  const NearLogarithms e(bits);
  const GapPart part = gap.parts(3).front();
  constexpr double z = 587 / 4096.0;
  const Ball y = Ball(3) + Ball::exactly(z, bits);
  const auto l = [](const Ball& x) { return x * log(x); };
  const Ball exact = (l(y - Ball(1)) - l(y)) / Ball::pi(bits);
  return ratio(part.value(z, e) - exact, part.rest);
}

/// Returns how far the part falls below the smaller of its ends, and the bound.
double dip(const GapPart& part, double z0, double z1, double lowest) {
  const NearLogarithms e(bits);
  const Ball fall = min(part.value(z0, e), part.value(z1, e)) - part.value(lowest, e);
  return ratio(fall, part.dip(z0, z1));
}

GapPart part_of(BallPolynomial q) { return {std::move(q), {}, {}, Ball(0, bits)}; }

/// A parabola, lowest in the middle.
double dip_of_parabola() { return dip(part_of({Ball(1, bits), Ball(-3, bits), Ball(3, bits)}), 0.25, 0.75, 0.5); }

/// -e_k has the curvature 1/(k + z). The chord is level with the linear term.
double dip_of_logarithm(std::size_t k, bool right) {
  GapPart part = part_of({Ball(0, bits), Ball(0, bits)});
  (right ? part.b : part.a)[k] = Ball(right ? 1 : -1, bits);
  const NearLogarithms e(bits);
  constexpr double z0 = 0.25, z1 = 0.3125;
  part.q[1] = (part.value(z0, e) - part.value(z1, e)) / Ball::exactly(z1 - z0, bits);
  return dip(part, z0, z1, 0.28125);
}

/// z log z falls by z1/e below its ends at z = z1/e; its ends over [0, 1] are level.
double dip_beside_node(bool right) {
  GapPart part = part_of({Ball(0, bits)});
  (right ? part.b : part.a)[0] = Ball(right ? 1 : -1, bits);
  return dip(part, 0, 1, right ? 1 - 0.3678794411 : 0.3678794411);
}

/// Sums over cells of numbers that are cut to 2^-fraction. Node, cell and fraction were found by a scan.
double toeplitz(bool mean) {
  const CellPressures pressures(std::vector<double>(40, 1.0));
  const Bits fraction = mean ? 14 : 10;
  const CellPotential few(pressures, fraction), all(pressures, 128);
  const Ball &cut = mean ? few.means[5] : few.nodes[7], &exact = mean ? all.means[5] : all.nodes[7];
  return ratio(exact - cut.midpoint(), cut.radius());
}

TEST_CASE("bounds for pressures on cells: a true error that nearly reaches each") {
  check_sharp_bounds("test_cell_bound", {{"cell-far-node", far_node},
                                         {"cell-dip-parabola", dip_of_parabola},
                                         {"cell-dip-left-logarithm", [] { return dip_of_logarithm(1, false); }},
                                         {"cell-dip-right-logarithm", [] { return dip_of_logarithm(1, true); }},
                                         {"cell-dip-beside-left-node", [] { return dip_beside_node(false); }},
                                         {"cell-dip-beside-right-node", [] { return dip_beside_node(true); }},
                                         {"cell-sum-node", [] { return toeplitz(false); }},
                                         {"cell-sum-mean", [] { return toeplitz(true); }}});
}

}  // namespace steadyslide::sharp_cells
