#include "symbolic/statements/written_statements.hpp"

#include "support/test.hpp"

using namespace steadyslide::symbolic;

namespace {

const std::string square = R"(definitions
  let sign = 1

square-of-a-sum
  # (a+b)^2
  says (a+b)^2 = a^2 + 2 a b
      + b^2
  let f(x) = x*x, cross = 2*a*b
  equal it :: f(a + b) = a^2 + sign*cross + b^2
  for k = 1, -1
  equal scaled :: (k*a)^2 = a*a
  end
  wrong without the 2 :: cross = cross/2
  wrong the other sign :: sign = -1
)";

}  // namespace

TEST_CASE("a written statement has its words, its equations and its wrong variants") {
  const std::vector<DecidedStatement> all = written_statements(square);
  REQUIRE(all.size() == 1);
  CHECK(all[0].id == "square-of-a-sum");
  CHECK(all[0].identity.statement == "(a+b)^2 = a^2 + 2 a b + b^2");
  CHECK(all[0].identity.identical);
  CHECK(all[0].identity.written->equations.size() == 3);
  REQUIRE(all[0].controls.size() == 2);
  CHECK(all[0].controls[0].statement == "without the 2");
  CHECK(all[0].controls[0].rhs == "it = a^2 + a*b + b^2");
  CHECK_FALSE(all[0].controls[1].identical);
}

TEST_CASE("statements decided elsewhere take the place that the text gives them") {
  const std::vector<DecidedStatement> all =
      written_statements("first\n" + square + "last\n", {{"last", {}, {}}, {"first", {}, {}}});
  REQUIRE(all.size() == 3);
  CHECK(all[0].id == "first");
  CHECK(all[2].id == "last");
  CHECK_THROWS_WITH(written_statements("first\n"), "statement: not decided; first");
  CHECK_THROWS_AS(written_statements(square, {{"last", {}, {}}}), std::logic_error);
}

TEST_CASE("a text that cannot be read is refused") {
  // What stands in the place of the first equation, and the message.
  const std::vector<std::pair<std::string, std::string>> rows{
      {"equal it :: f(a + b = 1", "a parenthesis is not closed; f(a + b"},
      {"equal it :: a + = 1", "not an expression; a +"},
      {"equal it :: a b = 1", "not an expression; a b"},
      {"equal it :: a", "an equation has two sides; it :: a"},
      {"equal it :: g(a) = a", "no such function; g"},
      {"equal it :: f(a, b) = a", "no such function; f"},
      {"equal it :: r(s) = 1", "no friction of the field; square-of-a-sum"},
      {"let a", "`let` gives values; a"},
      {"for k\n  end", "`for` gives values; k"},
      {"equals it :: a = a", "no such line; equals it :: a = a"},
      {"wrong without a change", "a wrong variant says what it changes; without a change"},
      {"wrong of no name :: sgn = 1", "a wrong variant changes what `let` gives; sgn = 1"}};
  for (const auto& [line, message] : rows) {
    CAPTURE(line);
    std::string text = square;
    text.replace(text.find("equal it"), text.find("\n  for") - text.find("equal it"), line);
    CHECK_THROWS_WITH(written_statements(text), ("statement: " + message).c_str());
  }
  CHECK_THROWS_WITH(written_statements("a\n  let b = 1\n"), "statement: a statement has words; a");
  CHECK_THROWS_WITH(written_statements("  says it\n"), "statement: a line belongs to a statement; says it");
}
