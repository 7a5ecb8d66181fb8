// A long solve on cells that is interrupted: nothing half-written, and a clean terminal.

#include <csignal>

#include "app/command_line.hpp"

namespace {

const std::string rough = STEADYSLIDE_EXAMPLES "/rough_surface.toml";
/// More than a second's work.
const Arguments arguments{"solve", rough, "--method", "variational", "--cells", "1048576", "-o", "result"};

}  // namespace

TEST_CASE("interrupted after a second, a solve leaves no file, or the old one as it was") {
  for (const char* earlier : {"", "earlier"}) {
    const TemporaryFolder folder;
    if (*earlier != '\0') folder.write("result", earlier);
    const std::vector<std::string> names = folder.names();
    const Finished finished = run_and_interrupt(arguments, folder, SIGINT, std::chrono::seconds(1));
    CHECK(finished.code == 130);
    CHECK(finished.out == "");
    CHECK(finished.err == "");
    CHECK(folder.names() == names);
    CHECK(folder.read("result") == earlier);
  }
}

TEST_CASE("interrupted on a terminal, a solve erases its bar") {
  const TemporaryFolder folder;
  const Finished finished = interrupt_on_terminal(arguments, folder.path(), " % ETA ", SIGINT);
  CHECK(finished.code == 130);
  CHECK(folder.names().empty());
  check_erased(finished, " % ETA ");
}
