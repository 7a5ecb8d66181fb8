#include "app/sweep/part_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "app/terminal/failure.hpp"

namespace steadyslide::app {

PartFile::PartFile(const std::string& file, const std::string& title, const std::string& header, bool resume)
    : name_(file + ".part"),
      descriptor_(::open(name_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC | O_NONBLOCK, 0666)),
      title_(title.size()) {
  if (descriptor_ < 0) fail("cannot be written");
  try {
    struct stat found {};
    if (::fstat(descriptor_, &found) != 0) fail("cannot be read");
    if (!S_ISREG(found.st_mode)) {
      throw Failure(ExitCode::bad_input,
                    name_ + ":1: no regular file; rows are kept in one until they are all there; a pipe or a device");
    }
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0) fail("another program writes it");
    read(title + header, resume);
  } catch (...) {
    ::close(descriptor_);
    throw;
  }
}

PartFile::~PartFile() { ::close(descriptor_); }

void PartFile::read(const std::string& first_lines, bool resume) {
  const std::string there = contents();
  const auto refuse = [&](const std::string& what, const std::string& rule, std::string_view value) {
    throw Failure(ExitCode::bad_input, fmt::format("{}:1: {}; {}; {}", name_, what, rule, excerpt(value)));
  };
  if (first_lines.starts_with(there)) {  // an empty file, or a part of the first two lines
    write(std::string_view(first_lines).substr(there.size()));
    return;
  }
  const std::string_view found = std::string_view(there).substr(0, there.find('\n'));
  if (!resume)
    refuse("rows of an interrupted sweep", "--resume goes on with them; without it there is no such file", found);
  if (!there.starts_with(first_lines)) {
    refuse("rows of another sweep", "--resume goes on with the same sweep, problem and version", found);
  }
  const std::size_t end = there.rfind('\n') + 1;
  if (end < there.size() && ::ftruncate(descriptor_, static_cast<off_t>(end)) != 0) fail("cannot be written");
  const auto first = there.begin() + static_cast<std::ptrdiff_t>(first_lines.size());
  rows_ = static_cast<std::size_t>(std::count(first, there.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
}

void PartFile::add(std::string_view row) {
  write(row);
  ++rows_;
}

std::string PartFile::table() const { return contents().substr(title_); }

void PartFile::remove() {
  if (::unlink(name_.c_str()) != 0) fail("cannot be removed");
}

std::string PartFile::contents() const {
  std::string text;
  std::array<char, 65536> block;
  ::lseek(descriptor_, 0, SEEK_SET);
  for (ssize_t count = 0; (count = ::read(descriptor_, block.data(), block.size())) != 0;) {
    if (count < 0) fail("cannot be read");
    text.append(block.data(), static_cast<std::size_t>(count));
  }
  return text;
}

void PartFile::write(std::string_view text) const {
  while (!text.empty()) {
    const ssize_t count = ::write(descriptor_, text.data(), text.size());
    if (count < 0 && errno != EINTR) fail("cannot be written");
    if (count > 0) text.remove_prefix(static_cast<std::size_t>(count));
  }
}

void PartFile::fail(const std::string& what) const {
  throw Failure(ExitCode::failed, fmt::format("{}: {}: {}", name_, what, std::strerror(errno)));
}

}  // namespace steadyslide::app
