#pragma once

#include "numeric/solution/contact_solution.hpp"

namespace steadyslide::testing {

/// A solution that has only the values set by the test.
struct MadeUp : numeric::ContactSolution<double> {
  std::vector<numeric::ContactComponent<double>> shown_contact;
  numeric::EstimatedError<double> shown_error{};
  numeric::Residuals<double> shown_residuals{};

  std::string method() const override { return "none"; }
  std::vector<numeric::ContactComponent<double>> contact() const override { return shown_contact; }
  std::vector<numeric::SolvedSingularPoint<double>> singular_points() const override { return {}; }
  numeric::Resultants<double> resultants() const override { return {}; }
  numeric::LargestPressure<double> largest_pressure() const override { return {}; }
  numeric::EstimatedError<double> estimated_error() const override { return shown_error; }
  numeric::Residuals<double> residuals() const override { return shown_residuals; }
  numeric::Sample<double> at(const Rational&) const override { return {}; }
  numeric::PiecewiseTraction<double> piecewise_traction() const override {
    return numeric::PiecewiseTraction<double>(Elasticity::reduced(0));
  }
  std::vector<numeric::Sample<double>> samples(int) const override { return {}; }
  numeric::DetailedSample<double> details_at(const Rational&) const override { return {}; }
  std::vector<numeric::DetailedSample<double>> detailed_samples(int) const override { return {}; }
};

}  // namespace steadyslide::testing
