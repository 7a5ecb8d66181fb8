#include "checker/cells.hpp"

#include <acb_elliptic.h>
#include <flint/fmpz_poly.h>

#include <algorithm>
#include <cstdlib>

#include "checker/certificate.hpp"
#include "checker/failure.hpp"
#include "checker/reader.hpp"

namespace steadyslide::checker {
namespace {

constexpr slong precision = 160;
constexpr slong fraction = 128;  ///< bits after the point of the numbers in sums over all nodes
constexpr std::size_t near = 3;
constexpr std::size_t degree = 8;
constexpr int most_halvings = 60;
constexpr std::size_t most_cells = std::size_t{1} << 22;
constexpr std::int64_t largest_weight = (std::int64_t{1} << 41) - 1;  ///< so that no sum of weights exceeds 63 bits

Ball ball(const Rational& q) { return {q, precision}; }
Rational size(const Rational& q) { return q.sign() < 0 ? Rational(0) - q : q; }
/// Returns k/2.
Ball halves(long k) { return Ball(static_cast<double>(k) / 2).rounded(precision); }
Ball logarithm_of_size(const Ball& x) { return log(x.is_negative() ? -x : x); }
/// Returns x log|x|; 0 at 0.
Ball l(const Ball& x) { return x.is_zero() ? x : x * logarithm_of_size(x); }
/// Returns int_0^x l = x^2/2 log|x| - x^2/4.
Ball integral_of_l(const Ball& x) { return x * l(x) * Ball(0.5) - x * x * Ball(0.25); }
/// Returns l on [0, w], w <= 1. It decreases to -1/e at 1/e and increases to 0 at 1.
Ball range_of_l(const Ball& w) { return hull((Ball(0.25) - w).is_positive() ? l(w) : Ball(-0.375), Ball()); }

/// Returns sum_m w_m kernel(i + 1/2 - m) for the cells i = 0..N-1. The argument is passed doubled, as an odd integer.
template <class Kernel>
std::vector<Ball> sums_over_nodes(const std::vector<std::int64_t>& w, const Kernel& kernel) {
  const auto n = static_cast<slong>(w.size()) - 1;
  struct IntegerPolynomial {
    fmpz_poly_t poly;
    IntegerPolynomial() { fmpz_poly_init(poly); }
    ~IntegerPolynomial() { fmpz_poly_clear(poly); }
  } a, k, product;
  fmpz_t number;
  fmpz_init(number);
  Ball sizes;
  for (slong m = 0; m <= n; ++m) {
    fmpz_poly_set_coeff_si(a.poly, m, w[static_cast<std::size_t>(m)]);
    sizes += Ball(static_cast<double>(std::abs(w[static_cast<std::size_t>(m)])));
  }
  Ball error;  // error of a kernel value, in units of 2^-fraction
  for (slong d = -n; d < n; ++d) {
    Ball value = kernel(2 * d + 1);
    arb_mul_2exp_si(value.get(), value.get(), fraction);
    arf_get_fmpz(number, arb_midref(value.get()), ARF_RND_NEAR);
    fmpz_poly_set_coeff_fmpz(k.poly, d + n, number);
    const Ball radius = value.radius() + Ball(1);
    if ((radius - error).is_positive()) error = radius;
  }
  fmpz_poly_mul(product.poly, a.poly, k.poly);
  std::vector<Ball> result;
  for (slong i = 0; i < n; ++i) {
    fmpz_poly_get_coeff_fmpz(number, product.poly, i + n);
    Ball sum = Ball().rounded(precision);
    arb_set_round_fmpz(sum.get(), number, precision);
    sum = sum.widened(error * sizes);
    arb_mul_2exp_si(sum.get(), sum.get(), -fraction);
    result.push_back(sum);
  }
  fmpz_clear(number);
  return result;
}

class Gap {
 public:
  explicit Gap(const Cells& cells) : cells_(cells), n_(cells.weights.size()) {
    const Problem& p = cells.problem;
    h_ = (p.pieces.back().to - p.left) / Rational(static_cast<slong>(n_));
    for (std::size_t m = 0; m <= n_; ++m) {
      rises_.push_back((m < n_ ? cells.weights[m] : 0) - (m > 0 ? cells.weights[m - 1] : 0));
    }
    for (const std::int64_t w : cells.weights) total_ += w;
    S_ = ball(Rational(total_));
    per_pi_ = Ball(1) / (Ball::pi(precision) * S_);
    far_ = far_coefficients();
    Ball sizes;
    for (const std::int64_t r : rises_) sizes += ball(Rational(std::abs(r)));
    // 2^-9/(72 3.5^8 (1 - 1/7)) < 2^-9/72/22518 7/6
    rest_ = (sizes * per_pi_ * Ball(7.0) / Ball(512.0 * 72 * 22518 * 6)).upper();
  }

  /// Proves H >= <H, p_h>/P - E everywhere.
  std::size_t prove() {
    Ball mean;
    std::vector<std::vector<CellPolynomial>> cells(n_);
    Progress progress;
    for (std::size_t i = 0; i < n_; ++i) {
      cells[i] = parts(i, progress);
      if (cells_.weights[i] != 0) mean += ball(Rational(cells_.weights[i])) * mean_of(i, cells[i]);
    }
    level_ = mean / S_ - ball(cells_.energy);
    for (std::size_t i = 0; i < n_; ++i) {
      for (const CellPolynomial& part : cells[i]) check(i, part, part.from, part.to, 0);
    }
    return intervals_;
  }

 private:
  /// A part of a cell, with psi/(c P) + F/S there as a polynomial in t.
  struct CellPolynomial {
    Ball from;
    Ball to;
    std::vector<Ball> given;
  };

  /// Returns, for each cell, the coefficients of t^p in the sum over the far nodes.
  std::vector<std::vector<Ball>> far_coefficients() const {
    std::vector<Ball> logs;  // logarithms of k + 1/2
    for (std::size_t k = 0; k <= n_; ++k) logs.push_back(log(halves(2 * static_cast<long>(k) + 1)));
    std::vector<std::vector<Ball>> result;
    for (std::size_t p = 0; p <= degree; ++p) {
      result.push_back(sums_over_nodes(rises_, [&](long twice) -> Ball {
        const auto k = static_cast<std::size_t>((std::abs(twice) - 1) / 2);
        if (k < near) return Ball().rounded(precision);
        const Ball d = halves(twice);
        if (p == 0) return d * logs[k];
        if (p == 1) return logs[k] + Ball(1);
        Ball power = Ball(1).rounded(precision);
        for (std::size_t q = 1; q < p; ++q) power *= d;
        const int divisor = static_cast<int>(p * (p - 1));
        return Ball(p % 2 == 0 ? 1 : -1) / (Ball(divisor) * power);
      }));
    }
    return result;
  }

  /// The progress of parts(): the current piece of the profile and of friction, and F = int_0^i s n.
  struct Progress {
    std::size_t piece = 0;
    std::size_t friction = 0;
    Rational work;
  };

  std::vector<CellPolynomial> parts(std::size_t i, Progress& at) const {
    const Problem& p = cells_.problem;
    const Rational weight(cells_.weights[i]);
    Rational place = p.left + h_ * Rational(static_cast<slong>(i));
    const Rational right = place + h_;
    const Rational middle = (place + right) / Rational(2);
    std::vector<CellPolynomial> result;
    while (place < right) {
      Rational next = std::min(right, p.pieces[at.piece].to);
      if (at.friction < p.jumps.size()) next = std::min(next, p.jumps[at.friction]);
      const Rational s = p.s(at.friction);
      const Rational from = (place - middle) / h_, to = (next - middle) / h_;
      const Polynomial height =
          composed(p.pieces[at.piece].profile, h_, middle) * Polynomial{Rational(1) / (p.compliance * p.loads.from)};
      const Polynomial work{(at.work - s * weight * from) / Rational(total_), s * weight / Rational(total_)};
      result.push_back({ball(from), ball(to), balls(trimmed(height + work), precision)});
      at.work = at.work + s * weight * (to - from);
      place = next;
      if (place == p.pieces[at.piece].to && at.piece + 1 < p.pieces.size()) ++at.piece;
      if (at.friction < p.jumps.size() && place == p.jumps[at.friction]) ++at.friction;
    }
    return result;
  }

  /// Calls f(-r/(pi S), tau) for the near nodes, with r = r_m and tau = m - i - 1/2.
  template <class F>
  void for_near(std::size_t i, const F& f) const {
    for (std::size_t m = i + 1 > near ? i + 1 - near : 0; m <= std::min(i + near, n_); ++m) {
      if (rises_[m] == 0) continue;
      f(-(ball(Rational(rises_[m])) * per_pi_), halves(2 * (static_cast<long>(m) - static_cast<long>(i)) - 1));
    }
  }

  Ball smooth(std::size_t i, const CellPolynomial& part, const Ball& t) const {
    Ball far;
    for (std::size_t p = degree + 1; p-- > 0;) far = far * t + far_[p][i];
    return horner(part.given, t) - far * per_pi_;
  }

  Ball smooth_slope(std::size_t i, const CellPolynomial& part, const Ball& t) const {
    Ball far, given;
    for (std::size_t p = degree + 1; p-- > 1;) far = far * t + Ball(static_cast<int>(p)) * far_[p][i];
    for (std::size_t p = part.given.size(); p-- > 1;) given = given * t + Ball(static_cast<int>(p)) * part.given[p];
    return given - far * per_pi_;
  }

  Ball at(std::size_t i, const CellPolynomial& part, const Ball& t) const {
    Ball value = smooth(i, part, t);
    for_near(i, [&](const Ball& factor, const Ball& tau) { value += factor * l(t - tau); });
    return value;
  }

  Ball mean_of(std::size_t i, const std::vector<CellPolynomial>& parts) const {
    const auto integral = [](const std::vector<Ball>& p, const Ball& from, const Ball& to) {
      std::vector<Ball> primitive{Ball()};
      for (std::size_t k = 0; k < p.size(); ++k) primitive.push_back(p[k] / Ball(static_cast<int>(k + 1)));
      return horner(primitive, to) - horner(primitive, from);
    };
    Ball sum;
    for (const CellPolynomial& part : parts) sum += integral(part.given, part.from, part.to);
    std::vector<Ball> far;
    for (std::size_t p = 0; p <= degree; ++p) far.push_back(far_[p][i]);
    const Ball half(0.5);
    sum -= integral(far, -half, half) * per_pi_;
    for_near(i, [&](const Ball& factor, const Ball& tau) {
      sum += factor * (integral_of_l(half - tau) - integral_of_l(-half - tau));
    });
    return sum.widened(rest_);
  }

  std::string name(std::size_t i, const Ball& t) const {
    const Ball y = ball(Rational(static_cast<slong>(i))) + Ball(0.5) + t;
    return "x = " + (ball(cells_.problem.left) + ball(h_) * y).middle().text(8);
  }

  /// Checks H >= level_ on [t0, t1].
  void check(std::size_t i, const CellPolynomial& part, const Ball& t0, const Ball& t1, int halvings) {
    ++intervals_;
    const Ball middle = ((t0 + t1) * Ball(0.5)).middle();
    const Ball all = hull(t0, t1);
    Ball value = smooth(i, part, middle);
    Ball slope = smooth_slope(i, part, all);
    Ball ends;  // terms of the nodes at the ends
    for_near(i, [&](const Ball& factor, const Ball& tau) {
      const Ball x = all - tau;
      if (arb_contains_zero(x.get()) != 0) {
        const bool beyond = tau.is_positive();  // x <= 0
        ends += (beyond ? -factor : factor) * range_of_l(x.size());
      } else {
        value += factor * l(middle - tau);
        slope += factor * (logarithm_of_size(x) + Ball(1));
      }
    });
    const Ball needed = level_ + rest_;
    const Ball low = value + slope * (all - middle) + ends - needed;
    if (arb_is_nonnegative(low.get()) != 0) return;
    const bool monotone = ends.is_zero() && (slope.is_positive() || slope.is_negative());
    if (monotone && arb_is_nonnegative((at(i, part, slope.is_positive() ? t0 : t1) - needed).get()) != 0) return;
    if ((at(i, part, middle) + rest_ - level_).is_negative()) {
      throw Unproved("the energy is larger than claimed: the gap is too low at " + name(i, middle));
    }
    if (halvings == most_halvings) throw Unproved("the energy claimed is not decided near " + name(i, middle));
    check(i, part, t0, middle, halvings + 1);
    check(i, part, middle, t1, halvings + 1);
  }

  const Cells& cells_;
  std::size_t n_;
  Rational h_;
  std::int64_t total_ = 0;
  std::vector<std::int64_t> rises_;
  Ball S_;
  Ball per_pi_;  ///< 1/(pi S)
  Ball rest_;    ///< rest of the Taylor polynomials, in units of H
  std::vector<std::vector<Ball>> far_;
  Ball level_;
  std::size_t intervals_ = 0;
};

/// Returns the fraction of the load left of y.
Rational load_before(const Cells& cells, const Rational& y) {
  Rational sum, total, place;
  for (const std::int64_t w : cells.weights) {
    sum = sum + Rational(w) * std::clamp(y - place, Rational(0), Rational(1));
    total = total + Rational(w);
    place = place + Rational(1);
  }
  return sum / total;
}

/// Returns K(1 - M)/K(M), 0 < M < 1.
Ball modulus(const Rational& M) {
  const auto K = [](const Rational& m) {
    acb_t z;
    acb_init(z);
    arb_set_fmpq(acb_realref(z), m.get(), precision);
    acb_elliptic_k(z, z, precision);
    Ball result = Ball().rounded(precision);
    arb_set(result.get(), acb_realref(z));
    acb_clear(z);
    return result;
  };
  return K(Rational(1) - M) / K(M);
}

class Deviations {
 public:
  explicit Deviations(const Cells& cells) : E_(ball(cells.energy).upper()) {
    const Problem& p = cells.problem;
    const Rational n(static_cast<slong>(cells.weights.size()));
    const Rational h = (p.pieces.back().to - p.left) / n;
    for (std::size_t k = 0; k < p.jumps.size(); ++k) {
      const Rational c = (p.jumps[k] - p.left) / h;
      rises_.push_back(p.s(k + 1) - p.s(k));
      before_.push_back(load_before(cells, c));
      const auto capacity = [&](const Rational& eps, const Rational& room, const Rational& far) {
        if (!(eps.sign() > 0 && eps < room)) throw Unproved("a reach ends outside the support");
        return Capacity{ball(size(load_before(cells, far) - before_.back())),
                        sqrt(modulus(eps * n / ((n - room + eps) * room)))};
      };
      const auto& [left, right] = cells.reaches[k];
      capacities_.push_back({capacity(left, c, c - left), capacity(right, n - c, c + right)});
    }
  }

  /// Returns the fraction of the load of the cells left of jump k; 0 and 1 at the support's ends.
  Rational before(std::size_t k) const {
    return k == 0 ? Rational(0) : k > before_.size() ? Rational(1) : before_[k - 1];
  }

  /// Returns an upper bound of |sum a_k D(c_k)|.
  Ball bound(const std::vector<Rational>& a) const {
    Rational sum;
    bool by_jumps = true;
    for (std::size_t k = 0; k < a.size(); ++k) {
      if (a[k].sign() == 0) continue;
      by_jumps = by_jumps && rises_[k].sign() > 0;
      if (by_jumps) sum = sum + a[k] * a[k] / rises_[k];
    }
    const auto energy_bound = [&](const Ball& beta) { return sqrt(Ball(2) * (E_ - beta) * ball(sum)); };
    const auto capacity_bound = [&](const Ball& beta) {
      Ball total;
      for (std::size_t k = 0; k < a.size(); ++k) {
        const auto side = [&](const Capacity& capacity) { return capacity.load + capacity.root * sqrt(beta); };
        total += ball(size(a[k])) * hull(side(capacities_[k][0]), side(capacities_[k][1])).upper();
      }
      return total;
    };
    if (!by_jumps) return capacity_bound(E_).upper();
    // The first bound decreases with beta, the second increases. So the larger of both at any beta is a bound.
    Ball low, high = E_;
    for (int i = 0; i < 50; ++i) {
      const Ball beta = ((low + high) * Ball(0.5)).middle();
      ((capacity_bound(beta) - energy_bound(beta)).is_positive() ? high : low) = beta;
    }
    const Ball by_both = hull(energy_bound(low), capacity_bound(high)).upper();
    const Ball by_energy = energy_bound(Ball()).upper();
    return (by_both - by_energy).is_positive() ? by_energy : by_both;
  }

 private:
  /// The bound |D(c)| <= load + root sqrt(beta) from one side.
  struct Capacity {
    Ball load;
    Ball root;
  };
  Ball E_;
  std::vector<Rational> rises_;
  std::vector<Rational> before_;
  std::vector<std::array<Capacity, 2>> capacities_;
};

void require_within(const std::array<Rational, 2>& claim, const Rational& value, const Ball& bound,
                    const Rational& least, const Rational& most, const std::string& what) {
  // At the smallest and the largest possible value of the number, a claim needs no bound.
  const bool below = claim[0] <= least || arb_is_nonnegative((ball(value - claim[0]) - bound).get()) != 0;
  const bool above = claim[1] >= most || arb_is_nonnegative((ball(claim[1] - value) - bound).get()) != 0;
  if (!below || !above) throw Unproved(what + " is proved to " + bound.text() + " only, about " + ball(value).text(10));
}

std::array<Rational, 2> interval(const Reader& at) {
  const std::vector<Rational> ends = at.rationals();
  if (ends.size() != 2 || ends[0] > ends[1]) at.fail("no interval", "[low, high] with low <= high");
  return {ends[0], ends[1]};
}

}  // namespace

Cells Cells::of_certificate(const Reader& at) {
  at.check_keys({"certificate", "kind", "generator", "problem", "pressures", "energy", "reaches", "claims"});
  check_heading(at);
  Cells c;
  c.problem = Problem::of_certificate(at["problem"], true);
  const std::vector<Reader> pressures = at["pressures"].list();
  if (pressures.size() > most_cells) at.fail("too many cells", "at most " + std::to_string(most_cells));
  for (const Reader& n : pressures) c.weights.push_back(n.integer(0, largest_weight));
  if (std::ranges::count(c.weights, 0) == std::ssize(c.weights)) at["pressures"].fail("no pressure", "one is not 0");
  c.energy = at["energy"].rational();
  if (c.energy.sign() < 0) at["energy"].fail("out of range", "it is at least 0");
  for (const Reader& reach : at["reaches"].list()) {
    const std::vector<Rational> sides = reach.rationals();
    if (sides.size() != 2) reach.fail("no reach", "[to the left, to the right]");
    c.reaches.push_back({sides[0], sides[1]});
  }
  if (c.reaches.size() != c.problem.jumps.size()) at["reaches"].fail("wrong number", "one for each friction jump");
  const Reader claims = at["claims"];
  claims.check_keys({"load_share", "effective_friction"});
  for (const Reader& share : claims["load_share"].list()) c.load_share.push_back(interval(share));
  if (c.load_share.size() != c.problem.friction.size()) {
    claims["load_share"].fail("wrong number", "one for each friction value");
  }
  c.effective_friction = interval(claims["effective_friction"]);
  if (!c.problem.theorem_1_applies()) {
    at["problem"].fail("no bound",
                       "the energy bounds errors where s never decreases towards +x, without steps and load_at");
  }
  return c;
}

std::size_t prove_cells(const Cells& cells) {
  const std::size_t intervals = Gap(cells).prove();
  const Deviations deviations(cells);
  const std::vector<Rational>& f = cells.problem.friction;
  std::vector<Rational> of_friction(f.size() - 1);
  Rational friction;
  for (std::size_t k = 0; k < f.size(); ++k) {
    const Rational share = deviations.before(k + 1) - deviations.before(k);
    friction = friction + f[k] * share;
    std::vector<Rational> of_share(f.size() - 1);
    if (k > 0) of_share[k - 1] = -1;
    if (k + 1 < f.size()) of_share[k] = 1;
    if (k > 0) of_friction[k - 1] = f[k - 1] - f[k];
    require_within(cells.load_share[k], share, deviations.bound(of_share), 0, 1, "load share " + std::to_string(k + 1));
  }
  const auto [least, most] = std::ranges::minmax(f);
  require_within(cells.effective_friction, friction, deviations.bound(of_friction), least, most,
                 "the effective friction");
  return intervals;
}

}  // namespace steadyslide::checker
