#pragma once
// Typed access to a document's values; every complaint names the file, the line and the key.

#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "app/problem_file/document.hpp"
#include "app/terminal/failure.hpp"
#include "model/invalid_data.hpp"
#include "model/rational.hpp"

namespace steadyslide::app {

class ProblemReader {
 public:
  ProblemReader(const Value& root, std::string file) : root_(root), file_(std::move(file)) {}

  const Value& root() const { return root_; }

  /// "FILE:LINE: FIELD: WHAT", the line of the deepest part of the field that the file has.
  Failure error(const std::string& field, const std::string& what) const;
  Failure error(const std::string& field, const std::string& what, const std::string& rule,
                const std::string& value) const;
  /// The model's complaint about `prefix` + its field.
  Failure error(const InvalidData& invalid, const std::string& prefix = "") const;

  /// Complains about the first key of the table that is not in `keys`.
  void check_keys(const std::string& field, std::initializer_list<std::string_view> keys) const;
  /// Null if absent.
  const Value* find(const std::string& field) const;
  const Value& required(const std::string& field, const std::string& rule) const;
  /// Complains unless the value at `field` is a table.
  void check_table(const std::string& field) const;

  Rational number(const std::string& field, const Value& value) const;
  const std::string& text(const std::string& field, const Value& value) const;
  const std::vector<Value>& list(const std::string& field, const Value& value, const std::string& of,
                                 std::size_t most) const;
  std::vector<Rational> numbers(const std::string& field, const Value& value, std::size_t most) const;

  std::size_t line_of(const std::string& field) const;

 private:
  struct Found {
    const Value* value;
    std::size_t line;
  };
  /// The value at "a.b[2].c", or null and the line of the deepest part that exists.
  Found locate(std::string_view field) const;

  const Value& root_;
  std::string file_;
};

}  // namespace steadyslide::app
