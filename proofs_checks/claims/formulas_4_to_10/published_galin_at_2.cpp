#include "numeric/quadrature/gsl_quadrature.hpp"
#include "proofs_checks/instruments/tractions/power_product.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::published_galin_at_2 {
namespace {

struct Published {};

std::string text_of(const Published&) { return "gamma f = 1, x = 2"; }

/// The integral int weight(x)/(x-2) dx over ]-1, 1[ and its value.
struct CauchyIntegral : PowerProduct {
  Number value;
};

template <Real R>
void check_integral(Findings& findings, const CauchyIntegral& integral, const Published&) {
  const R value(integral.value);
  const R pi = numeric::pi<R>();
  const PiecewiseDensity<R> density = integral.at<R>().traction().density();
  findings.compare<R>("trapezoidal", pi * trapezoidal::Grid<R>(density).cauchy(Side::right, R(1)), value);
  findings.compare<R>("tanh sinh", pi * tanh_sinh::cauchy<R>(density, Side::right, R(1)).value, value);

  PiecewiseDensity<double> with_kernel = integral.at<double>().traction().density();
  with_kernel[0].smooth = [](const Node<double>& node) { return 1 / (node.x - 2); };
  const auto by_gsl = numeric::gsl::integral(with_kernel);
  if (by_gsl.convergence == numeric::Convergence::reached) {
    findings.compare<double>("gsl", by_gsl.value, static_cast<double>(value));
  } else {
    findings.skip("gsl");
  }
  findings.decide(
      "`arctan(1)/pi = 1/4`: the powers at the edges are -3/4 and -1/4",
      Exponent::angle(1) == Exponent(Rational(1, 4)) &&
          integral.exponents == std::vector<Exponent>{-(half + Exponent::angle(1)), -(half - Exponent::angle(1))});
}

}  // namespace

Claim claim() {
  return formula_claim<Published, CauchyIntegral>("published-galin-at-2")
      .cases(fixed_cases<Published>({Published()}, 1, "the one published case"))
      .says([](const Published&) {
        return CauchyIntegral{
            PowerProduct::on({-1, 1}, {Exponent(Rational(-3, 4)), Exponent(Rational(-1, 4))}, {Number(1)}),
            -numeric::pi<Number>() * sqrt(Number(2)) / pow(Number(3), Number(3) / 4)};
      })
      .checked([]<Real R>(auto&... of) { check_integral<R>(of...); })
      .wrong("the edges exchanged: `((1-x)^3 (1+x))^{1/4}`",
             [](CauchyIntegral& i) { std::ranges::reverse(i.exponents); })
      .wrong("the value with the other sign", [](CauchyIntegral& i) { i.value *= -1; })
      .wrong("3^{1/4} for 3^{3/4}", [](CauchyIntegral& i) { i.value *= sqrt(Number(3)); })
      .wrong("wrong in the fifth digit, as a default quadrature has it",
             [](CauchyIntegral& i) { i.value += i.value / 100'000; })
      .near_miss("the value", &CauchyIntegral::value)
      .near_miss("the rear power", [](CauchyIntegral& i, const Number& step) { i.move_power(0, step); });
}

}  // namespace steadyslide::proofs_checks::published_galin_at_2
