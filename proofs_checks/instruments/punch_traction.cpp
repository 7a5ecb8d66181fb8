#include "proofs_checks/instruments/punch_traction.hpp"

#include <numeric>

namespace steadyslide::proofs_checks {

PowerProduct punch_traction(const ContactProblem& problem) {
  const std::vector<Rational>& jumps = problem.friction().jumps();
  std::vector<Rational> points{problem.indenter().left()};
  std::vector<Exponent> exponents{-(half + alpha(problem, 0))};
  std::vector<Number> amplitudes{punch_amplitude<Number>(problem, 0)};
  for (std::size_t k = 0; k < jumps.size(); ++k) {
    points.push_back(jumps[k]);
    exponents.push_back(alpha(problem, k) - alpha(problem, k + 1));
    amplitudes.push_back(punch_amplitude<Number>(problem, k + 1));
  }
  points.push_back(problem.indenter().right());
  exponents.push_back(-(half - alpha(problem, jumps.size())));
  return PowerProduct::on(points, std::move(exponents), std::move(amplitudes));
}

template <Real R>
void check_punch_traction(Findings& findings, const PowerProduct& t, const ContactProblem& problem,
                          std::size_t tanh_sinh_points) {
  const auto no_slope = [](const auto& x) { return std::remove_cvref_t<decltype(x)>(0); };
  check_surface(findings, surface_of<R>(t.at<R>(), problem, 0, no_slope), tanh_sinh_points);
  check_surface_by_gsl(findings, surface_of<double>(t.at<double>(), problem, 0, no_slope));
  check_punch_values(findings, t.at<R>(), problem);
  const Exponent sum = std::accumulate(t.exponents.begin(), t.exponents.end(), Exponent());
  findings.decide("the exponents sum to -1", sum == Exponent(-1));
}

template void check_punch_traction<double>(Findings&, const PowerProduct&, const ContactProblem&, std::size_t);
template void check_punch_traction<Real50>(Findings&, const PowerProduct&, const ContactProblem&, std::size_t);
template void check_punch_traction<Real100>(Findings&, const PowerProduct&, const ContactProblem&, std::size_t);

}  // namespace steadyslide::proofs_checks
