#include "library/text/one_line.hpp"
#include "support/test.hpp"

using namespace steadyslide::library;

TEST_CASE("what is printable stays, what is not is escaped") {
  CHECK(one_line("a b; 'é' → ü") == "a b; 'é' → ü");
  CHECK(one_line("a\nb\r\tc\x1b[31m") == "a\\x0ab\\x0d\\x09c\\x1b[31m");
  CHECK(one_line(std::string("a\0b", 3)) == "a\\x00b");
  CHECK(one_line("\xff\xfe") == "\\xff\\xfe");
  CHECK(one_line("\xc3") == "\\xc3");
  CHECK(one_line("\xc0\x80") == "\\xc0\\x80");
  CHECK(one_line("\xed\xa0\x80") == "\\xed\\xa0\\x80");
  CHECK(one_line("\xe2\x80\xae") == "\\xe2\\x80\\xae");
  CHECK(one_line("\xf0\x9f\x98\x80") == "\xf0\x9f\x98\x80");
}

TEST_CASE("long words and long lines are shortened") {
  CHECK(one_line(std::string(1000, 'a') + " b") == std::string(79, 'a') + "... b");
  CHECK(one_line(std::string(79, 'a')) == std::string(79, 'a'));
  std::string words;
  for (int k = 0; k < 1000; ++k) words += "abc ";
  CHECK(one_line(words).size() == 603);
  CHECK(excerpt(std::string(41, 'a')) == "'" + std::string(40, 'a') + "...'");
  CHECK(excerpt(std::string(40, 'a')) == "'" + std::string(40, 'a') + "'");
}

TEST_CASE("any bytes give one short line") {
  REQUIRE(rc::check([](const std::string& bytes) {
    const std::string line = one_line(bytes);
    RC_ASSERT(line.size() < 620U);
    for (const char c : line) RC_ASSERT(static_cast<unsigned char>(c) >= 0x20);
  }));
}
