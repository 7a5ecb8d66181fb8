#pragma once
// The two ways not to prove: what was read breaks a rule (exit code 2), or something is not decided (exit code 1).

#include <stdexcept>
#include <string>

namespace steadyslide::checker {

/// Safe to print on one line of a terminal: control characters and bytes that are not UTF-8 as \xNN, long lines shortened.
std::string one_line(const std::string& text);

/// "PLACE: what is wrong; the rule; the value", the value cut where it is long.
struct Malformed : std::runtime_error {
  Malformed(const std::string& place, const std::string& what, const std::string& rule, const std::string& value)
      : std::runtime_error(place + ": " + what + "; " + rule + "; " +
                           (value.size() > 60 ? value.substr(0, 60) + "..." : value)) {}
};

/// The place, and what is not proved there.
struct Unproved : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A sign that is the wrong one over all of the box: more digits do not help.
struct Refuted : Unproved {
  using Unproved::Unproved;
};

}  // namespace steadyslide::checker
