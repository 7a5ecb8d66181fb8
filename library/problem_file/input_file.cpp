#include "library/problem_file/input_file.hpp"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "library/problem_file/file_error.hpp"

namespace steadyslide::library {

std::string read_input(const std::string& name, const std::string& kind) {
  constexpr std::size_t max_size = std::size_t{64} << 20;
  const auto unreadable = [&] {
    return UnreadableFile(fmt::format("{}: cannot be read: {}", name, std::strerror(errno)));
  };
  const auto close = [](std::FILE* file) { return file == stdin ? 0 : std::fclose(file); };
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(name == "-" ? stdin : std::fopen(name.c_str(), "re"),
                                                             close);
  if (!file) throw unreadable();
  std::string text;
  std::array<char, 65536> block;
  for (std::size_t count = 0; (count = std::fread(block.data(), 1, block.size(), file.get())) > 0;) {
    text.append(block.data(), count);
    if (text.size() > max_size) {
      throw InvalidFile(name + ":1: file too large; " + kind + " has at most 64 MiB; more");
    }
  }
  if (std::ferror(file.get()) != 0) throw unreadable();
  return text;
}

}  // namespace steadyslide::library
