// Large friction, high degrees, wide or distant supports, many digits, and starts from a neighbouring solution.

#include "support/solved_contact.hpp"

namespace {

const Indenter wells = two_wells();
const Indenter bent(-1, {{0, Polynomial({0, -1, 1})}, {1, Polynomial({0, 0.5_r})}});
const Indenter step(-1, {{0, Polynomial({0, 0, 1})}, {1, Polynomial({0.1_r, 0, 1})}});

}  // namespace

TEST_CASE("large friction") {
  for (const int rear : {0, 15, 50}) {
    for (const int front : {0, 15, 50}) {
      INFO("rear = ", rear, ", front = ", front);
      const auto with = [&](const Indenter& indenter) { return reduced({rear, front}, {0.1_r}, indenter, 1); };
      solved<double>(with(one_piece(-100, 100, {0, 0, 1})));
      solved<double>(with(one_piece(-1, 1, {0})));
      solved<double>(with(one_piece(-1, 1, {0, 1})));
      solved<double>(with(Indenter(-1, {{0, Polynomial({0, 0, 1})}, {1, Polynomial()}})));
    }
  }
  solved<Real50>(reduced({15, 0}, {0.1_r}, one_piece(-100, 100, {0, 0, 1}), 1));
}

TEST_CASE("degree 64") {
  std::vector<Rational> high(65, 0_r), dense = high;
  high[64] = 1;
  std::vector<Rational> mixed = high;
  mixed[2] = 0.1_r;
  for (int k = 2; k <= 64; ++k) dense[static_cast<std::size_t>(k)] = Rational(1, k * k);
  for (const auto& coefficients : {high, mixed, dense}) {
    const ContactProblem p = on_two_coatings(one_piece(-1, 1, coefficients), 0.1_r);
    const auto found = solved<double>(p);
    solutions_agree<double, Real50>(*found, *riemann_hilbert<Real50>(p).solution, Real50(1e-12));
  }
}

TEST_CASE("wide supports and supports far away from the origin") {
  const Indenter near = one_piece(-1, 1, {0, 0, 1});
  const Indenter wide = one_piece(-1000000, 1000000, {0, 0, 1});
  const auto base = solved<double>(on_two_coatings(near, 1));
  solutions_agree<double, double>(*base, *solved<double>(on_two_coatings(wide, 1)), 1e-14);
  const std::vector<Indenter> indenters{near, wide, wells, bent, step};
  for (const Indenter& indenter : indenters) {
    const ContactProblem p = on_two_coatings(indenter, 1);
    const Rational far = 1000000;
    solutions_agree<double, double>(*solved<double>(p), *solved<double>(p.moved(1, far)), 1e-14, far);
    if (&indenter == &indenters[3]) solved<Real50>(p.moved(1, far));
  }
  // Two wells at one end of a wide support: heights in coordinates from its middle would lose 16 digits.
  const Indenter beside = one_piece(-3, 10000, {1, 0.2_r, -2, 0, 1});
  solutions_agree<double, double>(*solved<double>(on_two_coatings(wells, 1)),
                                  *solved<double>(on_two_coatings(beside, 1)), 1e-13);
  // Wide gaps beside two components.
  solved<double>(on_two_coatings(one_piece(-1000000, 1000000, {1, 0, -2, 0, 1}), 1));
}

TEST_CASE("16, 50 and 100 digits agree") {
  for (const Indenter& indenter : {wells, bent, step}) {
    const ContactProblem p = on_two_coatings(indenter, 3);
    const auto a = solved<double>(p);
    const auto b = riemann_hilbert<Real50>(p).solution;
    const auto c = riemann_hilbert<Real100>(p).solution;
    REQUIRE(b->failed_condition() + c->failed_condition() == "");
    solutions_agree<double, Real50>(*a, *b, Real50(1e-13));
    solutions_agree<Real50, Real100>(*b, *c, Real100(1e-50));
  }
}

TEST_CASE_TEMPLATE("a neighbouring solution to start from leads to the same one", R, double, Real50) {
  const auto indenters = std::same_as<R, double> ? std::vector{wells, bent, step} : std::vector{bent};
  for (const Indenter& indenter : indenters) {
    std::shared_ptr<const ContactSolution<R>> last;
    for (const int load : {1, 4, 3}) {
      const ContactProblem p = on_two_coatings(indenter, load);
      const auto alone = riemann_hilbert<R>(p).solution;
      if (last) solutions_agree<R, R>(*alone, *riemann_hilbert<R>(p, last.get()).solution, 1000 * epsilon<R>());
      last = alone;
    }
  }
  // A useless start: its component is in the wrong place.
  const auto right = solved<R>(on_two_coatings(one_piece(-3, 3, {0, 0, 1}), 1));
  const ContactProblem left = on_two_coatings(one_piece(-3, 3, {4, 4, 1}), 1);
  solutions_agree<R, R>(*solved<R>(left), *solved<R>(left, right.get()), 1000 * epsilon<R>());
}
