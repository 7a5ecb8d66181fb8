#pragma once
// The algorithms of std::ranges that the numeric code uses: emscripten 3.1.6 has libc++ 13, which has none. Read before every
// file of the Explorer, and by nothing else.

#include <algorithm>
#include <functional>
#include <iterator>

namespace std::ranges {

#define STEADYSLIDE_RANGE_TEST(name)                                                                    \
  template <class Range, class Test, class Of = std::identity>                                          \
  auto name(Range&& range, Test test, Of of = {}) {                                                     \
    return std::name(std::begin(range), std::end(range),                                                \
                     [&](const auto& element) { return std::invoke(test, std::invoke(of, element)); }); \
  }
STEADYSLIDE_RANGE_TEST(all_of)
STEADYSLIDE_RANGE_TEST(any_of)
STEADYSLIDE_RANGE_TEST(none_of)
STEADYSLIDE_RANGE_TEST(count_if)
#undef STEADYSLIDE_RANGE_TEST

#define STEADYSLIDE_RANGE_ORDER(name)                                                               \
  template <class Range, class Less = std::less<>, class Of = std::identity>                        \
  auto name(Range&& range, Less less = {}, Of of = {}) {                                            \
    return std::name(std::begin(range), std::end(range), [&](const auto& left, const auto& right) { \
      return std::invoke(less, std::invoke(of, left), std::invoke(of, right));                      \
    });                                                                                             \
  }
STEADYSLIDE_RANGE_ORDER(sort)
STEADYSLIDE_RANGE_ORDER(stable_sort)
STEADYSLIDE_RANGE_ORDER(min_element)
#undef STEADYSLIDE_RANGE_ORDER

template <class Range, class Value, class Of = std::identity>
auto find(Range&& range, const Value& value, Of of = {}) {
  return std::find_if(std::begin(range), std::end(range),
                      [&](const auto& element) { return std::invoke(of, element) == value; });
}

template <class Range, class Value>
void fill(Range&& range, const Value& value) {
  std::fill(std::begin(range), std::end(range), value);
}

template <class Range, class To>
void copy(Range&& range, To to) {
  std::copy(std::begin(range), std::end(range), to);
}

template <class Range>
void reverse(Range&& range) {
  std::reverse(std::begin(range), std::end(range));
}

template <class Element>
struct LeastAndMost {
  Element min, max;
};
template <class Range, class Less = std::less<>, class Of = std::identity>
auto minmax(Range&& range, Less less = {}, Of of = {}) {
  const auto found = std::minmax_element(std::begin(range), std::end(range), [&](const auto& left, const auto& right) {
    return std::invoke(less, std::invoke(of, left), std::invoke(of, right));
  });
  return LeastAndMost<std::decay_t<decltype(*found.first)>>{*found.first, *found.second};
}

}  // namespace std::ranges
