// Signs of the logarithm. It increases, so that on an interval ]0, d] the smallest value of -log is -log d.

#include "proofs_checks/enclosures/enclosure_list.hpp"

namespace steadyslide::proofs_checks {
namespace {

using enclosure::Ball;

Truth sign_decided(const Ball& value) {
  return value >= Ball(0, sign_bits) ? Truth::yes : value.is_negative() ? Truth::no : Truth::unknown;
}

Enclosure::Decide at(const Rational& number, int sign, const std::string& words) {
  return [=](const Box&) -> Decision { return {sign_decided(log(Ball(number, sign_bits)) * sign), {words}}; };
}

/// Decides the sign of -log(unit d) at the upper end of the interval; log 1 = 0 is exact.
Decision largest_distance(const Box& box, const Rational& unit) {
  const Interval d = box.at("d");
  if (!d.from || *d.from < 0 || !d.to) return {Truth::unknown, {"no interval of lengths"}};
  const Ball value = -log(Ball(*d.to * unit, sign_bits));
  return {sign_decided(value), {"-log d >= " + value.to_string(6)}};
}

}  // namespace

Enclosure logarithm_of_two() {
  return {"logarithm-of-two",
          at(2, 1, "`log 2 > 0`"),
          {{"`log(1/2) > 0`", at(Rational(1, 2), 1, "log(1/2)")},
           {"`-log 2 > 0`", at(2, -1, "-log 2")},
           {"`log(2/4) > 0`, on an interval twice as long as 4", at(Rational(4, 8), 1, "log(4/8)")}}};
}

Enclosure logarithm_of_a_unit() {
  return {"logarithm-of-a-unit",
          [](const Box& box) { return largest_distance(box, 1); },
          {{"lengths in units of half the support's", [](const Box& box) { return largest_distance(box, 2); }},
           {"lengths in units of a third of the support's", [](const Box& box) { return largest_distance(box, 3); }},
           {"`log d >= 0`", [](const Box& box) -> Decision {
              const Interval d = box.at("d");
              // The middle of the interval.
              const Ball value = log(Ball((*d.from + *d.to) / 2, sign_bits));
              return {sign_decided(value), {"log d = " + value.to_string(6)}};
            }}}};
}

}  // namespace steadyslide::proofs_checks
