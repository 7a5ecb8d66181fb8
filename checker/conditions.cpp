#include "checker/conditions.hpp"

#include <algorithm>

#include "checker/interpolant.hpp"

namespace steadyslide::checker {
namespace {

using Kind = LayoutPoint::Contact;

/// Returns the gaps as pairs of points, where contact ends and begins again.
std::vector<std::pair<std::size_t, std::size_t>> gaps(const Contact& contact) {
  const std::vector<std::size_t> ends = contact.layout().all(Kind::ends);
  const std::vector<std::size_t> begins = contact.layout().all(Kind::begins);
  std::vector<std::pair<std::size_t, std::size_t>> result;
  for (std::size_t k = 0; k + 1 < begins.size(); ++k) result.emplace_back(ends[k], begins[k + 1]);
  return result;
}

/// Returns the k for which the coefficient of z^-k in u'/c is a condition.
std::vector<int> orders_at_infinity(const Contact& contact) {
  std::vector<int> result;
  for (int k = 1 - contact.degree_at_infinity(); k <= 1; ++k) result.push_back(k);
  if (contact.problem().load_at) result.push_back(2);
  return result;
}

/// Returns int Y B_k over a panel inside a gap. In the strip of the rule |B_k| is at most the bound of its polynomial
/// plus sec(d/2) times its integrals with absolute values.
Ball integral_of_YB(const TractionRepresentation& form, std::size_t k, const PowerPanel& panel) {
  const Contact& contact = form.contact();
  const Trapezoid rule = panel.rule(form.bits());
  const auto place = [&](const Ball& u, const Ball& v) {
    return SurfacePoint{panel.i, panel.j, panel.start + u, panel.end + v};
  };
  Ball total, weights, integrals;
  slong largest = rule.nodes().front().weight.exponent();
  for (const Trapezoid::Node& node : rule.nodes()) largest = std::max(largest, node.weight.exponent());
  const Ball half = rule.panel().length * Ball(0.5);
  const auto interpolant =
      Interpolant::of(form, form.bits() + 4, k, place(Ball(), rule.panel().length), rule.panel().length);
  const std::vector<Ball> polynomial = interpolant ? interpolant->polynomial() : std::vector<Ball>();
  for (const Trapezoid::Node& node : rule.nodes()) {
    // Nodes with a small weight need fewer bits.
    const slong below = std::min(largest - node.weight.exponent(), form.bits());
    if (interpolant) {
      const Ball y = ((node.u - half) / half).rounded(contact.precision() - below);
      total += node.weight * horner(polynomial, y).widened(interpolant->rest()).rounded(contact.precision());
      integrals += node.weight * interpolant->integrals();
    } else {
      const TractionRepresentation::Value b = form.regular_to(form.bits() + 8 - below, k, place(node.u, node.v));
      total += node.weight * b.value;
      integrals += node.weight * b.integrals;
    }
    weights += node.weight;
  }
  const Ball M = form.polynomial_bound(k, contact.xi(panel.i) + panel.start + half, half * rule.secant());
  total = total.widened(rule.error(0, M, weights)).widened(rule.error(1, Ball(1), integrals));
  return Ball(contact.sign(panel.i)) * total;
}

/// Returns int Y p/(x - e) over the gap between points j and i, where e is the point `extra`; int Y p if `extra` is
/// none.
Ball integral_of_Y(const TractionRepresentation& form, std::size_t j, std::size_t i, const std::vector<Ball>& p,
                   std::size_t extra = none) {
  const Contact& contact = form.contact();
  const Trapezoid rule = PowerPanel{contact, j, i, {}, {}, 1, extra, p.size()}.rule(form.bits());
  Ball sum, weights;
  for (const Trapezoid::Node& node : rule.nodes()) {
    sum += node.weight * horner(p, contact.xi(j) + node.u);
    weights += node.weight;
  }
  const Ball half = rule.panel().length * Ball(0.5);
  const Ball M = bound_near(p, contact.xi(j) + half, half * rule.secant());
  const int side = extra == none || extra <= j ? 1 : -1;
  return Ball(side * contact.sign(j)) * sum.widened(rule.error(0, M, weights));
}

Ball gap_error(const TractionRepresentation& form, std::size_t j, std::size_t i) {
  const Contact& contact = form.contact();
  const std::size_t cut = longest_segment(contact, j, i);
  const Ball half = contact.length(cut) * Ball(0.5);
  const SurfacePoint middle{cut, cut + 1, half, half};
  return gap_at(form, j, middle) - gap_at(form, i, middle);
}

/// Returns [q/(z - e)]_poly.
std::vector<Ball> quotient(const std::vector<Ball>& q, const Ball& e) {
  std::vector<Ball> result(q.empty() ? 0 : q.size() - 1);
  Ball carry;
  for (std::size_t k = q.size(); k-- > 1;) result[k - 1] = carry = carry * e + q[k];
  return result;
}

}  // namespace

Ball slope_difference(const Contact& contact, std::size_t segment, std::size_t k, const Ball& from, const Ball& to) {
  const std::size_t own = contact.slope_of(segment);
  if (own == k) return {};
  // Expand about the anchor of the left point, so that a short gap beside it loses no digits.
  const ReducedProblem& problem = contact.problem();
  const Rational& anchor = problem.anchors[contact.layout().points[segment].anchor];
  const Polynomial d = composed(problem.slopes[own] - problem.slopes[k], 1, anchor);
  const Ball a = contact.offset(segment) + from;
  const Ball b = contact.offset(segment) + to;
  // b^(m+1) - a^(m+1) = (b - a) (b^m + b^(m-1) a + ... + a^m)
  Ball sum, powers, a_to_m = 1;
  for (std::size_t m = 0; m < d.size(); ++m) {
    powers = powers * b + a_to_m;
    a_to_m *= a;
    sum += Ball(d[m], contact.precision()) * powers / Ball(static_cast<int>(m) + 1);
  }
  return sum * (to - from);
}

Ball gap_at(const TractionRepresentation& form, std::size_t end, const SurfacePoint& at) {
  const Contact& contact = form.contact();
  const bool rightwards = end <= at.left;
  const std::size_t k = contact.slope_of(rightwards ? end - 1 : end);
  const std::size_t first = rightwards ? end : at.right;
  const std::size_t last = rightwards ? at.left : end;
  Ball sum;
  for (std::size_t m = first; m <= last; ++m) {
    const LayoutPoint& point = contact.layout().points[m];
    if (!point.is_free()) sum += Ball(contact.problem().steps[point.anchor], contact.precision());
    if (m < last) sum += slope_difference(contact, m, k, Ball(), contact.length(m));
  }
  const Ball length = contact.length(at.left);
  sum += rightwards ? slope_difference(contact, at.left, k, Ball(), at.from_left)
                    : slope_difference(contact, at.left, k, at.from_left, length);
  PowerPanel panel{contact, rightwards ? end : at.left, rightwards ? at.right : end};
  (rightwards ? panel.end : panel.start) = rightwards ? at.from_right : at.from_left;
  panel.length = contact.distance(at, end);
  sum += integral_of_YB(form, k, panel);
  return rightwards ? sum : -sum;
}

std::size_t longest_segment(const Contact& contact, std::size_t j, std::size_t i) {
  std::size_t longest = j;
  for (std::size_t k = j; k < i; ++k) {
    if ((contact.length(k) - contact.length(longest)).is_positive()) longest = k;
  }
  return longest;
}

std::vector<Ball> conditions(const TractionRepresentation& form) {
  const Contact& contact = form.contact();
  const slong precision = contact.precision();
  const int S = contact.degree_at_infinity();
  const Ball pi = Ball::pi(precision);
  std::vector<Ball> result;
  const std::vector<Ball> moments =
      form.moments(static_cast<std::size_t>(std::max(S + (contact.problem().load_at ? 2 : 1), 0)));
  for (const int k : orders_at_infinity(contact)) {
    const Ball expected = k < 1    ? Ball()
                          : k == 1 ? form.load() / pi
                                   : form.load() * Ball(*contact.problem().load_at, precision) / pi;
    Ball sum = -expected;
    for (int j = 0; j < S + k; ++j) {
      sum += moments[static_cast<std::size_t>(j)] * contact.series(S + k - 1 - j);
    }
    for (std::size_t l = 0; l < form.q().size(); ++l) {
      sum += form.q()[l] / pi * contact.series(S + k + static_cast<int>(l));
    }
    result.push_back(sum);
  }
  for (const auto& [j, i] : gaps(contact)) result.push_back(gap_error(form, j, i));
  return result;
}

std::vector<std::vector<Ball>> jacobian(const TractionRepresentation& form) {
  const Contact& contact = form.contact();
  const int S = contact.degree_at_infinity();
  const Ball pi = Ball::pi(contact.precision());
  const std::vector<std::size_t> free = contact.layout().free_ends();
  // The number includes the leading coefficient, which is the load and comes last.
  const std::size_t coefficients = form.q().size();
  const bool tilts = contact.problem().load_at.has_value();
  const auto inverse = [&](int k) { return contact.coefficient({Ball(1)}, k); };  // coefficient of z^k in 1/Y
  std::vector<Ball> rho;
  std::vector<std::vector<Ball>> r;
  for (const std::size_t f : free) {
    rho.push_back(contact.power_at(f) * form.at_end(f));
    std::vector<Ball>& rational = r.emplace_back(quotient(form.q(), contact.xi(f)));
    for (Ball& c : rational) c *= -contact.power_at(f) / pi;
  }
  std::vector<std::vector<Ball>> rows;
  for (const int k : orders_at_infinity(contact)) {
    std::vector<Ball>& row = rows.emplace_back();
    for (std::size_t f = 0; f < free.size(); ++f) {
      Ball sum;
      Ball power = rho[f];
      for (int j = 0; j < S + k; ++j) {
        sum += power * contact.series(S + k - 1 - j);
        power *= contact.xi(free[f]);
      }
      for (std::size_t l = 0; l < r[f].size(); ++l) sum += r[f][l] * contact.series(S + k + static_cast<int>(l));
      row.push_back(sum);
    }
    for (std::size_t l = 0; l < coefficients; ++l) row.push_back(contact.series(S + k + static_cast<int>(l)) / pi);
    if (coefficients == 0) row.emplace_back();
    if (k == 1) row.back() -= Ball(1) / pi;
    if (k == 2) row.back() -= Ball(*contact.problem().load_at, contact.precision()) / pi;
    Ball tilt;
    for (int j = 0; j < S + k; ++j) tilt += inverse(-j - 1) * contact.series(S + k - 1 - j);
    if (tilts) row.insert(row.end() - 1, tilt);
  }
  for (const auto& [j, i] : gaps(contact)) {
    std::vector<Ball>& row = rows.emplace_back();
    for (std::size_t f = 0; f < free.size(); ++f) {
      // rho + (z - e) r
      std::vector<Ball> p{rho[f]};
      p.resize(r[f].size() + 1);
      for (std::size_t l = 0; l < r[f].size(); ++l) {
        p[l] -= contact.xi(free[f]) * r[f][l];
        p[l + 1] += r[f][l];
      }
      row.push_back(-integral_of_Y(form, j, i, p, free[f]));
    }
    for (std::size_t l = 0; l < coefficients; ++l) {
      std::vector<Ball> p(l + 1);
      p[l] = Ball(-1) / pi;
      row.push_back(integral_of_Y(form, j, i, p));
    }
    if (coefficients == 0) row.emplace_back();
    if (!tilts) continue;
    std::vector<Ball> p;
    for (int k = 0; k <= -S; ++k) p.push_back(inverse(k));
    row.insert(row.end() - 1, integral_of_Y(form, j, i, p));
  }
  // The unknowns are log h, and d e/d log h = +-h.
  for (std::vector<Ball>& row : rows) {
    for (std::size_t f = 0; f < free.size(); ++f) row[f] *= contact.offset(free[f]);
  }
  return rows;
}

}  // namespace steadyslide::checker
