// Compares the contact ends of a parabola from integrals of alpha with those of the general solver, which uses powers.

#include "proofs_checks/instruments/solutions/local_behaviour.hpp"
#include "proofs_checks/instruments/tractions/parabola_cases.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::parabola_any_friction {
namespace {

CaseList<ContactProblem> parabolas(const Context& context) {
  const std::vector<ContactProblem> grid{
      parabola(Rational(3, 10), {Rational(1, 2), 3, 1}, {Rational(-1, 5), Rational(1, 10)}, 1, 1),
      parabola(Rational(3, 10), {2, Rational(1, 2)}, {0}, Rational(1, 5), 1, Rational(1, 3), Sliding::minus_x),
      parabola(0, {1, 0, 2, Rational(1, 3)}, {-5, Rational(1, 20), 7}, Rational(1, 2), 1)};
  return grid_and_random(context, "parabola-any-friction", grid, {8, 3, 1}, [&](Random& random) {
    const std::size_t m = random.below(5);
    std::vector<Rational> friction;
    for (std::size_t piece = 0; piece <= m; ++piece) friction.push_back(random.friction(5));
    const Rational load = random.between(Rational(1, 10), 4);
    const Rational radius = random.between(Rational(1, 10), 4);
    return parabola(random.poisson(), friction, random_jumps(random, m), radius, load);
  });
}

/// Factors that a wrong variant changes.
struct Law {
  int angle = 1;
  int moment = 1;
  Number load = 2;
};

/// Returns the contact ends by Newton's method for the zeros of -2 int alpha - (a+b) and
/// 2 P R/pi - (a^2+b^2)/2 - 2 int y alpha. The derivatives are those with respect to the integrals' limits: -(1 -+ 2 alpha), and this times a or b.
/// Coordinates are measured from the vertex.
Values ends(const ContactProblem& p, const Law& law) {
  const auto vertex = to_real<Number>(vertex_of(p));
  std::vector<Number> jumps;
  for (const Rational& c : p.friction().jumps()) jumps.push_back(to_real<Number>(c) - vertex);
  std::vector<Number> angle;
  for (const Exponent& a : angles(p)) angle.push_back(law.angle * to_real<Number>(a));
  const auto angle_at = [&](const Number& x) {
    std::size_t k = 0;
    while (k < jumps.size() && jumps[k] < x) ++k;
    return angle[k];
  };
  /// Returns int_0^x y^j alpha dy.
  const auto integral = [&](const Number& x, int j) {
    const auto power = [&](const Number& y) { return j == 0 ? y : Number(y * y / 2); };
    Number sum = 0;
    Number before = 0;
    for (std::size_t k = 0; k < angle.size(); ++k) {
      const Number end = k < jumps.size() && jumps[k] < x ? jumps[k] : x;
      sum += angle[k] * (power(end) - (k == 0 ? Number(0) : power(before)));
      if (end == x) break;
      before = end;
    }
    return sum;
  };
  const Number square = law.load * to_real<Number>(p.load()) * to_real<Number>(radius_of(p)) / numeric::pi<Number>();
  Number a = -sqrt(square);
  Number b = -a;
  for (int step = 0; step < 200; ++step) {
    const Number first = -2 * (integral(b, 0) - integral(a, 0)) - (a + b);
    const Number second = square - (a * a + b * b) / 2 - 2 * law.moment * (integral(b, 1) - integral(a, 1));
    const Number left = 1 - 2 * angle_at(a);
    const Number right = 1 + 2 * angle_at(b);
    const Number da = (first * b - second) / (left * (b - a));
    const Number db = (second - first * a) / (right * (b - a));
    // The limited step keeps each end on its side of the vertex, so that the contact does not vanish.
    const Number longest = (b - a) / 3;
    const Number scale = std::max({Number(1), Number(abs(da) / longest), Number(abs(db) / longest)});
    a += da / scale;
    b += db / scale;
  }
  return {{"left", Number(a + vertex)}, {"right", Number(b + vertex)}};
}

}  // namespace

Claim claim() {
  return compared<ContactProblem>("parabola-any-friction")
      .cases(parabolas)
      .effective_where(has_friction)
      .precision(Precision::quick_in_double)
      .measured([]<Real R>(const ContactProblem& p) -> Values {
        const auto contact = solve<R>(p)->contact();
        return {{"left", contact.front().left.x.value}, {"right", contact.back().right.x.value}};
      })
      .predicted([](const ContactProblem& p) { return ends(p, {}); })
      .wrong("the contact moved to the front",
             [](Values& v, const ContactProblem& p) { v.set(ends(p, {.angle = -1})); })
      .wrong("without friction", [](Values& v, const ContactProblem& p) { v.set(ends(p, {.angle = 0})); })
      .wrong("`P R/pi` for `2 P R/pi`", [](Values& v, const ContactProblem& p) { v.set(ends(p, {.load = 1})); })
      .near_misses();
}

}  // namespace steadyslide::proofs_checks::parabola_any_friction
