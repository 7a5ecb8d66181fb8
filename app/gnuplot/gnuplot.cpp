#include "app/gnuplot/gnuplot.hpp"

#include <fmt/format.h>
#include <sys/wait.h>

#include <csignal>
#include <cstdio>
#include <cstring>

#include "app/terminal/failure.hpp"
#include "app/terminal/memory_file.hpp"

namespace steadyslide::app {
namespace {

[[noreturn]] void fail(const std::string& what) { throw Failure(ExitCode::failed, "gnuplot: " + what); }

/// gnuplot shows the wrong line first, then the reason.
std::string last_line(std::string text) {
  text.erase(text.find_last_not_of(" \t\r\n") + 1);
  if (text.empty()) return "no message";
  const std::size_t begin = text.find_first_not_of(' ', text.rfind('\n') + 1);
  return text.substr(begin);
}

/// Returns the text after the last ": ", or the whole text if there is none.
std::string after_last_colon(const std::string& text) {
  const std::size_t colon = text.rfind(": ");
  return colon == text.npos ? text : text.substr(colon + 2);
}

}  // namespace

std::string run_gnuplot(const std::string& script) try {
  const MemoryFile out, err;
  // If this process has been interrupted meanwhile, its files are gone. The shell must not say so on the terminal.
  const std::string command = fmt::format(
      "exec 2> /dev/null; exec 2> {}; exec /usr/bin/env -u GNUTERM LC_ALL=C.UTF-8 gnuplot --default-settings - > {}",
      err.path(), out.path());
  std::FILE* const in = ::popen(command.c_str(), "w");
  if (in == nullptr) fail(std::string("cannot be run: ") + std::strerror(errno));
  // If gnuplot ends early, SIGPIPE must not end this process.
  const auto on_broken_pipe = std::signal(SIGPIPE, SIG_IGN);
  const std::size_t written = std::fwrite(script.data(), 1, script.size(), in);
  const int status = ::pclose(in);
  std::signal(SIGPIPE, on_broken_pipe);
  const std::string complaint = last_line(err.text());
  // env exits with 127 if it does not find gnuplot, and with 126 if it cannot run it.
  switch (WIFEXITED(status) ? WEXITSTATUS(status) : -1) {
    case 0:
      if (written < script.size()) fail("did not read the whole script");
      return out.text();
    case 127: fail("not found; figures are drawn by gnuplot 5.4 or later (Debian's package gnuplot-nox)");
    case 126: fail("cannot be run: " + after_last_colon(complaint));
    default: fail("did not draw the figure: " + complaint);
  }
} catch (const std::system_error& error) {
  fail(error.what());
}

}  // namespace steadyslide::app
