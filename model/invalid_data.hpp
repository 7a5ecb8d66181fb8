#pragma once
// The exception for invalid data. Constructors of the model throw it, so that no object with invalid data can exist.

#include <stdexcept>
#include <string>
#include <utility>

namespace steadyslide {

/// The message contains the wrong datum, the rule that it breaks, and its value.
/// `field` names the datum as a problem file does ("friction.jumps[1]"), so that a reader can find its line. Always
/// exported from the shared library, because programs catch it.
class __attribute__((visibility("default"))) InvalidData : public std::invalid_argument {
 public:
  /// Takes a complete message that names the datum.
  explicit InvalidData(const std::string& complaint) : std::invalid_argument(complaint) {}
  InvalidData(std::string field, const std::string& problem, const std::string& rule, const std::string& value)
      : std::invalid_argument(problem + "; " + rule + "; " + value), field_(std::move(field)) {}

  const std::string& field() const noexcept { return field_; }

 private:
  std::string field_;
};

}  // namespace steadyslide
