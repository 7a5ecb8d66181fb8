#include "proofs_checks/instruments/near.hpp"
#include "proofs_checks/instruments/punch.hpp"
#include "proofs_checks/kit/comparison.hpp"
#include "proofs_checks/kit/rate.hpp"

namespace steadyslide::proofs_checks {
namespace {

/// A parabola, psi = x^2/2, under the friction s; or what is left of its friction's influence as s -> 0.
struct Neglect {
  Rational s;
  bool in_the_limit = false;
};

std::string text_of(const Neglect& c) { return c.in_the_limit ? "s -> 0" : "s = " + to_string(c.s); }

CaseList<Neglect> parabolas(const Context& context) {
  std::vector<Neglect> all{{Rational(1, 10)}, {Rational(1, 2)}};
  if (!context.quick) all.insert(all.end(), {{Rational(1, 20)}, {Rational(3, 4)}, {2}});
  all.push_back({0, true});
  return {all, std::to_string(all.size() - 1) + " parabolas, solved, and three with s from 1e-4 to 1e-8"};
}

/// gamma = 1, as good as: s is f times a number of the data.
template <Real R>
Solved<R> parabola(const Rational& s) {
  return solve<R>({Elasticity::reduced(Rational(1, 2)), FrictionProfile({2 * s}, {}),
                   Indenter(-2, {{2, Polynomial({0, 0, Rational(1, 2)})}}), 1});
}

template <class R>
struct Contact {
  R width;
  R centre;
  R peak;    ///< t at x = 2 centre: -4 alpha a where the centre is at -2 alpha a
  R middle;  ///< t at x = 0
};

template <Real R>
Contact<R> contact(const Rational& s) {
  const auto solution = parabola<R>(s);
  const auto ends = solution->contact().front();
  const R left = ends.left.x.value;
  const R right = ends.right.x.value;
  const auto t = [&](const R& x) {
    return traction_beside(*solution, contact_end(*solution, Side::left), Side::right, R(x - left));
  };
  return {R((right - left) / 2), R((left + right) / 2), t(R(left + right)), t(R(0))};
}

template <Real R>
Values in_the_limit(const Contact<R>& zero) {
  std::vector<Level> peaks, centres;
  for (const char* small : {"1e-4", "1e-6", "1e-8"}) {
    const Rational s = parse_rational(small);
    const Contact<R> c = contact<R>(s);
    const auto inverse = numeric::to_real<double>(Rational(1 / s));
    peaks.push_back({inverse, static_cast<double>(R(1 - c.peak / zero.peak))});
    centres.push_back({inverse, std::abs(static_cast<double>(R(c.centre / c.width)))});
  }
  const auto order = [](const std::vector<Level>& levels) {
    const Rate rate = fitted_rate(levels);
    return Order{rate.value, rate.error_bar, "s from 1e-4 to 1e-8"};
  };
  const double over_square = peaks.back().error * peaks.back().cells * peaks.back().cells;
  return {{"loss", order(peaks)}, {"shift", order(centres)}, {"loss over s^2", over_square}};
}

}  // namespace

Claim rem_01_neglect() {
  return compared<Neglect>("rem-01-neglect")
      .cases(parabolas)
      .precision(Precision::at_least_fifty)
      .quantity({.name = "peak",
                 .what = "largest pressure under a parabola over the frictionless one",
                 .routes = {"solved problems", "cos(pi alpha) ((1+2 alpha)/(1-2 alpha))^alpha"}})
      .quantity({.name = "centre",
                 .what = "centre of the contact over its half-width",
                 .routes = {"solved problems", "-2 alpha"}})
      .quantity({.name = "width",
                 .what = "width over the frictionless one",
                 .routes = {"solved problems", "1/sqrt(1-4 alpha^2)"}})
      .quantity({.name = "loss", .what = "loss of the largest pressure", .routes = {}, .tolerance = 0.01})
      .quantity({.name = "shift", .what = "shift of the contact", .routes = {}, .tolerance = 0.01})
      .quantity({.name = "loss over s^2",
                 .what = "loss of the largest pressure over s^2, s = 1e-8",
                 .routes = {"solved problems", "1/2 - 4/pi^2"},
                 .tolerance = 1e-12})
      .measured([]<Real R>(const Neglect& c) -> Values {
        const Contact<R> zero = contact<R>(0);
        if (c.in_the_limit) return in_the_limit<R>(zero);
        const Contact<R> with = contact<R>(c.s);
        return {{"peak", R(with.peak / zero.peak)},
                {"centre", R(with.centre / with.width)},
                {"width", R(with.width / zero.width)}};
      })
      .predicted([](const Neglect& c) -> Values {
        const Number pi = numeric::pi<Number>();
        if (c.in_the_limit)
          return {{"loss", Order{2}}, {"shift", Order{1}}, {"loss over s^2", Number(0.5 - 4 / (pi * pi))}};
        const Number alpha = numeric::to_real<Number>(Exponent::angle(c.s));
        const Number ratio = pow(Number((1 + 2 * alpha) / (1 - 2 * alpha)), alpha);
        return {{"peak", Number(numeric::cos_pi_alpha<Number>(c.s) * ratio)},
                {"centre", Number(-2 * alpha)},
                {"width", Number(1 / sqrt(Number(1 - 4 * alpha * alpha)))}};
      })
      .wrong("the largest pressure lost at first order",
             [](Values& p, const Neglect& c) {
               if (c.in_the_limit) p.set("loss", Order{1});
             })
      .wrong("the contact shifted at second order",
             [](Values& p, const Neglect& c) {
               if (c.in_the_limit) p.set("shift", Order{2});
             })
      .wrong("the contact shifted to the front",
             [](Values& p, const Neglect& c) {
               if (!c.in_the_limit) p["centre"] *= -1;
             })
      .near_misses();
}

}  // namespace steadyslide::proofs_checks
