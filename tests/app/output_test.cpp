// Files written whole or not at all, and what happens when they cannot be.

#include <doctest/doctest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>

#include "app/process.hpp"

using namespace steadyslide::testing;
namespace fs = std::filesystem;

namespace {

const std::vector<std::string> small_table{"table", "--poisson", "0.3", "--rear", "0.2", "--front", "0.4"};

std::vector<std::string> with(std::vector<std::string> arguments, const std::vector<std::string>& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

}  // namespace

TEST_CASE("-o writes what the standard output would get, replaces, and leaves nothing else") {
  const TemporaryFolder folder;
  const Finished plain = run_program(small_table, folder.path());
  REQUIRE(plain.code == 0);
  folder.write("result", std::string(100000, 'x'));
  fs::permissions(folder.path() / "result", fs::perms(0640));
  const Finished finished = run_program(with(small_table, {"-o", "result"}), folder.path());
  CHECK(finished.code == 0);
  CHECK(finished.out == "");
  CHECK(folder.read("result") == plain.out);
  CHECK(fs::status(folder.path() / "result").permissions() == fs::perms(0640));
  CHECK(folder.names() == std::vector<std::string>{"result"});
}

TEST_CASE("a new file has the permissions that new files have") {
  const TemporaryFolder folder;
  CHECK(run_program(with(small_table, {"-o", "result"}), folder.path()).code == 0);
  const mode_t mask = ::umask(0);
  ::umask(mask);
  CHECK(fs::status(folder.path() / "result").permissions() == fs::perms(0666 & ~mask));
}

TEST_CASE("a symbolic link stays, the file it names is replaced") {
  const TemporaryFolder folder;
  folder.write("target", "earlier");
  fs::create_symlink("target", folder.path() / "link");
  CHECK(run_program(with(small_table, {"-o", "link"}), folder.path()).code == 0);
  CHECK(fs::is_symlink(folder.path() / "link"));
  CHECK(folder.read("target").substr(0, 2) == "nu");
}

TEST_CASE("devices are written, not replaced") {
  const TemporaryFolder folder;
  CHECK(run_program(with(small_table, {"-o", "/dev/null"}), folder.path()).code == 0);
  CHECK(fs::is_character_file("/dev/null"));
}

TEST_CASE("what cannot be read or written is exit code 3") {
  const TemporaryFolder folder;
  fs::create_directory(folder.path() / "folder");
  const auto check = [&](const std::vector<std::string>& arguments, const std::string& message) {
    const Finished finished = run_program(arguments, folder.path());
    CHECK(finished.err == "steadyslide: " + message + "\n");
    CHECK(finished.code == 3);
    CHECK(finished.out == "");
  };
  check({"solve", "none.toml"}, "none.toml: cannot be read: No such file or directory");
  check({"exponents", "folder"}, "folder: cannot be read: Is a directory");
  check(with(small_table, {"-o", "none/result"}), "none/result: cannot be written: No such file or directory");
  check(with(small_table, {"-o", "folder"}), "folder: cannot be written: Is a directory");
  check(with(small_table, {"-o", "/dev/full"}), "/dev/full: cannot be written: No space left on device");
  CHECK(folder.names() == std::vector<std::string>{"folder"});
}

TEST_CASE("a file without write permission is left alone") {
  if (::geteuid() == 0) return;  // root may write everything
  const TemporaryFolder folder;
  folder.write("result", "earlier");
  fs::permissions(folder.path() / "result", fs::perms(0440));
  CHECK(run_program(with(small_table, {"-o", "result"}), folder.path()).code == 3);
  CHECK(folder.read("result") == "earlier");
}

TEST_CASE("a full device and a closed pipe are failures") {
  const TemporaryFolder folder;
  for (const auto& arguments :
       {small_table, std::vector<std::string>{"--help"}, std::vector<std::string>{"--version"}}) {
    const Finished full = run_program(arguments, folder.path(), "", Stdout::full_device);
    CHECK(full.err == "steadyslide: standard output: cannot be written: No space left on device\n");
    CHECK(full.code == 3);
    const Finished closed = run_program(arguments, folder.path(), "", Stdout::closed_pipe);
    CHECK(closed.err == "steadyslide: standard output: cannot be written: Broken pipe\n");
    CHECK(closed.code == 3);
  }
}

TEST_CASE("an interrupted run leaves no file and says 130") {
  for (const int signal : {SIGINT, SIGTERM}) {
    const TemporaryFolder folder;
    folder.write("result", "earlier");
    const Finished finished = run_and_interrupt({"table", "--poisson=-0.5:0.45:0.01", "--rear", "0:1:0.01", "--front",
                                                 "0:1:0.01", "--digits", "100", "-o", "result"},
                                                folder, signal);
    CHECK(finished.code == 130);
    CHECK(folder.names() == std::vector<std::string>{"result"});
    CHECK(folder.read("result") == "earlier");
  }
}
