#include "checker/ball.hpp"

#include <regex>

namespace steadyslide::checker {

Ball Ball::parse(const std::string& text, slong bits) {
  // Midpoint and radius, each a mantissa and a power of two in hexadecimal. Infinity and NaN do not have this form. In
  // Arb a radius has 30 bits; Arb ends the process if it reads more.
  static const std::regex form("-?[0-9a-f]{1,2000} -?[0-9a-f]{1,8} ([0-9a-f]{1,7}|[0-3][0-9a-f]{7}) -?[0-9a-f]{1,8}");
  Ball result;
  bool read = text.size() <= 2100 && std::regex_match(text, form) && arb_load_str(result.ball_, text.c_str()) == 0 &&
              result.is_finite() && arb_bits(result.ball_) <= bits;
  if (read) {
    // If anything were rounded, the ball would differ from the text.
    char* again = arb_dump_str(result.ball_);
    read = text == again;
    flint_free(again);
  }
  if (!read) arb_indeterminate(result.ball_);
  result.precision_ = bits;
  return result;
}

std::string Ball::text(slong digits) const {
  const auto printed = [](arb_srcptr ball, slong n) {
    char* characters = arb_get_str(ball, n, ARB_STR_NO_RADIUS | ARB_STR_MORE);
    std::string result = characters;
    flint_free(characters);
    return result;
  };
  const std::string middle = printed(ball_, digits);
  return mag_is_zero(arb_radref(ball_)) ? middle : middle + " +/- " + printed(radius().ball_, 2);
}

}  // namespace steadyslide::checker
