#pragma once
// The problems of the tests of stresses below the surface, and an independent computation of these stresses.

#include "numeric/interior/half_plane_stress.hpp"
#include "numeric/interior/interior_stress.hpp"
#include "numeric/quadrature/tanh_sinh.hpp"
#include "numeric/riemann_hilbert/riemann_hilbert.hpp"
#include "numeric/riemann_hilbert/riemann_hilbert_solution.hpp"
#include "support/numeric_test.hpp"

namespace steadyslide::numeric::stress_test {

inline Elasticity body() { return Elasticity(Solid(0.2_r, 2)); }

/// Four friction values under a smooth indenter with free ends.
inline ContactProblem jumps(Sliding sliding = Sliding::plus_x) {
  return {body(), FrictionProfile({0.5_r, 3, 0, 1}, {Rational(-1, 3), 0, 0.25_r}),
          Indenter(-2, {{2, Polynomial({0, 0.1_r, 1, 0, 0.5_r})}}), 1, sliding};
}

/// A flat punch on [1, 3] with constant friction.
inline ContactProblem punch(Sliding sliding = Sliding::plus_x) {
  return {body(), FrictionProfile({1.5_r}), Indenter(1, {{3, Polynomial({0})}}), 2, sliding};
}

inline ContactProblem parabola(Sliding sliding = Sliding::plus_x) {
  return {body(), FrictionProfile({1.5_r}), Indenter(-2, {{2, Polynomial({0, 0.1_r, 1})}}), 1, sliding};
}

/// A wedge with a friction jump, a wedge, and a change of curvature, all in the contact.
inline ContactProblem corners(Sliding sliding = Sliding::plus_x) {
  const Polynomial left({0, -0.1_r, 1});
  const Polynomial middle({0, 0.1_r, 1});
  const Polynomial wedge = middle + Polynomial({-0.0125_r, 0.1_r});
  const Polynomial bent = wedge + Polynomial({0.0625_r, -0.5_r, 1});
  return {body(), FrictionProfile({2, 0.5_r}, {0}),
          Indenter(-2, {{0, left}, {0.125_r, middle}, {0.25_r, wedge}, {2, bent}}), 1, sliding};
}

/// A solution with its stresses below the surface.
template <Real R>
struct Solved {
  explicit Solved(const ContactProblem& problem) : found(riemann_hilbert<R>(problem).solution) {
    REQUIRE(solution.failed_condition().empty());
  }
  Rational place(double fraction) const { return Rational(left + fraction * length); }

  std::shared_ptr<const ContactSolution<R>> found;
  const RiemannHilbertSolution<R>& solution = dynamic_cast<const RiemannHilbertSolution<R>&>(*found);
  InteriorStress<R> interior{solution};
  double left = static_cast<double>(solution.contact().front().left.x.value);
  double length = static_cast<double>(solution.contact().back().right.x.value) - left;
};

template <Real R>
StressComponents<R> components(const StressState<R>& stress) {
  return {stress.xx.value, stress.zz.value, stress.xz.value};
}

template <Real R>
void add(StressComponents<R>& sum, const StressComponents<R>& part) {
  sum = {sum.xx + part.xx, sum.zz + part.zz, sum.xz + part.xz};
}

template <Real R>
std::vector<Estimate<R>> numbers(const StressState<R>& s) {
  return {s.xx, s.zz, s.xz, *s.yy, *s.mean(), *s.von_mises(), s.largest_shear(), s.gradient->x_z, s.gradient->z_x};
}

/// Checks that in double every number differs from that of 50 digits by no more than its error.
inline void errors_cover(const StressState<double>& found, const StressState<Real50>& truth) {
  const auto a = numbers(found);
  const auto b = numbers(truth);
  for (std::size_t k = 0; k < a.size(); ++k) CHECK_MESSAGE(within_error(a[k], b[k]), "number ", k);
}

/// Stresses of the pressure p and the traction q along +x on [a, b]: angles at the strip's ends and a logarithm [Joh85,
/// chapter 2].
template <Real R>
StressComponents<R> strip(const R& p, const R& q, const R& a, const R& b, const R& x, const R& z) {
  using std::atan2, std::cos, std::log, std::sin;
  const R l = x - a, r = x - b;
  const R one = atan2(z, r), two = atan2(z, l), angle = 2 * (one - two), twice = 2 * pi<R>();
  const R sines = sin(R(2 * one)) - sin(R(2 * two)), cosines = cos(R(2 * one)) - cos(R(2 * two));
  const R logarithm = 2 * log(R((r * r + z * z) / (l * l + z * z)));
  return {(-p * (angle + sines) + q * (logarithm - cosines)) / twice, (-p * (angle - sines) + q * cosines) / twice,
          (p * cosines - q * (angle + sines)) / twice};
}

template <Real R>
R difference(const StressComponents<R>& a, const StressComponents<R>& b) {
  return std::max({size_of(R(a.xx - b.xx)), size_of(R(a.zz - b.zz)), size_of(R(a.xz - b.xz))});
}

template <Real R>
R size(const StressComponents<R>& a) {
  return difference(a, {R(0), R(0), R(0)});
}

/// Integrates by the adaptive tanh-sinh rule on every segment, cut at x and next to it. `factor` multiplies the shear.
template <Real R>
StressComponents<R> by_quadrature(const RiemannHilbertSolution<R>& solution, const Rational& x, const Rational& z,
                                  const R& factor = R(1)) {
  using std::abs, std::pow;
  const TractionRepresentation<R>& form = solution.form();
  const ContactSet<R>& set = form.set();
  const SurfacePoint<R> above = solution.locate(x);
  const R depth = to_real<R>(z / solution.problem().frame().unit);
  R sums[3] = {0, 0, 0};
  for (std::size_t k = 0; k < set.segments(); ++k) {
    if (!set.in_contact(k)) continue;
    const R shear = factor * solution.shear_ratio(k);
    // x' = (left end) + node. `from` is x minus the panel's left end, `to` is x minus its right end.
    const auto add = [&](const Panel<R>& panel, const R& before, const R& behind, const R& from, const R& to) {
      const Power<R> none{R(0), R(1)};
      const Power<R> left = before == 0 ? form.fundamental_solution().powers()[k] : none;
      const Power<R> right = behind == 0 ? form.fundamental_solution().powers()[k + 1] : none;
      for (int i = 0; i < 3; ++i) {
        const auto smooth = [&, i](const Node<R>& node) {
          const R t =
              form.traction(surface_point(set, k, R(before + node.from_left), R(behind + node.from_right))).value;
          const bool by_left = abs(from) + node.from_left < abs(to) + node.from_right;
          const R offset = by_left ? R(from - node.from_left) : R(to + node.from_right);
          const StressComponents<R> s = stress_of_force<R>(t, shear * t, offset, depth);
          const R value = i == 0 ? s.xx : i == 1 ? s.zz : s.xz;
          return R(value / (pow(node.from_left, left.value) * pow(node.from_right, right.value)));
        };
        sums[i] += tanh_sinh::panel_integral<R>({panel, left, right, smooth}).value;
      }
    };
    const Panel<R> whole = set.panels()[k];
    const R &l = above.node.from_left, &r = above.node.from_right;
    if (static_cast<std::ptrdiff_t>(k) == above.segment && l > 0 && r > 0) {
      // Cuts again at four depths from x: the adaptive rule works best with one scale in each panel.
      const R near_left = std::min(R(l / 2), R(4 * depth));
      const R near_right = std::min(R(r / 2), R(4 * depth)), x_left = whole.left + l;
      const R far_left = l - near_left, far_right = r - near_right;
      add({whole.left, R(x_left - near_left), far_left}, R(0), R(r + near_left), l, near_left);
      add({R(x_left - near_left), x_left, near_left}, far_left, r, near_left, R(0));
      add({x_left, R(x_left + near_right), near_right}, l, far_right, R(0), R(-near_right));
      add({R(x_left + near_right), whole.right, far_right}, R(l + near_right), R(0), R(-near_right), R(-r));
    } else {
      add(whole, R(0), R(0), form.distance(above, k), form.distance(above, k + 1));
    }
  }
  return {sums[0], sums[1], sums[2]};
}

}  // namespace steadyslide::numeric::stress_test
