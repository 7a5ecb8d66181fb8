#pragma once
// The stresses below the surface, averaged over a window of length L along x whose middle is x. They are finite at every
// depth z >= 0. The window may reach beyond the contact.
//
// The integrals along x of the stresses under forces (half_plane_stress.hpp) are, with the sums of force_sums.hpp,
//
//   normal:       pi int (xx, zz, xz) dx = (P_0 - P_2, P_0 + P_2, -P_3),          int pi W dx = P_1,
//   tangential:   pi int (xx, zz, xz) dx = (-2 P_1 - P_3, P_3, P_2 - P_0),        int pi W dx = P_0.
//
// The average is the difference of these integrals at x + L/2 and x - L/2, over L. At the surface P_1 has a logarithm. If
// a window ends at a singular point, t ~ d^(q-1), the error on N cells is 1/N^q there.

#include <span>

#include "numeric/interior/body_sums.hpp"
#include "numeric/interior/hookes_law.hpp"
#include "numeric/interior/stress_field.hpp"

namespace steadyslide::numeric {

/// The rule for the largest stress of averages: with more digits its search would take hours.
inline constexpr const char* digits_of_averages = "the largest stress of averages is searched with 16 digits at most";

template <Real R>
class AverageStress : public StressField<R> {
 public:
  /// Throws std::invalid_argument unless length > 0.
  AverageStress(PiecewiseTraction<R> traction, const R& length);

  const PiecewiseTraction<R>& traction() const override { return meshes_.front().traction(); }
  R window() const override { return length_; }
  /// Throws std::invalid_argument unless z >= 0.
  void at(std::span<const R> x, std::span<const R> z, std::span<StressState<R>> states) const override;
  StressState<R> on_finest_mesh(const R& x, const R& z) const override;

 private:
  using Mesh = BodySums<R, PotentialKernel<R>>;
  StressState<R> at(const R& x, const R& z, std::span<const Mesh> meshes, TractionNodes<R>& nodes) const;

  R length_;
  HookesLaw<R> law_;
  std::vector<Mesh> meshes_;  ///< the finest first
};

}  // namespace steadyslide::numeric
