#include "numeric/variational/discrete_problem.hpp"

#include <algorithm>

namespace steadyslide::numeric::variational {

SurfaceKernel surface_kernel(const ContactProblem& problem, const Frame& frame) {
  if (problem.body().is_half_plane()) return {};
  const Indenter& indenter = problem.indenter();
  const std::vector<Rational>& f = problem.friction().values();
  return SurfaceKernel(
      // Cells look a little beyond the support.
      surface_correction<double>(problem, 1.5 * to_real<double>(Rational(indenter.right() - indenter.left()))),
      to_real<double>(frame.unit), to_real<double>(*std::max_element(f.begin(), f.end())));
}

DiscreteProblem::DiscreteProblem(const ContactProblem& problem, const CellMesh& mesh, FrictionRule rule,
                                 const SurfaceKernel& kernel, double shift)
    : DiscreteProblem(problem, mesh, CellProfile(problem, mesh.frame()), rule, kernel, shift) {}

DiscreteProblem::DiscreteProblem(const ContactProblem& problem, CellMesh mesh, const CellProfile& profile,
                                 FrictionRule rule, const SurfaceKernel& kernel, double shift)
    : mesh_(std::move(mesh)),
      galerkin_operator_(mesh_, cell_friction(problem, mesh_, rule, shift), kernel),
      profile_(profile.means(mesh_)) {
  if (!is_galerkin()) {
    const CellFriction& friction = galerkin_operator_.friction();
    // If two pieces meet there, take the piece inside the cell.
    const Side side = friction.sign > 0 ? Side::left : Side::right;
    for (std::size_t i = 0; i < size(); ++i) {
      if (friction.at_end[i]) profile_[i] = profile(place(i), side);
    }
  }
  if (problem.load_at()) load_at_ = mesh_.place(*problem.load_at());
}

DiscreteProblem::DiscreteProblem(const DiscreteProblem& other, const std::vector<double>& lowered,
                                 const std::vector<double>& diagonal)
    : mesh_(other.mesh_),
      galerkin_operator_(mesh_.is_uniform() ? other.galerkin_operator_.part(0, other.size())
                                            : GalerkinOperator(mesh_, other.galerkin_operator_.friction(),
                                                               other.galerkin_operator_.kernel())),
      profile_(other.profile_),
      load_at_(other.load_at_) {
  for (std::size_t i = 0; i < profile_.size(); ++i) profile_[i] -= lowered[i];
  if (!diagonal.empty()) galerkin_operator_.add_diagonal(diagonal);
}

double DiscreteProblem::place(std::size_t i) const {
  const CellFriction& friction = galerkin_operator_.friction();
  if (!friction.is_at_end(i)) return mesh_.centre(i);
  return friction.sign > 0 ? mesh_.right(i) : mesh_.left(i);
}

std::vector<std::size_t> cells_of(const CellSet& contact) {
  std::vector<std::size_t> cells;
  for (std::size_t i = 0; i < contact.size(); ++i) {
    if (contact[i]) cells.push_back(i);
  }
  return cells;
}

double height_over(const DiscreteProblem& problem, const std::vector<std::size_t>& cells) {
  const auto psi = [&](std::size_t cell) { return problem.profile()[cell]; };
  if (cells.empty()) return 1;
  const auto lower = [&](const auto& a, const auto& b) { return psi(a) < psi(b); };
  const auto [low, high] = std::minmax_element(cells.begin(), cells.end(), lower);
  return std::max(1.0, psi(*high) - psi(*low));
}

std::vector<double> gaps(const DiscreteProblem& problem, const DiscreteState& state) {
  std::vector<double> g(problem.size());
  problem.galerkin_operator().multiply(state.pressure, g);
  for (std::size_t i = 0; i < g.size(); ++i) {
    g[i] += problem.profile()[i] + state.tilt * problem.place(i) - state.approach;
  }
  return g;
}

}  // namespace steadyslide::numeric::variational
