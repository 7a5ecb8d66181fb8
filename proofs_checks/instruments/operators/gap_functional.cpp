#include "proofs_checks/instruments/operators/gap_functional.hpp"

#include <algorithm>

#include "numeric/quadrature/jacobi_rule.hpp"

namespace steadyslide::proofs_checks {
namespace {

using numeric::Power;

/// Returns Bernstein's coefficients of degree 3 on [left, right].
template <Real R>
std::array<R, 4> bernstein(const Polynomial& p, const Rational& left, const Rational& right) {
  const Rational h = right - left;
  const Polynomial slope = p.derivative();
  return {to_real<R>(p(left)), to_real<R>(p(left) + h * slope(left) / 3), to_real<R>(p(right) - h * slope(right) / 3),
          to_real<R>(p(right))};
}

/// True if a + C <= 0 on the whole interval. If this is not decided at the last depth, the maximum differs from 0 only
/// by rounding.
template <Real R>
bool is_nonpositive(const std::array<R, 4>& a, const R& shift, int depth) {
  if (a[0] + shift > 0 || a[3] + shift > 0) return false;
  if ((a[1] + shift <= 0 && a[2] + shift <= 0) || depth == 0) return true;
  const R ab = (a[0] + a[1]) / 2;
  const R bc = (a[1] + a[2]) / 2;
  const R cd = (a[2] + a[3]) / 2;
  const R abc = (ab + bc) / 2;
  const R bcd = (bc + cd) / 2;
  const R middle = (abc + bcd) / 2;
  return is_nonpositive<R>({a[0], ab, abc, middle}, shift, depth - 1) &&
         is_nonpositive<R>({middle, bcd, cd, a[3]}, shift, depth - 1);
}

/// Returns int v/W by Gauss-Jacobi rules on panels. A panel is divided until it is not longer than its distance from
/// the ends of ]-1, 1[ that are not its own.
template <Real R>
R on_panel(numeric::JacobiRules<R>& rules, const Rational& s, const Rational& left, const Rational& right,
           const Polynomial& v) {
  using std::pow;
  const Rational length = right - left;
  const Rational before = left == -1 ? Rational(2) : left + 1;
  const Rational behind = right == 1 ? Rational(2) : 1 - right;
  if (length > before || length > behind) {
    const Rational middle = (left + right) / 2;
    return on_panel<R>(rules, s, left, middle, v) + on_panel<R>(rules, s, middle, right, v);
  }
  const Exponent angle = Exponent::angle(s);
  const auto a = Power<R>::of(-(half + angle));
  const auto b = Power<R>::of(-(half - angle));
  const Power<R> none{R(0), R(1)};
  // The error falls as 5.8^{-2n} with the number n of nodes.
  constexpr int nodes = std::same_as<R, double> ? 14 : std::same_as<R, Real50> ? 42 : 82;
  const numeric::UnitRule<R>& rule = rules.get(left == -1 ? a : none, right == 1 ? b : none, nodes);
  const R h = to_real<R>(length);
  R scale = h;
  if (left == -1) scale *= pow(h, a.value);
  if (right == 1) scale *= pow(h, b.value);
  R sum = 0;
  for (std::size_t i = 0; i < rule.size(); ++i) {
    const R x = to_real<R>(left) + h * rule.from_left[i];
    R value = value_of(v, x);
    if (left != -1) value *= pow(R(1 + x), a.value);
    if (right != 1) value *= pow(R(1 - x), b.value);
    sum += rule.weights[i] * value;
  }
  return scale * sum;
}

/// Returns t_0 v on the panels, with t_0 for the friction s.
template <Real R>
PiecewiseDensity<R> weighted(const Rational& s, const PiecewiseFunction& v) {
  const Exponent angle = Exponent::angle(s);
  const auto a = Power<R>::of(-(half + angle));
  const auto b = Power<R>::of(-(half - angle));
  const Power<R> none{R(0), R(1)};
  const R size = cos_pi_alpha<R>(s) / numeric::pi<R>();
  PiecewiseDensity<R> density;
  for (std::size_t k = 0; k < v.pieces.size(); ++k) {
    const bool first = k == 0;
    const bool last = k + 1 == v.pieces.size();
    const R left = to_real<R>(v.points[k]);
    const R right = to_real<R>(v.points[k + 1]);
    const auto smooth = [=, piece = coefficients_of<R>(v.pieces[k])](const Node<R>& node) {
      using std::pow;
      R value = size * value_of(piece, node.x);
      if (!first) value *= pow(R(1 + left + node.from_left), a.value);
      if (!last) value *= pow(R(1 - right + node.from_right), b.value);
      return value;
    };
    density.push_back({{left, right, R(right - left)}, first ? a : none, last ? b : none, smooth});
  }
  return density;
}

}  // namespace

PiecewiseFunction PiecewiseFunction::constant(const Rational& value, std::vector<Rational> points) {
  const std::size_t panels = points.size() - 1;
  return {std::move(points), std::vector<Polynomial>(panels, Polynomial::constant(value))};
}

PiecewiseFunction PiecewiseFunction::combined(const Rational& a, const PiecewiseFunction& f, const Rational& b,
                                              const PiecewiseFunction& g) {
  PiecewiseFunction sum{f.points, {}};
  sum.pieces.reserve(f.pieces.size());
  for (std::size_t k = 0; k < f.pieces.size(); ++k) {
    sum.pieces.push_back(Polynomial::constant(a) * f.pieces[k] + Polynomial::constant(b) * g.pieces[k]);
  }
  return sum;
}

Rational PiecewiseFunction::at(const Rational& x) const {
  std::size_t k = 0;
  while (k + 1 < pieces.size() && x > points[k + 1]) ++k;
  return pieces[k](x);
}

PiecewiseFunction random_polygon(Random& random, const std::vector<Rational>& points) {
  PiecewiseFunction v{points, {}};
  Rational left = random.between(-1, 1);
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    const Rational right = random.between(-1, 1);
    const Rational slope = (right - left) / (points[k + 1] - points[k]);
    v.pieces.emplace_back(std::vector<Rational>{left - slope * points[k], slope});
    left = right;
  }
  return v;
}

PiecewiseFunction random_cubic(Random& random) { return {{-1, 1}, {Polynomial(random.between(-1, 1, 4))}}; }

std::vector<Rational> random_points(Random& random) {
  std::vector<Rational> points{-1, 1};
  const std::size_t inner = 1 + random.below(3);
  while (points.size() < inner + 2) {
    const Rational c(static_cast<long>(random.below(13)) - 6, 8);
    if (std::ranges::find(points, c) == points.end()) points.push_back(c);
  }
  std::ranges::sort(points);
  return points;
}

template <Real R>
R supremum(const PiecewiseFunction& v) {
  using std::max, std::sqrt;
  R most = to_real<R>(v.pieces[0](-1));
  for (std::size_t k = 0; k < v.pieces.size(); ++k) {
    const Polynomial& p = v.pieces[k];
    most = max({most, to_real<R>(p(v.points[k])), to_real<R>(p(v.points[k + 1]))});
    // An inner maximum is a zero of the slope c + 2 b x + a x^2. Rational numbers decide if there is none.
    const Rational a = 3 * p.coefficient(3);
    const Rational b = p.coefficient(2);
    const Rational c = p.coefficient(1);
    const Rational discriminant = b * b - a * c;
    if (discriminant < 0 || (a == 0 && b == 0)) continue;
    // The zero at which the slope falls: x = -(b + sqrt)/a = c/(sqrt - b).
    const R root = sqrt(to_real<R>(discriminant));
    const R x =
        b < 0 || a == 0 ? R(to_real<R>(c) / (root - to_real<R>(b))) : R(-(to_real<R>(b) + root) / to_real<R>(a));
    if (x > to_real<R>(v.points[k]) && x < to_real<R>(v.points[k + 1])) most = max(most, value_of(p, x));
  }
  return most;
}

template <Real R>
R largest_shift(const PiecewiseFunction& v) {
  std::vector<std::array<R, 4>> panels;
  R high = to_real<R>(-v.pieces[0](-1));
  for (std::size_t k = 0; k < v.pieces.size(); ++k) {
    panels.push_back(bernstein<R>(v.pieces[k], v.points[k], v.points[k + 1]));
  }
  R low = high;
  for (const auto& panel : panels) low = std::min(low, R(-*std::ranges::max_element(panel)));
  constexpr int bits = std::numeric_limits<R>::digits;
  for (int step = 0; step < bits && low < high; ++step) {
    const R middle = low + (high - low) / 2;
    const auto allowed = [&](const auto& panel) { return is_nonpositive(panel, middle, bits / 2); };
    (std::ranges::all_of(panels, allowed) ? low : high) = middle;
  }
  return low;
}

template <Real R>
R pairing(const Rational& s, const PiecewiseFunction& v) {
  // A claim pairs many functions with few friction values, so the rules are kept.
  thread_local numeric::JacobiRules<R> rules;
  R sum = 0;
  for (std::size_t k = 0; k < v.pieces.size(); ++k) {
    sum += on_panel(rules, s, v.points[k], v.points[k + 1], v.pieces[k]);
  }
  return cos_pi_alpha<R>(s) / numeric::pi<R>() * sum;
}

template <Real R>
R pairing_by_tanh_sinh(const Rational& s, const PiecewiseFunction& v) {
  return tanh_sinh::integral(weighted<R>(s, v)).value;
}

template <Real R>
R pairing_by_moments(const Rational& s, const Polynomial& v) {
  const R twice = 2 * to_real<R>(Exponent::angle(s));
  R before = 0;
  R moment = 1;
  R sum = 0;
  for (std::size_t k = 0; k < v.coefficients().size(); ++k) {
    sum += to_real<R>(v.coefficient(k)) * moment;
    const auto n = static_cast<int>(k);
    const R next = (n * before - twice * moment) / (n + 1);
    before = moment;
    moment = next;
  }
  return sum;
}

#define STEADYSLIDE_INSTANTIATE(R)                                            \
  template R supremum(const PiecewiseFunction&);                              \
  template R largest_shift(const PiecewiseFunction&);                         \
  template R pairing(const Rational&, const PiecewiseFunction&);              \
  template R pairing_by_tanh_sinh(const Rational&, const PiecewiseFunction&); \
  template R pairing_by_moments(const Rational&, const Polynomial&);
STEADYSLIDE_FOR_EACH_REAL(STEADYSLIDE_INSTANTIATE)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::proofs_checks
