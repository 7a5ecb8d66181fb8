#pragma once
// The two kinds of failure: the input breaks a rule (exit code 2), or a statement is not decided (exit code 1).

#include <stdexcept>
#include <string>

namespace steadyslide::checker {

/// Returns text that is safe on one line of a terminal: control characters and bytes that are not UTF-8 appear as \xNN,
/// and long lines are shortened.
std::string one_line(const std::string& text);

/// The message is "PLACE: what is wrong; the rule; the value". A long value is shortened.
struct Malformed : std::runtime_error {
  Malformed(const std::string& place, const std::string& what, const std::string& rule, const std::string& value)
      : std::runtime_error(place + ": " + what + "; " + rule + "; " +
                           (value.size() > 60 ? value.substr(0, 60) + "..." : value)) {}
};

/// The message has the place and the statement that is not proved.
struct Unproved : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A sign is wrong over the whole box, so more digits do not help.
struct Refuted : Unproved {
  using Unproved::Unproved;
};

}  // namespace steadyslide::checker
