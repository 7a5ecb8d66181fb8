#pragma once
// Compares two solutions of a problem, or of a problem and its image, quantity by quantity.

#include <tuple>

#include "numeric/interior/interior_stress.hpp"
#include "support/change_laws.hpp"

namespace steadyslide::testing {

/// Tolerances: of ends in units of the contact's length; of intensities relative to their size; of tractions, slopes
/// and gaps relative to their size plus `scale` times the average due to the load.
template <numeric::Real R>
struct Tolerance {
  R end;
  R intensity;
  R traction;
  R scale = 1;
};

template <numeric::Real R>
R length_of(const std::vector<numeric::ContactComponent<R>>& contact) {
  return contact.back().right.x.value - contact.front().left.x.value;
}

/// Places in each component and towards its ends, and beside the contact.
template <numeric::Real R>
std::vector<Rational> places(const std::vector<numeric::ContactComponent<R>>& contact) {
  std::vector<Rational> result;
  for (const auto& zone : contact) {
    const Rational left(zone.left.x.value), width = Rational(zone.right.x.value) - left;
    for (const int part : {13, 271, 502, 838, 991}) result.push_back(left + width * part / 1009);
  }
  const Rational left(contact.front().left.x.value), right(contact.back().right.x.value);
  result.push_back(left - (right - left) * 2 / 5);
  result.push_back(right + (right - left) * 3 / 10);
  return result;
}

/// True if b is within the distance of a. Infinities have to be equal.
template <numeric::Real R>
bool is_close(const R& a, const R& b, const R& distance) {
  using std::abs;
  const R difference = abs(a - b);
  return a == b || (difference <= distance && difference < numeric::infinity<R>());
}

/// Returns the quantity in which `after` is not the image of `before`, the solution of `problem`; empty if there is
/// none.
template <numeric::Real R>
std::string difference(const ContactProblem& problem, const numeric::ContactSolution<R>& before,
                       const numeric::ContactSolution<R>& after, const Image& image, const Tolerance<R>& within) {
  using namespace numeric;
  using std::abs, std::pow;
  const R scale = to_real<R>(image.scale), shift = to_real<R>(image.shift);
  const R factor = to_real<R>(image.traction), height = to_real<R>(image.height), size = abs(scale);
  const auto a = before.contact();
  auto b = after.contact();
  if (a.size() != b.size()) return "number of components";
  if (scale < 0) {
    std::reverse(b.begin(), b.end());
    for (auto& zone : b) std::swap(zone.left, zone.right);
  }
  const R length = length_of<R>(a);
  for (std::size_t k = 0; k < a.size(); ++k) {
    for (const auto end : {&ContactComponent<R>::left, &ContactComponent<R>::right}) {
      const ContactEnd<R>&p = a[k].*end, &q = b[k].*end;
      if (p.kind != q.kind || !(p.exponent == q.exponent)) return "kind of end";
      if (!is_close<R>(scale * p.x.value + shift, q.x.value, within.end * size * length)) return "end";
      if (p.intensity.error == infinity<R>() && q.intensity.error == infinity<R>()) continue;  // not known
      const R theta = factor * p.intensity.value * pow(size, R(-to_real<R>(p.exponent)));
      if (!is_close<R>(theta, q.intensity.value, within.intensity * (abs(theta) + abs(q.intensity.value)))) {
        return "intensity";
      }
    }
  }
  const Resultants<R> ra = before.resultants(), rb = after.resultants();
  const R force = factor * size;
  const std::tuple<const char*, R, R, R> totals[] = {
      {"normal", force * ra.normal.value, rb.normal.value, 2 * within.traction * rb.normal.value},
      {"tangential", force * ra.tangential.value, rb.tangential.value,
       within.traction * (rb.tangential.value + rb.normal.value)},
      {"effective friction", ra.effective_friction.value, rb.effective_friction.value,
       within.traction * (rb.effective_friction.value + 1)},
      {"centre of pressure", scale * ra.centre_of_pressure.value + shift, rb.centre_of_pressure.value,
       10 * within.end * size * length}};
  for (const auto& [name, expected, found, distance] : totals) {
    if (!is_close<R>(expected, found, distance)) return name;
  }
  // The average due to the load, for the image.
  const R mean = factor * ra.normal.value / length;
  const R bend = to_real<R>(problem.elasticity().compliance()) * ra.normal.value * height;
  const auto tilt_a = before.tilt();
  const auto tilt_b = after.tilt();
  if (tilt_a.has_value() != tilt_b.has_value()) return "tilt";
  if (tilt_a) {
    const R tilt = height / scale * tilt_a->value;
    if (!is_close<R>(tilt, tilt_b->value, within.intensity * (abs(tilt) + bend / (size * length)))) return "tilt";
  }
  for (const Rational& x : places<R>(a)) {
    const Sample<R> p = before.at(x), q = after.at(image.of(x));
    const auto differs = [&](const R& times, const TwoSided<R>& from, const TwoSided<R>& to, const R& unit) {
      const auto far = [&](const Estimate<R>& before_change, const Estimate<R>& found) {
        const R expected = times * before_change.value;
        return !is_close<R>(expected, found.value, within.traction * (2 * abs(expected) + within.scale * unit));
      };
      return far(from.left, scale < 0 ? to.right : to.left) || far(from.right, scale < 0 ? to.left : to.right);
    };
    if (differs(factor, p.traction, q.traction, mean)) return "traction";
    if (differs(scale < 0 ? R(-factor) : factor, p.shear, q.shear, mean)) return "shear";
    if (differs(height / scale, p.slope, q.slope, R(bend / (size * length)))) return "slope";
    if (p.gap.has_value() != q.gap.has_value()) return "support";
    if (p.gap && differs(height, {*p.gap, *p.gap}, {*q.gap, *q.gap}, bend)) return "gap";
  }
  const InteriorStress<R> below_a(before), below_b(after);
  const Rational z(length / 7);
  for (const Rational& x : places<R>(a)) {
    const StressState<R> p = below_a.at(x, z), q = below_b.at(image.of(x), abs(image.scale) * z);
    for (const auto& [name, expected, found] : {std::tuple("stress xx", R(p.xx.value), R(q.xx.value)),
                                                {"stress zz", p.zz.value, q.zz.value},
                                                {"stress xz", scale < 0 ? R(-p.xz.value) : p.xz.value, q.xz.value}}) {
      if (!is_close<R>(factor * expected, found, within.traction * (2 * abs(factor * expected) + mean))) return name;
    }
  }
  return "";
}

}  // namespace steadyslide::testing
