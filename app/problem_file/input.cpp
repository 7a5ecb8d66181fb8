#include "app/problem_file/input.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "app/terminal/failure.hpp"

namespace steadyslide::app {
namespace {

constexpr std::size_t max_size = std::size_t{64} << 20;

class Descriptor {
 public:
  explicit Descriptor(const std::string& name)
      : number_(name == "-" ? STDIN_FILENO : ::open(name.c_str(), O_RDONLY | O_CLOEXEC)), owned_(name != "-") {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (owned_ && number_ >= 0) ::close(number_);
  }

  int number() const { return number_; }

 private:
  int number_;
  bool owned_;
};

}  // namespace

std::string read_input(const std::string& name, const std::string& kind) {
  const auto unreadable = [&] {
    return Failure(ExitCode::failed, fmt::format("{}: cannot be read: {}", name, std::strerror(errno)));
  };
  const Descriptor file(name);
  if (file.number() < 0) throw unreadable();
  std::string text;
  std::array<char, 65536> block;
  while (true) {
    const ssize_t count = ::read(file.number(), block.data(), block.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw unreadable();
    if (count == 0) return text;
    text.append(block.data(), static_cast<std::size_t>(count));
    if (text.size() > max_size) {
      throw Failure(ExitCode::bad_input, name + ":1: file too large; " + kind + " has at most 64 MiB; more");
    }
  }
}

}  // namespace steadyslide::app
