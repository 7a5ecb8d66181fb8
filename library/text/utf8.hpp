#pragma once

#include <cstddef>
#include <string_view>

namespace steadyslide::library {

struct Utf8Character {
  char32_t code;
  std::size_t length;  ///< in bytes; 0 if the text does not begin with a UTF-8 character
};

/// Returns the first character. The text must not be empty.
Utf8Character first_character(std::string_view text);

}  // namespace steadyslide::library
