#pragma once

#include <stdexcept>

namespace steadyslide::library {

/// A file that is not of its kind. what() is "FILE:LINE: what is wrong; the rule; the value".
struct InvalidFile : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// A file that the system does not give. what() is "FILE: cannot be read: why".
struct UnreadableFile : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace steadyslide::library
