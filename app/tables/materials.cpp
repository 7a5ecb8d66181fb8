#include "app/tables/materials.hpp"

#include <stdexcept>

namespace steadyslide::app {

Solid Material::solid() const { return {parse_rational(poisson), parse_rational(young)}; }

const std::vector<Material>& materials() {
  // [KL95]: values at 20 degrees, as they are quoted from it, not compared with the book; a test asks that E, nu and mu
  // of a row agree. [Ger01] gives ranges: of nylon the middle of 2.1 to 3.4 GPa, rubber within 0.7 to 4 MPa and 0.45 to
  // 0.50.
  static const std::vector<Material> all{
      {"aluminium", "70.3", "0.345", "26.1", "[KL95]"},
      {"brass (70 Cu 30 Zn)", "100.6", "0.350", "37.3", "[KL95]"},
      {"copper", "129.8", "0.343", "48.3", "[KL95]"},
      {"crown glass", "71.3", "0.22", "29.2", "[KL95]"},
      {"lead", "16.1", "0.44", "5.59", "[KL95]"},
      {"mild steel", "211.9", "0.291", "82.2", "[KL95]"},
      {"titanium", "115.7", "0.321", "43.8", "[KL95]"},
      {"tungsten", "411.0", "0.280", "160.6", "[KL95]"},
      {"tungsten carbide", "534.4", "0.22", "219.0", "[KL95]"},
      {"nylon", "2.75", "0.4", std::nullopt, "[Ger01]"},
      {"rubber", "0.002", "0.49", std::nullopt, "[Ger01]"},
  };
  return all;
}

const Material& material(const std::string& name) {
  for (const Material& m : materials()) {
    if (m.name == name) return m;
  }
  throw std::out_of_range("no such material: " + name);
}

const std::vector<MaterialPair>& material_pairs() {
  static const std::vector<MaterialPair> all{
      {"mild steel", std::nullopt},
      {"rubber", std::nullopt},
      {"mild steel", "mild steel"},
      {"aluminium", "mild steel"},
      {"mild steel", "aluminium"},
      {"copper", "mild steel"},
      {"titanium", "mild steel"},
      {"lead", "mild steel"},
      {"brass (70 Cu 30 Zn)", "tungsten"},
      {"mild steel", "tungsten carbide"},
      {"crown glass", "mild steel"},
      {"mild steel", "crown glass"},
      {"nylon", "mild steel"},
      {"nylon", "crown glass"},
      {"rubber", "mild steel"},
      {"mild steel", "rubber"},
  };
  return all;
}

}  // namespace steadyslide::app
