#pragma once
// Runs a sweep from its file to its table, in threads and, if there are any, in other processes.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "app/terminal/failure.hpp"

namespace steadyslide::app {

/// The processes that compute a sweep together. Of the remaining rows, process k mod count makes the k-th; process 0
/// writes all of them.
struct Processes {
  int rank = 0;
  int count = 1;
  std::function<void(const std::string& row)> send{};        ///< sends to process 0
  std::function<std::string(int rank)> receive{};            ///< receives the next row of a process
  std::function<bool(bool)> true_in_all{};                   ///< true if the argument is true in all processes
  std::function<std::uint64_t(std::uint64_t)> from_first{};  ///< returns the argument of process 0
};

struct SweepWanted {
  std::string file;
  int jobs = 1;  ///< number of threads of this process
  bool resume = false;
  std::optional<std::string> output{};  ///< absent for the standard output
  /// Returns the bytes of the output for a table in CSV. Empty: the table itself is written.
  std::function<std::string(const std::string& table)> written_as{};
};

/// Throws Failure, exit code 1, if a problem is not solved; the table is written nevertheless.
void run_sweep(const SweepWanted& wanted, const Processes& processes = {});

}  // namespace steadyslide::app
