#include "app/sweep/sweep.hpp"

#include <fmt/format.h>

#include <exception>

#include "app/sweep/ordered_tasks.hpp"
#include "app/sweep/row_file.hpp"
#include "app/sweep/sweep_table.hpp"
#include "app/terminal/progress.hpp"

namespace steadyslide::app {
namespace {

/// Calls `act` in every process. If it throws in one, every process throws: otherwise the others would wait for ever.
template <class Act>
void in_all(const Processes& processes, Act act) {
  std::exception_ptr failure;
  try {
    act();
  } catch (...) {
    failure = std::current_exception();
  }
  const bool all_fine = processes.true_in_all ? processes.true_in_all(!failure) : !failure;
  if (failure) std::rethrow_exception(failure);
  if (!all_fine) throw Failure(ExitCode::failed, "another process of the sweep has failed");
}

}  // namespace

void run_sweep(const SweepWanted& wanted, const Processes& processes) {
  std::optional<SweepTable> table;
  in_all(processes, [&] { table.emplace(read_sweep(wanted.file)); });
  std::optional<RowFile> file;
  in_all(processes, [&] {
    if (processes.rank == 0) file.emplace(wanted, *table);
  });
  std::size_t first = file ? file->rows() : 0;
  if (processes.from_first) first = processes.from_first(first);
  const auto step = static_cast<std::size_t>(processes.count);
  const TaskRange tasks{first + static_cast<std::size_t>(processes.rank), table->size(), step};
  const auto make = [&](std::size_t n) { return table->row(n); };
  if (!file)
    return in_order(tasks, wanted.jobs, make, [&](std::size_t, const std::string& row) { processes.send(row); });

  {
    Progress progress(table->size() - first);
    const auto add = [&](const std::string& row) {
      file->add(row);
      progress.next();
    };
    in_order(tasks, wanted.jobs, make, [&](std::size_t n, const std::string& row) {
      add(row);
      for (int rank = 1; rank < processes.count && n + static_cast<std::size_t>(rank) < table->size(); ++rank) {
        add(processes.receive(rank));
      }
    });
  }
  file->finish();
  if (file->failures() == 0) return;
  throw Failure(
      ExitCode::refuted,
      fmt::format("{}: {} of {} problems not solved, first of all row {}; the column failed_condition says why",
                  wanted.file, file->failures(), table->size(), file->first_failure()));
}

}  // namespace steadyslide::app
