// Punches repeated with the period 2 pi: sum_k 1/(x'-x+2 pi k) = (1/2) cot((x'-x)/2). Friction pieces lie between the
// points x_0 < ... < x_n (edges and friction jumps). With the powers p_j of the half-space, sum p_j = -1, the traction
// is
//
//   t = -(P/(2 pi)) cos(pi alpha) prod_j |sin((x-x_j)/2)|^{p_j} cos((x + sum_j p_j x_j)/2).

#include "proofs_checks/instruments/tractions/punch.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::rem_02_same_singularities {
namespace {

/// One punch of the row.
struct Row {
  std::vector<Rational> places;
  std::vector<Rational> s;  ///< values of s between the points
};

std::string text_of(const Row& row) { return std::to_string(row.s.size()) + " friction values"; }

CaseList<Row> rows(const Context& context) {
  // The cheapest case comes first, for the controls.
  return first_when_quick<Row>(context,
                               {{{Rational(-5, 2), Rational(5, 2)}, {Rational(2, 3)}},
                                {{-1, Rational(1, 3), Rational(3, 2)}, {Rational(1, 4), 2}},
                                {{Rational(-1, 2), 0, Rational(1, 4), 2}, {3, Rational(1, 5), 1}}},
                               2, "rows of punches");
}

/// The traction for the load 1, and the kernel 1/w + smooth(w).
struct RowTraction {
  std::vector<Exponent> powers;
  Number moved = 0;                             ///< a near miss adds this to the first power
  bool periodic = true;                         ///< use sines; if false, distances
  std::optional<Number> centre = std::nullopt;  ///< a wrong value of sum_j p_j x_j, if present
  Number cotangent = 1;                         ///< factor of the kernel's smooth part
};

std::vector<Exponent> half_space_powers(const Row& row, bool reversed = false) {
  std::vector<Exponent> alpha;
  for (const Rational& s : row.s) alpha.push_back(Exponent::angle(reversed ? Rational(-s) : s));
  return punch_powers(alpha);
}

/// Returns the traction, panel by panel.
template <Real R>
PiecewiseDensity<R> density_of(const Row& row, const RowTraction& form) {
  std::vector<R> x;
  for (const Rational& place : row.places) x.push_back(to_real<R>(place));
  std::vector<numeric::Power<R>> p;
  for (const Exponent& exponent : form.powers) p.push_back(numeric::Power<R>::of(exponent));
  p[0].value += R(form.moved);
  p[0].plus_one += R(form.moved);
  R moment = 0;
  for (std::size_t j = 0; j < x.size(); ++j) moment += p[j].value * x[j];
  if (form.centre) moment = R(*form.centre);
  PiecewiseDensity<R> density;
  for (std::size_t k = 0; k + 1 < x.size(); ++k) {
    const R size = -cos_pi_alpha<R>(row.s[k]) / (2 * numeric::pi<R>());
    const auto smooth = [=, periodic = form.periodic](const Node<R>& node) {
      using std::cos, std::pow, std::sin;
      R value = size * cos(R((node.x + moment) / 2));
      for (std::size_t j = 0; j < x.size(); ++j) {
        const R d = j <= k ? R(node.from_left + (x[k] - x[j])) : R(node.from_right + (x[j] - x[k + 1]));
        const R length = periodic ? R(sin(R(d / 2))) : R(d / 2);
        value *= pow(j == k || j == k + 1 ? R(length / d) : length, p[j].value);
      }
      return value;
    };
    const R length = to_real<R>(row.places[k + 1] - row.places[k]);
    density.push_back({{x[k], x[k + 1], length}, p[k], p[k + 1], smooth});
  }
  return density;
}

/// Returns (1/2) cot(w/2) - 1/w = ((w/2) cos(w/2) - sin(w/2))/(w sin(w/2)). The numerator uses its series where its
/// terms cancel.
template <Real R>
R smooth_kernel(const R& w) {
  using std::abs, std::cos, std::sin;
  const R h = w / 2;
  if (w == 0) return 0;
  if (abs(w) > 1) return R(h * cos(h) - sin(h)) / (w * sin(h));
  R power = h;
  R sum = 0;
  for (int n = 1; n < 60; ++n) {
    power *= -h * h / (2 * n * (2 * n + 1));
    sum += 2 * n * power;
    if (abs(power) < abs(sum) * numeric::epsilon<R>() / 1000) break;
  }
  return sum / (w * sin(h));
}

template <Real R>
void check(Findings& findings, const RowTraction& form, const Row& row) {
  using std::abs, std::max;
  const PiecewiseDensity<R> t = density_of<R>(row, form);
  const trapezoidal::Grid<R> grid(t);
  for (std::size_t k = 0; k < t.size(); ++k) {
    for (const int percent : {30, 85}) {
      const auto at = grid.midpoint_near(k, R(percent) / 100);
      PiecewiseDensity<R> rest = t;
      for (auto& panel : rest) {
        panel.smooth = [smooth = panel.smooth, x = at.node.x](const Node<R>& node) {
          return R(smooth(node) * smooth_kernel(R(node.x - x)));
        };
      }
      const R singular = grid.hilbert(at);
      const R added = R(form.cotangent) * trapezoidal::Grid<R>(rest).integral() / numeric::pi<R>();
      const R friction = to_real<R>(row.s[k]) * t[k](at.node);
      const R size = max({R(abs(singular)), R(abs(added)), R(abs(friction))});
      findings.compare("equation", R(singular + added), R(-friction), size);
    }
  }
  findings.compare("load", grid.integral(), R(-1));
  Exponent sum;
  for (const Exponent& p : form.powers) sum += p;
  findings.decide("the powers add up to -1", sum == Exponent(-1));
}

}  // namespace

Claim claim() {
  return formula_claim<Row, RowTraction>("rem-02-same-singularities")
      .cases(rows)
      .precision(Precision::quick_in_double)
      .says([](const Row& row) { return RowTraction{.powers = half_space_powers(row)}; })
      .checked([]<Real R>(auto&... of) { check<R>(of...); })
      .wrong("the powers at edges without friction",
             [](RowTraction& form) { form.powers.front() = form.powers.back() = -half; })
      .wrong("no singularity at the friction jumps",
             [](RowTraction& form) { std::fill(form.powers.begin() + 1, form.powers.end() - 1, Exponent()); })
      .wrong("the angles' sign", [](RowTraction& form, const Row& row) { form.powers = half_space_powers(row, true); })
      .wrong("the half-space's traction",
             [](RowTraction& form) {
               form.periodic = false;
               form.centre = 0;
             })
      .wrong("the last factor centred at 0", &RowTraction::centre, 0)
      .wrong("the half-space's kernel", &RowTraction::cotangent, 0)
      .near_miss("the power at the rear", [](RowTraction& form, const Number& step) { form.moved = step; });
}

}  // namespace steadyslide::proofs_checks::rem_02_same_singularities
