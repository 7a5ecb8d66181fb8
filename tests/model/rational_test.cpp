#include "model/rational.hpp"
#include "broken_rule.hpp"

namespace {

std::string why_not(const std::string& text) {
  return refusal([&] { parse_rational(text); });
}

const std::string rule = ": not a number; a number is written like 2, -0.25, 1e-3 or 1/3; ";

}  // namespace

TEST_CASE("numbers are read as they are written") {
  for (const std::string& both :
       words("0=0 -0=0 7=7 +7=7 -7=-7 010=10 007.010=701/100 -00=0 0.1=1/10 +.5=1/2 -.5=-1/2 5.=5 1e3=1000 1E+3=1000 "
             "1e-3=1/1000 1e-0=1 08e1=80 -2.50e-1=-1/4 1e0000000000000000000002=100 1/3=1/3 -1/3=-1/3 1/-3=-1/3 "
             "-2/-6=1/3 010/030=1/3 0.5/1.5=1/3 1e2/1e-2=10000 0/5=0 0e400=0")) {
    CAPTURE(both);
    const std::size_t equal = both.find('=');
    CHECK(parse_rational(both.substr(0, equal)) == Rational(both.substr(equal + 1)));
  }
  const Integer large = boost::multiprecision::pow(Integer(10), 400);
  CHECK(parse_rational("1e400") == Rational(large));
  CHECK(parse_rational("1e-400") == Rational(1, large));
  CHECK(parse_rational("1e400/1e-400") == Rational(large * large));
}

TEST_CASE("what is no number is refused with its rule and the text") {
  for (const char* text : {"",      "+",   "-",   ".",     "+.",  "e5",  ".e5",   "1e",   "1e+",   "1e-",  "1e5.",
                           "1.2.3", "+-1", "--1", "1+1",   " 1",  "1 ",  "1 2",   "0x10", "1_000", "1,5",  "1//2",
                           "1/",    "/2",  "/",   "1/2/3", "inf", "nan", "1e5e5", "1f",   "x",     "1/ 2", "'1'"}) {
    CAPTURE(text);
    CHECK(why_not(text) == rule + "'" + text + "'");
  }
  // Characters that could confuse a terminal are shown as '?'; long texts are cut.
  CHECK(why_not(std::string("1\0", 2)) == rule + "'1?'");
  CHECK(why_not("1\n2") == rule + "'1?2'");
  CHECK(why_not("\xe2\x88\x92"
                "1") == rule + "'???1'");
  CHECK(why_not("12345678901234567890123456789012345678901x") ==
        rule + "'1234567890123456789012345678901234567890...'");
}

TEST_CASE("limits of a written number") {
  const std::string longest(max_number_length, '9');
  CHECK(parse_rational(longest) + 1 == parse_rational("1e400"));
  CHECK(why_not(longest + "9") == ": number too long; a number has at most 400 characters; 401 characters");
  const std::string range = ": exponent out of range; a decimal exponent is at most 400 in size; ";
  for (const std::string text : {"1e401", "1e-401", "0e401", "1e99999999999999999999", "2/1e401"}) {
    CHECK(why_not(text) == range + "'" + text + "'");
  }
  for (const char* text : {"1/0", "1/0.00", "1/-0", "0/0", "1/0e5"}) {
    CHECK(why_not(text) == ": division by zero; the denominator of a number is not zero; '" + std::string(text) + "'");
  }
}

TEST_CASE("numbers are written as short decimals where they end, else as fractions") {
  for (const std::string& both : words("0=0 -12=-12 -1/4=-0.25 1/1000=0.001 100001/1000=100.001 -1/3=-1/3 7/30=7/30")) {
    CAPTURE(both);
    const std::size_t equal = both.find('=');
    CHECK(to_string(Rational(both.substr(0, equal))) == both.substr(equal + 1));
  }
  CHECK(to_string(parse_rational("1e-30")) == "0." + std::string(29, '0') + "1");
  CHECK(to_string(parse_rational("1e-31")) == "1/1" + std::string(31, '0'));
}

TEST_CASE("what is written is read back") {
  int decimals = 0;
  CHECK(rc::check([&] {
    const auto power = [](int base, int exponent) {
      return boost::multiprecision::pow(Integer(base), static_cast<unsigned>(exponent));
    };
    Integer denominator = power(2, uniform(0, 19)) * power(5, uniform(0, 19));
    if (*rc::gen::arbitrary<bool>()) denominator *= uniform(1, 999);
    const Rational value(Integer(*rc::gen::arbitrary<long long>()), denominator);
    const std::string text = to_string(value);
    decimals += text.find('/') == std::string::npos;
    RC_ASSERT(parse_rational(text) == value);
  }));
  CHECK(decimals > 10);
}

TEST_CASE("no text crashes the reader, and what it accepts has a negative") {
  int accepted = 0;
  CHECK(rc::check([&] {
    // Mostly digits. With all characters equally likely, seed 16093947855052919028 had only two texts that are numbers.
    const std::string digits = "0123456789";
    const std::string text =
        *rc::gen::container<std::string>(rc::gen::elementOf(digits + digits + digits + digits + ".eE+-/"));
    Rational value;
    if (refusal([&] { value = parse_rational(text); }) != "accepted") return;
    ++accepted;
    if (text[0] != '+' && text[0] != '-') RC_ASSERT(parse_rational("-" + text) == -value);
    RC_ASSERT(parse_rational(value.str().size() > max_number_length ? text : value.str()) == value);
  }));
  CHECK(accepted > 3);
}
