#include "library/problem_file/list_parser.hpp"
#include "model/invalid_data.hpp"
#include "support/rows.hpp"

using namespace steadyslide::library;

namespace {

std::string list_error(std::string_view text, std::size_t most = 100) {
  return thrown_by([&] { parse_list(text, most); });
}

}  // namespace

TEST_CASE("lists are exact and inclusive") {
  CHECK(parse_list("0.1,1/3,-2", 3) == std::vector<Rational>{Rational(1, 10), Rational(1, 3), -2});
  CHECK(parse_list("0.7", 3) == std::vector<Rational>{Rational(7, 10)});
  CHECK(parse_list("0:0.4:0.1", 9) == std::vector<Rational>{0, 0.1_r, 0.2_r, 0.3_r, 0.4_r});
  CHECK(parse_list("0:0.45:0.1", 9).back() == Rational(2, 5));
  CHECK(parse_list("-0.5:-0.5:1", 9) == std::vector<Rational>{Rational(-1, 2)});
  CHECK(parse_list("0:1:1e-2", 101).size() == 101);
}

TEST_CASE("bad lists say what is wrong") {
  // Invalid lists with their messages; at most 100 entries are allowed.
  for (const auto& [text, message] : rows_of(STEADYSLIDE_TESTS "/library/problem_file/list_errors.json"))
    CHECK(list_error(text) == message);
  CHECK(list_error("") == "not a number; a number is written like 2, -0.25, 1e-3 or 1/3; ''");
  CHECK(list_error("1,2,3", 2) == "list too long; there are at most 2 entries; '1,2,3'");
}

TEST_CASE("a range has as many entries as fit") {
  REQUIRE(rc::check([] {
    const int first = *rc::gen::inRange(-50, 50), steps = *rc::gen::inRange(0, 40), d = *rc::gen::inRange(1, 20);
    const Rational step(*rc::gen::inRange(1, 30), d), last = first + step * steps;
    const auto list = parse_list(to_string(Rational(first)) + ":" + last.str() + ":" + step.str(), 100);
    RC_ASSERT(list.size() == static_cast<std::size_t>(steps) + 1);
    RC_ASSERT(list.back() == last);
  }));
}

TEST_CASE("counts are whole numbers within limits") {
  CHECK(parse_count("100", 1, 100) == 100);
  for (const char* text : {"", "0", "101", "1.5", "+5", " 5", "5 ", "x", "99999999999999999999"}) {
    CHECK_THROWS_AS(parse_count(text, 1, 100), InvalidData);
  }
}
