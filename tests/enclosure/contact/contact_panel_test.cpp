// Bounds on a panel's ellipse, compared with values at both of its ends; and a power near its singular point.

#include "enclosure/contact/contact_panel.hpp"

#include <arb_hypgeom.h>

#include "enclosure/contact/gap_contact.hpp"
#include "enclosure/contact/power_at_point.hpp"
#include "enclosure/contact/segment_moments.hpp"

namespace steadyslide::enclosure {

namespace {

constexpr Bits panel_bits = 160;

}  // namespace

TEST_CASE("a panel's bounds hold at both ends of its ellipses: products of powers, polynomials") {
  GapContact gap(-2, -3);
  int largest = 0;
  for (const std::size_t segment : {0U, 3U}) {
    for (const ContactPanel::Interval& part : ContactPanel::graded(gap.set, segment)) {
      for (const int n : {-1, 1}) {
        const ContactPanel panel(gap.set, part, n, std::nullopt, 20, gap.rules);
        for (const Ellipse ellipse : {Ellipse::close, Ellipse::beside, Ellipse::far}) {
          const Ball reach = panel.reach(ellipse) * Ball(0.9999_r, panel_bits);
          const Ball start = gap.set.x(segment) + part.from_left;
          for (const Ball& x : {start - reach, start + part.length + reach}) {
            CHECK(abs(x) <= panel.largest({Ball(0), Ball(1)}, ellipse));
            CHECK(power(x, 2) <= panel.largest({Ball(0), Ball(0), Ball(1)}, ellipse));
            // The bound of x on the ellipse is larger than that on the panel itself.
            largest += abs(x) > max(abs(start), abs(start + part.length)) ? 1 : 0;
            Ball product(1, panel_bits);
            bool inside = true;
            for (std::size_t j = 0; j < gap.set.points(); ++j) {
              const bool touched = part.touches && j == (*part.touches == Side::left ? segment : segment + 1);
              if (touched || gap.set.is_regular(j)) continue;
              const Ball distance = abs(x - gap.set.x(j));
              inside = inside && distance.is_positive();
              product *= power(distance, Ball(n) * gap.set.power(j));
            }
            if (inside && panel.largest_product(ellipse).is_finite()) CHECK(product <= panel.largest_product(ellipse));
          }
        }
      }
    }
  }
  CHECK(largest > 10);
}

TEST_CASE("Cauchy's integral of a power beside its point, however small the power is") {
  JacobiRules rules(panel_bits);
  const Ball length(3, panel_bits);
  for (const char* power_text : {"-0.4", "-1e-5", "-1e-14", "-1e-60", "0", "1e-60", "1e-14", "1e-5", "0.4", "0.9"}) {
    for (const char* distance : {"1.5", "0.2", "1e-10", "1e-40"}) {
      INFO("power = ", power_text, ", distance = ", distance);
      const Rational exact = parse_rational(power_text);
      const Ball a(exact, panel_bits), d(parse_rational(distance), panel_bits);
      const PowerAtPoint at_c(a, exact == 0, length);
      const Ball whole = at_c.factor() * at_c.at(d) + at_c.analytic_part(d);
      // int_0^L y^a/(y + d) dy = L^(a+1)/(d (a+1)) 2F1(1, a+1; a+2; -L/d), by Arb. Powers next to 0 need more bits.
      constexpr Bits bits = 1000;
      const Ball b = Ball(exact, bits) + 1, ratio = length / Ball(parse_rational(distance), bits);
      const Ball function =
          made_by(arb_hypgeom_2f1, bits, Ball(1).get(), b.get(), (b + 1).get(), (-ratio).get(), 0, bits);
      const Ball integral = steadyslide::enclosure::power(Ball(3, bits), Ball(exact, bits)) * ratio / b * function;
      CHECK(whole.overlaps(integral));
      CHECK(whole.radius() < abs(integral) * steadyslide::enclosure::power(Ball(10, 64), -38));
      // Over an interval of distances the enclosure is as wide as the integral there, not 1/a times as wide.
      const Ball wide = Ball::hull(d / Ball(2), d);
      const Ball range = at_c.factor() * at_c.singular_part(wide, 0) + at_c.analytic_part(wide);
      if (wide.upper() <= length / Ball(2)) {
        CHECK(range.contains(whole));
        CHECK(range.radius() < Ball(4) * (abs(a) + Ball(1)) * max(Ball(1), steadyslide::enclosure::power(d, a)));
      }
    }
  }
}

TEST_CASE("d^m E(d) for all d from 0 on") {
  const Ball length(2, panel_bits);
  for (const char* power_text : {"-0.9", "-0.3", "-1e-20", "0", "1e-20", "0.3", "0.9"}) {
    const Rational exact = parse_rational(power_text);
    const PowerAtPoint at_c(Ball(exact, panel_bits), exact == 0, length);
    for (const int m : {0, 1, 2}) {
      INFO("power = ", power_text, ", m = ", m);
      for (const char* upper : {"1", "0.7", "0.1", "1e-9"}) {
        const Ball d(parse_rational(upper), panel_bits);
        const Ball range = at_c.singular_part(Ball::hull(Ball(0, panel_bits), d), m);
        CHECK((range.is_finite() || (m == 0 ? exact <= 0 : exact == 0 && d > Ball(0.7_r, 64))));
        if (m == 0 && exact <= 0) CHECK_FALSE(range.is_finite());
        for (const int part : {1, 2, 3, 10, 1000, 1000000}) {
          const Ball at = d / Ball(part);
          const Ball value = power(at, m) * at_c.at(at);
          CHECK((!range.is_finite() || range.overlaps(value)));
          CHECK(at_c.at(d) <= at_c.at(at) + Ball(1e-30_r, 64));
        }
      }
    }
  }
}

TEST_CASE("a segment seen from afar by its moments: the sum over its nodes") {
  GapContact gap(-2, -3);
  for (const std::size_t segment : {0U, 3U}) {
    std::vector<ContactPanel> panels;
    std::vector<Ball> sizes;
    const BallPolynomial p{Ball(1, panel_bits), Ball(-2, panel_bits), Ball(3, panel_bits)};
    for (ContactPanel::Interval& part : ContactPanel::graded(gap.set, segment)) {
      panels.emplace_back(gap.set, std::move(part), -1, std::nullopt, 40, gap.rules);
      sizes.push_back(panels.back().largest(p, Ellipse::far));
    }
    const auto weights = SegmentMoments::of_weights(gap.set, segment, panels, 2);
    const SegmentMoments moments(gap.set, segment, panels, weights, p, sizes, gap.bits);
    for (const Side facing : {Side::left, Side::right}) {
      CHECK_FALSE(moments.seen_from(Ball(0.1_r, panel_bits), facing));
      CHECK_FALSE(moments.seen_from(Ball::hull(Ball(3, panel_bits), Ball(4, panel_bits)), facing));
      for (const char* distance : {"0.6", "1", "3", "100", "1e5", "1e6", "1e7", "1e8", "1e9", "1e10", "1e12", "1e30"}) {
        CAPTURE(distance);
        const Ball from(parse_rational(distance), panel_bits);
        Ball sum(0, panel_bits);
        for (const ContactPanel& panel : panels) {
          for (const ContactPanel::Node& node : panel.nodes()) {
            sum += node.weight * value_at(p, gap.set.x(segment) + node.from_left) /
                   (from + (facing == Side::left ? node.from_left : node.from_right));
          }
        }
        const auto seen = moments.seen_from(from, facing);
        REQUIRE(seen);
        CHECK(seen->contains(sum.midpoint()));
        CHECK(seen->radius() < abs(sum) * power(Ball(10, 64), -30));
      }
    }
  }
}

}  // namespace steadyslide::enclosure
