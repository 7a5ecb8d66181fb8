#include "app/gnuplot/gnuplot.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <cstring>

#include "app/terminal/child_process.hpp"
#include "app/terminal/failure.hpp"

namespace steadyslide::app {
namespace {

[[noreturn]] void fail(const std::string& what) { throw Failure(ExitCode::failed, "gnuplot: " + what); }

/// gnuplot shows the line it stumbles over, then says what is wrong.
std::string last_line(std::string text) {
  text.erase(text.find_last_not_of(" \t\r\n") + 1);
  if (text.empty()) return "no message";
  const std::size_t begin = text.find_first_not_of(' ', text.rfind('\n') + 1);
  return text.substr(begin);
}

}  // namespace

std::string run_gnuplot(const std::string& script) try {
  const MemoryFile out, err;
  const std::string command = fmt::format(
      "exec /usr/bin/env -u GNUTERM LC_ALL=C.UTF-8 gnuplot --default-settings - > {} 2> {}", out.path(), err.path());
  std::FILE* const in = ::popen(command.c_str(), "w");
  if (in == nullptr) fail(std::string("cannot be run: ") + std::strerror(errno));
  std::fwrite(script.data(), 1, script.size(), in);
  const int status = ::pclose(in);
  const std::string complaint = last_line(err.text());
  // These two are env's, of a program that it does not find or cannot run.
  switch (WIFEXITED(status) ? WEXITSTATUS(status) : -1) {
    case 0: return out.text();
    case 127: fail("not found; figures are drawn by gnuplot 5.4 or later (Debian's package gnuplot-nox)");
    case 126: fail("cannot be run: " + complaint.substr(complaint.rfind(": ") + 2));
    default: fail("did not draw the figure: " + complaint);
  }
} catch (const std::system_error& error) {
  fail(error.what());
}

}  // namespace steadyslide::app
