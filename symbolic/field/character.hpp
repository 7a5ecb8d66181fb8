#pragma once
// The letters and digits of formulas written as text.

#include <cctype>

namespace steadyslide::symbolic {

inline bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
inline bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

}  // namespace steadyslide::symbolic
