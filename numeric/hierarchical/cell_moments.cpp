#include "numeric/hierarchical/cell_moments.hpp"

#include <Eigen/Core>
#include <algorithm>

#include "numeric/number/mapped.hpp"

namespace steadyslide::numeric::hierarchical {
namespace {

std::vector<PanelTree::Panel> panels_of(const std::vector<double>& lengths, const std::vector<Source>& sources) {
  std::vector<PanelTree::Panel> panels = mapped(lengths, [](double length) { return PanelTree::Panel{length, false}; });
  for (const Source& source : sources) {
    PanelTree::Panel& panel = panels[source.panel];
    if (!panel.has_sources) panel.before = source.from_left;
    panel.after = source.from_right;
    panel.has_sources = true;
  }
  return panels;
}

using Binomials = std::array<CellMoments::Series, CellMoments::terms>;

const Binomials& binomials() {
  static const Binomials result = [] {
    Binomials b{};
    for (std::size_t k = 0; k < b.size(); ++k) {
      b[k][0] = b[k][k] = 1;
      for (std::size_t j = 1; j < k; ++j) b[k][j] = b[k - 1][j - 1] + b[k - 1][j];
    }
    return b;
  }();
  return result;
}

}  // namespace

CellMoments::CellMoments(const std::vector<double>& lengths, const std::vector<Source>& sources,
                         const std::vector<std::vector<double>>& weights)
    : stride_(weights.size() * terms), tree_(panels_of(lengths, sources)), moments_(tree_.cells().size() * stride_, 0) {
  gather(sources, weights);
  for (std::size_t cell = tree_.cells().size(); cell-- > 1;) shift_to_parent(cell);
}

double CellMoments::weighted(std::size_t cell, std::size_t sum, const Series& a, std::size_t count) const {
  using Vector = Eigen::Map<const Eigen::VectorXd>;
  const auto n = static_cast<Eigen::Index>(count);
  return Vector(of(cell, sum), n).dot(Vector(a.data(), n));
}

void CellMoments::gather(const std::vector<Source>& sources, const std::vector<std::vector<double>>& weights) {
  // Process several sources together, because the powers of one source depend on each other.
  constexpr std::size_t together = 8;
  for (std::size_t i = 0; i < sources.size();) {
    const std::size_t leaf = tree_.leaf(sources[i].panel);
    const PanelTree::Cell& cell = tree_.cells()[leaf];
    std::array<double, together> place{}, power{};
    std::size_t count = 0;
    for (; count < together && i + count < sources.size() && sources[i + count].panel == sources[i].panel; ++count) {
      const Source& source = sources[i + count];
      const double left = source.from_left - cell.before;
      const double right = source.from_right - cell.after;
      place[count] = cell.extent > 0 ? std::clamp((left - right) / cell.extent, -1.0, 1.0) : 0;
    }
    for (std::size_t s = 0; s < sums(); ++s) {
      double* m = &moments_[leaf * stride_ + s * terms];
      for (std::size_t j = 0; j < together; ++j) power[j] = j < count ? weights[s][i + j] : 0;
      for (std::size_t k = 0; k < terms; ++k) {
        m[k] += ((power[0] + power[4]) + (power[1] + power[5])) + ((power[2] + power[6]) + (power[3] + power[7]));
        for (std::size_t j = 0; j < together; ++j) power[j] *= place[j];
      }
    }
    i += count;
  }
}

void CellMoments::shift_to_parent(std::size_t index) {
  const PanelTree::Cell& cell = tree_.cells()[index];
  if (!cell.has_sources) return;
  const PanelTree::Cell& parent = tree_.cells()[cell.parent];
  const double ratio = parent.extent > 0 ? cell.extent / parent.extent : 1;
  const double shift = parent.left == index ? ratio - 1 : 1 - ratio;
  // If the other child has no sources, the parent has the moments of this child.
  Series ratios, shifts;
  ratios[0] = shifts[0] = 1;
  for (std::size_t k = 1; k < terms; ++k) {
    ratios[k] = ratios[k - 1] * ratio;
    shifts[k] = shifts[k - 1] * shift;
  }
  for (std::size_t s = 0; s < sums(); ++s) {
    const double* from = of(index, s);
    double* to = &moments_[cell.parent * stride_ + s * terms];
    for (std::size_t k = 0; k < terms; ++k) {
      double sum = 0;
      for (std::size_t j = 0; j <= k; ++j) sum += binomials()[k][j] * shifts[k - j] * (ratios[j] * from[j]);
      to[k] += sum;
    }
  }
}

}  // namespace steadyslide::numeric::hierarchical
