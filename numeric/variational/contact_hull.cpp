#include "numeric/variational/contact_hull.hpp"

#include <algorithm>
#include <bit>

namespace steadyslide::numeric::variational {

ContactHull::ContactHull(const DiscreteProblem& problem, std::size_t first, std::size_t count)
    : first(first),
      influence(problem.galerkin_operator().part(first, count)),
      inverse(influence, problem.mesh().length(0)) {}

std::shared_ptr<ContactHull> contact_hull(const DiscreteProblem& problem, const CellSet& contact,
                                          std::shared_ptr<ContactHull> last) {
  const auto begin = static_cast<std::size_t>(std::ranges::find(contact, 1) - contact.begin());
  const auto end = static_cast<std::size_t>(contact.rend() - std::find(contact.rbegin(), contact.rend(), 1));
  // A contact that grows by a few cells keeps its hull: to plan transforms of a new length takes as long as some products.
  const std::size_t step = std::bit_floor(std::max<std::size_t>((end - begin) / 32, 1));
  const std::size_t first = begin - begin % step;
  const std::size_t behind = std::min((end + step - 1) / step * step, contact.size());
  if (last && last->first == first && last->influence.size() == behind - first) return last;
  last = nullptr;
  return std::make_shared<ContactHull>(problem, first, behind - first);
}

}  // namespace steadyslide::numeric::variational
