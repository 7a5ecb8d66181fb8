#pragma once
// Work in several processes at a time, claims and others: GiNaC and CLN allow no threads, but a process has its own.

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "proofs_checks/kit/run.hpp"

namespace steadyslide::proofs_checks {

/// How many there can be at a time: the cores that the program may use.
unsigned available_processes();

/// What the task of this number makes. One that throws ends its process.
using Task = std::function<std::string(std::size_t)>;

struct TaskEnd {
  std::optional<std::string> bytes{};  ///< what it made
  std::string how{};                   ///< otherwise: "by signal 11", "with exit code 1"
};

/// Tasks 0, ..., count - 1, in this order. A process takes the next one when it is done with one; `begins` is called when
/// it does, here. Throws std::system_error where no process can be started.
std::vector<TaskEnd> do_in_processes(std::size_t count, unsigned processes, const Task& task,
                                     const std::function<void(std::size_t)>& begins = {});

/// As run_all() does, the same reports in the same order. A process that ends in the middle of a claim leaves it
/// undecided, with a note how it ended. Throws as do_in_processes() does.
std::vector<Report> run_in_processes(std::span<const Claim> claims, const Context& context, unsigned processes,
                                     const Progress& progress = {});

}  // namespace steadyslide::proofs_checks
