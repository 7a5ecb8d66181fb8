#include "app/gnuplot/gnuplot.hpp"

#include <fmt/format.h>
#include <sys/prctl.h>

#include <csignal>
#include <cstdlib>
#include <cstring>

#include "app/terminal/child_process.hpp"
#include "app/terminal/failure.hpp"
#include "app/terminal/interrupt.hpp"

namespace steadyslide::app {
namespace {

[[noreturn]] void fail(const std::string& what) { throw Failure(ExitCode::failed, "gnuplot: " + what); }

constexpr int not_started = 127;

/// In the child: never returns. `trouble` is told why gnuplot did not start.
[[noreturn]] void become_gnuplot(const MemoryFile& in, const MemoryFile& out, const MemoryFile& err,
                                 const MemoryFile& trouble) {
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
int trouble_of(const MemoryFile& trouble) {
  const std::string bytes = trouble.text();
  int error = 0;
  if (bytes.size() == sizeof error) std::memcpy(&error, bytes.data(), sizeof error);
  return error;
}

}  // namespace

std::string run_gnuplot(const std::string& script) try {
  const MemoryFile in(script);
  const MemoryFile out;
  const MemoryFile err;
  const MemoryFile trouble;
  pid_t child = 0;
  {
    // The child must not run our handlers, which would remove our files.
    const SignalsHeld held;
    child = ::fork();
    if (child == 0) become_gnuplot(in, out, err, trouble);
  }
  if (child < 0) fail(std::string("cannot be run: ") + std::strerror(errno));
  const int code = wait_for(child);
  if (const int error = trouble_of(trouble); error == ENOENT) {
    fail("not found; figures are drawn by gnuplot 5.4 or later (Debian's package gnuplot-nox)");
  } else if (error != 0) {
    fail(std::string("cannot be run: ") + std::strerror(error));
  }
  if (code != 0) fail(fmt::format("did not draw the figure: {}", last_line(err.text())));
  return out.text();
} catch (const std::system_error& error) {
  fail(error.what());
}

}  // namespace steadyslide::app
