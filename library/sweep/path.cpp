#include "library/sweep/path.hpp"

#include <algorithm>
#include <charconv>

namespace steadyslide::library {

std::vector<Step> steps_of(std::string_view path) {
  std::vector<Step> steps;
  while (true) {
    const std::size_t end = std::min(path.find_first_of(".[]"), path.size());
    if (end == 0) return {};
    steps.emplace_back(std::string(path.substr(0, end)));
    path.remove_prefix(end);
    while (path.starts_with('[')) {
      std::size_t index = 0;
      const char* const last = path.data() + path.size();
      const auto [after, error] = std::from_chars(path.data() + 1, last, index);
      if (error != std::errc() || after == last || *after != ']') return {};
      steps.emplace_back(index);
      path.remove_prefix(static_cast<std::size_t>(after + 1 - path.data()));
    }
    if (path.empty()) return steps;
    if (path.front() != '.') return {};
    path.remove_prefix(1);
  }
}

}  // namespace steadyslide::library
