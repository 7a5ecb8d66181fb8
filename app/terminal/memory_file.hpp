#pragma once
// Standard streams of another program as files in memory: they cannot fill up and make the program wait.

#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <string>
#include <string_view>
#include <system_error>

namespace steadyslide::app {

class MemoryFile {
 public:
  /// Holds the text; reading starts at its beginning. Throws std::system_error.
  explicit MemoryFile(std::string_view text = {}) : descriptor_(::memfd_create("steadyslide", MFD_CLOEXEC)) {
    if (descriptor_ < 0) throw std::system_error(errno, std::generic_category(), "no memory for its streams");
    while (!text.empty()) {
      const ssize_t count = ::write(descriptor_, text.data(), text.size());
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) throw std::system_error(errno, std::generic_category(), "its input cannot be written");
      text.remove_prefix(static_cast<std::size_t>(count));
    }
    ::lseek(descriptor_, 0, SEEK_SET);
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() { ::close(descriptor_); }

  int descriptor() const { return descriptor_; }
  /// The path by which another process opens it.
  std::string path() const { return "/proc/" + std::to_string(::getpid()) + "/fd/" + std::to_string(descriptor_); }

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

}  // namespace steadyslide::app
