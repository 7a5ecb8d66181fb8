#include "app/document_limits.hpp"

#include <fmt/format.h>

#include "app/failure.hpp"

namespace steadyslide::app {
namespace {

constexpr std::size_t max_values = 200000;
constexpr std::size_t max_depth = 32;

/// Follows strings and comments just enough to count what stands outside of them.
class Scanner {
 public:
  Scanner(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  void scan() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      switch (c) {
        case '"':
        case '\'': skip_string(c); continue;
        case '#': skip_comment(); continue;
        case '\n':
          ++line_;
          dots_ = 0;
          break;
        case '.': check(++dots_ <= max_depth, "key too deep", "a key has at most 32 parts"); break;
        case '=': count(); break;
        case ',': count(); break;
        case '[':
        case '{':
          check(++depth_ <= max_depth, "nested too deep", "brackets nest at most 32 deep");
          count();
          break;
        case ']':
        case '}':
          depth_ -= depth_ > 0 ? 1 : 0;
          dots_ = 0;
          break;
        default: break;
      }
      ++at_;
    }
  }

 private:
  void check(bool fine, const char* problem, const char* rule) const {
    if (!fine) throw Failure(ExitCode::bad_input, fmt::format("{}:{}: {}; {}; more", name_, line_, problem, rule));
  }

  void count() {
    dots_ = 0;
    check(++values_ <= max_values, "too many values", "a problem file has at most 200000 keys and values");
  }

  void skip_comment() {
    while (at_ < text_.size() && text_[at_] != '\n') ++at_;
  }

  void skip_string(char quote) {
    const std::string three(3, quote);
    if (text_.substr(at_, 3) == three) {
      std::size_t end = text_.find(three, at_ + 3);
      while (quote == '"' && end != std::string_view::npos && escaped(end)) end = text_.find(three, end + 1);
      const std::size_t after = end == std::string_view::npos ? text_.size() : end + 3;
      for (; at_ < after; ++at_) line_ += text_[at_] == '\n' ? 1 : 0;
      return;
    }
    for (++at_; at_ < text_.size() && text_[at_] != '\n'; ++at_) {
      if (text_[at_] == quote) {
        ++at_;
        return;
      }
      if (quote == '"' && text_[at_] == '\\' && at_ + 1 < text_.size() && text_[at_ + 1] != '\n') ++at_;
    }
  }

  bool escaped(std::size_t at) const {
    std::size_t backslashes = 0;
    while (text_[at - 1 - backslashes] == '\\') ++backslashes;
    return backslashes % 2 == 1;
  }

  std::string_view text_;
  const std::string& name_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
  std::size_t depth_ = 0;
  std::size_t dots_ = 0;
  std::size_t values_ = 0;
};

}  // namespace

void check_document_limits(std::string_view text, const std::string& name) { Scanner(text, name).scan(); }

}  // namespace steadyslide::app
