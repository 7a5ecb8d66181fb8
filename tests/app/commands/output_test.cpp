// Files are written completely or not at all, also when they cannot be written.

#include <sys/stat.h>
#include <unistd.h>
#include <csignal>

#include "app/command_line.hpp"

namespace fs = std::filesystem;

namespace {

const Arguments small_table = words("table --poisson 0.3 --rear 0.2 --front 0.4");

Arguments into(const std::string& file) { return joined(small_table, {"-o", file}); }

/// It works for more than a second.
const Arguments long_solve = joined({"solve", STEADYSLIDE_EXAMPLES "/rough_surface.toml"},
                                    words("--method variational --cells 1048576 -o result"));

}  // namespace

TEST_CASE("-o writes the text of the standard output, replaces the file, and leaves no other file") {
  const TemporaryFolder folder;
  const std::string plain = out_of(folder.run(small_table));
  folder.write("result", std::string(100000, 'x'));
  fs::permissions(folder.path() / "result", fs::perms(0640));
  CHECK(out_of(folder.run(into("result"))) == "");
  CHECK(folder.read("result") == plain);
  CHECK(fs::status(folder.path() / "result").permissions() == fs::perms(0640));
  CHECK(folder.names() == std::vector<std::string>{"result"});
}

TEST_CASE("-o keeps the permissions of new files, keeps a link and replaces its file, and writes to devices") {
  const TemporaryFolder folder{{"target", "earlier"}};
  fs::create_symlink("target", folder.path() / "link");
  for (const char* file : {"result", "link", "/dev/null"}) CHECK(folder.run(into(file)).code == 0);
  const mode_t mask = ::umask(0);
  ::umask(mask);
  CHECK(fs::status(folder.path() / "result").permissions() == fs::perms(0666 & ~mask));
  CHECK(fs::is_symlink(folder.path() / "link"));
  CHECK(folder.read("target").substr(0, 2) == "nu");
  CHECK(fs::is_character_file("/dev/null"));
}

TEST_CASE("a file that cannot be read or written gives exit code 3") {
  const TemporaryFolder folder;
  fs::create_directory(folder.path() / "folder");
  for (const auto& [arguments, message] : std::vector<std::pair<Arguments, std::string>>{
           {{"solve", "none.toml"}, "none.toml: cannot be read: No such file or directory"},
           {{"exponents", "folder"}, "folder: cannot be read: Is a directory"},
           {into("none/result"), "none/result: cannot be written: No such file or directory"},
           {into("folder"), "folder: cannot be written: Is a directory"},
           {into("/dev/full"), "/dev/full: cannot be written: No space left on device"}}) {
    check_refused(folder.run(arguments), message, 3);
  }
  CHECK(folder.names() == std::vector<std::string>{"folder"});
}

TEST_CASE("the exit code does not change if the standard error cannot be written") {
  const TemporaryFolder folder;
  const Arguments without_stderr{"sh", "-c", "exec \"$@\" 2> /dev/full", "sh"};
  CHECK(run_program_by(without_stderr, {"solve", "none.toml"}, folder.path()).code == 3);
  CHECK(run_program_by(without_stderr, {"solve"}, folder.path()).code == 2);
}

TEST_CASE("no input is a pipe or a device, except for the standard input") {
  const TemporaryFolder folder;
  REQUIRE(::mkfifo((folder.path() / "pipe").c_str(), 0600) == 0);
  const std::string problem =
      "load = 1\n[half_space]\npoisson = 0.3\n[friction]\nvalues = [0.1]\n[indenter]\nprofile = 0\n";
  folder.write("p.toml", problem);
  folder.write("trace.toml", replaced(problem, "profile = 0", "samples = \"pipe\""));
  folder.write("sweep.toml", "problem = \"pipe\"\n[vary]\nload = [1]\n");
  // Opening a pipe without a writer would block for ever.
  const auto refused = [&](const Arguments& arguments, const std::string& message) {
    check_refused(run_program_by({"timeout", "20"}, arguments, folder.path()), message);
  };
  const auto rule = [](const std::string& kind) {
    return ":1: no regular file; " + kind + " is one, or comes from the standard input; ";
  };
  refused({"exponents", "pipe"}, "pipe" + rule("a problem file") + "a pipe");
  refused({"solve", "/dev/zero"}, "/dev/zero" + rule("a problem file") + "a device");
  refused({"solve", "trace.toml"}, "pipe" + rule("a trace") + "a pipe");
  refused({"sweep", "pipe"}, "pipe" + rule("a sweep") + "a pipe");
  refused({"sweep", "sweep.toml"}, "pipe" + rule("a problem file") + "a pipe");
  refused({"solve", "p.toml", "--at-file", "pipe"}, "pipe" + rule("a table of places") + "a pipe");
  refused({"solve", "p.toml", "--stress-at", "pipe"}, "pipe" + rule("a table of points") + "a pipe");
  refused({"solve", "p.toml", "--loads-on", "pipe"}, "pipe" + rule("a mesh") + "a pipe");
  for (const char* input : {"-", "/dev/stdin"}) CHECK(out_of(folder.run({"solve", input}, problem)) != "");
}

TEST_CASE("a file without write permission is not changed") {
  if (::geteuid() == 0) return;  // root may write everywhere
  const TemporaryFolder folder{{"result", "earlier"}};
  fs::permissions(folder.path() / "result", fs::perms(0440));
  CHECK(folder.run(into("result")).code == 3);
  CHECK(folder.read("result") == "earlier");
}

TEST_CASE("a full device and a closed pipe are failures") {
  const TemporaryFolder folder;
  for (const Arguments& arguments : {small_table, {"--help"}, {"--version"}}) {
    check_refused(folder.run(arguments, "", Stdout::full_device),
                  "standard output: cannot be written: No space left on device", 3);
    check_refused(folder.run(arguments, "", Stdout::closed_pipe), "standard output: cannot be written: Broken pipe", 3);
  }
}

TEST_CASE("an interrupted run leaves no file and has exit code 130") {
  for (const int signal : {SIGINT, SIGTERM}) {
    const TemporaryFolder folder{{"result", "earlier"}};
    const Finished finished = run_and_interrupt(
        words("table --poisson=-0.5:0.45:0.01 --rear 0:1:0.01 --front 0:1:0.01 --digits 100 -o result"), folder,
        signal);
    CHECK(finished.code == 130);
    CHECK(folder.names() == std::vector<std::string>{"result"});
    CHECK(folder.read("result") == "earlier");
  }
}

TEST_CASE("a solve that is interrupted after a second leaves no file, or leaves the old one unchanged") {
  for (const char* earlier : {"", "earlier"}) {
    const TemporaryFolder folder;
    if (*earlier != '\0') folder.write("result", earlier);
    const std::vector<std::string> names = folder.names();
    const Finished finished = run_and_interrupt(long_solve, folder, SIGINT, std::chrono::seconds(1));
    CHECK(finished.code == 130);
    CHECK(finished.out == "");
    CHECK(finished.err == "");
    CHECK(folder.names() == names);
    CHECK(folder.read("result") == earlier);
  }
}

TEST_CASE("interrupted on a terminal, a solve erases its bar") {
  const TemporaryFolder folder;
  const Finished finished = interrupt_on_terminal(long_solve, folder.path(), " % ETA ", SIGINT);
  CHECK(finished.code == 130);
  CHECK(folder.names().empty());
  check_erased(finished, " % ETA ");
}
