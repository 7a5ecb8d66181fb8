#pragma once
// Claims examined in several processes at a time: GiNaC and CLN allow no threads, but a process has its own.

#include "proofs_checks/kit/run.hpp"

namespace steadyslide::proofs_checks {

/// How many there can be at a time: the cores that the program may use.
unsigned available_processes();

/// As run_all() does, the same reports in the same order. A process takes the next claim when it is done with one;
/// `progress` is called when it does. A process that ends in the middle of a claim leaves it undecided, with a note how it
/// ended. Throws std::system_error where no process can be started.
std::vector<Report> run_in_processes(std::span<const Claim> claims, const Context& context, unsigned processes,
                                     const Progress& progress = {});

}  // namespace steadyslide::proofs_checks
