#pragma once
// Typed access to a document's values by field, "indenter.pieces[2].to"; every complaint names the file, the line and
// the field, and is an InvalidFile.

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
  /// `kind`: what the document is meant to be.
  ProblemReader(const Value& root, std::string file, std::string kind = "a problem file")
      : root_(root), file_(std::move(file)), kind_(std::move(kind)) {}

  /// "FILE:LINE: FIELD: WHAT", the line of the deepest part of the field that the file has.
  InvalidFile error(const std::string& field, const std::string& what) const;
  InvalidFile error(const std::string& field, const std::string& what, const std::string& rule,
                    const std::string& value) const;
  /// What `make` returns; the model's complaint as one about `prefix` + its field.
  template <class Make>
  auto accepted(const std::string& prefix, Make make) const {
    try {
      return make();
    } catch (const InvalidData& invalid) {
      throw error(prefix + invalid.field(), invalid.what());
    }
  }

  /// Null if absent.
  const Value* find(const std::string& field) const { return locate(field).value; }
  /// Complains, with this rule, if the field is absent.
  const Value& required(const std::string& field, const std::string& rule) const;
  /// Complains unless there is a table, and about its first key that is not one of these.
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
  /// None if absent.
  std::vector<Rational> numbers(const std::string& field, std::size_t most) const;
  /// Which of two words the field says, the first if it is absent. `what` is the complaint about others.
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
  /// The value at "a.b[2].c", or null and the line of the deepest part that exists.
  Found locate(std::string_view field) const;

  const Value& root_;
  std::string file_;
  std::string kind_;
};

}  // namespace steadyslide::library
