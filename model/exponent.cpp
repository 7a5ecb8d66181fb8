#include "model/exponent.hpp"

#include <algorithm>
#include <cstdlib>

#include "model/invalid_data.hpp"

namespace steadyslide {
namespace {

/// A nonzero Gaussian integer x + iy times i^quarter_turns, with -x < y <= x. Its argument is
/// quarter_turns * pi/2 + arctan(y/x); the second term lies in ]-pi/4, pi/4].
struct Argument {
  Integer quarter_turns = 0;
  Integer x = 1;
  Integer y = 0;

  /// Adds the argument, in ]-pi/2, pi/2[, of a + ib with a > 0.
  void add(const Integer& a, const Integer& b) {
    const Integer new_x = x * a - y * b;
    y = x * b + y * a;
    x = new_x;
    // The sum lies in ]-3pi/4, 3pi/4[, so at most one quarter turn brings it back.
    if (y > x) {
      const Integer turned = -x;
      x = y;
      y = turned;
      ++quarter_turns;
    } else if (y <= -x) {
      const Integer turned = x;
      x = -y;
      y = turned;
      --quarter_turns;
    }
  }
};

/// Returns a + b. Throws InvalidData if the sum exceeds `max_times`: the products in reduced() would become too large.
int added(int a, int b) {
  const long long sum = static_cast<long long>(a) + b;
  if (std::abs(sum) > Exponent::max_times) {
    throw InvalidData("", "angle counted too often",
                      "an exponent contains an angle at most " + std::to_string(Exponent::max_times) + " times",
                      std::to_string(sum));
  }
  return static_cast<int>(sum);
}

std::string magnitude_of(const Exponent::Angle& angle) {
  const int times = std::abs(angle.times);
  return (times == 1 ? "" : std::to_string(times) + "*") + "arctan(" + angle.slope.str() + ")/pi";
}

}  // namespace

Exponent::Exponent(const Rational& offset) : offset_(offset) {
  if (boost::multiprecision::denominator(Rational(4 * offset)) != 1) {
    throw InvalidData("", "offset of an exponent out of range", "the offset is a multiple of 1/4",
                      steadyslide::to_string(offset));
  }
}

Exponent Exponent::angle(const Rational& slope) {
  Exponent result;
  result.add(1, slope);
  return result;
}

void Exponent::add(int times, const Rational& slope) {
  if (slope == 0) return;
  if (slope < 0) return add(-times, -slope);
  const auto same = std::find_if(angles_.begin(), angles_.end(), [&](const Angle& a) { return a.slope == slope; });
  if (same == angles_.end()) {
    angles_.push_back({times, slope});
    return;
  }
  same->times = added(same->times, times);
  if (same->times == 0) angles_.erase(same);
}

Exponent& Exponent::operator+=(const Exponent& other) {
  offset_ += other.offset_;
  if (&other == this) {
    for (Angle& angle : angles_) angle.times = added(angle.times, angle.times);
    return *this;
  }
  for (const Angle& angle : other.angles_) add(angle.times, angle.slope);
  return *this;
}

Exponent Exponent::operator-() const {
  Exponent result;
  result.offset_ = -offset_;
  result.angles_ = angles_;
  for (Angle& angle : result.angles_) angle.times = -angle.times;
  return result;
}

Exponent::Reduced Exponent::reduced() const {
  Argument sum;
  const Integer quarters = boost::multiprecision::numerator(Rational(4 * offset_));
  const bool odd = quarters % 2 != 0;
  sum.quarter_turns = (odd ? quarters - 1 : quarters) / 2;
  if (odd) sum.add(1, 1);
  for (const Angle& angle : angles_) {
    const Integer a = boost::multiprecision::denominator(angle.slope);
    const Integer b = boost::multiprecision::numerator(angle.slope);
    for (int k = std::abs(angle.times); k > 0; --k) sum.add(a, angle.times > 0 ? b : Integer(-b));
  }
  return {sum.quarter_turns, Rational(sum.y, sum.x)};
}

int Exponent::sign() const {
  const Reduced value = reduced();
  return value.halves != 0 ? value.halves.sign() : value.slope.sign();
}

std::string to_string(const Exponent& exponent) {
  std::string text;
  if (exponent.offset() != 0 || exponent.angles().empty()) text = exponent.offset().str();
  for (const Exponent::Angle& angle : exponent.angles()) {
    if (text.empty()) {
      text = (angle.times < 0 ? "-" : "") + magnitude_of(angle);
    } else {
      text += (angle.times < 0 ? " - " : " + ") + magnitude_of(angle);
    }
  }
  return text;
}

}  // namespace steadyslide
