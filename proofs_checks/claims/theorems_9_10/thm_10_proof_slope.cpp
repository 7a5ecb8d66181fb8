#include "proofs_checks/instruments/tractions/friction_values.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::thm_10_proof_slope {
namespace {

const Rational near(1, 1000);
const Rational far(1, 20);

/// Returns t = y^p on ]0, 1[, p = -(1/2+alpha).
template <Real R>
PiecewiseDensity<R> power_density(const Rational& s) {
  return {{{R(0), R(1), R(1)}, numeric::Power<R>::of(-(half + Exponent::angle(s))), {R(0), R(1)}, [](const auto&) {
             return R(1);
           }}};
}

Number sine(const Rational& s) { return 1 / sqrt(Number(1 + to_real<Number>(s * s))); }

/// Returns d^p/sine minus the power series that comes from ]1, oo[.
Number slope_beyond(const Rational& s, const Rational& distance, const Number& sine) {
  const Number p = -to_real<Number>(half + Exponent::angle(s));
  const auto d = to_real<Number>(distance);
  Number series = 0;
  Number term = 1;
  for (int k = 0; abs(term) > numeric::epsilon<Number>() / 100; ++k, term *= -d) series += term / (k - p);
  return pow(d, p) / sine - series / numeric::pi<Number>();
}

Values values_with(const Rational& s, const Number& sine) {
  return {{"sine", sine},
          {"near", slope_beyond(s, near, sine)},
          {"far", slope_beyond(s, far, sine)},
          {"far by tanh-sinh", slope_beyond(s, far, sine)},
          {"tangent", true}};
}

/// True if s = 2m/(1-m^2) is the tangent of twice the angle of m.
bool tangent_of_twice_the_angle(const Rational& m) {
  const Rational twice = 2 * m / (1 - m * m);
  const Rational root = (1 + m * m) / (1 - m * m);
  return Exponent::angle(m) + Exponent::angle(m) == Exponent::angle(twice) && 1 + twice * twice == root * root;
}

}  // namespace

Claim claim() {
  return compared<FrictionValue>("thm-10-proof-slope")
      .cases([](const Context& context) { return friction_values(context, "thm-10-proof-slope"); })
      .effective_where([](const FrictionValue& c) { return is_coupled(c); })
      .precision(Precision::quick_in_double)
      .measured([]<Real R>(const FrictionValue& c) -> Values {
        using std::sin;
        const PiecewiseDensity<R> power = power_density<R>(c.s);
        const trapezoidal::Grid<R> grid(power);
        const R d = to_real<R>(far);
        return {{"sine", R(sin(R(numeric::pi<R>() * to_real<R>(half + Exponent::angle(c.s)))))},
                {"near", grid.cauchy(Side::left, to_real<R>(near))},
                {"far", grid.cauchy(Side::left, d)},
                {"far by tanh-sinh", tanh_sinh::cauchy<R>(power, Side::left, d).value},
                {"tangent", tangent_of_twice_the_angle(c.s / 5)}};
      })
      .predicted([](const FrictionValue& c) { return values_with(c.s, sine(c.s)); })
      .wrong("without the sine",
             [](Values& p, const FrictionValue& c) {
               const Number right = p["sine"];
               p = values_with(c.s, 1);
               p["sine"] = right;
             })
      .wrong("the sine of `pi alpha`",
             [](Values& p, const FrictionValue& c) {
               if (is_coupled(c)) p = values_with(c.s, to_real<Number>(c.s) * sine(c.s));
             })
      .near_misses();
}

}  // namespace steadyslide::proofs_checks::thm_10_proof_slope
