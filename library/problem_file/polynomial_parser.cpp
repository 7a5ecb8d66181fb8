#include "library/problem_file/polynomial_parser.hpp"

#include <fmt/format.h>

#include <charconv>

#include "library/text/one_line.hpp"
#include "model/invalid_data.hpp"

namespace steadyslide::library {
namespace {

// These limits keep every computation on profiles feasible. No realistic profile comes near them.
constexpr std::size_t max_length = 10000;
constexpr int max_nesting = 100;
constexpr unsigned max_exponent = 1000;
constexpr std::size_t max_coefficient_bits = 4096;

class Parser {
 public:
  Parser(std::string_view text, PolynomialBudget& budget) : text_(text), budget_(budget) {}

  Polynomial parse() {
    if (text_.size() > max_length) {
      throw InvalidData("", "polynomial too long", fmt::format("it has at most {} characters", max_length),
                        fmt::format("{} characters", text_.size()));
    }
    Polynomial result = expression();
    if (peek() != '\0' || at_ < text_.size()) fail(at_, "unexpected character", "expected +, -, *, /, ^ or the end");
    return result;
  }

 private:
  [[noreturn]] void fail(std::size_t at, const std::string& problem, const std::string& rule) const {
    throw InvalidData("", fmt::format("{} at character {}", problem, at + 1), rule, excerpt(text_));
  }

  /// The next character that is not a space; NUL at the end.
  char peek() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }

  bool accept(char symbol) {
    if (peek() != symbol || at_ >= text_.size()) return false;
    ++at_;
    return true;
  }

  void spend(std::size_t at, std::size_t operations) {
    budget_.operations -= static_cast<long>(operations);
    if (budget_.operations < 0)
      fail(at, "profile too complicated", "the profiles of a file are expanded within a limit");
  }

  Polynomial checked(std::size_t at, Polynomial value) {
    for (const Rational& c : value.coefficients()) {
      if (bits(numerator(c)) > max_coefficient_bits || bits(denominator(c)) > max_coefficient_bits) {
        fail(at, "coefficient too large", fmt::format("a coefficient has at most {} bits", max_coefficient_bits));
      }
    }
    return value;
  }

  Polynomial product(std::size_t at, const Polynomial& a, const Polynomial& b) {
    check_degree(at, a.degree() + b.degree());
    spend(at, (a.coefficients().size() + 1) * (b.coefficients().size() + 1));
    return checked(at, a * b);
  }

  void check_degree(std::size_t at, int degree) const {
    if (degree > max_degree) {
      fail(at, "degree too high", fmt::format("the degree of a profile is at most {}", max_degree));
    }
  }

  Polynomial expression() {
    Polynomial sum = term();
    while (true) {
      const char symbol = peek();
      const std::size_t at = at_;
      if (!accept('+') && !accept('-')) return sum;
      const Polynomial next = term();
      spend(at, sum.coefficients().size() + next.coefficients().size() + 1);
      sum = checked(at, symbol == '+' ? sum + next : sum - next);
    }
  }

  Polynomial term() {
    Polynomial result = power();
    while (true) {
      peek();
      const std::size_t at = at_;
      if (accept('*')) {
        result = product(at, result, power());
      } else if (accept('/')) {
        const Polynomial divisor = power();
        if (divisor.degree() > 0) fail(at, "division by a polynomial", "the divisor is a constant");
        if (divisor.degree() < 0) fail(at, "division by zero", "the divisor is not zero");
        result = product(at, result, Polynomial::constant(1 / divisor.coefficient(0)));
      } else {
        return result;
      }
    }
  }

  Polynomial power() {
    const bool negative = peek() == '-';
    if (!accept('-')) accept('+');
    Polynomial base = atom();
    peek();
    const std::size_t at = at_;
    if (accept('^')) base = raised(at, base, exponent());
    return negative ? Polynomial::constant(-1) * base : base;
  }

  unsigned exponent() {
    peek();
    const std::size_t start = at_;
    unsigned value = 0;
    const char* const end = text_.data() + text_.size();
    const auto [after, error] = std::from_chars(text_.data() + at_, end, value);
    if (error == std::errc::invalid_argument) fail(start, "no exponent", "^ is followed by digits");
    if (error != std::errc() || value > max_exponent) {
      fail(start, "exponent too large", fmt::format("an exponent is at most {}", max_exponent));
    }
    at_ = static_cast<std::size_t>(after - text_.data());
    return value;
  }

  Polynomial raised(std::size_t at, const Polynomial& base, unsigned exponent) {
    if (base.degree() > 0) check_degree(at, base.degree() * static_cast<int>(exponent));
    Polynomial result = Polynomial::constant(1);
    for (unsigned bit = 1U << 10; bit != 0; bit >>= 1) {
      result = product(at, result, result);
      if ((exponent & bit) != 0) result = product(at, result, base);
    }
    return result;
  }

  Polynomial atom() {
    const char next = peek();
    if (accept('x')) return Polynomial({0, 1});
    if (accept('(')) {
      const std::size_t open = at_ - 1;
      if (++nesting_ > max_nesting) {
        fail(open, "too many parentheses", fmt::format("they nest at most {} deep", max_nesting));
      }
      Polynomial inside = expression();
      if (!accept(')'))
        fail(at_, at_ < text_.size() ? "unexpected character" : "missing )", "expected ) or an operator");
      --nesting_;
      return inside;
    }
    if ((next >= '0' && next <= '9') || next == '.') return Polynomial::constant(number());
    fail(at_, at_ < text_.size() ? "unexpected character" : "missing value", "expected a number, x or (");
  }

  Rational number() {
    const std::size_t start = at_;
    const auto digits = [this] {
      while (at_ < text_.size() && text_[at_] >= '0' && text_[at_] <= '9') ++at_;
    };
    digits();
    if (at_ < text_.size() && text_[at_] == '.') ++at_;
    digits();
    if (at_ < text_.size() && (text_[at_] == 'e' || text_[at_] == 'E')) {
      ++at_;
      if (at_ < text_.size() && (text_[at_] == '+' || text_[at_] == '-')) ++at_;
      digits();
    }
    try {
      return parse_rational(text_.substr(start, at_ - start));
    } catch (const InvalidData& error) {
      const std::string message = error.what();
      const std::size_t end = message.find("; ");
      throw InvalidData("", fmt::format("{} at character {}", message.substr(0, end), start + 1),
                        message.substr(end + 2), excerpt(text_));
    }
  }

  std::string_view text_;
  PolynomialBudget& budget_;
  std::size_t at_ = 0;
  int nesting_ = 0;
};

}  // namespace

std::size_t bits(const Integer& value) { return value == 0 ? 1 : msb(Integer(abs(value))) + 1; }
std::size_t bits(const Rational& value) { return bits(numerator(value)) + bits(denominator(value)); }

Polynomial parse_polynomial(std::string_view text, PolynomialBudget& budget) { return Parser(text, budget).parse(); }

}  // namespace steadyslide::library
