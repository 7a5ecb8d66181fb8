#include "proofs_checks/instruments/solutions/local_behaviour.hpp"
#include "proofs_checks/instruments/tractions/punch.hpp"
#include "proofs_checks/kit/claim_builder.hpp"
#include "proofs_checks/kit/rate.hpp"

namespace steadyslide::proofs_checks::rem_01_neglect {
namespace {

const Rational s_front(1);  ///< value of s in front of the friction jump

/// The cases: a parabola, psi = x^2/2, under the friction s; the limit of the influence of its friction as s -> 0; and
/// the two features that give the traction another power, an edge and a friction jump.
struct Neglect {
  enum class What { parabola, limit, punch, jump } what = What::parabola;
  Rational s = 0;
};
using What = Neglect::What;

std::string text_of(const Neglect& c) {
  switch (c.what) {
    case What::parabola: return "s = " + to_string(c.s);
    case What::limit: return "s -> 0";
    case What::punch: return "flat punch, s = " + to_string(c.s);
    default: return "parabola, s = " + to_string(c.s) + " and " + to_string(s_front);
  }
}

CaseList<Neglect> parabolas(const Context& context) {
  std::vector<Neglect> all{{What::parabola, Rational(1, 10)}, {What::parabola, Rational(1, 2)}};
  if (!context.quick) {
    for (const Rational& s : {Rational(1, 20), Rational(3, 4), Rational(2)}) all.push_back({What::parabola, s});
  }
  const std::string parabolas = std::to_string(all.size());
  all.insert(all.end(), {{What::limit}, {What::punch, Rational(2, 5)}, {What::jump, Rational(2, 5)}});
  return {all, parabolas + " parabolas, solved, three with `s` from `1e-4` to `1e-8`, a punch and a friction jump"};
}

const Indenter parabola(-2, {{2, Polynomial({0, 0, Rational(1, 2)})}});

/// Returns a reduced problem with gamma = 1/2 and f = 2 s: the values of s are the data.
ContactProblem sliding(std::vector<Rational> s, const Indenter& indenter, std::vector<Rational> jumps = {}) {
  for (Rational& value : s) value *= 2;
  return {Elasticity::reduced(Rational(1, 2)), FrictionProfile(std::move(s), std::move(jumps)), indenter, 1};
}

template <class R>
struct Contact {
  R width;
  R centre;
  R peak;    ///< t at x = 2 centre: -4 alpha a if the centre is at -2 alpha a
  R middle;  ///< t at x = 0
};

template <Real R>
Contact<R> contact(const Rational& s) {
  const auto solution = solve<R>(sliding({s}, parabola));
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
    const auto inverse = to_real<double>(Rational(1 / s));
    peaks.push_back({inverse, static_cast<double>(R(1 - c.peak / zero.peak))});
    centres.push_back({inverse, std::abs(static_cast<double>(R(c.centre / c.width)))});
  }
  const auto order = [](const std::vector<Level>& levels) {
    const Rate rate = fitted_rate(levels);
    return Order{rate.value, rate.error_bar, "`s` from `1e-4` to `1e-8`"};
  };
  const double over_square = peaks.back().error * peaks.back().cells * peaks.back().cells;
  return {{"loss", order(peaks)}, {"shift", order(centres)}, {"loss over s^2", over_square}};
}

/// Returns the powers measured on cells. The cell solver uses no exponents.
Values powers(const Neglect& c, bool quick) {
  const ContactProblem problem = c.what == What::punch ? sliding({c.s}, Indenter(-1, {{1, Polynomial()}}))
                                                       : sliding({c.s, s_front}, parabola, {Rational(1, 8)});
  const auto solution = solve_on_cells(problem, quick ? 2048 : 8192);
  Values values;
  for (const auto& place : solution->places()) {
    if (place.kind == SingularKind::edge) {
      values.add(
          {place.contact == Side::right ? "rear" : "front", power_on_cells(*solution, place, place.contact).value});
    } else if (place.kind == SingularKind::friction_jump) {
      values.add({"jump", power_on_cells(*solution, place, Side::left).value});
    }
  }
  return values;
}

Values predicted(const Neglect& c) {
  const auto pi = numeric::pi<Number>();
  const Exponent angle = Exponent::angle(c.s);
  switch (c.what) {
    case What::limit: return {{"loss", Order{2}}, {"shift", Order{1}}, {"loss over s^2", Number(0.5 - 4 / (pi * pi))}};
    case What::punch: return {{"rear", to_real<Number>(-(half + angle))}, {"front", to_real<Number>(-(half - angle))}};
    case What::jump: return {{"jump", to_real<Number>(angle - Exponent::angle(s_front))}};
    default: break;
  }
  const auto alpha = to_real<Number>(angle);
  const Number ratio = pow(Number((1 + 2 * alpha) / (1 - 2 * alpha)), alpha);
  return {{"peak", Number(cos_pi_alpha<Number>(c.s) * ratio)},
          {"centre", Number(-2 * alpha)},
          {"width", Number(1 / sqrt(Number(1 - 4 * alpha * alpha)))}};
}

}  // namespace

Claim claim() {
  return compared<Neglect>("rem-01-neglect")
      .cases(parabolas)
      .precision(Precision::at_least_fifty)
      .measured([]<Real R>(const Neglect& c, const Context& context) -> Values {
        if (c.what == What::punch || c.what == What::jump) return powers(c, context.quick);
        const Contact<R> zero = contact<R>(0);
        if (c.what == What::limit) return in_the_limit<R>(zero);
        const Contact<R> with = contact<R>(c.s);
        return {{"peak", R(with.peak / zero.peak)},
                {"centre", R(with.centre / with.width)},
                {"width", R(with.width / zero.width)}};
      })
      .predicted(predicted)
      .wrong("the printed 'of': no other power unless the indenter is nonsmooth and friction not constant",
             replaced({{"rear", Number(-0.5)}, {"front", Number(-0.5)}, {"jump", Number(0)}}))
      .wrong("the largest pressure lost at first order", replaced({{"loss", Order{1}}}))
      .wrong("the contact shifted at second order", replaced({{"shift", Order{2}}}))
      .wrong("the contact shifted to the front", scaled({"centre"}, -1))
      .near_misses();
}

}  // namespace steadyslide::proofs_checks::rem_01_neglect
