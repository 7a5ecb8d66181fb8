// Finds where the load of a flat punch acts when one of its edges lifts. The traction then has a free end there, and is
// integrated.

#include "numeric/flat_punch/flat_punch.hpp"
#include "numeric/quadrature/trapezoidal.hpp"
#include "numeric/riemann_hilbert/traction_density.hpp"
#include "proofs_checks/instruments/tractions/punch.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::punch_core {
namespace {

CaseList<ContactProblem> punches(const Context& context) {
  const std::vector<ContactProblem> grid{punch(Rational(3, 10), {Rational(1, 2), 2}, {Rational(1, 4)}, 3),
                                         punch(Rational(3, 10), {1}), punch(0, {0}),
                                         punch(Rational(-9, 10), {5, 1, 3}, {0, Rational(1, 2)}, 1, Sliding::minus_x)};
  return grid_and_random(context, "punch-core", grid, {20, 8, 3},
                         [&](Random& random) { return random_punch(context, random, random.below(5)); });
}

/// Returns int x t/int t, where the edge that lifts has the power of a free end.
template <Real R>
R place_of_load(const ContactProblem& p, bool front_lifts) {
  PowerProduct t = punch_traction(p);
  Exponent& lifted = front_lifts ? t.exponents.back() : t.exponents.front();
  lifted += Exponent(1);
  const numeric::trapezoidal::Grid<R> grid(t.at<R>().traction().density());
  return grid.moment(R(0)) / grid.integral();
}

/// Returns M_0 and M_1.
std::array<Number, 2> moments(const ContactProblem& p) {
  std::array<Number, 2> m{};
  for (const ContactProblem::Piece& piece : p.pieces()) {
    const auto angle = to_real<Number>(alpha(p, piece.friction));
    m[0] += angle * to_real<Number>(piece.right - piece.left);
    m[1] += angle * to_real<Number>((piece.right * piece.right - piece.left * piece.left) / 2);
  }
  return m;
}

Values core(const Number& m0, const Number& m1) {
  const Number rear = m1 / (1 + m0) - (1 + m0) / 2;
  const Number front = (1 - m0) / 2 - m1 / (1 - m0);
  return {{"rear", rear}, {"front", front}, {"rear, core", rear}, {"front, core", front}};
}

}  // namespace

Claim claim() {
  return compared<ContactProblem>("punch-core")
      .cases(punches)
      .effective_where(has_friction)
      .measured([]<Real R>(const ContactProblem& p) -> Values {
        const auto core = numeric::punch_core<R>(p);
        return {{"rear", place_of_load<R>(p, true)},
                {"front", place_of_load<R>(p, false)},
                {"rear, core", core->left.value},
                {"front, core", core->right.value}};
      })
      .predicted([](const ContactProblem& p) {
        const auto [m0, m1] = moments(p);
        return core(m0, m1);
      })
      .wrong("the middle half, as without friction", [](Values& p) { p.set(core(0, 0)); })
      .wrong("the other direction of sliding",
             [](Values& p, const ContactProblem& c) {
               const auto [m0, m1] = moments(c);
               p.set(core(-m0, -m1));
             })
      .wrong("`M_1` left out", [](Values& p, const ContactProblem& c) { p.set(core(moments(c)[0], 0)); })
      .wrong("the load at `-M_0` alone",
             [](Values& p, const ContactProblem& c) {
               const Number centre = -moments(c)[0];
               p.set({{"rear", centre}, {"front", centre}});
             })
      .near_misses();
}

}  // namespace steadyslide::proofs_checks::punch_core
