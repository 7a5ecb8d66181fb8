#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace steadyslide::app {

/// Tasks first, first + step, ... below `last`.
struct TaskRange {
  std::size_t first;
  std::size_t last;
  std::size_t step = 1;
};

/// Makes the text of every task, `jobs` of them at a time, and passes the texts to `take` in order, one at a time. An
/// exception of either function ends all and is thrown here.
void in_order(const TaskRange& tasks, int jobs, const std::function<std::string(std::size_t)>& make,
              const std::function<void(std::size_t, const std::string&)>& take);

}  // namespace steadyslide::app
