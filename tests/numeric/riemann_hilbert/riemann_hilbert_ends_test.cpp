// Free ends beside, at and across friction jumps, and at the edges of the support.

#include "numeric/closed_form/closed_form.hpp"
#include "support/solved_contact.hpp"

namespace {

Rational exact(const Real50& value) { return parse_rational(value.str(56)); }

const Indenter parabola = one_piece(-100, 100, {0, 0, 1});

/// psi/c = x^2 with friction s: returns the load at which the left or right end is at the distance 1/2 from the vertex.
/// It follows from p_0 a + p_1 b = 0, p_0 a^2 + p_1 b^2 = P/pi.
Rational load_to_reach_half(End end, const Rational& s) {
  const Real50 own = to_real<Real50>(free_exponent(end, s));
  const Real50 other = to_real<Real50>(free_exponent(opposite(end), s));
  return exact(pi<Real50>() * own / (4 * other));
}

template <Real R>
const ContactEnd<R>& end_of(const ContactComponent<R>& zone, End end) {
  return end == End::left ? zone.left : zone.right;
}

template <Real R>
void agree(const ContactSolution<R>& a, const ContactSolution<R>& b, const R& tolerance) {
  const auto za = a.contact();
  const auto zb = b.contact();
  REQUIRE(za.size() == zb.size());
  for (std::size_t k = 0; k < za.size(); ++k) {
    for (const End end : {End::left, End::right}) {
      CHECK(size_of(R(end_of(za[k], end).x.value - end_of(zb[k], end).x.value)) <= tolerance);
    }
  }
  const Rational middle((za[0].left.x.value + za[0].right.x.value) / 2);
  const R t = a.at(middle).traction.left.value;
  CHECK(size_of(R(b.at(middle).traction.left.value - t)) <= tolerance * size_of(t));
}

}  // namespace

TEST_CASE_TEMPLATE("a friction jump beside a free end: outside it changes nothing, inside next to nothing", R, double,
                   Real50) {
  const bool many = std::same_as<R, double>;
  const Rational s(3, 10);
  const auto base = solved<R>(reduced({s}, {}, parabola, 1));
  const auto zone = riemann_hilbert<Real50>(reduced({s}, {}, parabola, 1)).solution->contact()[0];
  for (const End end : {End::left, End::right}) {
    for (const std::string& distance : many ? std::vector<std::string>{"1e-3", "1e-12", "1e-15", "1e-17", "1e-30"}
                                            : std::vector<std::string>{"1e-12"}) {
      for (const Rational& other : {0_r, 2_r}) {
        if (!many && other == 0) continue;
        for (const bool inside : {true, false}) {
          INFO("distance = ", distance, ", inside = ", inside);
          const Rational d = parse_rational(distance);
          const bool rightwards = (end == End::left) == inside;
          const Rational c = exact(end_of(zone, end).x.value) + (rightwards ? d : Rational(-d));
          const std::vector<Rational> values = end == End::left ? std::vector{other, s} : std::vector{s, other};
          const auto found = solved<R>(reduced(values, {c}, parabola, 1));
          const R moved = inside ? to_real<R>(d) : R(0);
          agree<R>(*base, *found, 100 * epsilon<R>() + 10 * moved);
        }
      }
    }
  }
}

TEST_CASE_TEMPLATE("an end exactly at a jump, and just before and beyond it", R, double, Real50) {
  const bool many = std::same_as<R, double>;
  const std::pair<Rational, Rational> frictions[] = {{0.3_r, 1.5_r}, {2, Rational(1, 3)}, {0, 15}, {15, 0}};
  for (const End end : {End::left, End::right}) {
    for (const auto& [own, other] : frictions) {
      const std::vector<std::string> all{"0", "1e-3", "-1e-3", "1e-8", "-1e-8", "1e-14", "-1e-14", "1e-30", "-1e-30"};
      for (const std::string& change : many ? all : std::vector<std::string>{"0", "-1e-30"}) {
        if (!many && own != 2) continue;
        CAPTURE(change);
        const Rational load = load_to_reach_half(end, own) * (1 + parse_rational(change));
        const Rational c = end == End::left ? -0.5_r : 0.5_r;
        const auto values = end == End::left ? std::vector{other, own} : std::vector{own, other};
        const ContactProblem p = reduced(values, {c}, parabola, load);
        const auto found = solved<R>(p);
        agree<R>(*closed_form<R>(p).solution, *found, (own + other > 10 ? 1e5 : 1e3) * epsilon<R>());
        if (change != "0") continue;
        CHECK(size_of(R(end_of(found->contact()[0], end).x.value - to_real<R>(c))) <= 8 * epsilon<R>());
        CHECK(end_of(found->contact()[0], end).kind == SingularKind::free);
      }
    }
  }
}

TEST_CASE_TEMPLATE("an end exactly at the support's edge, and just before and beyond it", R, double, Real50) {
  for (const End end : {End::left, End::right}) {
    for (const Rational& s : {0_r, 0.3_r, 1_r}) {
      const Rational load = load_to_reach_half(end, s);
      const Indenter indenter =
          end == End::left ? one_piece(-0.5_r, 100, {0, 0, 1}) : one_piece(-100, 0.5_r, {0, 0, 1});
      const auto at_edge = solved<R>(reduced({s}, {}, indenter, load));
      const std::vector<std::string> all{"1e-3", "1e-8", "1e-14", "1e-30"};
      for (const std::string& change : std::same_as<R, double> ? all : std::vector<std::string>{"1e-8"}) {
        if (!std::same_as<R, double> && s != 1) continue;
        CAPTURE(change);
        const Rational d = parse_rational(change);
        const ContactProblem below = reduced({s}, {}, indenter, load * (1 - d));
        const auto before = solved<R>(below);
        const auto beyond = solved<R>(reduced({s}, {}, indenter, load * (1 + d)));
        agree<R>(*before, *closed_form<R>(reduced({s}, {}, parabola, load * (1 - d))).solution, 1e3 * epsilon<R>());
        // The far end moves continuously; the near one becomes an edge.
        const End far = opposite(end);
        const R far_before = end_of(before->contact()[0], far).x.value;
        const R far_beyond = end_of(beyond->contact()[0], far).x.value;
        CHECK(size_of(R(far_before - far_beyond)) <= 4 * to_real<R>(d) + 100 * epsilon<R>());
        const ContactEnd<R> near_beyond = end_of(beyond->contact()[0], end);
        if (to_real<R>(d) > 1000 * epsilon<R>()) {
          CHECK(end_of(before->contact()[0], end).kind == SingularKind::free);
          CHECK(near_beyond.kind == SingularKind::edge);
          CHECK(near_beyond.intensity.value > 0);
        }
        CHECK(size_of(R(near_beyond.x.value - end_of(at_edge->contact()[0], end).x.value)) <=
              4 * to_real<R>(d) + 100 * epsilon<R>());
      }
    }
  }
}
