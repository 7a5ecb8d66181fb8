#include <chrono>

#include "library/problem_file/polynomial_parser.hpp"
#include "model/invalid_data.hpp"
#include "support/rows.hpp"

using namespace steadyslide::library;

namespace {

Polynomial parse(std::string_view text) {
  PolynomialBudget budget;
  return parse_polynomial(text, budget);
}

std::string polynomial_error(std::string_view text) {
  return thrown_by([&] { parse(text); });
}

}  // namespace

TEST_CASE("the grammar") {
  // Allowed forms of polynomials, and their coefficients of 1, x, x^2, ...
  for (const auto& row : rows_of(STEADYSLIDE_TESTS "/library/problem_file/polynomials.json")) {
    std::vector<Rational> expected;
    for (const std::string& c : words(row.second)) expected.emplace_back(c);
    CHECK_MESSAGE(parse(row.first) == Polynomial(expected), row.first);
  }
  CHECK(parse(" 1/2*x ^2 - x") == Polynomial({0, -1, Rational(1, 2)}));
  CHECK(parse("x^64").degree() == 64);
  CHECK(parse("2^1000").coefficient(0) == Rational(boost::multiprecision::pow(Integer(2), 1000)));
}

TEST_CASE("every error says its place") {
  const auto errors = rows_of(STEADYSLIDE_TESTS "/library/problem_file/polynomial_errors.json");
  CHECK(errors.size() >= 16);
  for (const auto& [text, message] : errors) CHECK(polynomial_error(text) == message);
  CHECK(polynomial_error("") == "missing value at character 1; expected a number, x or (; ''");
  CHECK(polynomial_error(std::string_view("x\0", 2)) ==
        "unexpected character at character 2; expected +, -, *, /, ^ or the end; 'x\\x00'");
}

TEST_CASE("nothing blows up") {
  const auto start = std::chrono::steady_clock::now();
  CHECK(polynomial_error("(((1e400)^64)^64)^64") ==
        "coefficient too large at character 10; a coefficient has at most 4096 bits; '(((1e400)^64)^64)^64'");
  CHECK(polynomial_error("((2^1000)^1000)^1000").substr(0, 37) == "coefficient too large at character 10");
  const std::string deep = std::string(5000, '(') + "x" + std::string(4000, ')');
  CHECK(polynomial_error(deep).substr(0, 37) == "too many parentheses at character 101");
  CHECK(parse(std::string(100, '(') + "x" + std::string(100, ')')).degree() == 1);
  CHECK(polynomial_error(std::string(10001, '1')) ==
        "polynomial too long; it has at most 10000 characters; 10001 characters");
  std::string many = "(1+x/3)^60";
  for (int k = 0; k < 1000; ++k) many += "*1";
  CHECK(parse(many).degree() == 60);
  PolynomialBudget small{100000};
  CHECK_THROWS_AS(parse_polynomial(many, small), InvalidData);
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(5));
}

TEST_CASE("what to_string prints is read back") {
  REQUIRE(rc::check([](const std::vector<std::pair<int, int>>& parts) {
    std::vector<Rational> coefficients;
    for (const auto& [n, d] : parts) {
      if (coefficients.size() <= 64) coefficients.emplace_back(n, d == 0 ? 1 : d);
    }
    const Polynomial polynomial(coefficients);
    RC_ASSERT(parse(to_string(polynomial)) == polynomial);
  }));
}

TEST_CASE("sums, products and powers of texts are those of polynomials") {
  REQUIRE(rc::check([] {
    const auto linear = [](int a, int b) { return "(" + std::to_string(a) + "*x-" + std::to_string(b) + "/7)"; };
    const int a = *rc::gen::inRange(0, 9), b = *rc::gen::inRange(0, 9), c = *rc::gen::inRange(0, 9);
    const int n = *rc::gen::inRange(0, 6);
    const Polynomial p({Rational(-b, 7), a});
    const Polynomial q({Rational(-c, 7), b});
    Polynomial power = Polynomial::constant(1);
    for (int k = 0; k < n; ++k) power = power * q;
    RC_ASSERT(parse(linear(a, b) + "+3*" + linear(b, c) + "^" + std::to_string(n)) ==
              p + Polynomial::constant(3) * power);
  }));
}
