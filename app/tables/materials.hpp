#pragma once
// Elastic constants of materials that slide on each other, as published: data, not results. Isotropic, small strains,
// room temperature; a batch of a material differs from its table by more than these digits say.

#include <optional>
#include <string>
#include <vector>

#include "model/elasticity.hpp"

namespace steadyslide::app {

struct Material {
  std::string name;
  std::string young;                 ///< E in GPa, as printed
  std::string poisson;               ///< nu, as printed
  std::optional<std::string> shear;  ///< the shear modulus in GPa, where the source prints it too: E = 2 mu (1 + nu)
  std::string source;                ///< a key of docs/references.md with brackets

  /// E in GPa.
  Solid solid() const;
};

const std::vector<Material>& materials();

/// Throws std::out_of_range for a name that is not listed.
const Material& material(const std::string& name);

/// The half-plane, and the indenter that slides on it; a rigid one has no name.
struct MaterialPair {
  std::string half_plane;
  std::optional<std::string> indenter;
};

const std::vector<MaterialPair>& material_pairs();

}  // namespace steadyslide::app
