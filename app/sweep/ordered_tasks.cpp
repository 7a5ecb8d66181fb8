#include "app/sweep/ordered_tasks.hpp"

#include <tbb/global_control.h>
#include <tbb/parallel_pipeline.h>

#include <utility>
#include <vector>

namespace steadyslide::app {

void in_order(const TaskRange& tasks, int jobs, const std::function<std::string(std::size_t)>& make,
              const std::function<void(std::size_t, const std::string&)>& take) {
  const auto threads = static_cast<std::size_t>(jobs);
  const std::size_t most = 64 * threads;  // tasks that may be ahead of a slow one
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  // TBB does not free the values between two filters if an exception ends them. So the texts are here.
  std::vector<std::string> texts(most);
  const auto text = [&](std::size_t task) -> std::string& { return texts[(task - tasks.first) / tasks.step % most]; };
  std::size_t next = tasks.first;
  const auto begin = [&](tbb::flow_control& control) {
    if (next >= tasks.last) control.stop();
    return std::exchange(next, next + tasks.step);
  };
  const auto make_text = [&](std::size_t task) {
    text(task) = make(task);
    return task;
  };
  using tbb::filter_mode;
  tbb::parallel_pipeline(most,
                         tbb::make_filter<void, std::size_t>(filter_mode::serial_in_order, begin) &
                             tbb::make_filter<std::size_t, std::size_t>(filter_mode::parallel, make_text) &
                             tbb::make_filter<std::size_t, void>(filter_mode::serial_in_order,
                                                                 [&](std::size_t task) { take(task, text(task)); }));
}

}  // namespace steadyslide::app
