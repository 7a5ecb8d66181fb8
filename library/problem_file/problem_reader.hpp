#pragma once
// Typed access to the values of a document by field, "indenter.pieces[2].to". Every error is an InvalidFile that names
// the file, the line and the field.

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "library/problem_file/document.hpp"
#include "library/problem_file/file_error.hpp"
#include "library/text/one_line.hpp"
#include "model/invalid_data.hpp"
#include "model/rational.hpp"

namespace steadyslide::library {

class ProblemReader {
 public:
  /// `kind` names the expected document in messages.
  ProblemReader(const Value& root, std::string file, std::string kind = "a problem file")
      : root_(root), file_(std::move(file)), kind_(std::move(kind)) {}

  /// "FILE:LINE: FIELD: WHAT", with the line of the deepest part of the field that exists in the file.
  InvalidFile error(const std::string& field, const std::string& what) const;
  InvalidFile error(const std::string& field, const std::string& what, const std::string& rule,
                    const std::string& value) const;
  /// Returns what `make` returns. An InvalidData of the model becomes an error of the field `prefix` + its field.
  template <class Make>
  auto accepted(const std::string& prefix, Make make) const {
    try {
      return make();
    } catch (const InvalidData& invalid) {
      throw error(prefix + invalid.field(), invalid.what());
    }
  }

  /// Null if the field is absent.
  const Value* find(const std::string& field) const { return locate(field).value; }
  /// Throws InvalidFile with this rule if the field is absent.
  const Value& required(const std::string& field, const std::string& rule) const;
  /// Throws InvalidFile if the field is not a table, and for its first key that is not in `keys`.
  void check_table(const std::string& field, std::initializer_list<std::string_view> keys) const;
  void check_keys(const std::string& field, std::initializer_list<std::string_view> keys) const;

  Rational number(const std::string& field, const Value& value) const;
  Rational number(const std::string& field, const std::string& rule) const {
    return number(field, required(field, rule));
  }
  std::optional<Rational> number_if_any(const std::string& field) const;
  const std::string& text(const std::string& field, const Value& value) const;
  const std::vector<Value>& list(const std::string& field, const Value& value, const std::string& of,
                                 std::size_t most) const;
  /// Empty if the field is absent.
  std::vector<Rational> numbers(const std::string& field, std::size_t most) const;
  /// Returns which of two words the field has, and the first one if the field is absent. `what` is the error for other
  /// words.
  template <class Choice>
  Choice choice(const std::string& field, const std::string& what, const std::pair<std::string, Choice>& first,
                const std::pair<std::string, Choice>& second) const {
    const Value* value = find(field);
    if (value == nullptr || text(field, *value) == first.first) return first.second;
    if (value->text == second.first) return second.second;
    throw error(field, what, "it is " + first.first + " or " + second.first, excerpt(value->text));
  }

 private:
  struct Found {
    const Value* value;
    std::size_t line;
    const std::string* file;

    std::string place() const;
  };
  /// Returns the value at "a.b[2].c", or null and the line of the deepest part that exists.
  Found locate(std::string_view field) const;

  const Value& root_;
  std::string file_;
  std::string kind_;
};

}  // namespace steadyslide::library
