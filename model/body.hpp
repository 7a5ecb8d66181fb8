#pragma once
// The elastic body, beyond the half-plane: layers on a base, a contact that repeats with a period, or a body that is known
// by its symbols only. Every body looks the same from every place of its surface, so it does not depend on x.

#include <memory>
#include <optional>
#include <vector>

#include "model/elasticity.hpp"

namespace steadyslide {

/// The lower side of a layer: bonded, or free to slip without friction and without a gap.
enum class Interface { bonded, slip };

struct Layer {
  Rational thickness;
  Solid solid;
  Interface below = Interface::bonded;
  friend bool operator==(const Layer&, const Layer&) = default;
};

/// The symbols of a body at one wave number k, relative to the half-plane of the surface's material:
///
///   W = normal displacement by a pressure cos(kx), over that of the half-plane;   V = the same for the coupling.
struct SymbolRow {
  Rational wave_number;  ///< k > 0, 1/L
  Rational normal;       ///< W
  Rational coupling;     ///< gamma V
  friend bool operator==(const SymbolRow&, const SymbolRow&) = default;
};

/// Throws InvalidData unless the wave number is larger than that of the row before (null: than 0), and W > 0.
void check_symbols(const SymbolRow& row, const SymbolRow* before);

class Body {
 public:
  /// The half-plane.
  Body() = default;
  /// Layers from the surface down, on an elastic half-plane, or on a rigid base if `base` is absent. Throws InvalidData
  /// unless there is a layer, every thickness is positive, and at most 64 layers are given.
  static Body layered(std::vector<Layer> layers, std::optional<Solid> base);
  /// The half-plane under indenters that repeat with this period. Throws InvalidData unless it is positive.
  static Body periodic(Rational period);
  /// A body with these symbols, W = V = 1 above the last wave number. Throws InvalidData unless there are two rows, all
  /// accepted by check_symbols().
  static Body of_symbols(std::vector<SymbolRow> rows);

  /// True if there are neither layers nor a period nor symbols.
  bool is_half_plane() const { return layers_.empty() && !period_ && !symbols_; }
  const std::vector<Layer>& layers() const { return layers_; }
  /// Returns the half-plane under the layers; absent: it is rigid, or there are no layers.
  const std::optional<Solid>& base() const { return base_; }
  const std::optional<Rational>& period() const { return period_; }
  /// Returns the given symbols; null if there are none.
  const std::shared_ptr<const std::vector<SymbolRow>>& symbols() const { return symbols_; }

  /// Returns why a method that knows the half-plane alone does not apply; empty if it does.
  const char* beyond_half_plane() const {
    return is_half_plane() ? "" : "the method is for the half-plane, and the body has layers, a period or symbols";
  }
  /// Returns the body with all lengths multiplied by `scale` > 0.
  Body scaled(const Rational& scale) const;
  friend bool operator==(const Body& a, const Body& b);

 private:
  std::vector<Layer> layers_;
  std::optional<Solid> base_;
  std::optional<Rational> period_;
  std::shared_ptr<const std::vector<SymbolRow>> symbols_;  ///< copies share the table
};

}  // namespace steadyslide
