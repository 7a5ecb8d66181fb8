// The checker's bounds, each in a case whose error nearly reaches it.

#include <acb_hypgeom.h>
#include <arb_hypgeom.h>

#include <cmath>

#include "checker/conditions.hpp"
#include "checker/interpolant.hpp"
#include "checker/reader.hpp"
#include "support/sharp_bounds.hpp"

namespace steadyslide::sharp_checker {

using namespace steadyslide::checker;
using steadyslide::testing::check_sharp_bounds;
using Kind = LayoutPoint::Contact;

constexpr slong precision = 400;

Ball rounded(double x) { return Ball(x).rounded(precision); }

double ratio(const Ball& error, const Ball& bound) { return (error.middle().size() / bound.middle()).approximately(); }

/// Returns the distance of the enclosed number from the middle of a wide ball, divided by its radius.
double reached(const Ball& wide, const Ball& number) { return ratio(number - wide.middle(), wide.radius()); }

/// A rule for u^power v^power on [0, 1], and cos(2 pi tau/h): it is 1 at every node, and its integral is nearly 0.
struct Oscillation {
  Trapezoid rule;
  Ball w;       ///< 2 pi/h
  Ball growth;  ///< its largest value in the strip

  Oscillation(double power, slong bits)
      : rule({Ball(1).rounded(precision),
              {{rounded(power), {Ball()}, {}}, {rounded(power), {}, {Ball()}}},
              Ball(1),
              Ball(1),
              0},
             bits, precision) {
    w = Ball(2) * Ball::pi(precision) / log(rule.nodes()[1].u / rule.nodes()[1].v);
    Ball d = Ball(1) / rule.secant();  // cos(d/2)
    arb_acos(d.get(), d.get(), precision);
    const Ball e = exp(w * Ball(2) * d);
    growth = (e + Ball(1) / e) * Ball(0.5);
  }

  /// Returns int_0^1 u^power v^power (u + beyond)^-more cos(w tau) du =
  /// Re beyond^-more B(power+1+iw, power+1-iw) 2F1(more, power+1+iw; 2 power+2; -1/beyond).
  Ball integral(double power, int more, double beyond) const {
    acb_t p, q, value, other;
    for (acb_ptr z : {p, q, value, other}) acb_init(z);
    acb_set_d_d(p, power + 1, 0);
    arb_set(acb_imagref(p), w.get());
    acb_conj(q, p);
    acb_gamma(value, p, precision);
    acb_gamma(other, q, precision);
    acb_mul(value, value, other, precision);
    acb_set_d(q, 2 * power + 2);
    acb_rgamma(other, q, precision);
    acb_mul(value, value, other, precision);
    if (more > 0) {
      acb_t a;
      acb_init(a);
      acb_set_si(a, more);
      acb_set_d(other, -1 / beyond);
      acb_hypgeom_2f1(other, a, p, q, other, 0, precision);
      acb_mul(value, value, other, precision);
      acb_clear(a);
    }
    Ball result = rounded(0);
    arb_set(result.get(), acb_realref(value));
    for (acb_ptr z : {p, q, value, other}) acb_clear(z);
    return result / Ball(std::pow(beyond, more));
  }
};

double rule(int more, double power, slong bits, double beyond) {
  const Oscillation f(power, bits);
  Ball sum;
  for (const Trapezoid::Node& node : f.rule.nodes()) {
    const Ball distance = node.u + rounded(beyond);
    sum += node.weight / (more == 0 ? Ball(1) : more == 1 ? distance : distance * distance);
  }
  return ratio(sum - f.integral(power, more, beyond), f.rule.error(more, f.growth, sum));
}

/// The last node to the right represents all nodes beyond: the sum of as many of them as matter.
double tail(double power, slong bits) {
  const Oscillation f(power, bits);
  const std::size_t last = f.rule.nodes_to_right() - 1;
  const Ball h = Ball(2) * Ball::pi(precision) / f.w;
  Ball sum;
  const auto add = [&](int first, int direction) {
    for (int k = first; k < 4000 && k > -4000; k += direction) {
      const Ball e = exp(-(h * Ball(static_cast<int>(last - 1) + k)));
      const Ball large = Ball(1) / (Ball(1) + e);
      sum += h * exp(Ball(2 * (power + 1)) * log(large)) * exp(Ball(power + 1) * log(e));
    }
  };
  add(1, 1);
  return reached(f.rule.nodes()[last].weight, sum);
}

/// Two pieces of contact with other polynomials, and a gap: a short piece, far away or near.
struct Example {
  Problem problem;
  ReducedProblem reduced;
  Layout layout;
  Unknowns v;

  Example(const std::string& right_profile, double left, double right)
      : problem(Problem::of_certificate(
            Reader::of_json(R"({"load": "1", "load_at": null, "sliding": "+x", "gamma": "1/2", "compliance": "1",
  "friction": {"values": ["0.4", "1.2"], "jumps": ["0"]},
  "indenter": {"left": "-1", "pieces": [{"to": "0", "profile": ["0", "1"]}, {"to": "1", "profile": )" +
                                right_profile + "}]}}",
                            "example"),
            true)),
        reduced(problem, Rational(0), Rational(1)) {
    const auto anchor = [](std::size_t a, Kind kind) { return LayoutPoint{a, 0, kind}; };
    layout.points = {anchor(0, Kind::begins), LayoutPoint{1, -1, Kind::ends}, anchor(1, Kind::outside),
                     LayoutPoint{1, 1, Kind::begins}, anchor(2, Kind::ends)};
    layout.in_contact = {true, false, false, true};
    layout.intervals = {0, 0, 1, 1};
    v.log_offsets = {log(rounded(left)), log(rounded(right))};
    v.q.assign(static_cast<std::size_t>(std::max(-layout.degree_at_infinity() - 1, 0)), Ball(0.25));
  }
};

/// B_k at a place of a segment, at these parts of its length, from a rule with few bits and from one with many. These
/// cases were found by a scan over profiles, gaps, places and bits.
struct Seen {
  Example example;
  Contact contact;
  TractionRepresentation fine;

  Seen(const std::string& profile, double left, double right)
      : example(profile, left, right),
        contact(example.reduced, example.layout, example.v.log_offsets, precision),
        fine(contact, example.v, example.problem.loads, 120) {}

  TractionRepresentation coarse(slong bits) const { return {contact, example.v, example.problem.loads, bits}; }
  SurfacePoint place(std::size_t segment, double part) const {
    const Ball d = contact.length(segment) * Ball(part);
    return {segment, segment + 1, d, contact.length(segment) - d};
  }
};

const char* const notch = R"(["0", "-1"])";

/// The nodes that are left out are those with small weights.
double left_out_nodes() {
  const Seen seen(notch, 0.01, 0.3);
  const SurfacePoint at = seen.place(2, 0.5);
  return reached(seen.fine.sums_to(4, 0, at).value, seen.fine.regular(0, at).value);
}

/// A short piece far away: one moment is enough.
double far_moments() {
  const Seen seen(notch, 0.5, 0.999);
  const SurfacePoint at = seen.place(2, 0.001);
  return reached(seen.fine.sums_to(1, 0, at).value, seen.fine.regular(0, at).value);
}

/// With these bits the rule's error dominates, not the nodes beyond its last one.
double traction(bool slope) {
  const Seen seen(notch, 0.5, 0.9);
  const SurfacePoint at = seen.place(2, 0.99);
  const auto few = seen.coarse(11).regular(0, at), all = seen.fine.regular(0, at);
  return slope ? reached(few.slope, all.slope) : reached(few.value, all.value);
}

double moment() {
  const Seen seen(notch, 0.5, 0.9);
  return reached(seen.coarse(12).moments(1)[0], seen.fine.moments(1)[0]);
}

/// A short piece, whose nodes all have nearly the same distance from the panel.
double interpolant() {
  const Seen seen(notch, 0.99999, 0.9999);
  const SurfacePoint start = seen.place(2, 0.9);
  const auto found = Interpolant::of(seen.fine, 6, 0, start, seen.contact.length(2) * Ball(0.05));
  if (!found) return 0;
  return ratio(horner(found->polynomial(), Ball(-1)) - seen.fine.regular(0, start).value, found->rest());
}

double gap_condition() {
  const Seen seen(notch, 0.1, 0.1);
  return reached(conditions(seen.coarse(16))[1], conditions(seen.fine)[1]);
}

double gap_derivative() {
  const Seen seen(notch, 0.1, 0.1);
  return reached(jacobian(seen.coarse(17))[1][1], jacobian(seen.fine)[1][1]);
}

TEST_CASE("bounds of the checker: a true error that nearly reaches each") {
  check_sharp_bounds("test_checker", {{"checker-rule", [] { return rule(0, -0.95, 4, 1); }},
                                      {"checker-rule-pole", [] { return rule(1, -0.95, 4, 0.01); }},
                                      {"checker-rule-double-pole", [] { return rule(2, -0.95, 4, 0.1); }},
                                      {"checker-tail", [] { return tail(-0.95, 2); }},
                                      {"checker-left-out-nodes", left_out_nodes},
                                      {"checker-far-moments", far_moments},
                                      {"checker-traction", [] { return traction(false); }},
                                      {"checker-traction-slope", [] { return traction(true); }},
                                      {"checker-moment", moment},
                                      {"checker-interpolant", interpolant},
                                      {"checker-gap-condition", gap_condition},
                                      {"checker-gap-derivative", gap_derivative}});
}

}  // namespace steadyslide::sharp_checker
