#include "app/problem_file/document_text.hpp"

#include <fmt/format.h>

#include "app/terminal/failure.hpp"
#include "app/terminal/utf8.hpp"

namespace steadyslide::app {
namespace {

constexpr std::size_t max_values = 200000;
constexpr std::size_t max_depth = 32;

/// Follows strings and comments just enough to know what stands outside of them.
class Scanner {
 public:
  Scanner(std::string_view text, const std::string& name) : text_(text), name_(name) {
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
  /// What becomes of a character beyond ASCII.
  enum class Beyond { refused, escaped, dropped };

  [[noreturn]] void fail(const char* problem, const char* rule, const std::string& value) const {
    throw Failure(ExitCode::bad_input, fmt::format("{}:{}: {}; {}; {}", name_, line_, problem, rule, value));
  }

  void check(bool fine, const char* problem, const char* rule) const {
    if (!fine) fail(problem, rule, "more");
  }

  bool at(std::string_view part) const { return text_.substr(at_, part.size()) == part; }

  /// The next character, with the lines counted.
  void copy(Beyond beyond) {
    const Utf8Character character = first_character(text_.substr(at_));
    if (character.length == 0) fail("not UTF-8", "a problem file is encoded in UTF-8", excerpt(text_.substr(at_, 1)));
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
      check(++values_ <= max_values, "too many values", "a problem file has at most 200000 keys and values");
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
      // What a backslash escapes ends no string, and is no place for another escape.
      if (escape && at_ < text_.size() && (is_long || text_[at_] != '\n')) copy(Beyond::refused);
    }
    if (!at(delimiter)) return;
    for (std::size_t k = 0; k < delimiter.size(); ++k) copy(beyond);
    // A long string may end in one or two quotes of its own.
    for (int k = 0; is_long && k < 2 && at(delimiter.substr(0, 1)); ++k) copy(beyond);
  }

  std::string_view text_;
  const std::string& name_;
  std::string ascii_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
  std::size_t depth_ = 0;
  std::size_t dots_ = 0;
  std::size_t values_ = 0;
};

}  // namespace

std::string ready_for_parser(std::string_view text, const std::string& name) { return Scanner(text, name).scan(); }

}  // namespace steadyslide::app
