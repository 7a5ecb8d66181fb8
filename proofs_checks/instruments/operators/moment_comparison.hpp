#pragma once
// Solves one problem with constant friction in three ways: problem I on polynomials, problem I0 on cells, and by
// Riemann-Hilbert. The solutions are compared by the moments int t_n T_k, k = 1, ..., 8, of Chebyshev's polynomials, in
// the norm
//
//   |t|^2 = (2/pi) sum_k (int t T_k)^2/k.
//
// This is the norm of H^{-1/2} on a traction of zero mean, because
// -(1/pi) log|x-y| = (1/pi) log 2 + (2/pi) sum_k T_k(x) T_k(y)/k.

#include <map>

#include "proofs_checks/instruments/cells/cells.hpp"
#include "proofs_checks/instruments/operators/displacement_problem.hpp"
#include "proofs_checks/kit/claim.hpp"
#include "proofs_checks/kit/rate.hpp"

namespace steadyslide::proofs_checks {

inline constexpr std::size_t compared_moments = 8;

/// A reduced problem on [-1, 1]; s < 0 means sliding towards -x.
struct DualCase {
  std::string name;
  Rational s;
  Polynomial profile;
  Rational load;
  /// Rate of convergence of problem I0 on cells: 1 with an edge, 2 with free ends only.
  double cells_rate;

  ContactProblem problem(int friction_sign = 1) const;
  std::function<double(double)> height() const;
};

/// Returns the cases: a parabola with two free ends; one with an edge at the rear, sliding towards +x; one with an edge
/// at the front, sliding towards -x; two wells. A quick run has the first two.
std::vector<DualCase> dual_cases(const Context& context);

using Moments = std::vector<double>;
/// Returns the distance of two sets of moments in the norm above, divided by the load.
double distance(const Moments& a, const Moments& b, double load);

/// Return the moments in double. Throw std::runtime_error if the problem is not solved on cells or polynomials, and
/// Refutation if it is not solved by singular functions.
Moments riemann_hilbert_moments(const ContactProblem& problem);
Moments cell_moments(const ContactProblem& problem, std::size_t cells);
Moments displacement_moments(const DualCase& c, int n, const DisplacementFormula& formula = {});

/// The moments of dual_cases(), computed once for a claim and its controls.
class KnownMoments {
 public:
  const Moments& exact(const DualCase& c) {
    return known({0, c.name, 0, 1}, [&] { return riemann_hilbert_moments(c.problem()); });
  }
  const Moments& cells(const DualCase& c, int n, int friction = 1) {
    return known({1, c.name, n, friction},
                 [&] { return cell_moments(c.problem(friction), static_cast<std::size_t>(n)); });
  }
  const Moments& polynomials(const DualCase& c, int n) {
    return known({2, c.name, n, 1}, [&] { return displacement_moments(c, n); });
  }

 private:
  /// The method (one of the three), the case, the size and the sign of the friction.
  using Key = std::tuple<int, std::string, int, int>;
  template <class Make>
  const Moments& known(const Key& key, const Make& make) {
    Moments& moments = moments_[key];
    if (moments.empty()) moments = make();
    return moments;
  }
  std::map<Key, Moments> moments_;
};

/// Returns the root mean square of the distance of moments(n) from reference(n) over `meshes` consecutive sizes n.
/// `first` holds the first size of each level.
template <class Solve, class Reference>
std::vector<Level> levels_of(const std::vector<int>& first, int meshes, double load, const Solve& moments,
                             const Reference& reference) {
  std::vector<Level> levels;
  for (const int size : first) {
    std::vector<double> errors;
    for (int n = size; n < size + meshes; ++n) errors.push_back(distance(moments(n), reference(n), load));
    levels.push_back({size + (meshes - 1) / 2.0, root_mean_square(errors)});
  }
  return levels;
}

}  // namespace steadyslide::proofs_checks
