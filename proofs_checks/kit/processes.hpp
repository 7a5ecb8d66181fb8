#pragma once
// Runs claims and other tasks in several processes at a time. GiNaC and CLN do not allow threads, but each process has
// its own copy of them.

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "proofs_checks/kit/run.hpp"

namespace steadyslide::proofs_checks {

/// Returns the largest useful number of processes: the cores that the program may use.
unsigned available_processes();

/// Returns the bytes that the task of this number makes. A task that throws ends its process.
using Task = std::function<std::string(std::size_t)>;

struct TaskEnd {
  std::optional<std::string> bytes{};  ///< the task's bytes
  std::string how{};                   ///< if there are none, how the process ended: "by signal 11", "with exit code 1"
};

/// Runs the tasks 0, ..., count - 1 in this order. A process takes the next task when it has finished one; `begins` is
/// then called in the calling process. Throws std::system_error if no process can be started.
std::vector<TaskEnd> do_in_processes(std::size_t count, unsigned processes, const Task& task,
                                     const std::function<void(std::size_t)>& begins = {});

/// Returns the same reports in the same order as run_all(). If a process ends in the middle of a claim, the claim stays
/// undecided, and a note says how the process ended. Throws as do_in_processes() does.
std::vector<Report> run_in_processes(std::span<const Claim> claims, const Context& context, unsigned processes,
                                     const Progress& progress = {});

}  // namespace steadyslide::proofs_checks
