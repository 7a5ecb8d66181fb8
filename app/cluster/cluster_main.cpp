// steadyslide-sweep: the command `sweep` as a program of its own. It runs in as many processes as mpirun starts, and
// writes HDF5.

#include <fcntl.h>
#include <mpi.h>
#include <unistd.h>

#include <algorithm>
#include <vector>

#include "app/cluster/hdf5_table.hpp"
#include "app/commands/command_line.hpp"
#include "app/sweep/sweep_options.hpp"

#ifdef __SANITIZE_ADDRESS__
// Tells the leak sanitizer to report nothing here: Open MPI does not free all its memory.
extern "C" [[gnu::visibility("default")]] int __lsan_is_turned_off() { return 1; }
#endif

namespace {

using namespace steadyslide::app;

int rank_of_process = 0;
bool sweeping = false;  // true in all processes or in none

void send(const std::string& row) {
  MPI_Send(row.data(), static_cast<int>(row.size()), MPI_CHAR, 0, 0, MPI_COMM_WORLD);
}

std::string receive(int rank) {
  MPI_Status status;
  MPI_Probe(rank, 0, MPI_COMM_WORLD, &status);
  int size = 0;
  MPI_Get_count(&status, MPI_CHAR, &size);
  std::string row(static_cast<std::size_t>(size), '\0');
  MPI_Recv(row.data(), size, MPI_CHAR, rank, 0, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  return row;
}

/// True if the argument is true in all processes; sets `sweeping` to this.
bool true_in_all(bool fine) {
  int mine = fine ? 1 : 0;
  int least = 0;
  MPI_Allreduce(&mine, &least, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
  sweeping = least == 1;
  return sweeping;
}

std::uint64_t from_first(std::uint64_t number) {
  MPI_Bcast(&number, 1, MPI_UINT64_T, 0, MPI_COMM_WORLD);
  return number;
}

/// Returns the number of processes on this machine.
int processes_here() {
  MPI_Comm here = MPI_COMM_NULL;
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &here);
  int count = 1;
  MPI_Comm_size(here, &count);
  MPI_Comm_free(&here);
  return count;
}

ExitCode run(const Given& given) {
  SweepOptions options = read_sweep_options(given);
  if (options.hdf5) options.wanted.written_as = hdf5_of;
  // The processes on a machine share its cores.
  if (!given.has("--jobs")) options.wanted.jobs = std::max(1, options.wanted.jobs / processes_here());
  Processes processes{rank_of_process, 1, send, receive, true_in_all, from_first};
  MPI_Comm_size(MPI_COMM_WORLD, &processes.count);
  run_sweep(options.wanted, processes);
  return ExitCode::done;
}

}  // namespace

int main(int argc, char** argv) {
  // Rows are sent by the thread that has the next one; only one thread sends at a time.
  int provided = MPI_THREAD_SINGLE;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_SERIALIZED, &provided);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_of_process);
  const bool silent = rank_of_process != 0;
  if (silent) {
    // Only one process reports the errors of the sweep.
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    ::dup2(nowhere, STDOUT_FILENO);
    ::dup2(nowhere, STDERR_FILENO);
  }
  const int code = run_program({"steadyslide-sweep",
                                "Many problems, one row each: the command sweep of steadyslide for several processes\n"
                                "(mpirun -n N steadyslide-sweep SWEEP) and for HDF5.",
                                {sweep_command(run)}},
                               argc, argv);
  // Another process may be waiting for this one.
  if (sweeping && code == static_cast<int>(ExitCode::failed)) MPI_Abort(MPI_COMM_WORLD, code);
  MPI_Finalize();
  return silent ? 0 : code;
}
