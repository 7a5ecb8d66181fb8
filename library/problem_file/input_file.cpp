#include "library/problem_file/input_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <memory>

#include "library/problem_file/file_error.hpp"

namespace steadyslide::library {
namespace {

int close_input(std::FILE* file) { return file == stdin ? 0 : std::fclose(file); }
using InputFile = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

InputFile opened(const std::string& name, const std::string& kind) {
  if (name == "-" || name == "/dev/stdin") return {stdin, close_input};
  // Opening a pipe would wait for its writer.
  const int descriptor = ::open(name.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
  if (descriptor < 0) throw UnreadableFile(name, errno);
  InputFile file(::fdopen(descriptor, "r"), close_input);
  struct stat found {};
  if (!file || ::fstat(descriptor, &found) != 0) throw UnreadableFile(name, errno);
  if (S_ISDIR(found.st_mode)) throw UnreadableFile(name, EISDIR);
  if (!S_ISREG(found.st_mode)) {
    throw InvalidFile(name + ":1: no regular file; " + kind + " is one, or comes from the standard input; " +
                      (S_ISFIFO(found.st_mode) ? "a pipe" : "a device"));
  }
  return file;
}

}  // namespace

std::string read_input(const std::string& name, const std::string& kind) {
  constexpr std::size_t max_size = std::size_t{64} << 20;
  const InputFile file = opened(name, kind);
  std::string text;
  std::array<char, 65536> block;
  for (std::size_t count = 0; (count = std::fread(block.data(), 1, block.size(), file.get())) > 0;) {
    text.append(block.data(), count);
    if (text.size() > max_size) {
      throw InvalidFile(name + ":1: file too large; " + kind + " has at most 64 MiB; more");
    }
  }
  if (std::ferror(file.get()) != 0) throw UnreadableFile(name, errno);
  return text;
}

}  // namespace steadyslide::library
