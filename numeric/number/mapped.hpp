#pragma once
// Makes a vector from the elements of a range.

#include <cstddef>
#include <type_traits>
#include <vector>

namespace steadyslide::numeric {

/// Returns f of every element of a range, in order.
template <class Range, class F>
auto mapped(const Range& range, const F& f) {
  std::vector<std::decay_t<decltype(f(*range.begin()))>> result;
  result.reserve(static_cast<std::size_t>(range.size()));
  for (const auto& element : range) result.push_back(f(element));
  return result;
}

}  // namespace steadyslide::numeric
