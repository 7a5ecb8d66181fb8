#include "proofs_checks/instruments/operators/half_plane_field.hpp"

#include <algorithm>

#include "numeric/quadrature/jacobi_rule.hpp"

namespace steadyslide::proofs_checks {
namespace {

using numeric::Complex;
using numeric::StressComponents;

/// Returns the coefficients of Q. For t = x^k, Q is sum_j zeta^(k-1-j) (b^(j+1) - a^(j+1))/(j+1).
template <Real R>
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

/// Returns Gauss' rule for [0, 1], made once. With this number of nodes it integrates a function to 100 digits and more
/// if its nearest pole is an interval's length away.
template <Real R>
const numeric::UnitRule<R>& gauss_rule() {
  static const auto rule = numeric::jacobi_rule<R>({R(0), R(1)}, {R(0), R(1)}, std::same_as<R, Real100> ? 180 : 90);
  return rule;
}

}  // namespace

template <class R>
PiecewiseDensity<R> density_of(const PiecewiseTraction& traction) {
  PiecewiseDensity<R> density;
  for (const TractionPiece& piece : traction) {
    const auto value = [p = coefficients_of<R>(piece.t)](const Node<R>& node) { return value_of(p, node.x); };
    density.push_back({{to_real<R>(piece.from), to_real<R>(piece.to), to_real<R>(piece.to - piece.from)},
                       {R(0), R(1)},
                       {R(0), R(1)},
                       value});
  }
  return density;
}

template <class R>
HalfPlaneField<R>::HalfPlaneField(const Solid& body, const PiecewiseTraction& normal,
                                  const PiecewiseTraction& tangential)
    : body_(body), normal_(pieces_of(normal)), tangential_(pieces_of(tangential)) {}

template <class R>
std::vector<typename HalfPlaneField<R>::Piece> HalfPlaneField<R>::pieces_of(const PiecewiseTraction& traction) {
  const numeric::UnitRule<R>& rule = gauss_rule<R>();
  std::vector<Piece> result;
  for (const TractionPiece& piece : traction) {
    const R from = to_real<R>(piece.from);
    const R length = to_real<R>(piece.to - piece.from);
    result.push_back({from, to_real<R>(piece.to), coefficients_of<R>(piece.t), remainder_polynomial<R>(piece), {}, {}});
    for (std::size_t i = 0; i < rule.size(); ++i) {
      const R x = from + length * rule.from_left[i];
      result.back().places.push_back(x);
      result.back().forces.push_back(length * rule.weights[i] * value_of(result.back().t, x));
    }
  }
  return result;
}

template <class R>
Jet<R> HalfPlaneField<R>::jet(const std::vector<Piece>& pieces, const Complex<R>& zeta) {
  Jet<R> sum;
  for (const Piece& piece : pieces) {
    const Complex<R> right = zeta - Complex<R>{piece.to, 0};
    const Complex<R> left = zeta - Complex<R>{piece.from, 0};
    const R length = piece.to - piece.from;
    if (right.re * right.re + right.im * right.im > 16 * length * length) {
      // Far away the logarithm and Q cancel. There Gauss' rule computes the integral.
      for (std::size_t i = 0; i < piece.places.size(); ++i) {
        const Complex<R> pole = reciprocal(Complex<R>{piece.places[i] - zeta.re, -zeta.im});
        const Complex<R> square = pole * pole;
        sum = sum + piece.forces[i] * Jet<R>{pole, square, R(2) * (square * pole)};
      }
      continue;
    }
    const Complex<R> pole_right = reciprocal(right);
    const Complex<R> pole_left = reciprocal(left);
    const Jet<R> l{logarithm(right) - logarithm(left), pole_right - pole_left,
                   pole_left * pole_left - pole_right * pole_right};
    sum = sum + polynomial_jet(piece.t, zeta) * l + polynomial_jet(piece.q, zeta);
  }
  return R(1 / numeric::pi<R>()) * sum;
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
  for (const auto* pieces : {&normal_, &tangential_}) {
    for (const Piece& piece : *pieces) {
      for (std::size_t i = 0; i < piece.places.size(); ++i) {
        const R normal = pieces == &normal_ ? piece.forces[i] : R(0);
        const auto part = numeric::stress_of_force<R>(normal, piece.forces[i] - normal, x - piece.places[i], z);
        sum = {sum.xx + part.xx, sum.zz + part.zz, sum.xz + part.xz};
      }
    }
  }
  return sum;
}

template <class R>
R HalfPlaneField<R>::strain_xx(const StressComponents<R>& stress) const {
  const Rational& nu = body_.poisson();
  return (to_real<R>(1 - nu * nu) * stress.xx - to_real<R>(nu * (1 + nu)) * stress.zz) / to_real<R>(body_.young());
}

template <class R>
R HalfPlaneField<R>::tangential_slope(const R& x) const {
  return strain_xx(stress(x, R(0)));
}

/// Uses z = scale y/(1-y). The poles lie at +-i times the distances of the ends; the scale is between the smallest and
/// the largest distance.
template <class R>
R HalfPlaneField<R>::normal_slope(const R& x) const {
  using std::abs, std::sqrt;
  R nearest = numeric::infinity<R>();
  R farthest = 0;
  for (const Piece& piece : normal_) {
    for (const R& end : {piece.from, piece.to}) {
      nearest = std::min(nearest, R(abs(x - end)));
      farthest = std::max(farthest, R(abs(x - end)));
    }
  }
  const numeric::UnitRule<R>& rule = gauss_rule<R>();
  const R scale = sqrt(nearest * farthest);
  R sum = 0;
  for (std::size_t i = 0; i < rule.size(); ++i) {
    const R& rest = rule.from_right[i];
    const StressComponents<R> rate = stress_rate(x, scale * rule.from_left[i] / rest);
    // epsilon_zz is epsilon_xx with x and z exchanged.
    sum += rule.weights[i] * scale / (rest * rest) * strain_xx({rate.zz, rate.xx, rate.xz});
  }
  return sum;
}

#define STEADYSLIDE_INSTANTIATE(R)                                   \
  template PiecewiseDensity<R> density_of(const PiecewiseTraction&); \
  template class HalfPlaneField<R>;
STEADYSLIDE_FOR_EACH_REAL(STEADYSLIDE_INSTANTIATE)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::proofs_checks
