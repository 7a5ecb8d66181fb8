#include "checker/failure.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

namespace steadyslide::checker {
namespace {

constexpr std::size_t longest_line = 600;

/// Returns the length of the UTF-8 character at `at` if a terminal prints it; 0 if it is a control character or
/// invalid.
std::size_t printable_length(const std::string& text, std::size_t at) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned>(static_cast<unsigned char>(text[k])); };
  const unsigned first = byte(at);
  if (first < 0x80) return first >= 0x20 && first != 0x7f ? 1 : 0;
  const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4 || at + length > text.size()) return 0;
  unsigned code = first & (0x7fU >> length);
  for (std::size_t k = 1; k < length; ++k) {
    if ((byte(at + k) & 0xc0U) != 0x80) return 0;
    code = (code << 6U) | (byte(at + k) & 0x3fU);
  }
  constexpr std::array<unsigned, 5> least{0, 0, 0x80, 0x800, 0x10000};
  const bool character = code >= least.at(length) && code <= 0x10ffff && (code < 0xd800 || code > 0xdfff);
  const bool obeyed =
      code < 0xa0 || (code >= 0x2028 && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069) || code == 0xfeff;
  return character && !obeyed ? length : 0;
}

}  // namespace

std::string one_line(const std::string& text) {
  std::string line;
  for (std::size_t at = 0; at < text.size();) {
    if (line.size() >= longest_line) return line + "...";
    const std::size_t length = printable_length(text, at);
    if (length > 0) {
      line += text.substr(at, length);
    } else {
      std::array<char, 5> escaped{};
      std::snprintf(escaped.data(), escaped.size(), "\\x%02x",
                    static_cast<unsigned>(static_cast<unsigned char>(text[at])));
      line += escaped.data();
    }
    at += std::max<std::size_t>(length, 1);
  }
  return line;
}

}  // namespace steadyslide::checker
