// The singularities of the half-space when the kernel changes by a smooth function: a row of punches, or a circle.
// [Bal16, remark 2]
//
// Punches repeated with the period 2 pi: sum_k 1/(x'-x+2 pi k) = (1/2) cot((x'-x)/2). With friction pieces between
// the places x_0 < ... < x_n (edges and jumps) and the powers p_j of the half-space, sum p_j = -1:
//
//   t = -(P/(2 pi)) cos(pi alpha) prod_j |sin((x-x_j)/2)|^{p_j} cos((x + sum_j p_j x_j)/2).

#include "numeric/cauchy/sliding_operator.hpp"
#include "numeric/quadrature/trapezoidal.hpp"
#include "proofs_checks/claims/remarks/remarks.hpp"
#include "proofs_checks/instruments/near.hpp"
#include "proofs_checks/instruments/punch.hpp"

namespace steadyslide::proofs_checks {
namespace {

struct RowCase {
  std::vector<Rational> places;
  std::vector<Rational> s;  ///< between them
};

std::vector<RowCase> rows(bool quick) {
  // The cheapest first, for the controls.
  std::vector<RowCase> all{{{Rational(-5, 2), Rational(5, 2)}, {Rational(2, 3)}},
                           {{-1, Rational(1, 3), Rational(3, 2)}, {Rational(1, 4), 2}}};
  if (!quick) all.push_back({{Rational(-1, 2), 0, Rational(1, 4), 2}, {3, Rational(1, 5), 1}});
  return all;
}

struct RowSaid {
  bool angles = true;  ///< in the powers at edges
  bool jumps = true;
  int sign = 1;          ///< of the angles
  bool circular = true;  ///< sines in place of distances
  bool centred = true;   ///< the last factor
  bool kernel = true;    ///< the smooth part of the kernel
  int miss = 0;
};

std::vector<Exponent> powers(const RowCase& c, const RowSaid& said) {
  const auto alpha = [&](std::size_t k) {
    const Exponent angle = Exponent::angle(c.s[k]);
    return said.sign > 0 ? angle : -angle;
  };
  std::vector<Exponent> p{said.angles ? -(half + alpha(0)) : -half};
  for (std::size_t k = 1; k < c.s.size(); ++k) p.push_back(said.jumps ? alpha(k - 1) - alpha(k) : Exponent());
  p.push_back(said.angles ? -(half - alpha(c.s.size() - 1)) : -half);
  return p;
}

/// The traction for the load 1, panel by panel.
template <Real R>
numeric::PiecewiseDensity<R> traction(const RowCase& c, const RowSaid& said) {
  std::vector<R> x;
  for (const Rational& place : c.places) x.push_back(numeric::to_real<R>(place));
  std::vector<numeric::Power<R>> p;
  for (const Exponent& exponent : powers(c, said)) p.push_back(numeric::Power<R>::of(exponent));
  p[0].value += said.miss * R(tolerance<R>());
  p[0].plus_one += said.miss * R(tolerance<R>());
  R moment = 0;
  for (std::size_t j = 0; j < x.size(); ++j) moment += p[j].value * x[j];
  if (!said.centred) moment = 0;
  numeric::PiecewiseDensity<R> density;
  for (std::size_t k = 0; k + 1 < x.size(); ++k) {
    const R size = -numeric::cos_pi_alpha<R>(c.s[k]) / (2 * numeric::pi<R>());
    const bool circular = said.circular;
    const auto smooth = [=](const numeric::Node<R>& node) {
      using std::cos, std::pow, std::sin;
      R value = size * cos(R((node.x + moment) / 2));
      for (std::size_t j = 0; j < x.size(); ++j) {
        const R d = j <= k ? R(node.from_left + (x[k] - x[j])) : R(node.from_right + (x[j] - x[k + 1]));
        const R length = circular ? R(sin(R(d / 2))) : R(d / 2);
        value *= pow(j == k || j == k + 1 ? R(length / d) : length, p[j].value);
      }
      return value;
    };
    const R length = numeric::to_real<R>(c.places[k + 1] - c.places[k]);
    density.push_back({{x[k], x[k + 1], length}, p[k], p[k + 1], smooth});
  }
  return density;
}

/// (1/2) cot(w/2) - 1/w = ((w/2) cos(w/2) - sin(w/2))/(w sin(w/2)), the numerator by its series where it cancels.
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
void check_row(Findings& findings, const RowCase& c, const RowSaid& said) {
  using std::abs, std::max;
  const Quantity equation{"equation with the periodic kernel",
                          {"(1/pi) PV int t/(x'-x) and the smooth part by quadrature", "-s t"},
                          tolerance<R>()};
  const Quantity load{"total load", {"quadrature", "1"}, tolerance<R>()};
  const numeric::PiecewiseDensity<R> t = traction<R>(c, said);
  const numeric::trapezoidal::Grid<R> grid(t);
  std::vector<R> s;
  for (const Rational& value : c.s) s.push_back(numeric::to_real<R>(value));
  const numeric::SlidingOperator<R> A(grid, s);
  for (std::size_t k = 0; k < t.size(); ++k) {
    for (const int percent : std::vector<int>{30, 85}) {
      const auto at = grid.midpoint_near(k, R(percent) / 100);
      numeric::PiecewiseDensity<R> rest = t;
      for (auto& panel : rest) {
        panel.smooth = [smooth = panel.smooth, x = at.node.x](const numeric::Node<R>& node) {
          return R(smooth(node) * smooth_kernel(R(node.x - x)));
        };
      }
      const numeric::SlidingTerms<R> terms = A.at(at);
      const R added = said.kernel ? R(numeric::trapezoidal::Grid<R>(rest).integral() / numeric::pi<R>()) : R(0);
      const R size = max({R(abs(terms.hilbert.value)), R(abs(added)), R(abs(terms.friction))});
      findings.compare(equation, static_cast<double>(R(abs(terms.sum().value + added) / size)));
    }
  }
  findings.compare(load, relative_difference<R>(grid.integral(), R(-1)));
}

std::vector<Evidence> check(const Context& context, const RowSaid& said) {
  return gather_quick_in_double(context, [&]<Real R>() {
    Findings findings;
    const auto all = rows(context.quick);
    for (const RowCase& c : all) {
      findings.begin_case(std::to_string(c.s.size()) + " friction values");
      check_row<R>(findings, c, said);
      findings.decide("the powers add up to -1", [&] {
        Exponent sum;
        for (const Exponent& p : powers(c, said)) sum += p;
        return sum == Exponent(-1);
      }());
    }
    return findings.evidence(std::to_string(all.size()) + " rows of punches");
  });
}

}  // namespace

Claim remark_same_singularities() {
  return make_claim(
      claim_text("rem-02-same-singularities"), check, RowSaid{},
      std::vector<Wrong<RowSaid>>{
          {"the powers at edges without friction", changed<RowSaid>([](RowSaid& said) { said.angles = false; })},
          {"no singularity at the friction jumps", changed<RowSaid>([](RowSaid& said) { said.jumps = false; })},
          {"the angles' sign", changed<RowSaid>([](RowSaid& said) { said.sign = -1; })},
          {"the half-space's traction", changed<RowSaid>([](RowSaid& said) { said.circular = said.centred = false; })},
          {"the last factor centred at 0", changed<RowSaid>([](RowSaid& said) { said.centred = false; })},
          {"the half-space's kernel", changed<RowSaid>([](RowSaid& said) { said.kernel = false; })},
          {"near miss: the power at the rear moved by ten times the tolerance",
           changed<RowSaid>([](RowSaid& said) { said.miss = 10; })}});
}

}  // namespace steadyslide::proofs_checks
