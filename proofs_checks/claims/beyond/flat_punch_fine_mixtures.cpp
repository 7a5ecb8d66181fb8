#include "numeric/flat_punch/flat_punch.hpp"

#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::flat_punch_fine_mixtures {
namespace {

struct Period {
  std::string name;
  std::vector<Rational> shares;
  std::vector<Rational> s;  ///< values of s from left to right
};

double s_eff(const Period& period, int count) {
  const auto layout = numeric::FrictionLayout<double>::periodic(period.shares, period.s, count);
  return numeric::EffectiveFriction<double>(layout).value().value;
}

/// Returns the values for 256, 512, ..., 4096 periods. The order comes from differences, which have the same powers as
/// the error, so that the limit is not needed for it.
Values measured(const Period& period) {
  std::vector<double> values;
  for (int count = 256; count <= 4096; count *= 2) values.push_back(s_eff(period, count));
  std::vector<double> d;
  for (std::size_t k = 0; k + 1 < values.size(); ++k) d.push_back(values[k + 1] - values[k]);
  const double order = numeric::order_of_periods(d[1], d[2], d[3]);
  // The terms C N^-p, D N^-(1-p) and E/N are eliminated in turn.
  for (const double power : {order, 1 - order, 1.0}) {
    const double factor = std::exp2(power);
    for (std::size_t k = 0; k + 1 < values.size(); ++k) values[k] = (factor * values[k + 1] - values[k]) / (factor - 1);
    values.pop_back();
  }
  return {{"limit", values.back()}, {"order", order}, {"it comes from above", s_eff(period, 256) > values.back()}};
}

Values predicted(const Period& period) {
  const auto fine = numeric::fine_mixture<Number>(period.shares, period.s);
  return {
      {"limit", fine.s_eff.value}, {"order", fine.order}, {"it comes from above", period.s.front() > period.s.back()}};
}

Number mean(const Period& period) {
  Rational sum = 0;
  for (std::size_t k = 0; k < period.s.size(); ++k) sum += period.shares[k] * period.s[k];
  return to_real<Number>(sum);
}

}  // namespace

Claim claim() {
  const std::vector<Rational> halves{Rational(1, 2), Rational(1, 2)};
  return compared<Period>("flat-punch-fine-mixtures")
      .cases(fixed_cases<Period>({{"s = 0, 2, half and half", halves, {0, 2}},
                                  {"s = 2, 0, half and half", halves, {2, 0}},
                                  {"s = 0.1, 0.5, half and half", halves, {Rational(1, 10), Rational(1, 2)}},
                                  {"s = 1, 0, three quarters smooth", {Rational(1, 4), Rational(3, 4)}, {1, 0}},
                                  {"s = 0, 1, 3", {Rational(1, 2), Rational(1, 4), Rational(1, 4)}, {0, 1, 3}}},
                                 3, "periods"))
      .precision(Precision::in_double)
      .measured(measured)
      .predicted(predicted)
      .wrong("the mean of `s`", [](Values& p, const Period& c) { p["limit"] = mean(c); })
      .wrong("the order 1/2, as without friction", replaced({{"order", Number(0.5)}}))
      .wrong("the order `1/2 + <alpha>`, of the front edge", [](Values& p) { p["order"] = 1 - p["order"]; })
      .wrong("the order 1", replaced({{"order", Number(1)}}))
      .wrong("always from above", replaced({{"it comes from above", true}}))
      .near_misses();
}

}  // namespace steadyslide::proofs_checks::flat_punch_fine_mixtures
