#include "proofs_checks/kit/processes.hpp"

#include <poll.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <memory>
#include <optional>
#include <system_error>

#include "proofs_checks/kit/transport.hpp"

namespace steadyslide::proofs_checks {
namespace {

[[noreturn]] void fail(const char* what) { throw std::system_error(errno, std::generic_category(), what); }

/// Returns false if the other process has closed the socket.
bool send_all(int socket, const char* bytes, std::size_t size) {
  while (size > 0) {
    const ssize_t sent = ::send(socket, bytes, size, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    bytes += sent;
    size -= static_cast<std::size_t>(sent);
  }
  return true;
}

bool receive_all(int socket, char* bytes, std::size_t size) {
  while (size > 0) {
    const ssize_t received = ::recv(socket, bytes, size, 0);
    if (received < 0 && errno == EINTR) continue;
    if (received <= 0) return false;
    bytes += received;
    size -= static_cast<std::size_t>(received);
  }
  return true;
}

/// Receives numbers of tasks and sends their bytes until the other process closes the socket. Returns false if it
/// closed before it received the bytes of a task.
bool answer(int socket, const Task& task) noexcept {
  std::size_t index = 0;
  while (receive_all(socket, reinterpret_cast<char*>(&index), sizeof index)) {
    const std::string bytes = task(index);
    const std::size_t size = bytes.size();
    if (!send_all(socket, reinterpret_cast<const char*>(&size), sizeof size)) return false;
    if (!send_all(socket, bytes.data(), size)) return false;
  }
  return true;
}

/// A child process that runs tasks. The destructor ends it.
class Worker {
 public:
  explicit Worker(const Task& task) {
    int sockets[2];
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets) != 0) fail("no socket for a process");
    std::fflush(nullptr);  // otherwise both processes would write what the buffers hold
    const pid_t parent = ::getpid();
    child_ = ::fork();
    if (child_ == 0) {
      ::prctl(PR_SET_PDEATHSIG, SIGKILL);
      ::close(sockets[0]);
      ::_exit(::getppid() == parent && answer(sockets[1], task) ? 0 : 1);
    }
    ::close(sockets[1]);
    socket_ = sockets[0];
    if (child_ < 0) {
      ::close(socket_);
      fail("no process can be started");
    }
  }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;
  ~Worker() {
    ::shutdown(socket_, SHUT_RDWR);  // closing alone is not enough: children that start later inherit a copy
    ::close(socket_);
    if (child_ == 0) return;
    if (index) ::kill(child_, SIGKILL);
    wait();
  }

  int socket() const { return socket_; }
  std::optional<std::size_t> index;  ///< number of the current task

  void begin(std::size_t next) {
    index = next;
    send_all(socket_, reinterpret_cast<const char*>(&next), sizeof next);  // if the child has died, end() reports it
  }
  /// Returns the bytes of the current task, or how the process ended.
  TaskEnd end() {
    std::size_t size = 0;
    std::string bytes;
    bool received = receive_all(socket_, reinterpret_cast<char*>(&size), sizeof size);
    if (received) {
      bytes.resize(size);
      received = receive_all(socket_, bytes.data(), size);
    }
    index.reset();
    return received ? TaskEnd{bytes} : TaskEnd{std::nullopt, wait()};
  }
  bool has_ended() const { return child_ == 0; }

 private:
  /// Waits for the end of the process. Returns how it ended: "by signal 11", "with exit code 1".
  std::string wait() {
    int status = 0;
    while (::waitpid(child_, &status, 0) < 0 && errno == EINTR) {
    }
    child_ = 0;
    return WIFSIGNALED(status) ? "by signal " + std::to_string(WTERMSIG(status))
                               : "with exit code " + std::to_string(WEXITSTATUS(status));
  }

  pid_t child_ = 0;
  int socket_ = -1;
};

}  // namespace

unsigned available_processes() {
  cpu_set_t cores;
  if (::sched_getaffinity(0, sizeof cores, &cores) != 0) return 1;
  return static_cast<unsigned>(std::max(1, CPU_COUNT(&cores)));
}

std::vector<TaskEnd> do_in_processes(std::size_t count, unsigned processes, const Task& task,
                                     const std::function<void(std::size_t)>& begins) {
  std::vector<TaskEnd> ends(count);
  std::vector<std::unique_ptr<Worker>> workers;
  std::size_t next = 0;
  const auto give_next = [&](Worker& worker) {
    if (next == count) return;
    if (begins) begins(next);
    worker.begin(next++);
  };
  while (workers.size() < std::min<std::size_t>(processes, count)) {
    workers.push_back(std::make_unique<Worker>(task));
    give_next(*workers.back());
  }
  for (std::size_t done = 0; done < count;) {
    std::vector<pollfd> waiting;
    for (const auto& worker : workers) waiting.push_back({worker->index ? worker->socket() : -1, POLLIN, 0});
    if (::poll(waiting.data(), waiting.size(), -1) < 0) {
      if (errno == EINTR) continue;
      fail("the processes of a run cannot be waited for");
    }
    for (std::size_t k = 0; k < workers.size(); ++k) {
      if (waiting[k].revents == 0) continue;
      const std::size_t index = *workers[k]->index;
      ends[index] = workers[k]->end();
      ++done;
      if (workers[k]->has_ended() && next < count) workers[k] = std::make_unique<Worker>(task);
      give_next(*workers[k]);
    }
  }
  return ends;
}

std::vector<Report> run_in_processes(std::span<const Claim> claims, const Context& context, unsigned processes,
                                     const Progress& progress) {
  const std::vector<TaskEnd> ends = do_in_processes(
      claims.size(), processes, [&](std::size_t k) { return to_bytes(run(claims[k], context)); },
      [&](std::size_t k) {
        if (progress) progress(k, claims.size(), claims[k]);
      });
  std::vector<Report> reports;
  for (std::size_t k = 0; k < claims.size(); ++k) {
    const auto& [bytes, how] = ends[k];
    const std::string note = "the check ended its process " + how;
    reports.push_back(bytes ? report_from(*bytes, claims[k]) : Report{claims[k], Verdict::undecided, {}, note, {}, 0});
  }
  return reports;
}

}  // namespace steadyslide::proofs_checks
