#pragma once
// A TOML document as plain data with line numbers, so that only one source file sees the TOML library.

#include <string>
#include <string_view>
#include <vector>

namespace steadyslide::library {

struct Entry;

struct Value {
  enum class Kind { text, integer, decimal, boolean, date, list, table };

  Kind kind = Kind::table;
  std::size_t line = 1;
  const std::string* file = nullptr;  ///< where it stands, if that is another one than its document's
  std::string text;                   ///< of a string; of a number, the shortest decimal that gives it; true or false
  std::vector<Value> items;           ///< of a list
  std::vector<Entry> entries;         ///< of a table, in the order of the text

  /// The entry of this key, or null.
  const Entry* find(std::string_view key) const;
};

struct Entry {
  std::string key;
  std::size_t line;
  std::size_t column;
  Value value;
};

/// "a string", "an integer", ...
const char* name_of(Value::Kind kind);

/// `kind`: what it is meant to be. Throws InvalidFile for what is no TOML, and for documents nested so deep or with so
/// many values that no problem file needs them.
Value parse_document(std::string_view text, const std::string& name, const std::string& kind = "a problem file");

}  // namespace steadyslide::library
