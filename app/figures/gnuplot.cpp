#include "app/figures/gnuplot.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>

#include "app/terminal/failure.hpp"
#include "app/terminal/interrupt.hpp"

namespace steadyslide::app {
namespace {

[[noreturn]] void fail(const std::string& what) { throw Failure(ExitCode::failed, "gnuplot: " + what); }

/// A file in memory: the streams of the child, so that nothing can fill up and wait.
class Stream {
 public:
  Stream() : descriptor_(::memfd_create("steadyslide", MFD_CLOEXEC)) {
    if (descriptor_ < 0) fail(std::string("no memory for its streams: ") + std::strerror(errno));
  }
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;
  ~Stream() { ::close(descriptor_); }

  int descriptor() const { return descriptor_; }

  void write(std::string_view text) const {
    while (!text.empty()) {
      const ssize_t count = ::write(descriptor_, text.data(), text.size());
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) fail(std::string("its script cannot be written: ") + std::strerror(errno));
      text.remove_prefix(static_cast<std::size_t>(count));
    }
    ::lseek(descriptor_, 0, SEEK_SET);
  }

  std::string text() const {
    std::string result;
    std::array<char, 65536> block;
    ::lseek(descriptor_, 0, SEEK_SET);
    for (ssize_t n = 0; (n = ::read(descriptor_, block.data(), block.size())) > 0;) {
      result.append(block.data(), static_cast<std::size_t>(n));
    }
    return result;
  }

 private:
  int descriptor_;
};

constexpr int not_started = 127;

/// In the child: never returns. `trouble` is told why gnuplot did not start.
[[noreturn]] void become_gnuplot(const Stream& in, const Stream& out, const Stream& err, const Stream& trouble) {
  // With us it ends, however we do.
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
  std::signal(SIGPIPE, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  ::dup2(in.descriptor(), STDIN_FILENO);
  ::dup2(out.descriptor(), STDOUT_FILENO);
  ::dup2(err.descriptor(), STDERR_FILENO);
  ::setenv("LC_ALL", "C.UTF-8", 1);
  ::unsetenv("GNUTERM");
  ::execlp("gnuplot", "gnuplot", "--default-settings", "-", nullptr);
  const int error = errno;
  if (::write(trouble.descriptor(), &error, sizeof error) < 0) ::_exit(not_started);
  ::_exit(not_started);
}

/// gnuplot shows the line it stumbles over, then says what is wrong.
std::string last_line(std::string text) {
  text.erase(text.find_last_not_of(" \t\r\n") + 1);
  if (text.empty()) return "no message";
  const std::size_t begin = text.find_first_not_of(' ', text.rfind('\n') + 1);
  return text.substr(begin);
}

/// The errno of a child that did not become gnuplot; 0: it did.
int trouble_of(const Stream& trouble) {
  const std::string bytes = trouble.text();
  int error = 0;
  if (bytes.size() == sizeof error) std::memcpy(&error, bytes.data(), sizeof error);
  return error;
}

}  // namespace

std::string run_gnuplot(const std::string& script) {
  const Stream in;
  in.write(script);
  const Stream out;
  const Stream err;
  const Stream trouble;
  pid_t child = 0;
  {
    // The child must not run our handlers, which would remove our files.
    const SignalsHeld held;
    child = ::fork();
    if (child == 0) become_gnuplot(in, out, err, trouble);
  }
  if (child < 0) fail(std::string("cannot be run: ") + std::strerror(errno));
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (const int error = trouble_of(trouble); error == ENOENT) {
    fail("not found; figures are drawn by gnuplot 5.4 or later (Debian's package gnuplot-nox)");
  } else if (error != 0) {
    fail(std::string("cannot be run: ") + std::strerror(error));
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    fail(fmt::format("did not draw the figure: {}", last_line(err.text())));
  }
  return out.text();
}

}  // namespace steadyslide::app
