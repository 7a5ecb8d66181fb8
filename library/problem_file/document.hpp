#pragma once
// A TOML document as plain data with line numbers. Only one source file includes the TOML library.

#include <string>
#include <string_view>
#include <vector>

namespace steadyslide::library {

struct Entry;

struct Value {
  enum class Kind { text, integer, decimal, boolean, date, list, table };

  Kind kind = Kind::table;
  std::size_t line = 1;
  const std::string* file = nullptr;  ///< the file of this value, if it is not the document's file
  std::string text;                   ///< a string; the shortest decimal of a number; true or false
  std::vector<Value> items;           ///< the items of a list
  std::vector<Entry> entries;         ///< the entries of a table, in the order of the text

  /// The entry with this key, or null.
  const Entry* find(std::string_view key) const;
};

struct Entry {
  std::string key;
  std::size_t line;
  std::size_t column;
  Value value;
};

/// Returns "a string", "an integer", ...
const char* name_of(Value::Kind kind);

/// Parses a TOML document. `kind` names the expected document in messages. Throws InvalidFile if the text is not TOML,
/// and if it is nested deeper or has more values than any problem file needs.
Value parse_document(std::string_view text, const std::string& name, const std::string& kind = "a problem file");

}  // namespace steadyslide::library
