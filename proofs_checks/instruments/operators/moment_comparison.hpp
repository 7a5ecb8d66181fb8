#pragma once
// One problem with constant friction, three times: problem I on polynomials, problem I0 on cells, and by
// Riemann-Hilbert. They are compared by the moments int t_n T_k, k = 1, ..., 8, of Chebyshev's polynomials, in the norm
//
//   |t|^2 = (2/pi) sum_k (int t T_k)^2/k,
//
// that of H^{-1/2} on a traction of zero mean, from -(1/pi) log|x-y| = (1/pi) log 2 + (2/pi) sum_k T_k(x) T_k(y)/k.

#include <map>

#include "proofs_checks/instruments/cells/cells.hpp"
#include "proofs_checks/instruments/operators/displacement_problem.hpp"
#include "proofs_checks/kit/claim.hpp"
#include "proofs_checks/kit/rate.hpp"

namespace steadyslide::proofs_checks {

inline constexpr std::size_t compared_moments = 8;

/// Reduced, on [-1, 1]; s < 0: sliding towards -x.
struct DualCase {
  std::string name;
  Rational s;
  Polynomial profile;
  Rational load;
  double cells_rate;  ///< with which problem I0 on cells converges: 1 with an edge, 2 with free ends alone

  ContactProblem problem(int friction_sign = 1) const;
  std::function<double(double)> height() const;
};

/// A parabola with two free ends; one with an edge at the rear and one at the front, either direction; two wells. In a
/// quick run the first two.
std::vector<DualCase> dual_cases(const Context& context);

using Moments = std::vector<double>;
/// The norm above of a difference, over the load.
double distance(const Moments& a, const Moments& b, double load);

/// In double. Throws std::runtime_error where a problem is not solved on cells or polynomials, Refutation where not by
/// its singular functions.
Moments riemann_hilbert_moments(const ContactProblem& problem);
Moments cell_moments(const ContactProblem& problem, std::size_t cells);
Moments displacement_moments(const DualCase& c, int n, const DisplacementFormula& formula = {});

/// Moments of dual_cases(), found once for a claim and its controls.
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
  /// Which of the three, the case, the size and the friction's sign.
  using Key = std::tuple<int, std::string, int, int>;
  template <class Make>
  const Moments& known(const Key& key, const Make& make) {
    Moments& moments = moments_[key];
    if (moments.empty()) moments = make();
    return moments;
  }
  std::map<Key, Moments> moments_;
};

/// Root mean squares of the distance of moments(n) to reference(n) over `meshes` neighbouring sizes n, `first` being a
/// level's first one.
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
