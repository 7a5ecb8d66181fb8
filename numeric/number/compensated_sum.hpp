#pragma once
// Sums of many terms. In a plain sum of n equal terms the rounding errors of the last digit all have one sign, so that
// the error grows like n. Neumaier's summation keeps what each addition loses. [Neu74]

#include "numeric/number/estimate.hpp"

namespace steadyslide::numeric {

/// A sum whose rounding error does not grow with the number of terms.
template <Real R>
class CompensatedSum {
 public:
  void add(const R& term) {
    const R sum = sum_ + term;
    compensation_ += abs(sum_) >= abs(term) ? (sum_ - sum) + term : (term - sum) + sum_;
    sum_ = sum;
  }
  R value() const { return sum_ + compensation_; }

 private:
  R sum_ = 0;
  R compensation_ = 0;
};

/// The same for values with errors.
template <Real R>
class EstimateSum {
 public:
  EstimateSum() = default;
  explicit EstimateSum(const Estimate<R>& first) { add(first); }
  void add(const Estimate<R>& term) {
    sum_.add(term.value);
    rest_ += {R(0), term.error, term.convergence};
  }
  Estimate<R> value() const { return {sum_.value(), rest_.error, rest_.convergence}; }

 private:
  CompensatedSum<R> sum_;
  Estimate<R> rest_;  ///< the error and the convergence of the sum
};

}  // namespace steadyslide::numeric
