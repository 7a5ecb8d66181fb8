#include "proofs_checks/instruments/half_plane_field.hpp"

#include <algorithm>
#include <utility>

#include "numeric/number/polynomial.hpp"

namespace steadyslide::proofs_checks {
namespace {

using numeric::coefficients_of;
using numeric::Complex;
using numeric::Real;
using numeric::StressComponents;
using numeric::to_real;
using numeric::value_of;

/// Coefficients of Q: of t = x^k it is sum_j zeta^(k-1-j) (b^(j+1) - a^(j+1))/(j+1).
template <class R>
std::vector<R> remainder_polynomial(const TractionPiece& piece) {
  std::vector<Rational> q(static_cast<std::size_t>(std::max(piece.t.degree(), 0)), Rational(0));
  for (std::size_t k = 1; k <= q.size(); ++k) {
    Rational a = piece.from;
    Rational b = piece.to;
    for (std::size_t j = 0; j < k; ++j) {
      q[k - 1 - j] += piece.t.coefficient(k) * (b - a) / static_cast<long>(j + 1);
      a *= piece.from;
      b *= piece.to;
    }
  }
  return coefficients_of<R>(Polynomial(std::move(q)));
}

/// With so many nodes functions whose nearest pole is a length of the interval away are exact to 100 digits and more.
template <class R>
constexpr int gauss_nodes = std::same_as<R, numeric::Real100> ? 180 : 90;

}  // namespace

PiecewiseTraction scaled_pieces(const PiecewiseTraction& traction, const std::vector<Rational>& factors) {
  PiecewiseTraction result;
  for (std::size_t k = 0; k < traction.size(); ++k) {
    result.push_back({traction[k].from, traction[k].to, Polynomial::constant(factors.at(k)) * traction[k].t});
  }
  return result;
}

template <class R>
numeric::PiecewiseDensity<R> density_of(const PiecewiseTraction& traction) {
  numeric::PiecewiseDensity<R> density;
  Rational before = 0;
  for (const TractionPiece& piece : traction) {
    const numeric::Panel<R> panel{to_real<R>(piece.from), to_real<R>(piece.to), to_real<R>(piece.to - piece.from)};
    const auto value = [p = coefficients_of<R>(piece.t)](const numeric::Node<R>& node) { return value_of(p, node.x); };
    const R gap = density.empty() ? R(0) : to_real<R>(piece.from - before);
    density.push_back({panel, {R(0), R(1)}, {R(0), R(1)}, value, gap});
    before = piece.to;
  }
  return density;
}

template <class R>
R value_at(const PiecewiseTraction& traction, const R& x) {
  for (const TractionPiece& piece : traction) {
    if (to_real<R>(piece.from) < x && x < to_real<R>(piece.to)) return value_of(coefficients_of<R>(piece.t), x);
  }
  return 0;
}

template <class R>
HalfPlaneField<R>::HalfPlaneField(Solid body, const PiecewiseTraction& normal, const PiecewiseTraction& tangential,
                                  GaussRules& rules)
    : body_(std::move(body)),
      rule_(std::get<numeric::JacobiRules<R>>(rules).get({R(0), R(1)}, {R(0), R(1)}, gauss_nodes<R>)),
      normal_(pieces_of(normal)),
      tangential_(pieces_of(tangential)) {}

template <class R>
std::vector<typename HalfPlaneField<R>::Piece> HalfPlaneField<R>::pieces_of(const PiecewiseTraction& traction) const {
  std::vector<Piece> result;
  for (const TractionPiece& piece : traction) {
    const R from = to_real<R>(piece.from);
    const R length = to_real<R>(piece.to - piece.from);
    result.push_back({from, to_real<R>(piece.to), coefficients_of<R>(piece.t), remainder_polynomial<R>(piece), {}, {}});
    for (std::size_t i = 0; i < rule_.size(); ++i) {
      const R x = from + length * rule_.from_left[i];
      result.back().places.push_back(x);
      result.back().forces.push_back(length * rule_.weights[i] * value_of(result.back().t, x));
    }
  }
  return result;
}

/// Far away the logarithm and Q cancel: there the integral by Gauss' rule.
template <class R>
Jet<R> HalfPlaneField<R>::far_jet(const Piece& piece, const Complex<R>& zeta) {
  Jet<R> sum{{0, 0}, {0, 0}, {0, 0}};
  for (std::size_t i = 0; i < piece.places.size(); ++i) {
    const Complex<R> pole = reciprocal(Complex<R>{piece.places[i] - zeta.re, -zeta.im});
    const Complex<R> square = pole * pole;
    sum.value = sum.value + piece.forces[i] * pole;
    sum.first = sum.first + piece.forces[i] * square;
    sum.second = sum.second + R(2 * piece.forces[i]) * (square * pole);
  }
  return sum;
}

template <class R>
Jet<R> HalfPlaneField<R>::jet(const std::vector<Piece>& pieces, const Complex<R>& zeta) {
  Jet<R> sum{{0, 0}, {0, 0}, {0, 0}};
  for (const Piece& piece : pieces) {
    const Complex<R> right = zeta - Complex<R>{piece.to, 0};
    const Complex<R> left = zeta - Complex<R>{piece.from, 0};
    const R length = piece.to - piece.from;
    Jet<R> part;
    if (right.re * right.re + right.im * right.im > 16 * length * length) {
      part = far_jet(piece, zeta);
    } else {
      const Complex<R> pole_right = reciprocal(right);
      const Complex<R> pole_left = reciprocal(left);
      const Jet<R> l{logarithm(right) - logarithm(left), pole_right - pole_left,
                     pole_left * pole_left - pole_right * pole_right};
      const Jet<R> t = polynomial_jet(piece.t, zeta);
      const Jet<R> q = polynomial_jet(piece.q, zeta);
      part = {t.value * l.value + q.value, t.first * l.value + t.value * l.first + q.first,
              t.second * l.value + R(2) * (t.first * l.first) + t.value * l.second + q.second};
    }
    sum = {sum.value + part.value, sum.first + part.first, sum.second + part.second};
  }
  const R factor = 1 / numeric::pi<R>();
  return {factor * sum.value, factor * sum.first, factor * sum.second};
}

template <class R>
StressComponents<R> HalfPlaneField<R>::stress(const R& x, const R& z) const {
  const Jet<R> n = jet(normal_, {x, z});
  const Jet<R> t = jet(tangential_, {x, z});
  return numeric::stress_of_potentials<R>({n.value, n.first}, {t.value, t.first}, z);
}

template <class R>
StressComponents<R> HalfPlaneField<R>::stress_rate(const R& x, const R& z) const {
  const Jet<R> n = jet(normal_, {x, z});
  const Jet<R> t = jet(tangential_, {x, z});
  return numeric::stress_of_potentials<R>({n.first, n.second}, {t.first, t.second}, z);
}

template <class R>
StressComponents<R> HalfPlaneField<R>::superposed_stress(const R& x, const R& z) const {
  StressComponents<R> sum{0, 0, 0};
  const auto add = [&](const Piece& piece, bool is_normal) {
    for (std::size_t i = 0; i < piece.places.size(); ++i) {
      const R& force = piece.forces[i];
      const auto part =
          numeric::stress_of_force<R>(is_normal ? force : R(0), is_normal ? R(0) : force, x - piece.places[i], z);
      sum = {sum.xx + part.xx, sum.zz + part.zz, sum.xz + part.xz};
    }
  };
  for (const Piece& piece : normal_) add(piece, true);
  for (const Piece& piece : tangential_) add(piece, false);
  return sum;
}

template <class R>
R HalfPlaneField<R>::strain_xx(const StressComponents<R>& stress) const {
  const Rational& nu = body_.poisson();
  return (to_real<R>(1 - nu * nu) * stress.xx - to_real<R>(nu * (1 + nu)) * stress.zz) / to_real<R>(body_.young());
}

template <class R>
R HalfPlaneField<R>::strain_zz(const StressComponents<R>& stress) const {
  return strain_xx({stress.zz, stress.xx, stress.xz});
}

template <class R>
R HalfPlaneField<R>::tangential_slope(const R& x) const {
  return strain_xx(stress(x, R(0)));
}

/// z = scale y/(1-y), the scale between the distances of the nearest and the farthest end: they lie at +-i distance.
template <class R>
R HalfPlaneField<R>::normal_slope(const R& x) const {
  using std::abs, std::sqrt;
  R nearest = numeric::infinity<R>();
  R farthest = 0;
  for (const auto* pieces : {&normal_, &tangential_}) {
    for (const Piece& piece : *pieces) {
      for (const R& end : {piece.from, piece.to}) {
        nearest = std::min(nearest, R(abs(x - end)));
        farthest = std::max(farthest, R(abs(x - end)));
      }
    }
  }
  const R scale = sqrt(nearest * farthest);
  R sum = 0;
  for (std::size_t i = 0; i < rule_.size(); ++i) {
    const R& rest = rule_.from_right[i];
    const R z = scale * rule_.from_left[i] / rest;
    sum += rule_.weights[i] * scale / (rest * rest) * strain_zz(stress_rate(x, z));
  }
  return sum;
}

#define STEADYSLIDE_INSTANTIATE(R)                                            \
  template numeric::PiecewiseDensity<R> density_of(const PiecewiseTraction&); \
  template R value_at(const PiecewiseTraction&, const R&);                    \
  template class HalfPlaneField<R>;
STEADYSLIDE_INSTANTIATE(double)
STEADYSLIDE_INSTANTIATE(numeric::Real50)
STEADYSLIDE_INSTANTIATE(numeric::Real100)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::proofs_checks
