#include "numeric/riemann_hilbert/distant_nodes.hpp"

namespace steadyslide::numeric {
namespace {

std::vector<hierarchical::LineSum::Kernel> kernels_of(const NodeLine& line) {
  using Kernel = hierarchical::LineSum::Kernel;
  std::vector<Kernel> kernels(line.weights().size(), Kernel::cauchy);
  kernels.back() = Kernel::distance;
  return kernels;
}

}  // namespace

DistantNodes::DistantNodes(NodeLine line)
    : line_(std::move(line)), sum_(kernels_of(line_), line_.lengths(), line_.sources(), line_.weights()) {}

PivotedNodes::PivotedNodes(const SignedFundamentalSolution<double>& y, NodeLine line)
    : y_(&y), line_(std::move(line)), sum_(line_.lengths(), line_.sources(), line_.weights()) {
  for (const auto& [first, end] : y.set().runs()) {
    if (y.set().in_contact(first)) components_.push_back({first, end});
  }
}

hierarchical::PivotSum::Place PivotedNodes::place(const SurfacePoint<double>& at) const {
  if (line_.is_left_of(at) || line_.is_right_of(at)) {
    return {line_.is_left_of(at) ? static_cast<std::ptrdiff_t>(line_.lengths().size()) : -1, 0, 0};
  }
  const auto [leaf, from_left, from_right] = line_.place(at);
  return {static_cast<std::ptrdiff_t>(leaf), from_left, from_right};
}

}  // namespace steadyslide::numeric
