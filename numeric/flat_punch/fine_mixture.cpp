#include "numeric/flat_punch/fine_mixture.hpp"

namespace steadyslide::numeric {

template <Real R>
FineMixture<R> fine_mixture(const std::vector<Rational>& shares, const std::vector<Rational>& s) {
  using std::abs, std::min, std::tan;
  R mean = 0;
  R below_half = 0;  // 1/2 - <alpha> and 1/2 + <alpha>, which large friction would cancel
  R above_half = 0;
  for (std::size_t k = 0; k < s.size(); ++k) {
    const Exponent angle = Exponent::angle(s[k]);
    const R share = to_real<R>(shares[k]);
    mean += share * to_real<R>(angle);
    below_half += share * to_real<R>(half - angle);
    above_half += share * to_real<R>(half + angle);
  }
  const R order = min(below_half, above_half);
  const R size = order < R(0.25) ? R(1 / tan(pi<R>() * order)) : R(tan(pi<R>() * abs(mean)));
  return {Estimate<R>{mean < 0 ? R(-size) : size, R(0)}.widened(16 * epsilon<R>()), order};
}

template <Real R>
R order_of_periods(const R& e, const R& doubled, const R& doubled_twice) {
  using std::log, std::sqrt;
  const R half_sum = (doubled_twice + e / 2) / doubled / 2;
  return -log(half_sum + sqrt(half_sum * half_sum - R(0.5))) / log(R(2));
}

template FineMixture<double> fine_mixture(const std::vector<Rational>&, const std::vector<Rational>&);
template FineMixture<Real50> fine_mixture(const std::vector<Rational>&, const std::vector<Rational>&);
template FineMixture<Real100> fine_mixture(const std::vector<Rational>&, const std::vector<Rational>&);
template double order_of_periods(const double&, const double&, const double&);
template Real50 order_of_periods(const Real50&, const Real50&, const Real50&);
template Real100 order_of_periods(const Real100&, const Real100&, const Real100&);

}  // namespace steadyslide::numeric
