#include "library/problem_file/document.hpp"

#include <fmt/format.h>

// The TOML library (3.3.0) asserts a condition that its next line tests and reports as an error of the document. With
// NDEBUG it tells the optimizer that the condition holds. Therefore its assertions are switched off here: the test
// decides.
#undef NDEBUG
#define TOML_ASSERT(expr) static_assert(true)
#define TOML_HEADER_ONLY 1
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "library/problem_file/file_error.hpp"
#include "library/text/one_line.hpp"
#include "library/text/utf8.hpp"

namespace steadyslide::library {
namespace {

constexpr std::size_t max_values = 200000;
constexpr std::size_t max_depth = 32;

/// Makes a text ready for the TOML library (3.3.0), which has three weaknesses: it recurses as deep as dotted keys go,
/// it keeps a hundred bytes for every value, and it reaches code that it declares unreachable if it looks for white
/// space and finds a character beyond ASCII. The scanner returns the same document in ASCII, line by line: characters
/// beyond ASCII are escaped in strings and dropped from comments. It follows strings and comments only as far as needed
/// to find the text outside of them.
class Scanner {
 public:
  Scanner(std::string_view text, const std::string& name, const std::string& kind)
      : text_(text), name_(name), kind_(kind) {
    ascii_.reserve(text.size());
    if (text_.starts_with("\xef\xbb\xbf")) at_ = 3;  // a byte order mark
  }

  std::string scan() && {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '"' || c == '\'') {
        copy_string(c);
      } else if (c == '#') {
        copy_comment();
      } else {
        count(c);
        copy(Beyond::refused);
      }
    }
    return std::move(ascii_);
  }

 private:
  /// The treatment of a character beyond ASCII.
  enum class Beyond { refused, escaped, dropped };

  [[noreturn]] void fail(const char* problem, const std::string& rule, const std::string& value) const {
    throw InvalidFile(fmt::format("{}:{}: {}; {}; {}", name_, line_, problem, rule, value));
  }

  void check(bool fine, const char* problem, const char* rule) const {
    if (!fine) fail(problem, rule, "more");
  }

  bool at(std::string_view part) const { return text_.substr(at_, part.size()) == part; }

  /// Copies the next character and counts lines.
  void copy(Beyond beyond) {
    const Utf8Character character = first_character(text_.substr(at_));
    if (character.length == 0) fail("not UTF-8", kind_ + " is encoded in UTF-8", excerpt(text_.substr(at_, 1)));
    if (character.length == 1) {
      ascii_ += text_[at_];
      if (text_[at_] == '\n') ++line_;
    } else if (beyond == Beyond::escaped) {
      ascii_ += character.code > 0xffff ? fmt::format("\\U{:08x}", static_cast<unsigned>(character.code))
                                        : fmt::format("\\u{:04x}", static_cast<unsigned>(character.code));
    } else if (beyond == Beyond::refused) {
      fail("unexpected character", "characters beyond ASCII stand in comments and in \"strings\"",
           excerpt(text_.substr(at_, character.length)));
    }
    at_ += character.length;
  }

  void count(char c) {
    if (c == '.') check(++dots_ <= max_depth, "key too deep", "a key has at most 32 parts");
    if (c == '[' || c == '{') check(++depth_ <= max_depth, "nested too deep", "brackets nest at most 32 deep");
    if ((c == ']' || c == '}') && depth_ > 0) --depth_;
    if (c == '=' || c == ',' || c == '[' || c == '{') {
      if (++values_ > max_values) fail("too many values", kind_ + " has at most 200000 keys and values", "more");
    }
    if (c != '.' && std::string_view("=,[]{}\n").find(c) != std::string_view::npos) dots_ = 0;
  }

  void copy_comment() {
    while (at_ < text_.size() && text_[at_] != '\n') copy(Beyond::dropped);
  }

  void copy_string(char quote) {
    const std::string three(3, quote);
    const bool is_long = at(three);
    const std::string_view delimiter = std::string_view(three).substr(0, is_long ? 3 : 1);
    const Beyond beyond = quote == '"' ? Beyond::escaped : Beyond::refused;
    for (std::size_t k = 0; k < delimiter.size(); ++k) copy(beyond);
    while (at_ < text_.size() && !at(delimiter) && (is_long || text_[at_] != '\n')) {
      const bool escape = quote == '"' && text_[at_] == '\\';
      copy(beyond);
      // A quote after a backslash does not end the string. An escaped character is not escaped again.
      if (escape && at_ < text_.size() && (is_long || text_[at_] != '\n')) copy(Beyond::refused);
    }
    if (!at(delimiter)) return;
    for (std::size_t k = 0; k < delimiter.size(); ++k) copy(beyond);
    // A long string may end in one or two quotes of its own.
    for (int k = 0; is_long && k < 2 && at(delimiter.substr(0, 1)); ++k) copy(beyond);
  }

  std::string_view text_;
  const std::string& name_;
  const std::string& kind_;
  std::string ascii_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
  std::size_t depth_ = 0;
  std::size_t dots_ = 0;
  std::size_t values_ = 0;
};

/// The line of a node. A table that only dotted keys imply has no line of its own: it gets `line`, the line of the
/// table that contains it.
std::size_t line_of(const toml::node& node, std::size_t line) {
  return node.source().begin.line != 0 ? node.source().begin.line : line;
}

Value converted(const toml::node& node, std::size_t enclosing_line) {
  Value value;
  value.line = line_of(node, enclosing_line);
  if (const toml::table* table = node.as_table()) {
    value.kind = Value::Kind::table;
    for (const auto& [key, child] : *table) {
      const std::size_t key_line = key.source().begin.line != 0 ? key.source().begin.line : value.line;
      value.entries.push_back(
          {std::string(key.str()), key_line, key.source().begin.column, converted(child, key_line)});
    }
    std::stable_sort(value.entries.begin(), value.entries.end(), [](const Entry& a, const Entry& b) {
      return std::pair(a.line, a.column) < std::pair(b.line, b.column);
    });
  } else if (const toml::array* array = node.as_array()) {
    value.kind = Value::Kind::list;
    value.items.reserve(array->size());
    for (const toml::node& child : *array) value.items.push_back(converted(child, value.line));
  } else if (const auto* text = node.as_string()) {
    value.kind = Value::Kind::text;
    value.text = text->get();
  } else if (const auto* integer = node.as_integer()) {
    value.kind = Value::Kind::integer;
    value.text = std::to_string(integer->get());
  } else if (const auto* decimal = node.as_floating_point()) {
    value.kind = Value::Kind::decimal;
    value.text = fmt::format("{}", decimal->get());
  } else if (const auto* boolean = node.as_boolean()) {
    value.kind = Value::Kind::boolean;
    value.text = boolean->get() ? "true" : "false";
  } else {
    value.kind = Value::Kind::date;
  }
  return value;
}

}  // namespace

const Entry* Value::find(std::string_view key) const {
  const auto entry = std::find_if(entries.begin(), entries.end(), [&](const Entry& entry) { return entry.key == key; });
  return entry == entries.end() ? nullptr : &*entry;
}

const char* name_of(Value::Kind kind) {
  constexpr std::array names{"a string",       "an integer", "a decimal number", "a boolean",
                             "a date or time", "an array",   "a table"};
  return names.at(static_cast<std::size_t>(kind));
}

Value parse_document(std::string_view text, const std::string& name, const std::string& kind) {
  const std::string ascii = Scanner(text, name, kind).scan();
  try {
    return converted(toml::parse(std::string_view(ascii)), 1);
  } catch (const toml::parse_error& error) {
    throw InvalidFile(fmt::format("{}:{}: not TOML; {} is written in TOML; {}", name,
                                  std::max<std::size_t>(error.source().begin.line, 1), kind,
                                  std::string(error.description())));
  }
}

}  // namespace steadyslide::library
