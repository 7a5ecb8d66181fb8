#include "numeric/variational/touching_state.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace steadyslide::numeric::variational {
namespace {

/// Places in a cell, as fractions of its length. They are denser near its ends, where the slope has logarithms.
constexpr std::array places{0.0, 0.01, 0.04, 0.09, 0.16, 0.25, 0.37, 0.5, 0.63, 0.75, 0.84, 0.91, 0.96, 0.99, 1.0};

/// The error bound is the root of the duality gap.
constexpr double near_enough = 1.1;
constexpr int most_passes = 16;

/// Gaps within cells of a uniform mesh.
class InnerGaps {
 public:
  InnerGaps(const ContactProblem& problem, const DiscreteProblem& discrete);

  struct Least {
    std::vector<double> below_mean;  ///< delta_i
    double duality_gap;              ///< int p (gap - its minimum over all places), in units of c P^2
    double within_cells;             ///< int p delta: the rest of it if all minima were 0
  };
  Least least(const DiscreteState& state) const;

 private:
  /// Computes the displacement due to the logarithm only, at the place z of all cells.
  void displacement(std::size_t place, const std::vector<double>& p, std::vector<double>& result) const;
  /// Returns int s from the left end of cell i, over a part of it.
  double friction(std::size_t i, double part) const;

  const DiscreteProblem& discrete_;
  CellProfile profile_;
  std::vector<double> jumps_;  ///< jumps of s
  std::vector<double> s_;
  std::vector<double> breaks_;  ///< breaks of the profile
  Fourier fourier_;
  std::vector<std::vector<std::complex<double>>> spectra_;
};

InnerGaps::InnerGaps(const ContactProblem& problem, const DiscreteProblem& discrete)
    : discrete_(discrete),
      profile_(problem, discrete.mesh().frame()),
      breaks_(profile_.breaks()),
      fourier_(fast_length(2 * discrete.size())) {
  const CellMesh& mesh = discrete.mesh();
  for (const Rational& c : problem.friction().jumps()) jumps_.push_back(mesh.place(c));
  for (std::size_t k = 0; k <= jumps_.size(); ++k) s_.push_back(to_real<double>(problem.coupled_friction(k)));
  const auto n = static_cast<std::ptrdiff_t>(mesh.size());
  const double h = mesh.length(0);
  const SurfaceKernel& kernel = discrete.galerkin_operator().kernel();
  for (const double z : places) {
    const std::span<double> values = fourier_.values();
    std::fill(values.begin(), values.end(), 0);
    for (std::ptrdiff_t k = 1 - n; k < n; ++k) {
      const auto size = static_cast<std::ptrdiff_t>(values.size());
      values[static_cast<std::size_t>((k + size) % size)] = kernel.from_equal_cell(h, static_cast<double>(k) + z - 0.5);
    }
    fourier_.forward();
    spectra_.emplace_back(fourier_.modes().begin(), fourier_.modes().end());
  }
}

void InnerGaps::displacement(std::size_t place, const std::vector<double>& p, std::vector<double>& result) const {
  const std::span<double> values = fourier_.values();
  std::copy(p.begin(), p.end(), values.begin());
  std::fill(values.begin() + static_cast<std::ptrdiff_t>(p.size()), values.end(), 0);
  fourier_.forward();
  fourier_.convolve(spectra_[place], std::span(result).first(p.size()));
}

double InnerGaps::friction(std::size_t i, double part) const {
  double left = discrete_.mesh().left(i);
  const double right = left + part * discrete_.mesh().length(i);
  auto jump = std::upper_bound(jumps_.begin(), jumps_.end(), left);
  double sum = 0;
  for (; jump != jumps_.end() && *jump < right; ++jump) {
    sum += s_[static_cast<std::size_t>(jump - jumps_.begin())] * (*jump - left);
    left = *jump;
  }
  return sum + s_[static_cast<std::size_t>(jump - jumps_.begin())] * (right - left);
}

InnerGaps::Least InnerGaps::least(const DiscreteState& state) const {
  const CellMesh& mesh = discrete_.mesh();
  const std::vector<double>& p = state.pressure;
  const CellFriction& s = discrete_.galerkin_operator().friction();
  const std::size_t n = mesh.size();
  // The friction term at the cells' left ends, with the convention of the operator.
  std::vector<double> before(n + 1);
  for (std::size_t i = 0; i < n; ++i) before[i + 1] = before[i] + s.whole[i] * p[i];
  const double from_right = s.sign < 0 ? before[n] : 0;

  std::vector<double> lowest(n, std::numeric_limits<double>::infinity());
  std::vector<double> sample(n), last(n);
  for (std::size_t k = 0; k < places.size(); ++k) {
    displacement(k, p, sample);
    for (std::size_t i = 0; i < n; ++i) {
      const double xi = mesh.left(i) + places[k] * mesh.length(i);
      sample[i] += before[i] - from_right + p[i] * friction(i, places[k]) - state.approach;
      const double height = k == 0 ? profile_(xi, Side::right) : profile_(xi, Side::left);
      lowest[i] = std::min(lowest[i], sample[i] + height + state.tilt * xi);
    }
    // The gap may have its minimum at a wedge or a step. There displacements are interpolated linearly between two
    // places.
    for (const double xi : k == 0 ? std::vector<double>() : breaks_) {
      const std::size_t i = mesh.cell_at(xi);
      const double z = (xi - mesh.left(i)) / mesh.length(i);
      if (z < places[k - 1] || z > places[k]) continue;
      const double along = (z - places[k - 1]) / (places[k] - places[k - 1]);
      const double height = std::min(profile_(xi, Side::left), profile_(xi, Side::right));
      lowest[i] = std::min(lowest[i], last[i] + along * (sample[i] - last[i]) + height + state.tilt * xi);
    }
    std::swap(sample, last);
  }

  const std::vector<double> means = gaps(discrete_, state);
  Least result{std::vector<double>(n), 0, 0};
  double mean = 0;
  for (std::size_t i = 0; i < n; ++i) {
    result.below_mean[i] = std::max(means[i] - lowest[i], 0.0);
    mean += p[i] * mesh.length(i) * means[i];
    result.within_cells += p[i] * mesh.length(i) * result.below_mean[i];
  }
  result.duality_gap = mean - *std::min_element(lowest.begin(), lowest.end());
  return result;
}

}  // namespace

DiscreteState touching_state(const ContactProblem& problem, const MeshSolution& found) {
  std::shared_ptr<const DiscreteProblem> galerkin = found.problem;
  if (!galerkin->is_galerkin()) {
    galerkin = std::make_shared<const DiscreteProblem>(problem, galerkin->mesh(), FrictionRule::galerkin,
                                                       galerkin->galerkin_operator().kernel());
  }
  const InnerGaps inner(problem, *galerkin);
  InnerGaps::Least least = inner.least(found.found.state);
  double best_gap = least.duality_gap;
  DiscreteState best = found.found.state;
  CellSet contact = found.found.contact;
  DiscreteState state = found.found.state;
  for (int pass = 0; pass < most_passes && best_gap > near_enough * least.within_cells; ++pass) {
    const MeshSolution next =
        solve_on_cells(std::make_shared<DiscreteProblem>(*galerkin, least.below_mean), contact, state, {});
    if (next.found.outcome != ActiveSetResult::Outcome::solved) break;
    contact = next.found.contact;
    state = next.found.state;
    least = inner.least(state);
    if (least.duality_gap < best_gap) {
      best_gap = least.duality_gap;
      best = state;
    }
  }
  return best;
}

}  // namespace steadyslide::numeric::variational
