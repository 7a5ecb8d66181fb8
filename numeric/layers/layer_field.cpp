#include "numeric/layers/layer_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "numeric/quadrature/jacobi_rule.hpp"

namespace steadyslide::numeric {
namespace {

constexpr double last_exponent = 48;  ///< integrands with exp(-48) are 0
constexpr double most_phase = 12;     ///< half the phase of a panel: 24 nodes are exact up to 16
constexpr int panel_nodes = 24;
constexpr double farthest = 2000;  ///< thicknesses of the first layer

std::array<double, 4> components(const WaveStress<double>& stress) {
  return {stress.xx, stress.zz, stress.xz, stress.rotation};
}

}  // namespace

LayerField::LayerField(const ContactProblem& problem, std::vector<SurfaceForces> tractions)
    : symbols_(problem),
      tractions_(std::move(tractions)),
      centre_(tractions_.front().first + tractions_.front().width() / 2) {
  Rational depth = 0;
  for (const Layer& layer : problem.body().layers()) {
    depth += layer.thickness;
    interfaces_.push_back(to_real<double>(depth));
  }
}

std::size_t LayerField::layer_at(double z) const {
  return static_cast<std::size_t>(std::lower_bound(interfaces_.begin(), interfaces_.end(), z) - interfaces_.begin());
}

std::array<std::complex<double>, 2> LayerField::loads_at(double k, const SurfaceForces& forces) const {
  constexpr std::size_t order = SurfaceForces::order;
  std::array<std::complex<double>, order> waves;
  for (std::size_t j = 0; j < order; ++j) waves[j] = std::polar(1.0, -k * forces.from_middle(j));
  std::complex<double> pressure = 0, shear = 0;
  for (std::size_t part = 0; part < forces.parts(); ++part) {
    const double *normal = &forces.normal[part * order], *tangential = &forces.tangential[part * order];
    std::complex<double> of_normal = 0, of_tangential = 0;
    for (std::size_t j = 0; j < order; ++j) {
      of_normal += normal[j] * waves[j];
      of_tangential += tangential[j] * waves[j];
    }
    const std::complex<double> wave = std::polar(1.0, -k * (forces.middle(part) - centre_));
    pressure -= of_normal * wave;
    shear += of_tangential * wave;
  }
  return {pressure, std::complex<double>(0, 1) * shear};
}

std::shared_ptr<const LayerField::Waves> LayerField::waves_for(double reach) const {
  double rounded = 2 * tractions_.front().width() + 8 * interfaces_.front();
  while (rounded < reach) rounded *= 2;
  std::shared_ptr<const Waves>& found = waves_[rounded];
  if (found) return found;
  static const UnitRule<double> rule = jacobi_rule<double>({}, {}, panel_nodes);
  Waves waves;
  const auto add = [&](double left, double right) {
    const double parts = std::ceil((right - left) * rounded / (2 * most_phase));
    const double length = (right - left) / parts;
    for (double part = 0; part < parts; ++part) {
      for (std::size_t i = 0; i < rule.size(); ++i) {
        const double k = left + length * (part + rule.from_left[i]);
        Wave wave{k, length * rule.weights[i] / std::numbers::pi, {symbols_, k}, {}};
        for (const SurfaceForces& traction : tractions_) wave.loads.push_back(loads_at(k, traction));
        waves.push_back(std::move(wave));
      }
    }
  };
  double left = last_exponent / interfaces_.front() * 0x1p-40;
  add(0, left);
  for (int panel = 0; panel < 20; ++panel, left *= 4) add(left, 4 * left);
  found = std::make_shared<const Waves>(std::move(waves));
  return found;
}

std::shared_ptr<const LayerField::Depth> LayerField::depth_at(double z, double reach) const {
  const std::lock_guard lock(making_);
  auto waves = waves_for(reach);
  if (last_ && last_->z == z && last_->waves == waves) return last_;
  auto result = std::make_shared<Depth>();
  result->waves = waves;
  result->z = z;
  result->tractions.resize(tractions_.size());
  const std::size_t layer = layer_at(z);
  const double decay = layer == 0 ? 2 * interfaces_.front() - z : z,
               below = z - (layer == 0 ? 0 : interfaces_[layer - 1]);
  for (const Wave& wave : *waves) {
    if (wave.k * decay > last_exponent) break;
    const WaveStresses<double> stresses = layer == 0 ? wave.transfer.defects_at(z) : wave.transfer.at(layer, below);
    const auto of_pressure = components(stresses.of_pressure), of_shear = components(stresses.of_shear);
    // Those of the half-plane, at most 2, cancel here.
    const double cancelled = layer == 0 && wave.k * interfaces_.front() <= 1 ? 2 : 0;
    for (std::size_t j = 0; j < 4; ++j) {
      result->of_pressure[j] += wave.weight * std::abs(of_pressure[j]);
      result->of_shear[j] += wave.weight * std::abs(of_shear[j]);
    }
    for (std::size_t n = 0; n < tractions_.size(); ++n) {
      Depth::Traction& traction = result->tractions[n];
      const auto& [p, q] = wave.loads[n];
      auto& amplitudes = traction.amplitudes.emplace_back();
      for (std::size_t j = 0; j < 4; ++j) {
        amplitudes[j] = wave.weight * (of_pressure[j] * p + of_shear[j] * q);
        const double size = wave.weight * ((std::abs(of_pressure[j]) + cancelled) * std::abs(p) +
                                           (std::abs(of_shear[j]) + cancelled) * std::abs(q));
        traction.size[j] += size;
        traction.size_k[j] += wave.k * size;
      }
    }
  }
  last_ = result;
  return result;
}

LayerField::Stress LayerField::at(std::size_t traction, double x, double z) const {
  const double aside = x - centre_, reach = std::abs(aside) + tractions_.front().width() / 2;
  const bool is_known = reach <= tractions_.front().width() + farthest * interfaces_.front() &&
                        (symbols_.base_gamma() || z <= interfaces_.back());
  if (!is_known) {
    const Estimate<double> unknown{std::numeric_limits<double>::quiet_NaN(), infinity<double>()};
    return {unknown, unknown, unknown, unknown};
  }
  const std::shared_ptr<const Depth> depth = depth_at(z, reach);
  const Depth::Traction& of = depth->tractions[traction];
  std::array<double, 4> sum{};
  for (std::size_t i = 0; i < of.amplitudes.size(); ++i) {
    const double angle = (*depth->waves)[i].k * aside, c = std::cos(angle), s = std::sin(angle);
    const auto& [xx, zz, xz, rotation] = of.amplitudes[i];
    sum[0] += xx.real() * c - xx.imag() * s;
    sum[1] += zz.real() * c - zz.imag() * s;
    sum[2] += xz.real() * s + xz.imag() * c;
    sum[3] += rotation.real() * s + rotation.imag() * c;
  }
  Stress result;
  const SurfaceForces& forces = tractions_[traction];
  for (std::size_t j = 0; j < 4; ++j) {
    const double rounding = epsilon<double>() * (256 * of.size[j] + reach * of.size_k[j]);
    result[j] = {sum[j],
                 rounding + depth->of_pressure[j] * forces.normal_error + depth->of_shear[j] * forces.tangential_error};
  }
  return result;
}

}  // namespace steadyslide::numeric
