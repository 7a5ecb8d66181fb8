#pragma once
// Common parts of all tests.

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "model/rational.hpp"

namespace steadyslide::testing {}
using namespace steadyslide;
using namespace steadyslide::testing;

/// 0.3_r is exactly 3/10, not the double next to it.
inline Rational operator""_r(const char* number) { return parse_rational(number); }

/// Returns a whole number from low to high, both included, with equal chances. (rc::gen::inRange alone stays near `low`
/// in early tests.)
inline int uniform(int low, int high) { return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(low, high + 1)); }

inline bool holds(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

inline std::size_t times(const std::string& text, std::string_view part) {
  std::size_t n = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size()) ++n;
  return n;
}

inline std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> result;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) result.push_back(line);
  return result;
}

/// Returns the parts of a text between spaces.
inline std::vector<std::string> words(const std::string& text) {
  std::vector<std::string> result;
  std::istringstream stream(text);
  for (std::string word; stream >> word;) result.push_back(word);
  return result;
}

inline std::string file_text(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw std::runtime_error(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Reads a table of texts: a line that begins with "=== " is the heading of the text below it.
inline std::vector<std::pair<std::string, std::string>> sections_of(const std::string& file) {
  std::vector<std::pair<std::string, std::string>> sections;
  for (const std::string& line : lines(file_text(file))) {
    if (line.starts_with("=== ")) {
      sections.emplace_back(line.substr(4), "");
    } else if (!sections.empty()) {
      sections.back().second += line + '\n';
    }
  }
  return sections;
}

/// Returns the message of the exception that `act` throws, or "no error".
template <class F>
std::string thrown_by(const F& act) {
  try {
    act();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "no error";
}
