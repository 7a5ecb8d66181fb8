#include "symbolic/statements/written_statements.hpp"

#include "support/rows.hpp"

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

TEST_CASE("several statements of one section: each has its equations, and the wrong variants that break it") {
  const std::string text = R"(symbols a
powers
  let two = 2, three = 3
  for k = 1, -1
  says square(a) :: a^2
  equal {k} :: (k*a)^2 = a^two
  says cube({a, b}), cube(c) :: a^3
  equal {k} :: (k*a)^3 = k*a^three
  end
  says square
  equal more :: a^two*a = a^3
  wrong a^4 :: two = 4
  wrong a :: two = 1, three = 1
)";
  const std::vector<DecidedStatement> all = written_statements(text);
  REQUIRE(all.size() == 2);
  CHECK(all[0].id == "powers-square");
  CHECK(all[0].identity.written->equations.size() == 3);
  CHECK(all[0].controls.size() == 2);
  CHECK(all[1].id == "powers-cube");
  CHECK(all[1].decides == "cube({a, b}), cube(c)");
  CHECK(all[1].identity.statement == "a^3");
  REQUIRE(all[1].controls.size() == 1);
  CHECK(all[1].controls[0].statement == "a");
  // A variant that breaks none is shown as not refuted; a statement that none breaks is an error.
  const std::vector<DecidedStatement> idle = written_statements(text + "  wrong nothing :: two = 2\n");
  CHECK(idle[0].controls.back().identical);
  CHECK(idle[1].controls.back().identical);
  CHECK_THROWS_WITH(written_statements(text.substr(0, text.find("  wrong a ::"))),
                    "statement: line 12: no wrong variant breaks it; powers-cube");
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
  // The text that replaces the first equation, and the message.
  for (const auto& row : rows_of(STEADYSLIDE_TESTS "/symbolic/statements/unreadable_lines.json")) {
    CAPTURE(row.first);
    std::string text = square;
    text.replace(text.find("equal it"), text.find("\n  for") - text.find("equal it"), row.first);
    CHECK_THROWS_WITH(written_statements(text), ("statement: line 10: " + row.second).c_str());
  }
  CHECK_THROWS_WITH(written_statements("a\n  let b = 1\n"), "statement: line 1: a statement has words; a");
  CHECK_THROWS_WITH(written_statements("symbols b\na\n  equal b = b\n  says it\n"),
                    "statement: line 3: an equation stands below the words that it decides; b = b");
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
