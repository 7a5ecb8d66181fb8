#include "symbolic/statements/written_statements.hpp"

#include "support/test.hpp"

using namespace steadyslide::symbolic;

namespace {

const std::string square = R"(symbols a, b, s
definitions
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
  CHECK_THROWS_WITH(written_statements("first\n"), "statement: line 1: not decided; first");
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
      {"equal it :: f(a, b) = a", "wrong number of arguments (2); f"},
      {"equal it :: diff(a) = a", "wrong number of arguments (1); diff"},
      {"equal it :: at(a, b) = a", "wrong number of arguments (2); at"},
      {"equal it :: at(a, b, 1, a) = a", "wrong number of arguments (4); at"},
      {"let diff(x) = a", "a function of every text; diff"},
      {"equal it :: alhpa = a", "no such name; alhpa"},
      {"equal it :: a_{1} = a", "no such name; a_1"},
      {"equal it :: [a, b][2] = a", "no such entry; [a, b][2]"},
      {"equal it :: [a, b = a", "an equation has two sides; it :: [a, b = a"},
      {"let c = [a, b", "a bracket is not closed; [a, b"},
      {"equal it :: sum(a) = a", "no list; a"},
      {"equal it :: diff(a, 2*b) = a", "no symbol; 2*b"},
      {"equal it :: coeff(a, b, 1/2) = a", "no integer; (1)/(2)"},
      {"equal it :: max(a, 1) = a", "no number; a"},
      {"equal it :: sign(a) = a", "neither 1 nor -1; a"},
      {"equal it :: size(powers([edge, free])) = 2", "a component has two ends and a number of jumps; 2"},
      {"let c = [a | k]", "a list gives values; a | k"},
      {"for k = 1", "`for` has an `end`; k = 1"},
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
    CHECK_THROWS_WITH(written_statements(text), ("statement: line 10: " + message).c_str());
  }
  CHECK_THROWS_WITH(written_statements("a\n  let b = 1\n"), "statement: line 1: a statement has words; a");
  CHECK_THROWS_WITH(written_statements("  says it\n"), "statement: line 1: a line belongs to a statement; says it");
}

TEST_CASE("a message names the file and the line, and symbols are those of one file") {
  const std::string first = "file one.txt\nsymbols a\n\none\n  says it\n  equal a :: a = a\n  wrong it :: a = 1\n";
  CHECK_THROWS_WITH(written_statements(first),
                    "statement: one.txt, line 6: a wrong variant changes what `let` gives; a = 1");
  const std::string second = "file one.txt\nsymbols a\nfile two.txt\ntwo\n  says it\n\n  # it\n  equal a :: a = a\n";
  CHECK_THROWS_WITH(written_statements(second), "statement: two.txt, line 5: no such name; a");
}

TEST_CASE("lists, names with an index, and definitions around a statement") {
  const std::vector<DecidedStatement> all = written_statements(R"(symbols e_*, x

definitions
  let last = 3
  then
  for n = 1..last
  equal sum {n} :: sum([p[j]*e_{j} | j = 0..n]) = stated(n)
  end
  equal ends :: join([e_0], [e_{j} | j = 2..1], [e_{last}])[1] = polynomial([e_3, 0], x)

squares
  says sum j^2 e_j
  let p = [0, 1, 4, 9], stated(n) = power*sum([j*j*e_{j} | j = 1..n]), power = 1
  wrong twice :: power = 2
  wrong p_2 :: p = [0..3]
)");
  REQUIRE(all.size() == 1);
  CHECK(all[0].identity.identical);
  CHECK(all[0].identity.lhs == "sum 1 = e_1; sum 2 = e_1 + 4*e_2; sum 3 = e_1 + 4*e_2 + 9*e_3; ends = e_3");
  REQUIRE(all[0].controls.size() == 2);
  CHECK(all[0].controls[0].lhs == "sum 1 = e_1");
  CHECK(all[0].controls[1].lhs == "sum 2 = e_1 + 2*e_2");
}
