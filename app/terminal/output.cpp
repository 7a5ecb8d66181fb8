#include "app/terminal/output.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "app/terminal/failure.hpp"
#include "app/terminal/interrupt.hpp"

namespace steadyslide::app {
namespace {

constexpr std::size_t buffer_size = std::size_t{1} << 16;

/// Returns the permissions of a newly created file.
mode_t default_mode() {
  const mode_t mask = ::umask(0);
  ::umask(mask);
  return static_cast<mode_t>(0666) & ~mask;
}

}  // namespace

Output::Output(const std::optional<std::string>& file) : name_(file.value_or("standard output")) {
  if (!file) return;
  // Follows symbolic links: the link stays, and its target is replaced.
  std::error_code error;
  target_ = std::filesystem::weakly_canonical(*file, error).string();
  if (error || target_.empty()) target_ = *file;
  struct stat status {};
  const bool exists = ::stat(target_.c_str(), &status) == 0;
  if (exists && !S_ISREG(status.st_mode)) {
    descriptor_ = ::open(target_.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor_ < 0) fail("cannot be written");
    return;
  }
  if (exists && ::access(target_.c_str(), W_OK) != 0) fail("cannot be written");
  const SignalsHeld held;
  temporary_ = (std::filesystem::path(target_).parent_path() / ".steadyslide-XXXXXX").string();
  descriptor_ = ::mkostemp(temporary_.data(), O_CLOEXEC);
  if (descriptor_ < 0) {
    temporary_.clear();
    fail("cannot be written");
  }
  remove_when_interrupted(temporary_);
  ::fchmod(descriptor_, exists ? status.st_mode & 07777U : default_mode());
}

Output::~Output() {
  if (descriptor_ != STDOUT_FILENO && descriptor_ >= 0) ::close(descriptor_);
  if (temporary_.empty()) return;
  const SignalsHeld held;
  ::unlink(temporary_.c_str());
  keep_when_interrupted(temporary_);
}

void Output::write(std::string_view text) {
  buffer_ += text;
  if (buffer_.size() >= buffer_size) flush();
}

void Output::flush() {
  std::string_view rest = buffer_;
  while (!rest.empty()) {
    const ssize_t count = ::write(descriptor_, rest.data(), rest.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail("cannot be written");
    rest.remove_prefix(static_cast<std::size_t>(count));
  }
  buffer_.clear();
}

void Output::commit() {
  flush();
  if (temporary_.empty()) return;
  if (::fsync(descriptor_) != 0) fail("cannot be written");
  const SignalsHeld held;
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail("cannot be written");
  keep_when_interrupted(temporary_);
  temporary_.clear();
}

void write_whole(const std::optional<std::string>& file, std::string_view text) {
  Output output(file);
  output.write(text);
  output.commit();
}

bool make_folder(const std::string& folder) {
  std::error_code error;
  const bool is_new = std::filesystem::create_directories(folder, error);
  if (error) throw Failure(ExitCode::failed, fmt::format("{}: cannot be made: {}", folder, error.message()));
  return is_new;
}

void Output::fail(const std::string& what) const {
  throw Failure(ExitCode::failed, fmt::format("{}: {}: {}", name_, what, std::strerror(errno)));
}

}  // namespace steadyslide::app
