// Bounds for a contact set, each in a case whose error nearly reaches it. Rules with few nodes are compared with rules
// with many; expansions with the sums that they replace.

#include "support/sharp_bounds.hpp"

#include "enclosure/contact/contact_conditions.hpp"
#include "enclosure/contact/contact_load.hpp"
#include "enclosure/contact/gap_contact.hpp"
#include "enclosure/contact/panel_moments.hpp"
#include "enclosure/contact/power_at_point.hpp"
#include "enclosure/contact/segment_moments.hpp"

namespace steadyslide::enclosure {

namespace {

constexpr Bits bits = 160;
constexpr int many = 40;

double ratio(const Ball& error, const Ball& bound) { return (abs(error) / bound).to_double(); }

/// Returns the distance of the enclosed number from the middle of a wide ball, divided by its radius.
double reached(const Ball& wide, const Ball& number) {
  return ratio(number.midpoint() - wide.midpoint(), wide.radius());
}

Ball chebyshev(int k, const Ball& t) {
  Ball before(1, t.bits()), here = t;
  for (int i = 1; i < k; ++i) before = std::exchange(here, Ball(2) * t * here - before);
  return here;
}

Ball largest_chebyshev(int k, Ellipse ellipse) {
  const Ball rho = ContactPanel::rho(ellipse);
  return (power(rho, k) + power(rho, -k)) / 2;
}

/// A contact set with numbers of its own, and forms with any number of nodes.
struct Case {
  ReducedProblem problem;
  ContactSet set;
  JacobiRules rules{bits};

  Case(const ContactProblem& of, const ContactTopology& topology, const std::vector<Ball>& offsets)
      : problem(of, {0, 1}), set(problem, topology, offsets, bits) {}
  Case(const Case&) = delete;

  TractionRepresentation form(int count) {
    const int free = std::max(-set.degree_at_infinity() - 1, 0);
    return {set, BallPolynomial(static_cast<std::size_t>(free), Ball(0.25_r, bits)), Ball(0.125_r, bits), count, rules};
  }
};

using Kind = ContactTopology::Kind;

/// The gap [-e^left, e^right] of GapContact, under slopes that differ by a polynomial.
ContactTopology with_gap() {
  return {{{0, {}, Kind::begins, false},
           {1, Side::left, Kind::ends, true},
           {1, {}, Kind::interior, false},
           {1, Side::right, Kind::begins, true},
           {2, {}, Kind::ends, false}}};
}

/// Returns the panel of 1/|Y| that begins at a distance from a segment's left point.
ContactPanel panel_of(const ContactSet& set, std::size_t segment, const Ball& from_left, const Ball& length, int count,
                      JacobiRules& rules) {
  std::optional<Side> touches;
  if (from_left.is_zero()) touches = Side::left;
  return {set,   {segment, from_left, set.length(segment) - from_left - length, length, touches},
          -1,    std::nullopt,
          count, rules};
}

/// Returns T_2n at the panel's nodes, multiplied by their weights.
std::vector<Ball> oscillation(const ContactPanel& panel, bool at_end) {
  const int degree = 2 * static_cast<int>(panel.nodes().size());
  std::vector<Ball> result;
  for (const ContactPanel::Node& node : panel.nodes()) {
    const Ball t = (node.from_left - panel.part().from_left) / panel.part().length * Ball(2) - Ball(1);
    result.push_back((at_end ? node.end_weight : node.weight) * chebyshev(degree, t));
  }
  return result;
}

Ball sum_of(const std::vector<Ball>& terms) {
  Ball sum(0, bits);
  for (const Ball& term : terms) sum += term;
  return sum;
}

/// T_2n by n nodes: the rule with many nodes gives its integral.
double panel_rule(bool at_end) {
  GapContact gap(-2, -3);
  constexpr int n = 4;
  // Far from all points that it does not touch, the other powers hardly change on the panel.
  const Ball start(at_end ? 0 : 0.4_r, bits), length(1_r / 64, bits);
  const ContactPanel few = panel_of(gap.set, 0, start, length, n, gap.rules),
                     all = panel_of(gap.set, 0, start, length, many, gap.rules);
  Ball exact(0, bits);
  for (const ContactPanel::Node& node : all.nodes()) {
    const Ball t = (node.from_left - start) / length * Ball(2) - Ball(1);
    exact += (at_end ? node.end_weight : node.weight) * chebyshev(2 * n, t);
  }
  const Ball bound = largest_chebyshev(2 * n, Ellipse::far);
  return ratio(exact - sum_of(oscillation(few, at_end)),
               at_end ? few.end_remainder(bound, Ellipse::far) : few.remainder(bound, Ellipse::far));
}

/// The product of powers next to the end of the ellipse where the nearest power is largest.
double panel_product() {
  GapContact gap(-2, -3);
  const Ball length(1_r / 64, bits), start = gap.set.length(0) - length * Ball(2);
  const ContactPanel panel = panel_of(gap.set, 0, start, length, 2, gap.rules);
  const Ball x = gap.set.x(0) + start + length + panel.reach(Ellipse::far) * Ball(0.9999_r, bits);
  Ball product(1, bits);
  for (std::size_t j = 0; j < gap.set.points(); ++j) {
    if (!gap.set.is_regular(j)) product *= power(abs(x - gap.set.x(j)), -gap.set.power(j));
  }
  return ratio(product, panel.largest_product(Ellipse::far));
}

double panel_polynomial() {
  GapContact gap(-2, -3);
  const Ball length(1_r / 4, bits);
  const ContactPanel panel = panel_of(gap.set, 0, Ball(0, bits), length, 2, gap.rules);
  const BallPolynomial p{Ball(1, bits), Ball(-2, bits), Ball(3, bits)};
  const Ball x = gap.set.x(0) - panel.reach(Ellipse::far);
  return ratio(value_at(p, x), panel.largest(p, Ellipse::far));
}

/// A panel seen from afar. `beyond` is true for a panel farther away than the place.
struct SeenPanel {
  GapContact gap{-40, -40};
  ContactPanel panel;
  Ball distance;

  SeenPanel(bool beyond, int count)
      // The panel's ends are at 1/4 of the distance, or at 4 times it.
      : panel(panel_of(gap.set, 3, Ball(Rational(beyond ? 256 : 255, 1024), bits), Ball(1_r / 1024, bits), count,
                       gap.rules)),
        distance(beyond ? 1_r / 16 : 1, bits) {}

  /// The terms that are cut: 20 bits, and all other errors have 160.
  double cut() {
    std::vector<Ball> values(panel.nodes().size(), Ball(0, bits));
    (distance < Ball(1) ? values.front() : values.back()) = Ball(1, bits);
    const Ball y = (distance < Ball(1) ? panel.nodes().front() : panel.nodes().back()).from_left;
    return reached(seen(values, Ball(0, 64), 20), Ball(1) / (distance + y));
  }

  /// The rule's error for T_2n; the bits are many.
  double rule(bool beyond) {
    const std::vector<Ball> values = oscillation(panel, false);
    const SeenPanel fine(beyond, many);
    const int degree = 2 * static_cast<int>(panel.nodes().size());
    Ball exact(0, bits);
    for (const ContactPanel::Node& node : fine.panel.nodes()) {
      const Ball t = (node.from_left - panel.part().from_left) / panel.part().length * Ball(2) - Ball(1);
      exact += node.weight * chebyshev(degree, t) / (distance + node.from_left);
    }
    return reached(seen(values, largest_chebyshev(degree, Ellipse::far), bits), exact);
  }

 private:
  Ball seen(const std::vector<Ball>& values, const Ball& size, Bits accuracy) {
    // A panel in front never counts as far.
    std::vector<ContactPanel> panels{panel};
    std::vector<std::vector<Ball>> all{values};
    std::vector<Ball> sizes{size};
    if (distance < Ball(1)) {
      panels.insert(panels.begin(), panel_of(gap.set, 3, Ball(0, bits), Ball(1_r / 4, bits), 1, gap.rules));
      all.insert(all.begin(), std::vector<Ball>{Ball(0, bits)});
      sizes.insert(sizes.begin(), Ball(0, 64));
    }
    return PanelMoments(panels, all, sizes, Side::left, std::nullopt, accuracy).seen_from(distance).sum;
  }
};

/// Returns T_k((x - middle)/half) as a polynomial in x.
BallPolynomial chebyshev_in_x(int k, const Ball& middle, const Ball& half) {
  const BallPolynomial twice{Ball(-2) * middle / half, Ball(2) / half};
  BallPolynomial before{Ball(1, bits)}, here{-middle / half, Ball(1) / half};
  if (k == 0) return before;
  for (int i = 1; i < k; ++i) {
    BallPolynomial next = product(twice, here);
    for (std::size_t m = 0; m < before.size(); ++m) next[m] -= before[m];
    before = std::exchange(here, next);
  }
  return here;
}

/// A segment whose weights lie next to the end that faces the place: the terms that are cut, or the error of the rule.
double segment_moments(bool rule) {
  GapContact gap(-40, -40);
  constexpr int n = 4;
  const Ball length(1_r / 1024, bits), start = rule ? Ball(0.4_r, bits) : gap.set.length(0) - length * Ball(2);
  const ContactPanel fine = panel_of(gap.set, 0, start, length, many, gap.rules);
  const std::vector<ContactPanel> panels{rule ? panel_of(gap.set, 0, start, length, n, gap.rules) : fine};
  const Ball middle = gap.set.x(0) + start + length / Ball(2);
  const BallPolynomial p = chebyshev_in_x(rule ? 2 * n : 0, middle, length / Ball(2));
  const Ball size = rule ? largest_chebyshev(2 * n, Ellipse::far) : Ball(1, 64);
  const Ball distance = rule ? Ball(1e6_r, bits) : Ball(0.6_r, bits);
  Ball exact(0, bits);
  for (const ContactPanel::Node& node : fine.nodes()) {
    exact += node.weight * value_at(p, gap.set.x(0) + node.from_left) / (distance + node.from_right);
  }
  const SegmentMoments moments(gap.set, 0, panels, SegmentMoments::of_weights(gap.set, 0, panels, 2 * n), p, {size},
                               rule ? bits : 20);
  const auto seen = moments.seen_from(distance, Side::right);
  REQUIRE(seen);
  return reached(*seen, exact);
}

/// The series of Cauchy's integral of a power: a and L have many bits, and the distance few, which cut the series. The
/// distance was found by a scan.
double power_series() {
  const PowerAtPoint at_c(Ball(-0.9_r, bits), false, Ball(1, bits));
  const Rational d = 3_r / 128;
  return reached(at_c.analytic_part(Ball(d, 38)), at_c.analytic_part(Ball(d, bits)));
}

/// The series of 1 - sinc x: its second term, x^2/120, is just below 2^-bits.
double sinc_series() {
  const auto part = [](Bits accuracy) {
    const Ball a(0.00000329_r, accuracy);
    return PowerAtPoint(a, false, Ball(1, accuracy)).analytic_part(Ball(0, accuracy));
  };
  return reached(part(40), part(bits));
}

/// d^m E(d) rises up to the end of the interval, or is largest within it.
double power_range(const Rational& a, int m, const Rational& upper, const Rational& at) {
  const PowerAtPoint at_c(Ball(a, bits), a == 0, Ball(2, bits));
  const Ball range = at_c.singular_part(Ball::hull(Ball(0, bits), Ball(upper, bits)), m);
  const Ball d(at, bits);
  return ratio(power(d, m) * at_c.at(d), range.upper());
}

// Rules of one node and rules of many. Friction is very large, so that powers are nearly 0 or +-1. The integrand is x^2
// on a panel with its middle at 0, so that the rule's error is nearly the largest for its bound.

/// The slope x^2 on one side of the corner, 0 on the other.
ContactProblem of_square(const Rational& left, const Rational& corner, const Rational& right, Side side) {
  const Polynomial cube({0, 0, 0, 1_r / 3}), flat;
  const bool on_left = side == Side::left;
  const Indenter indenter(left, {{corner, on_left ? cube : flat}, {right, on_left ? flat : cube}});
  return reduced({10000000, 10000000}, {corner}, indenter, 1, std::nullopt,
                 on_left ? Sliding::minus_x : Sliding::plus_x);
}

/// B over the contact [-1/4, 3/4], seen from 50 away.
double integrals_of_traction() {
  Case c(of_square(-0.25_r, 100, 200, Side::left), with_gap(), {log(Ball(99.25_r, bits)), log(Ball(99, bits))});
  const SurfacePoint at{2, Ball(50, bits), Ball(49, bits)};
  return reached(c.form(1).regular_factor(1, at).value(), c.form(many).regular_factor(1, at).value());
}

/// The condition on the load: the integral over the contact [-1/4, 3/4] without a pole.
double integral_of_condition() {
  Case c(of_square(-200, -100, 0.75_r, Side::right), with_gap(), {log(Ball(99, bits)), log(Ball(99.75_r, bits))});
  return reached(ContactConditions(c.form(1)).conditions()[0], ContactConditions(c.form(many)).conditions()[0]);
}

/// The gap's change over [-1/2, 1/2], far from all points. Y is nearly (x - 150)/(x - 250), and the slope is the
/// polynomial part of x^2 Y.
double change_of_gap() {
  const ContactProblem problem =
      reduced({10000000000000, 10000000000000}, {50}, one_piece(-150, 250, {0, 25000, 50, 1_r / 3}), 1, std::nullopt,
              Sliding::minus_x);
  Case c(problem, with_gap(), {log(Ball(100, bits)), log(Ball(100, bits))});
  const ContactPanel::Interval part{1, Ball(49.5_r, bits), Ball(49.5_r, bits), Ball(1, bits), {}};
  return reached(c.form(1).gap_change(part, 0), c.form(many).gap_change(part, 0));
}

/// int t x^2 dx over a short part of a punch.
double load_on_part() {
  Case c(reduced({0.5_r}, {}, one_piece(-1, 3, {}), 1), {{{0, {}, Kind::begins, false}, {1, {}, Kind::ends, false}}},
         {});
  const ContactPanel::DistanceRange range{Ball(63_r / 64, bits), Ball(65_r / 64, bits)};
  const BallPolynomial square{Ball(0, bits), Ball(0, bits), Ball(1, bits)};
  const auto load = [&](int count) {
    const TractionRepresentation form = c.form(count);
    return ContactLoad(form).load_on(0, range, square);
  };
  return reached(load(1), load(many));
}

/// max |B_k| on an ellipse, at its end.
double traction_on_ellipse() {
  GapContact gap(-1, -1);
  const TractionRepresentation form(gap.set, {}, Ball(0, bits), many, gap.rules);
  const std::vector<ContactPanel::Interval> parts = ContactPanel::graded(gap.set, 3);
  double most = 0;
  for (const ContactPanel::Interval& part : parts) {
    const ContactPanel panel = form.panel(part);
    const Ball bound = form.bound(form.slope_of(3), panel, Ellipse::close), reach = panel.reach(Ellipse::close);
    const SurfacePoint end{3, part.from_left - reach, part.from_right + part.length + reach};
    if (!bound.is_finite() || !end.from_left.is_positive()) continue;
    most = std::max(most, ratio(form.regular_factor(end).value(), bound));
  }
  return most;
}

ContactProblem over_jump(const std::vector<Rational>& right) {
  return reduced({0.1_r, 0.5_r}, {0}, {-1, {{0, Polynomial({0, 0.2_r})}, {1, Polynomial(right)}}}, 1);
}

ContactTopology full() {
  return {{{0, {}, Kind::begins, false}, {1, {}, Kind::interior, false}, {2, {}, Kind::ends, false}}};
}

/// B beside a point where the polynomial changes.
double traction_beside_point() {
  Case c(over_jump({0, 1}), full(), {});
  const SurfacePoint at = c.set.place(0, Side::right, Ball(0.1_r, bits));
  const LocalValue wide = c.form(1).regular_factor(at);
  REQUIRE(wide.has_singular);
  return reached(wide.regular, c.form(many).regular_factor(at).regular);
}

/// int t T_4 dx over the panel beside the point, by two nodes.
double load_beside_point() {
  Case c(over_jump({0, 1}), full(), {});
  const Ball length(0.1_r, bits);  // a fifth of the panel on the other side
  const BallPolynomial weight = chebyshev_in_x(4, length / Ball(2), length / Ball(2));
  const auto load = [&](int count) {
    const TractionRepresentation form = c.form(count);
    return ContactLoad(form).load_on(1, {Ball(0, bits), length}, weight);
  };
  return reached(load(2), load(many));
}

/// The derivative of a gap's condition with respect to one of its ends. The slope is the same on both sides, so that B
/// has no error.
double derivative_of_gap() {
  Case c(over_jump({0, 0.2_r}), with_gap(), {Ball(-6, bits), Ball(-6, bits)});
  return reached(ContactConditions(c.form(1)).jacobian()[1][0], ContactConditions(c.form(many)).jacobian()[1][0]);
}

}  // namespace

TEST_CASE("bounds for a contact set: a true error that nearly reaches each") {
  check_sharp_bounds("test_contact_proof", {{"panel", [] { return panel_rule(false); }},
                                            {"panel-at-end", [] { return panel_rule(true); }},
                                            {"panel-product", panel_product},
                                            {"panel-polynomial", panel_polynomial},
                                            {"moments-near-cut", [] { return SeenPanel(false, 40).cut(); }},
                                            {"moments-far-cut", [] { return SeenPanel(true, 40).cut(); }},
                                            {"moments-near-rule", [] { return SeenPanel(false, 4).rule(false); }},
                                            {"moments-far-rule", [] { return SeenPanel(true, 4).rule(true); }},
                                            {"segment-cut", [] { return segment_moments(false); }},
                                            {"segment-rule", [] { return segment_moments(true); }},
                                            {"power-series", power_series},
                                            {"sinc-series", sinc_series},
                                            {"power-range-rising", [] { return power_range(0.3_r, 2, 0.1_r, 0.1_r); }},
                                            {"traction-integrals", integrals_of_traction},
                                            {"condition-integral", integral_of_condition},
                                            {"gap-change", change_of_gap},
                                            {"load", load_on_part},
                                            {"traction-on-ellipse", traction_on_ellipse},
                                            {"traction-beside-point", traction_beside_point},
                                            {"load-beside-point", load_beside_point},
                                            {"gap-derivative", derivative_of_gap},
                                            {"power-range-inside", [] { return power_range(-0.9_r, 1, 1, 0.5_r); }}});
}

}  // namespace steadyslide::enclosure
