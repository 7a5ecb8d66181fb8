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
#include <utility>

#include "proofs_checks/kit/transport.hpp"

namespace steadyslide::proofs_checks {
namespace {

[[noreturn]] void fail(const char* what) { throw std::system_error(errno, std::generic_category(), what); }

/// False where the other side has gone.
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

/// Numbers of claims come in, reports go out, until the other side closes. False where that was too early.
bool answer(int socket, std::span<const Claim> claims, const Context& context) noexcept {
  std::size_t index = 0;
  while (receive_all(socket, reinterpret_cast<char*>(&index), sizeof index)) {
    const std::string bytes = to_bytes(run(claims[index], context));
    const std::size_t size = bytes.size();
    if (!send_all(socket, reinterpret_cast<const char*>(&size), sizeof size)) return false;
    if (!send_all(socket, bytes.data(), size)) return false;
  }
  return true;
}

/// A process that examines claims. Destruction ends it.
class Worker {
 public:
  Worker(std::span<const Claim> claims, const Context& context) {
    int sockets[2];
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets) != 0) fail("no socket for a process");
    std::fflush(nullptr);  // else what waits to be written would be written twice
    const pid_t parent = ::getpid();
    child_ = ::fork();
    if (child_ == 0) {
      ::prctl(PR_SET_PDEATHSIG, SIGKILL);
      ::close(sockets[0]);
      ::_exit(::getppid() == parent && answer(sockets[1], claims, context) ? 0 : 1);
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
    ::shutdown(socket_, SHUT_RDWR);  // closing is not enough: later processes have a copy
    ::close(socket_);
    if (child_ == 0) return;
    if (claim) ::kill(child_, SIGKILL);
    wait();
  }

  int socket() const { return socket_; }
  std::optional<std::size_t> claim;  ///< that it examines

  void examine(std::size_t index) {
    claim = index;
    send_all(socket_, reinterpret_cast<const char*>(&index), sizeof index);  // if it has gone, report() says so
  }
  /// On its claim; nothing where it has ended.
  std::optional<Report> report(std::span<const Claim> claims) {
    std::size_t size = 0;
    std::string bytes;
    if (!receive_all(socket_, reinterpret_cast<char*>(&size), sizeof size)) return std::nullopt;
    bytes.resize(size);
    if (!receive_all(socket_, bytes.data(), size)) return std::nullopt;
    return report_from(bytes, claims[*std::exchange(claim, std::nullopt)]);
  }
  /// Waits for its end: "by signal 11", "with exit code 1".
  std::string wait() {
    int status = 0;
    while (::waitpid(child_, &status, 0) < 0 && errno == EINTR) {
    }
    child_ = 0;
    claim.reset();
    return WIFSIGNALED(status) ? "by signal " + std::to_string(WTERMSIG(status))
                               : "with exit code " + std::to_string(WEXITSTATUS(status));
  }

 private:
  pid_t child_ = 0;
  int socket_ = -1;
};

}  // namespace

unsigned available_processes() {
  cpu_set_t cores;
  if (::sched_getaffinity(0, sizeof cores, &cores) != 0) return 1;
  return static_cast<unsigned>(std::max(1, CPU_COUNT(&cores)));
}

std::vector<Report> run_in_processes(std::span<const Claim> claims, const Context& context, unsigned processes,
                                     const Progress& progress) {
  std::vector<std::optional<Report>> reports(claims.size());
  std::vector<std::unique_ptr<Worker>> workers;
  std::size_t next = 0;
  const auto give_next = [&](Worker& worker) {
    if (next == claims.size()) return;
    if (progress) progress(next, claims.size(), claims[next]);
    worker.examine(next++);
  };
  while (workers.size() < std::min<std::size_t>(processes, claims.size())) {
    workers.push_back(std::make_unique<Worker>(claims, context));
    give_next(*workers.back());
  }
  for (std::size_t done = 0; done < claims.size();) {
    std::vector<pollfd> waiting;
    for (const auto& worker : workers) waiting.push_back({worker->claim ? worker->socket() : -1, POLLIN, 0});
    if (::poll(waiting.data(), waiting.size(), -1) < 0) {
      if (errno == EINTR) continue;
      fail("the processes of a run cannot be waited for");
    }
    for (std::size_t k = 0; k < workers.size(); ++k) {
      if (waiting[k].revents == 0) continue;
      const std::size_t index = *workers[k]->claim;
      reports[index] = workers[k]->report(claims);
      if (!reports[index]) {
        const std::string note = "the check ended its process " + workers[k]->wait();
        reports[index] = Report{claims[index], Verdict::undecided, {}, note, {}, 0};
        if (next < claims.size()) workers[k] = std::make_unique<Worker>(claims, context);
      }
      ++done;
      give_next(*workers[k]);
    }
  }
  std::vector<Report> result;
  for (std::optional<Report>& report : reports) result.push_back(std::move(*report));
  return result;
}

}  // namespace steadyslide::proofs_checks
