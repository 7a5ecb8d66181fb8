#pragma once
// The stresses in a layered body under a traction on its surface. With the forces' transforms
//
//   P(k) = -int t e^(-ikx) dx,   Q(k) = i int t_t e^(-ikx) dx
//
// and the transfer functions of layer_stress.hpp, of a pressure (p) and of a shear traction (q),
//
//   sigma(x, z) = (1/pi) int_0^oo Re [(sigma_p(k, z) P + sigma_q(k, z) Q) e^(ikx)] dk   for sigma_xx and sigma_zz,
//   the same with Im for sigma_xz and the rotation W.
//
// In the first layer those of the half-plane of its solid are subtracted, so that the integrand decreases like
// exp(-k (2h - z)) down to the surface. What is left is smooth. The half-plane's own stresses, which are singular at
// singular points, are computed elsewhere (numeric/interior/interior_stress.hpp). Below the first layer the integrand
// decreases like exp(-kz), and nothing is subtracted.
//
// The integral is a sum of Gauss rules. Panels in k grow by 4 from 1e-12 of the last wave number, because transfer
// functions of stiff and soft layers change on any scale of k, and are not longer than the waves e^(ik(x-x')) allow.

#include <array>
#include <complex>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "numeric/layers/layer_stress.hpp"
#include "numeric/layers/surface_forces.hpp"
#include "numeric/number/estimate.hpp"

namespace steadyslide::numeric {

class LayerField {
 public:
  /// sigma_xx, sigma_zz, sigma_xz and W = (d u_z/dx - d u_x/dz)/(2 c).
  using Stress = std::array<Estimate<double>, 4>;

  /// Returns the length of parts that is short enough for the forces.
  static double longest_part(const Body& body) { return to_real<double>(body.layers().front().thickness) / 2; }
  /// The body of the problem has layers. There is at least one traction; several are those of nested meshes.
  LayerField(const ContactProblem& problem, std::vector<SurfaceForces> tractions);

  /// Returns the depths of the layers' lower sides.
  const std::vector<double>& interfaces() const { return interfaces_; }
  /// Returns the number of the layer at a depth, in which an interface belongs to the layer above it. Below all layers
  /// it is the number of layers.
  std::size_t layer_at(double z) const;
  /// Returns the stresses of a traction at a depth z >= 0, in the first layer without those of the half-plane. They are not
  /// known (NaN) in a rigid base, and 2000 thicknesses of the first layer away from the contact.
  Stress at(std::size_t traction, double x, double z) const;

 private:
  struct Wave {
    double k;
    double weight;  ///< of the integral over k, over pi
    LayerStress<double> transfer;
    std::vector<std::array<std::complex<double>, 2>> loads;  ///< P and Q of each traction
  };
  using Waves = std::vector<Wave>;
  /// The integrand at one depth.
  struct Depth {
    std::shared_ptr<const Waves> waves;
    double z;
    struct Traction {
      std::vector<std::array<std::complex<double>, 4>> amplitudes;
      std::array<double, 4> size{};    ///< sums of absolute values
      std::array<double, 4> size_k{};  ///< times k
    };
    std::vector<Traction> tractions;
    std::array<double, 4> of_pressure{}, of_shear{};  ///< sums of the absolute values of the transfer functions
  };
  std::array<std::complex<double>, 2> loads_at(double k, const SurfaceForces& forces) const;
  std::shared_ptr<const Waves> waves_for(double reach) const;
  std::shared_ptr<const Depth> depth_at(double z, double reach) const;

  BodySymbols<double> symbols_;
  std::vector<double> interfaces_;
  std::vector<SurfaceForces> tractions_;
  double centre_;
  mutable std::mutex making_;
  mutable std::map<double, std::shared_ptr<const Waves>> waves_;  ///< by reach
  mutable std::shared_ptr<const Depth> last_;
};

}  // namespace steadyslide::numeric
