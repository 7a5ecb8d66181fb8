#pragma once
// A sweep from its file to its table: computed by threads, and by other processes where there are some.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "app/terminal/failure.hpp"

namespace steadyslide::app {

/// The processes that compute a sweep together: of the rows that are left the k-th is made by process k mod count, and
/// all are written by process 0.
struct Processes {
  int rank = 0;
  int count = 1;
  std::function<void(const std::string& row)> send{};      ///< to process 0
  std::function<std::string(int rank)> receive{};          ///< what this process has sent next
  std::function<bool(bool)> all{};                         ///< is it so in all processes?
  std::function<std::uint64_t(std::uint64_t)> of_first{};  ///< what process 0 says
};

struct SweepWanted {
  std::string file;
  int jobs = 1;  ///< threads of this process
  bool resume = false;
  std::optional<std::string> output{};  ///< absent: the standard output
  /// The bytes of the output, of a table in CSV; none: the table.
  std::function<std::string(const std::string& table)> written_as{};
};

/// Throws Failure: exit code 1 if a problem is not solved; the table is written all the same.
void run_sweep(const SweepWanted& wanted, const Processes& processes = {});

}  // namespace steadyslide::app
