#include "numeric/bodies/approach.hpp"

#include "numeric/bodies/correction_sum.hpp"
#include "numeric/layers/body_symbols.hpp"
#include "numeric/solution/mesh_error.hpp"

namespace steadyslide::numeric {

std::optional<Estimate<double>> approach(const ContactProblem& problem, const ContactSolution<double>& solution) {
  const Body& body = problem.body();
  if (body.is_half_plane() || body.period() || solution.contact().empty()) return std::nullopt;
  if (!BodySymbols<double>(problem).has_absolute_displacement()) return std::nullopt;
  // At a place far from the contact the integral of log|x - x'| has no singularity.
  const Indenter& indenter = problem.indenter();
  const Rational support = indenter.right() - indenter.left(), far = indenter.right() + support;
  const std::shared_ptr<const SurfaceCorrection<double>> correction =
      surface_correction<double>(problem, to_real<double>(2 * support));
  const auto x = to_real<double>(far), gamma = to_real<double>(problem.elasticity().gamma());
  const PiecewiseTraction<double> traction = solution.piecewise_traction();
  std::vector<const PiecewiseTraction<double>*> meshes{&traction};
  for (const PiecewiseTraction<double>& coarser : traction.coarser()) meshes.push_back(&coarser);
  const auto on_mesh = [&](const PiecewiseTraction<double>* mesh) {
    return std::array{CorrectionSum(correction, *mesh).absolute_on_the_right(x, gamma)};
  };
  const auto [absolute] =
      on_nested_meshes(std::span<const PiecewiseTraction<double>* const>(meshes), on_mesh, traction.mesh_rates().rate);
  const Rational& origin = problem.origin_of_displacement();
  Estimate<double> height{to_real<double>(indenter.profile(origin, Side::left)(origin))};
  if (const auto tilt = solution.tilt()) height += to_real<double>(origin) * *tilt;
  return height - solution.at(origin).gap.value_or(Estimate<double>{}) + solution.details_at(far).displacement -
         to_real<double>(problem.elasticity().compliance()) * absolute;
}

}  // namespace steadyslide::numeric
