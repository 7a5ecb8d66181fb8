#include "app/sweep/ordered_tasks.hpp"

#include <tbb/global_control.h>
#include <tbb/parallel_pipeline.h>

#include <utility>

namespace steadyslide::app {

void in_order(const TaskRange& tasks, int jobs, const std::function<std::string(std::size_t)>& make,
              const std::function<void(std::size_t, const std::string&)>& take) {
  using Made = std::pair<std::size_t, std::string>;
  constexpr std::size_t ahead = 64;  // tasks that may be ahead of a slow one, for each thread
  const auto threads = static_cast<std::size_t>(jobs);
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  std::size_t next = tasks.first;
  const auto begin = [&](tbb::flow_control& control) {
    if (next >= tasks.last) control.stop();
    return std::exchange(next, next + tasks.step);
  };
  tbb::parallel_pipeline(ahead * threads,
                         tbb::make_filter<void, std::size_t>(tbb::filter_mode::serial_in_order, begin) &
                             tbb::make_filter<std::size_t, Made>(
                                 tbb::filter_mode::parallel, [&](std::size_t task) { return Made(task, make(task)); }) &
                             tbb::make_filter<Made, void>(tbb::filter_mode::serial_in_order,
                                                          [&](const Made& made) { take(made.first, made.second); }));
}

}  // namespace steadyslide::app
