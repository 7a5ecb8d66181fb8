#include "library/text/one_line.hpp"

#include <fmt/format.h>

#include <cstdint>

#include "library/text/utf8.hpp"

namespace steadyslide::library {
namespace {

constexpr std::size_t longest_line = 600;
constexpr std::size_t longest_word = 80;
constexpr std::size_t longest_excerpt = 40;

/// The length of the printable UTF-8 character at the start of `text`; 0 if there is none.
std::size_t printable_length(std::string_view text) {
  const auto [code, length] = first_character(text);
  const bool unprintable = code < 0x20 || (code >= 0x7f && code < 0xa0) || (code >= 0x2028 && code <= 0x202e) ||
                           (code >= 0x2066 && code <= 0x2069) || code == 0xfeff;
  return unprintable ? 0 : length;
}

}  // namespace

std::string one_line(std::string_view text) {
  std::string line;
  std::size_t word = 0;
  while (!text.empty()) {
    if (line.size() >= longest_line) return line + "...";
    const std::size_t length = printable_length(text);
    word = text.front() == ' ' ? 0 : word + 1;
    if (word == longest_word) line += "...";
    if (word < longest_word) {
      line += length != 0 ? std::string(text.substr(0, length))
                          : fmt::format("\\x{:02x}", static_cast<std::uint8_t>(text.front()));
    }
    text.remove_prefix(length != 0 ? length : 1);
  }
  return line;
}

std::string excerpt(std::string_view text) {
  if (text.size() <= longest_excerpt) return fmt::format("'{}'", one_line(text));
  std::size_t end = longest_excerpt;
  while (end > 0 && (static_cast<std::uint8_t>(text[end]) & 0xc0U) == 0x80) --end;
  return fmt::format("'{}...'", one_line(text.substr(0, end)));
}

}  // namespace steadyslide::library
