#pragma once
// Broken precondition of exact data: thrown by the constructors of the model, so that invalid data cannot exist.

#include <stdexcept>
#include <string>
#include <utility>

namespace steadyslide {

/// Says which datum is wrong, which rule it breaks, and its value.
/// `field` names the datum the way a problem file does ("friction.jumps[1]"), so that a reader can find its line.
/// Exported, whatever is hidden: programs catch what the shared library throws.
class __attribute__((visibility("default"))) InvalidData : public std::invalid_argument {
 public:
  /// Data of a file or of a caller, in the words that say which.
  explicit InvalidData(const std::string& complaint) : std::invalid_argument(complaint) {}
  InvalidData(std::string field, const std::string& problem, const std::string& rule, const std::string& value)
      : std::invalid_argument(problem + "; " + rule + "; " + value), field_(std::move(field)) {}

  const std::string& field() const noexcept { return field_; }

 private:
  std::string field_;
};

}  // namespace steadyslide
