#include "numeric/variational/contact_hull.hpp"

#include <algorithm>
#include <bit>
#include <functional>

namespace steadyslide::numeric::variational {

ContactHull::ContactHull(const DiscreteProblem& problem, std::size_t first, std::size_t count)
    : first(first),
      influence(problem.galerkin_operator().part(first, count)),
      inverse(influence, problem.mesh().length(0)) {}

std::shared_ptr<ContactHull> contact_hull(const DiscreteProblem& problem, const CellSet& contact,
                                          std::shared_ptr<ContactHull> last) {
  const auto begin = static_cast<std::size_t>(std::find(contact.begin(), contact.end(), 1) - contact.begin());
  const auto end = static_cast<std::size_t>(contact.rend() - std::find(contact.rbegin(), contact.rend(), 1));
  // A contact that grows by a few cells keeps its hull: to plan transforms of a new length takes as long as some products.
  const std::size_t step = std::bit_floor(std::max<std::size_t>((end - begin) / 32, 1));
  const std::size_t first = begin - begin % step;
  const std::size_t behind = std::min((end + step - 1) / step * step, contact.size());
  if (last && last->first == first && last->influence.size() == behind - first) return last;
  last = nullptr;
  return std::make_shared<ContactHull>(problem, first, behind - first);
}

std::vector<CellRange> contact_zones(const std::vector<std::size_t>& cells, std::size_t most) {
  std::vector<std::size_t> gaps;  // 1 + cells between
  for (std::size_t k = 1; k < cells.size(); ++k) {
    if (cells[k] != cells[k - 1] + 1) gaps.push_back(cells[k] - cells[k - 1]);
  }
  std::size_t least = 2;
  if (gaps.size() >= most) {
    const auto place = gaps.begin() + static_cast<std::ptrdiff_t>(most - 1);
    std::nth_element(gaps.begin(), place, gaps.end(), std::greater<>());
    least = *place + 1;
  }
  std::vector<CellRange> zones;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    if (k == 0 || cells[k] - cells[k - 1] >= least) zones.push_back({cells[k], 0});
    zones.back().count = cells[k] + 1 - zones.back().first;
  }
  return zones;
}

}  // namespace steadyslide::numeric::variational
