#include "support/random_contact.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <vector>

namespace steadyslide::testing {

namespace {

/// splitmix64. The standard's distributions differ between libraries, and the order in which compilers evaluate
/// arguments differs. Therefore every draw has its own statement or stands in a braced list.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : state_(seed) {}

  /// Both ends are included.
  int whole(int low, int high) {
    state_ += 0x9e3779b97f4a7c15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    z ^= z >> 31U;
    return low + static_cast<int>(z % static_cast<std::uint64_t>(high - low + 1));
  }
  bool chance(int percent) { return whole(1, 100) <= percent; }
  Rational part(int low, int high, int denominator) { return Rational(whole(low, high), denominator); }
  template <class T>
  T one_of(const std::vector<T>& choices) {
    return choices[static_cast<std::size_t>(whole(0, static_cast<int>(choices.size()) - 1))];
  }
  Rational one_of_these(std::initializer_list<Rational> choices) { return one_of(std::vector<Rational>(choices)); }
  /// Returns 10^(k/10) to two digits, low <= k <= high.
  Rational decades(int low, int high) {
    static constexpr int mantissa[] = {10, 13, 16, 20, 25, 32, 40, 50, 63, 79};
    const int k = whole(low, high), last = (k % 10 + 10) % 10, power = (k - last) / 10;
    Rational value(mantissa[last], 10);
    for (int e = 0; e < power; ++e) value *= 10;
    for (int e = 0; e > power; --e) value /= 10;
    return value;
  }

 private:
  std::uint64_t state_;
};

/// The approximate place of a contact.
struct Spot {
  Rational centre;
  Rational radius;
};

/// psi in units of its own height on [-1, 1]; the load in units of height/c.
struct Shape {
  std::vector<Indenter::Piece> pieces;
  std::vector<Spot> spots;
  Rational load;
  std::optional<Rational> load_at = std::nullopt;  ///< a place for the load if the indenter tilts
};

Polynomial around(const Rational& centre, const std::vector<Rational>& coefficients) {
  return Polynomial(coefficients).composed(1, -centre);
}

/// The power of two below 1 up to which a load presses in the profile slope |y| + curve y^2: 2 slope a + pi curve a^2.
Rational reach(const Rational& load, const Rational& slope, const Rational& curve) {
  const auto needed = [&](const Rational& a) { return 2 * slope * a + Rational(22, 7) * curve * a * a; };
  Rational a = 1;
  while (needed(a / 2) >= load) a /= 2;
  return a;
}

/// Bumps side by side, equally wide. Over its width a flank rises by 1, tip |u| + (..) u^2 + quartic u^4; `tipped`
/// bumps have a wedge at the tip. A single bump has flanks of different heights, joined smoothly if it has no wedge.
Shape bumps(Dice& dice, int count, int tipped) {
  const Rational width(1, count);
  const Rational share =
      count == 1 ? dice.chance(60) ? dice.decades(-20, 5) : dice.decades(-30, 30) : dice.decades(-25, 0);
  Shape shape{{}, {}, share * count};
  const int first_tipped = dice.whole(0, count - tipped);
  for (int k = 0; k < count; ++k) {
    const Rational from = Rational(2 * k, count) - 1;
    const Rational centre = from + width * (count == 1 ? dice.part(4, 12, 8) : Rational(1));
    const Rational level = count == 1 ? Rational(0) : Rational(share * dice.part(0, 4, 32));
    const bool wedge = first_tipped <= k && k < first_tipped + tipped;
    const auto flank = [&](int side, const Rational& size) {
      const Rational tip = wedge ? dice.part(1, 8, 8) : Rational(0);
      const Rational quartic = dice.chance(30) ? Rational((1 - tip) * dice.part(1, 4, 8)) : Rational(0);
      return std::vector<Rational>{level, side * size * tip / width, size * (1 - tip - quartic) / (width * width), 0,
                                   size * quartic / (width * width * width * width)};
    };
    const Rational size = count == 1 ? dice.part(1, 4, 2) : Rational(1);
    const std::vector<Rational> right = flank(1, 1);
    if (wedge || (count == 1 && dice.chance(40))) shape.pieces.push_back({centre, around(centre, flank(-1, size))});
    shape.pieces.push_back({from + 2 * width, around(centre, right)});
    shape.spots.push_back({centre, reach(share, right[1], right[2])});
  }
  shape.load_at =
      count == 1 ? Rational(shape.spots[0].centre + shape.spots[0].radius * dice.part(-2, 2, 16)) : dice.part(-1, 1, 8);
  return shape;
}

/// Six to twenty wedges.
Shape wedges(Dice& dice) {
  const int count = dice.whole(6, 20);
  return bumps(dice, count, dice.whole(count / 2, count));
}

/// Wells at +-a, and also at 0 for degree six; between them psi = 1.
Shape wells(Dice& dice) {
  const bool three = dice.chance(40);
  const Rational a = three ? dice.one_of_these({Rational(3, 4), Rational(4, 5)}) : dice.part(3, 6, 8);
  const Rational share = dice.decades(-25, 4);
  const Polynomial square({0, 0, 1 / (a * a)});
  const Polynomial twice = (square - Polynomial::constant(1)) * (square - Polynomial::constant(1));
  const Polynomial incline({0, share * dice.part(-4, 4, 16)});
  const Polynomial level = three ? Polynomial::constant(Rational(27, 4)) * square * twice : twice;
  const Rational radius = reach(share, 0, (three ? 27 : 4) / (a * a));
  Shape shape{{{1, level + incline}}, {{-a, radius}, {a, radius}}, share * (three ? 3 : 2)};
  if (three) shape.spots.push_back({0, reach(share, 0, Rational(27, 4) / (a * a))});
  return shape;
}

Shape punch(Dice& dice) {
  const Rational place = dice.part(-2, 2, 16);
  const int kind = dice.whole(1, 10);
  if (kind <= 2) return {{{1, Polynomial()}}, {{0, 1}}, dice.decades(-30, 30), place};
  if (kind <= 5) {
    const Rational slope = dice.chance(50) ? 1 : -1;
    return {{{1, Polynomial({0, slope})}}, {{-slope, 1}}, dice.decades(-30, 30)};
  }
  const Rational left = -dice.part(2, 7, 8), right = dice.part(2, 7, 8);
  const Polynomial incline({0, dice.chance(50) ? Rational(0) : dice.part(-2, 2, 16)});
  const auto rounded = [&](const Rational& from, const Rational& end) {
    return around(from, {0, 0, 1 / ((end - from) * (end - from))}) + incline;
  };
  return {
      {{left, rounded(left, -1)}, {right, incline}, {1, rounded(right, 1)}}, {{0, 1}}, dice.decades(-20, 20), place};
}

/// A convex polygon with straight or bent sides. It is pressed in so far that the lowest corners lie inside the
/// contact.
Shape polygon(Dice& dice) {
  const int sides = dice.whole(2, 5);
  std::set<Rational> corners;
  std::set<Rational> slopes;
  while (static_cast<int>(corners.size()) < sides - 1) corners.insert(dice.part(-6, 6, 8));
  while (static_cast<int>(slopes.size()) < sides) slopes.insert(dice.part(-8, 8, 8));
  corners.insert(1);
  const Polynomial bend({0, 0, dice.part(0, 2, 4)});
  Shape shape{{}, {}, dice.decades(-3, 20)};
  Rational from = -1, height = 0;
  auto slope = slopes.begin();
  for (const Rational& to : corners) {
    shape.pieces.push_back({to, Polynomial({height - *slope * from, *slope}) + bend});
    shape.spots.push_back({to == 1 ? Rational(0) : to, Rational(1, 4)});
    height += *slope++ * (to - from);
    from = to;
  }
  return shape;
}

Shape steps(Dice& dice) {
  const Rational a = dice.part(-5, -1, 8), b = dice.part(1, 5, 8), up = dice.part(2, 4, 4);
  const Rational load = dice.decades(-10, 5);
  const auto flat = [](const Rational& height) { return Polynomial::constant(height); };
  switch (dice.whole(1, 5)) {
    case 1: return {{{a, flat(0)}, {1, flat(up)}}, {{(a - 1) / 2, Rational(1, 4)}}, load};
    case 2: return {{{b, flat(up)}, {1, flat(0)}}, {{(b + 1) / 2, Rational(1, 4)}}, load};
    case 3:
      return {{{a, flat(0)}, {b, flat(up)}, {1, flat(0)}},
              {{(a - 1) / 2, Rational(1, 8)}, {(b + 1) / 2, Rational(1, 8)}},
              load};
    case 4: return {{{a, flat(up)}, {b, flat(0)}, {1, flat(1)}}, {{(a + b) / 2, Rational(1, 8)}}, load};
    default: {
      const Polynomial parabola({0, 0, 1});
      const Rational& c = dice.chance(50) ? a : b;
      return {
          {{c, parabola + flat(c == a ? up / 4 : Rational(0))}, {1, parabola + flat(c == a ? Rational(0) : up / 4)}},
          {{0, reach(load, 0, 1)}},
          load};
    }
  }
}

Shape any_polynomial(Dice& dice) {
  std::vector<Rational> coefficients;
  for (int degree = dice.whole(2, 6); degree >= 0; --degree) coefficients.push_back(dice.part(-8, 8, 8));
  return {{{1, Polynomial(coefficients)}}, {{0, 1}}, dice.decades(-20, 20)};
}

/// 10^(k/10) to two digits, k at random: a small length or height.
Rational small(Dice& dice, int lowest, int highest) { return dice.decades(10 * lowest, 10 * highest); }

/// A parabola with a step of 1e-4 to 1e-12 of its height; or a narrow slot in a flat bottom; or two flanks with a short
/// piece between them, 1e-4 to 1e-10 long, that rises or falls, and a step down behind it.
Shape short_gap(Dice& dice) {
  const Rational length = small(dice, -10, -4);
  const Rational curve = dice.chance(30) ? dice.part(1, 4, 4) : Rational(0);
  const Rational load = dice.decades(-8, 5);
  const auto from = [&](const Rational& place, const Rational& height, const Rational& slope) {
    return around(place, {height, slope, curve});
  };
  if (dice.chance(25)) {
    const Rational step = small(dice, -12, -4), share = dice.decades(-20, 4);
    const Rational place = reach(share, 0, 1) * dice.part(-6, 6, 8);
    const Polynomial parabola({0, 0, 1});
    const Polynomial above = parabola + Polynomial::constant(step);
    const bool rises = dice.chance(50);
    return {{{place, rises ? parabola : above}, {1, rises ? above : parabola}}, {{place, Rational(1, 8)}}, share};
  }
  if (dice.chance(20)) {
    const Rational depth = length * dice.decades(-20, 10), place = dice.part(-4, 4, 8);
    return {{{place, Polynomial()}, {place + length, Polynomial::constant(depth)}, {1, Polynomial()}}, {{0, 1}}, load};
  }
  const Rational step = length * dice.decades(-30, 0);
  const Rational rise = length * dice.part(-4, 8, 8);
  const Rational steep = dice.part(1, 8, 8), flat = dice.part(0, 8, 8);
  if (dice.chance(50)) {
    return {{{0, from(0, 0, -steep)}, {length, from(0, 0, rise / length)}, {1, from(length, rise - step, flat)}},
            {{0, 1}},
            load};
  }
  return {{{-length, from(-length, rise - step, -flat)}, {0, from(0, 0, -rise / length)}, {1, from(0, 0, steep)}},
          {{0, 1}},
          load};
}

/// The profile x^4.
Shape flat_bottom(Dice& dice) {
  const Rational load = dice.decades(-30, 4);
  Rational reach = 1;
  while (reach * reach * reach * reach > load && reach > Rational(1, 16)) reach /= 2;
  return {{{1, Polynomial({0, 0, 0, 0, 1})}}, {{0, reach}}, load, reach * dice.part(-2, 2, 16)};
}

/// A wedge and a notch beside it: contact ends before the notch, in it or beyond it, or leaves an almost closed gap
/// over it.
Shape notch(Dice& dice) {
  const Rational place = dice.chance(60) ? dice.part(1, 6, 8) : small(dice, -6, -1);
  const Rational left = dice.part(1, 8, 8), right = dice.part(1, 8, 8);
  const Rational beyond = right * dice.part(-6, 7, 8);
  const Rational curve = dice.part(1, 4, 8);
  Shape shape{{{0, Polynomial({0, -left})}, {place, Polynomial({0, right})}}, {{0, place}, {place, place / 4}}, 0};
  shape.pieces.push_back({1, around(place, {right * place, beyond, curve})});
  shape.load = (left + right) * place * dice.decades(-5, 15);
  return shape;
}

Shape any_shape(Dice& dice) {
  const int kind = dice.whole(1, 100);
  if (kind <= 14) return bumps(dice, 1, 0);
  if (kind <= 32) return bumps(dice, 1, 1);
  if (kind <= 44) return bumps(dice, dice.whole(2, 4), 0);
  if (kind <= 57) {
    const int count = dice.whole(2, 3);
    return bumps(dice, count, dice.whole(1, 2));  // at most five pieces
  }
  if (kind <= 70) return wells(dice);
  if (kind <= 80) return punch(dice);
  if (kind <= 87) return polygon(dice);
  if (kind <= 93) return steps(dice);
  return any_polynomial(dice);
}

Elasticity any_elasticity(Dice& dice) {
  const Rational nu =
      dice.chance(15) ? dice.one_of_these({Rational(-9, 10), 0, Rational(499, 1000)}) : dice.part(-90, 49, 100);
  const Rational young = dice.one_of_these({1, 1, Rational(5, 2), 70, 210000});
  return Elasticity(Solid(nu, young), dice.chance(75) ? Plane::strain : Plane::stress);
}

/// Poisson's ratio near 1/2, 0 or -1.
Elasticity limiting_elasticity(Dice& dice) {
  const Rational off = small(dice, -9, -2);
  const int kind = dice.whole(1, 20);
  const Rational nu = kind <= 8    ? Rational(Rational(1, 2) - off)
                      : kind <= 11 ? off
                      : kind <= 14 ? Rational(-off)
                                   : Rational(off - 1);
  return Elasticity(Solid(nu, 1), dice.chance(75) ? Plane::strain : Plane::stress);
}

/// One in five is zero, half are up to 1, the others up to 20.
Rational any_friction(Dice& dice) {
  const int kind = dice.whole(1, 20);
  return kind <= 4    ? Rational(0)
         : kind <= 14 ? dice.part(1, 100, 100)
         : kind <= 17 ? dice.part(10, 40, 10)
                      : Rational(dice.whole(2, 20));
}

/// The values on the two sides of every jump are nearly the same: they differ by 1e-4 to 1e-16.
std::vector<Rational> neighbouring_values(Dice& dice, std::size_t count) {
  std::vector<Rational> values{any_friction(dice)};
  while (values.size() < count) {
    const Rational step = small(dice, -16, -4);
    const bool rises = dice.chance(50) || values.back() < step;
    values.push_back(rises ? Rational(values.back() + step) : Rational(values.back() - step));
  }
  return values;
}

/// Places on [-1, 1] at which friction changes.
std::vector<Rational> any_jumps(Dice& dice, const Shape& shape) {
  const int count = dice.one_of(std::vector<int>{1, 1, 1, 1, 2, 2, 2, 3, 3, 4, 5, 6});
  std::set<Rational> jumps;
  while (static_cast<int>(jumps.size()) < count) {
    const Spot spot = dice.one_of(shape.spots);
    const Rational corner = dice.one_of(shape.pieces).to;
    const int kind = dice.whole(1, 20);
    const Rational c = kind <= 10   ? Rational(spot.centre + spot.radius * dice.part(-12, 12, 16))
                       : kind <= 13 ? corner
                       : kind <= 15 ? Rational(corner + spot.radius * dice.part(-4, 4, 64))
                                    : dice.part(-63, 63, 64);
    if (-1 < c && c < 1) jumps.insert(c);
  }
  return {jumps.begin(), jumps.end()};
}

/// At least half of the wedges, and the jumps of any problem.
std::vector<Rational> jumps_on_wedges(Dice& dice, const Shape& shape) {
  std::set<Rational> jumps;
  for (const Spot& spot : shape.spots) {
    if (dice.chance(60)) jumps.insert(spot.centre);
  }
  for (const Rational& jump : any_jumps(dice, shape)) jumps.insert(jump);
  return {jumps.begin(), jumps.end()};
}

/// Rounds to three digits.
Rational rounded(const Rational& value) {
  Rational unit = 1;
  while (value / unit < 100) unit /= 10;
  while (value / unit >= 1000) unit *= 10;
  const Rational scaled = value / unit;
  return Rational(Integer(numerator(scaled) / denominator(scaled))) * unit;
}

}  // namespace

ContactProblem random_contact(std::uint64_t seed, ContactFamily family) {
  using enum ContactFamily;
  Dice dice(seed);
  const bool quartic = family == limits_of_poisson && dice.chance(25);
  const bool falling = family == falling_frictions;
  Shape shape = quartic                 ? flat_bottom(dice)
                : family == short_gaps  ? short_gap(dice)
                : family == notches     ? notch(dice)
                : family == many_wedges ? wedges(dice)
                                        : any_shape(dice);
  const bool may_tilt = dice.chance(family == limits_of_poisson ? 40 : 10);
  if (!may_tilt) shape.load_at.reset();
  const Elasticity elasticity = family == limits_of_poisson ? limiting_elasticity(dice)
                                : falling                   ? Elasticity(Solid(0, 1))  // gamma = 1/2
                                                            : any_elasticity(dice);
  const std::vector<Rational> jumps = family == many_wedges ? jumps_on_wedges(dice, shape) : any_jumps(dice, shape);
  std::vector<Rational> values;
  if (family == neighbouring_frictions) values = neighbouring_values(dice, jumps.size() + 1);
  while (values.size() <= jumps.size()) {
    values.push_back(falling                                        ? dice.part(0, 1000, 100)
                     : family == large_frictions && dice.chance(70) ? Rational(dice.whole(20, 50))
                                                                    : any_friction(dice));
  }
  const Rational height =
      dice.one_of_these({Rational(1, 1000), Rational(1, 100), Rational(1, 20), Rational(1, 4), 1, 3});
  const Sliding sliding = dice.chance(50) ? Sliding::plus_x : Sliding::minus_x;
  if (falling) {
    std::sort(values.begin(), values.end());
    if (sliding == Sliding::plus_x) std::reverse(values.begin(), values.end());
  }
  const ContactProblem unit(elasticity, FrictionProfile(values, jumps), Indenter(-1, shape.pieces),
                            rounded(shape.load / elasticity.compliance()), sliding, shape.load_at);
  const Rational length = dice.one_of_these({Rational(1, 4), Rational(1, 2), 1, 1, 2, 5});
  const Rational shift = dice.chance(50) ? Rational(0) : dice.part(-8, 8, 4);
  return unit.with_indenter(unit.indenter().scaled(height)).with_load(height * unit.load()).moved(length, shift);
}

std::optional<ContactFamily> contact_family(std::string_view name) {
  for (const auto& [family, its_name] : contact_families) {
    if (name == its_name) return family;
  }
  return std::nullopt;
}

}  // namespace steadyslide::testing
