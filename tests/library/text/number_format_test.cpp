#include "library/text/number_format.hpp"
#include "support/test.hpp"

using namespace steadyslide::library;
using numeric::Estimate;
using numeric::Real100;
using numeric::Real50;

namespace {
constexpr double infinite = std::numeric_limits<double>::infinity();
}

TEST_CASE("numbers are rounded to nearest, plain for moderate exponents, without zeros at the end") {
  // A double, the requested digits, the expected text.
  for (const std::string& row :
       words("0.0:16:0 -0.0:16:0 -0.0123:16:-0.0123 1.5e-30:16:1.5e-30 0.1:16:0.1 9.996:3:10 1000.0:3:1e3 100.0:3:100 "
             "100.0:4:100 -123456.0:3:-1.23e5 1.5e-5:16:0.000015 1.5e-6:16:1.5e-6 1e100:16:1e100 5e-324:3:4.94e-324")) {
    CAPTURE(row);
    const std::size_t colon = row.find(':'), last = row.rfind(':');
    CHECK(format_number(std::strtod(row.c_str(), nullptr), std::stoi(row.substr(colon + 1))) == row.substr(last + 1));
  }
  CHECK(format_number(1.0 / 3, 16) == "0.3333333333333333");
  CHECK(format_number(2.0 / 3, 1) == "0.7");
}

TEST_CASE("infinities have names, what is no number has no text") {
  CHECK(format_number(infinite, 5) == "inf");
  CHECK(format_number(-infinite, 5) == "-inf");
  CHECK(format_number(-numeric::infinity<Real50>(), 5) == "-inf");
  CHECK(format_number(std::nan(""), 5) == "");
  CHECK(format_number(std::numeric_limits<Real100>::quiet_NaN(), 5) == "");
}

TEST_CASE("fifty and a hundred digits are served, and one digit too") {
  const Rational third(1, 3);
  CHECK(format_number(numeric::to_real<Real50>(third), 50) == "0." + std::string(50, '3'));
  CHECK(format_number(numeric::to_real<Real100>(third), 100) == "0." + std::string(100, '3'));
  CHECK(format_number(Rational(2, 3), 100) == "0." + std::string(99, '6') + "7");
  CHECK(format_number(numeric::to_real<Real50>(Rational(2, 3)), 1) == "0.7");
  CHECK(format_number(Rational(2, 3), 1) == "0.7");
  CHECK(format_number(parse_rational("1e-400"), 50) == "1e-400");
}

TEST_CASE("digits that the error does not support are not printed") {
  // A value, its error, the requested digits, the expected text. With an infinite error a value is not known.
  for (const std::string& row : words(
           "1.23456789:0:16:1.23456789 1.23456789:3e-5:16:1.2346 1.23456789:1e-4:16:1.2346 1.23456789:1.1e-4:16:1.235 "
           "1.23456789:1e-4:3:1.23 3:2:16:3 0:0:16:0 1.5:nan:16: -inf:0:16:-inf 1.5:inf:16: 0:inf:16: "
           "-inf:inf:16:-inf")) {
    CAPTURE(row);
    const std::size_t error = row.find(':') + 1, digits = row.find(':', error) + 1, last = row.rfind(':') + 1;
    const Estimate<double> estimate{std::stod(row), std::stod(row.substr(error))};
    CHECK(format_number(estimate, std::stoi(row.substr(digits))) == row.substr(last));
  }
  CHECK(format_number(Estimate<Real50>{Real50(1) / 3, Real50("1e-40")}, 50) == "0." + std::string(40, '3'));
  CHECK(format_number(Estimate<Real50>{1, numeric::infinity<Real50>()}, 50) == "");
}

TEST_CASE("a value that does not exceed its error has it beside it, rounded where the error is; 0 alone is exact") {
  const auto text = [](double value, double error) { return format_number(Estimate<double>{value, error}, 16); };
  CHECK(text(76.278, 110) == "80 +/- 120");
  CHECK(text(-0.0042, 0.0078) == "-0.0042 +/- 0.0078");
  CHECK(text(1e-17, 1e-13) == "0 +/- 1.1e-13");
  CHECK(text(1.5, 1e300) == "0 +/- 1.1e300");
  CHECK(text(2, 2) == "2 +/- 2");
  CHECK(text(0, 3e-16) == "0 +/- 3e-16");
  CHECK(text(0, 0) == "0");
  CHECK(format_number(Estimate<Real50>{Real50("1e-60"), Real50("3e-57")}, 50) == "0 +/- 3.1e-57");
  REQUIRE(rc::check([](std::uint16_t value, std::uint16_t error) {
    const double v = value / 256., e = v + error / 64.;
    const std::string text = format_number(Estimate<double>{v, e}, 16);
    const std::size_t sign = text.find(" +/- ");
    if (e == 0) return;
    RC_ASSERT(sign != text.npos);
    // All values within the estimate are within the printed error.
    const Rational said = parse_rational(text.substr(0, sign)), most = parse_rational(text.substr(sign + 5));
    RC_ASSERT(abs(said - Rational(v)) + Rational(e) <= most);
    RC_ASSERT(most <= Rational(e) * 5 / 4);
  }));
}

TEST_CASE("17 digits bring any double back") {
  REQUIRE(rc::check([](double value) {
    RC_PRE(std::isfinite(value));
    RC_ASSERT(std::stod(format_number(value, 17)) == value);
  }));
}

TEST_CASE("16 digits of all of a number are the shortest decimal that brings the double back") {
  for (const char* text : {"0.1", "0.3333333333333333", "0.30000000000000004", "-5e-324"}) {
    CHECK(full_number(std::strtod(text, nullptr), 16) == text);
  }
  CHECK(full_number(Rational(1, 3), 16) == "0.3333333333333333");
  CHECK(full_number(Real50("1e-400") / 3, 16) == "3.333333333333333e-401");
  CHECK(full_number(Real50(2) / 3, 16) == "0.6666666666666666");  // the double's digits, not the rounded
                                                                  // 0.6666666666666667
  CHECK(full_number(2.0 / 3, 6) == "0.666667");
  CHECK(full_number(Real50(1) / 3, 30) == "0." + std::string(30, '3'));
  CHECK(full_number(-infinite, 16) == "-inf");
  CHECK(full_number(std::nan(""), 16) == "");
  REQUIRE(rc::check([](double value) {
    RC_PRE(std::isfinite(value));
    const std::string text = full_number(value, 16);
    RC_ASSERT(std::stod(text) == value);
    RC_ASSERT(full_number(Real50(value), 16) == text);
  }));
}

TEST_CASE("an estimate for a person and for a file") {
  const NumberText text = number_text(Estimate<double>{0.123456789, 2.34e-3}, 16);
  CHECK(text.shown == "0.12");
  CHECK(text.value == "0.123456789");
  CHECK(text.error == "0.0024");
  CHECK(number_text(Estimate<double>{1e-17, 1e-13}, 16).value == "1e-17");
  const NumberText blow_up = number_text(Estimate<double>{-infinite, 0}, 16);
  CHECK(blow_up.value == "-inf");
  CHECK(blow_up.error == "0");
  for (const double error : {infinite, std::nan("")}) {
    const NumberText unknown = number_text(Estimate<double>{1.5, error}, 16);
    CHECK(unknown.shown + unknown.value + unknown.error == "");
  }
}

TEST_CASE("an estimated error counts what its value is rounded by") {
  CHECK(number_text(Estimate<double>{2. / 3, 1e-17}, 3).error == "0.00034");
  CHECK(number_text(Estimate<double>{0.5, 0}, 3).error == "0");
  CHECK(number_text(Estimate<double>{2. / 3, 1e-16}, 16).error == "1e-16");  // the text gives exactly the double
  CHECK(number_text(Estimate<Real50>{Real50(2) / 3, Real50("1e-56")}, 25).error == "3.4e-26");
  // The nearest double is further away than the 16th digit.
  CHECK(number_text(Estimate<Real50>{Real50(2) / 3, Real50("1e-56")}, 16).error == "6.7e-17");
  // The text as a reader of this type parses it.
  const auto covers = []<numeric::Real R>(const R& value, const R& error, int digits) {
    const NumberText text = number_text(Estimate<R>{value, error}, digits);
    const auto read = [](const std::string& decimal) { return numeric::to_real<R>(parse_rational(decimal)); };
    const Rational off = abs(Rational(read(text.value)) - Rational(value)) + Rational(error);
    return off <= parse_rational(text.error) && parse_rational(text.error) <= off * 11 / 10;
  };
  REQUIRE(rc::check([&](std::uint32_t n, std::uint16_t e) {
    const int digits = 2 + static_cast<int>(n % 15);
    RC_ASSERT(covers((n + 1.) / 7, e / 65536. / (n + 1.), digits));
    RC_ASSERT(covers(Real50(Real50(n) + 1) / 7, Real50(Real50(e) / (Real50(n) + 1) / Real50("1e30")), digits + 34));
  }));
}

TEST_CASE("a formatted number differs from the value by half a unit of its last digit at most") {
  REQUIRE(rc::check([](int n) {
    const int digits = *rc::gen::inRange(1, 40);
    const Rational value(n, *rc::gen::inRange(1, 100000));
    const std::string text = format_number(value, digits);
    const Rational error = abs(parse_rational(text) - value);
    RC_ASSERT(2 * error * parse_rational("1e" + std::to_string(digits - 1)) <= abs(value));
  }));
}

TEST_CASE("exact text is read back as the same number, also the longest") {
  CHECK(exact_text(parse_rational("1e-400")) == "1e-400");
  CHECK(exact_text(parse_rational("-1.25e399")) == "-125e397");
  CHECK(exact_text(Rational(-1, 3)) == "-1/3");
  CHECK(exact_text(Rational(0)) == "0");
  REQUIRE(rc::check([](int mantissa) {
    const int exponent = *rc::gen::inRange(-400, 391);
    const Rational value = parse_rational(std::to_string(mantissa) + "e" + std::to_string(exponent));
    RC_ASSERT(parse_rational(exact_text(value)) == value);
  }));
}

TEST_CASE("of a ball those digits are shown to which all its numbers are rounded alike") {
  using enclosure::Ball;
  const auto around = [](const char* middle, const char* radius) {
    return Ball::plus_or_minus(Ball(parse_rational(middle), 400), Ball(parse_rational(radius), 400));
  };
  using Row = std::tuple<Ball, int, const char*>;
  for (const auto& [ball, digits, shown] :
       {Row{around("1.23456789", "0"), 5, "1.2346"}, Row{around("1.23456789", "1e-4"), 16, "1.23"},
        Row{around("1.23456789", "3e-6"), 16, "1.2346"}, Row{around("0.5", "1e-60"), 50, "0.5"},
        Row{around("-1e-93", "1e-95"), 16, "-1e-93"}, Row{around("9.9996", "1e-4"), 16, "10"},
        Row{around("2", "1"), 5, "2 +/- 1.1"}, Row{around("0", "1e-30"), 5, "0 +/- 1.1e-30"}, Row{Ball(0), 5, "0"},
        Row{Ball::infinity(-1, 64), 5, "-inf"}, Row{Ball::unknown(64), 5, ""}}) {
    CHECK(number_text(ball, digits).shown == shown);
  }
}

TEST_CASE("a ball's value and error: every number in it is within the error of the value, at any number of digits") {
  REQUIRE(rc::check([](std::uint32_t top, std::uint8_t exponent) {
    const int digits = 1 + static_cast<int>(top % 1000);
    const Rational middle = Rational(top) / 7 - 3;
    const enclosure::Ball radius = power(enclosure::Ball(10, 64), -static_cast<int>(exponent));
    const auto ball = enclosure::Ball::plus_or_minus(enclosure::Ball(middle, 4000), radius);
    const NumberText text = number_text(ball, digits);
    enclosure::Ball said(0, 4000), error(0, 4000);
    arb_set_str(said.get(), text.value.c_str(), 4000);
    arb_set_str(error.get(), text.error.c_str(), 4000);
    RC_ASSERT(arb_contains(enclosure::Ball::plus_or_minus(said, error).get(), ball.get()) != 0);
  }));
}
