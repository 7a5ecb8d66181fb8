#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <system_error>

namespace steadyslide::library {

/// A file with a mistake in its content. what() is "FILE:LINE: what is wrong; the rule; the value".
class InvalidFile : public std::invalid_argument {
 public:
  explicit InvalidFile(const std::string& what) : std::invalid_argument(what) {}
  /// `place`: "FILE:LINE".
  InvalidFile(const std::string& place, const std::string& complaint)
      : std::invalid_argument(place + ": " + complaint), complaint_begins_(place.size() + 2) {}

  /// Returns what() without the place.
  std::string complaint() const { return what() + complaint_begins_; }

 private:
  std::size_t complaint_begins_ = 0;
};

/// A file that cannot be read. what() is "FILE: cannot be read: why", code() is the system's error number.
struct UnreadableFile : std::system_error {
  UnreadableFile(const std::string& file, int error)
      : std::system_error(error, std::generic_category(), file + ": cannot be read") {}
};

}  // namespace steadyslide::library
