#pragma once

#include <cstddef>
#include <string_view>

namespace steadyslide::library {

struct Utf8Character {
  char32_t code;
  std::size_t length;  ///< in bytes; 0: the text begins with no character of UTF-8
};

/// The first character of a text that is not empty.
Utf8Character first_character(std::string_view text);

}  // namespace steadyslide::library
