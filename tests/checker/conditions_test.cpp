#include "checker/conditions.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "checker/interpolant.hpp"
#include "checker/reader.hpp"
#include "overlap.hpp"

namespace {

using namespace steadyslide::checker;
using Kind = LayoutPoint::Contact;

/// Two zones over a profile of three pieces, with a friction jump and a free tilt: every kind of unknown. These zones
/// are not a solution; the conditions and their derivative exist nevertheless.
struct Example {
  Problem problem = Problem::of_certificate(Reader::of_json(R"({
"load": "1", "load_at": "1/10", "sliding": "+x", "gamma": "1/2", "compliance": "1",
"friction": {"values": ["0.4", "1.2", "0.2"], "jumps": ["-1", "1"]},
"indenter": {"left": "-2", "pieces": [{"to": "-1.1", "profile": ["0", "0", "1"]},
  {"to": "0", "profile": ["0", "1/3", "1"]}, {"to": "2", "profile": ["0", "0", "2", "-1/7"]}]}})",
                                                            "example"),
                                            true);
  ReducedProblem reduced{problem, Rational(1) / Rational(7), Rational(3) / Rational(2)};
  Layout layout;
  Unknowns v;

  Example(bool four_free) {
    // Anchors: -2, -1.1, -1, 0, 1, 2.
    const auto anchor = [](std::size_t a, Kind kind) { return LayoutPoint{a, 0, kind}; };
    const auto beside = [](std::size_t a, int side, Kind kind) { return LayoutPoint{a, side, kind}; };
    if (four_free) {
      layout.points = {anchor(0, Kind::outside),    beside(0, 1, Kind::begins), anchor(1, Kind::interior),
                       anchor(2, Kind::interior),   beside(2, 1, Kind::ends),   anchor(3, Kind::outside),
                       beside(4, -1, Kind::begins), anchor(4, Kind::interior),  beside(5, -1, Kind::ends),
                       anchor(5, Kind::outside)};
      layout.in_contact = {false, true, true, true, false, false, true, true, false};
      layout.intervals = {0, 0, 1, 2, 2, 3, 3, 4, 4};
      v.log_offsets = {Ball(-1.0), Ball(-2.0), Ball(-1.5), Ball(-0.5)};
    } else {
      layout.points = {anchor(0, Kind::begins),   anchor(1, Kind::interior), anchor(2, Kind::interior),
                       beside(2, 1, Kind::ends),  anchor(3, Kind::outside),  beside(4, -1, Kind::begins),
                       anchor(4, Kind::interior), anchor(5, Kind::ends)};
      layout.in_contact = {true, true, true, false, false, true, true};
      layout.intervals = {0, 1, 2, 2, 3, 3, 4};
      v.log_offsets = {Ball(-2.0), Ball(-1.5)};
    }
    v.q.assign(static_cast<std::size_t>(std::max(-layout.degree_at_infinity() - 1, 0)), Ball(0.25));
    v.tilt = {Ball(0.125)};
  }

  std::vector<Ball> conditions_at(const std::vector<Ball>& list, slong bits) const {
    const Unknowns at = v.with(list);
    const Contact contact(reduced, layout, at.log_offsets, bits + 64);
    return conditions(TractionRepresentation(contact, at, problem.loads, bits));
  }
};

}  // namespace

TEST_CASE("the derivative of the conditions is that of their differences") {
  for (const bool four_free : {true, false}) {
    const Example example(four_free);
    const Contact contact(example.reduced, example.layout, example.v.log_offsets, 192);
    const auto J = jacobian(TractionRepresentation(contact, example.v, example.problem.loads, 40));
    std::vector<Ball> list = example.v.list();
    REQUIRE(J.size() == list.size());
    const double step = std::ldexp(1, -18);
    for (std::size_t k = 0; k < list.size(); ++k) {
      std::vector<Ball> up = list, down = list;
      up[k] = up[k] + Ball(step);
      down[k] = down[k] - Ball(step);
      const std::vector<Ball> above = example.conditions_at(up, 50);
      const std::vector<Ball> below = example.conditions_at(down, 50);
      for (std::size_t i = 0; i < J.size(); ++i) {
        const Ball difference = (above[i] - below[i]) / Ball(2 * step);
        INFO("four free: ", four_free, ", i = ", i, ", k = ", k, ": ", difference.text(20), ", ", J[i][k].text(20));
        REQUIRE(difference.is_finite());
        // The third derivative times step^2/6, plus the errors of the integrals over the step.
        CHECK((Ball(1e-8) - (difference - J[i][k]).size()).is_positive());
      }
    }
  }
}

TEST_CASE("conditions at different precision enclose the same numbers") {
  const Example example(true);
  const std::vector<Ball> list = example.v.list();
  const std::vector<Ball> coarse = example.conditions_at(list, 30);
  const std::vector<Ball> fine = example.conditions_at(list, 60);
  for (std::size_t i = 0; i < coarse.size(); ++i) {
    CHECK(overlap(coarse[i], fine[i]));
    CHECK((coarse[i].radius() - fine[i].radius()).is_positive());
    CHECK((Ball(1e-15) - fine[i].radius()).is_positive());
  }
}

TEST_CASE("B_k on both sides of a wedge differ as the profile's slopes over Y") {
  // u'/c = g_k + tilt - Y B_k is one function off the contact: it is the same for every k.
  const Example example(true);
  const Contact contact(example.reduced, example.layout, example.v.log_offsets, 192);
  const TractionRepresentation form(contact, example.v, example.problem.loads, 80);
  const SurfacePoint place{4, 5, contact.length(4) * Ball(0.25), contact.length(4) * Ball(0.75)};
  const Ball x = contact.xi(place);
  std::vector<Ball> slopes;
  for (const std::size_t k : {contact.slope_of(1), contact.slope_of(3), contact.slope_of(7)}) {
    const Ball g = horner(balls(example.reduced.slopes[k], 192), x);
    slopes.push_back(g -
                     Ball(contact.sign(4)) * contact.modulus(place, contact.points()) * form.regular(k, place).value);
  }
  CHECK(overlap(slopes[0], slopes[1]));
  CHECK(overlap(slopes[1], slopes[2]));
  CHECK((Ball(1e-15) - slopes[0].radius()).is_positive());
  CHECK((Ball(1e-15) - slopes[2].radius()).is_positive());
}

TEST_CASE("B_k and its derivative with few bits enclose what they are with many") {
  // With few bits, the error of the rule and the nodes that regular_to leaves out have to be counted.
  const Example example(true);
  const Contact contact(example.reduced, example.layout, example.v.log_offsets, 260);
  const TractionRepresentation fine(contact, example.v, example.problem.loads, 100);
  for (const slong bits : {4, 6, 8, 12, 16}) {
    const TractionRepresentation coarse(contact, example.v, example.problem.loads, bits);
    for (const std::size_t segment : {0U, 4U, 5U, 8U}) {
      for (const double part : {0.01, 0.1, 0.5, 0.9, 0.99}) {
        const Ball length = contact.length(segment);
        const SurfacePoint place{segment, segment + 1, length * Ball(part), length - length * Ball(part)};
        for (const std::size_t k : {contact.slope_of(1), contact.slope_of(3), contact.slope_of(7)}) {
          const TractionRepresentation::Value few = coarse.regular(k, place);
          const TractionRepresentation::Value many = fine.regular(k, place);
          INFO("bits = ", bits, ", segment = ", segment, ", part = ", part, ", k = ", k);
          CHECK(few.value.contains_inside(many.value));
          CHECK(few.slope.contains_inside(many.slope));
          CHECK(fine.regular_to(bits, k, place).value.contains_inside(many.value));
          CHECK(coarse.regular_to(bits + 60, k, place).value.contains_inside(many.value));
        }
      }
    }
    for (const std::size_t j : {0U, 1U}) CHECK(coarse.moments(2)[j].contains_inside(fine.moments(2)[j]));
  }
}

TEST_CASE("polynomials in place of B_k enclose it between and at the places that they are made of") {
  const Example example(true);
  const Contact contact(example.reduced, example.layout, example.v.log_offsets, 260);
  const TractionRepresentation fine(contact, example.v, example.problem.loads, 100);
  const TractionRepresentation coarse(contact, example.v, example.problem.loads, 4);
  // With many bits, the error of the polynomial dominates; for an exact polynomial, that of the rules.
  for (const auto& [form, bits] : {std::pair(&fine, 1), {&fine, 4}, {&fine, 8}, {&fine, 60}, {&coarse, 60}}) {
    for (const std::size_t segment : {0U, 4U, 5U, 8U}) {
      for (const std::size_t k : {contact.slope_of(1), contact.slope_of(3), contact.slope_of(7)}) {
        for (const double from : {0.0, 0.25, 0.5, 0.6875, 0.8125}) {
          const auto at = [&](double part) {
            const Ball d = contact.length(segment) * Ball(part);
            return SurfacePoint{segment, segment + 1, d, contact.length(segment) - d};
          };
          const auto found = Interpolant::of(*form, bits, k, at(from), contact.length(segment) * Ball(0.1875));
          if (!found) continue;
          for (const double y : {-1.0, -0.875, -0.25, 0.0, 0.375, 0.75, 1.0}) {
            INFO("segment = ", segment, ", from = ", from, ", y = ", y);
            const SurfacePoint place = at(from + 0.09375 * (1 + y));
            const Ball exact = fine.regular(k, place).value;
            CHECK(horner(found->polynomial(), Ball(y)).widened(found->rest()).contains_inside(exact));
            CHECK(found->range().contains_inside(exact));
            CHECK_FALSE((form->regular(k, place).integrals - found->integrals()).is_positive());
          }
        }
      }
    }
  }
}

TEST_CASE("no polynomial in place of B_k where another piece is closer than an eighth of the panel") {
  const Example example(true);
  const Contact contact(example.reduced, example.layout, example.v.log_offsets, 192);
  const TractionRepresentation form(contact, example.v, example.problem.loads, 40);
  // Segment 5 has on its right the piece of segments 6 and 7.
  const std::size_t k = contact.slope_of(1);
  const Ball length = contact.length(5);
  const auto found = [&](double to) {
    return Interpolant::of(form, 20, k, {5, 6, Ball(), length}, length * Ball(to)).has_value();
  };
  CHECK(found(0.85));
  CHECK_FALSE(found(0.95));
}
