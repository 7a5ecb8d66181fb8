#pragma once
// What a trapezoidal rule with the nodes tau = 0, h, 2h, ... knows of the unit interval, whatever the panel
// (double_exponential_grid.hpp): a whole number of steps doubles e^tau.

#include <map>
#include <memory>
#include <mutex>
#include <numbers>
#include <vector>

#include "numeric/quadrature/double_exponential_grid.hpp"

namespace steadyslide::numeric::double_exponential {

/// h.
inline double step(int per_octave) { return std::numbers::ln2 / per_octave; }

/// 2^shift x without its fraction. Sums of products of such numbers cost a third of what they do with floating points.
template <Real R>
Integer shifted(const R& x, int shift);
template <Real R>
R shifted_back(const Integer& sum, int shift);

/// e^-(2 p u) at tau = 0, h, 2h, ..., `rise` being (pi/2) e^tau over one octave. e^(-p rise) is squared from one octave to
/// the next, e^(p (pi/2) e^-tau) the root of what it was: an exponential a node of one octave is all.
template <Real R>
std::vector<R> decays(const R& p, const std::vector<R>& rise, std::size_t count);

/// A node at tau >= 0 of the unit interval.
template <Real R>
struct UnitNode {
  R near;  ///< distances to the right end and to the left one
  R far;
  R log_far;
  R rate;             ///< pi cosh tau
  R both;             ///< near far
  R mirror;           ///< near far rate^2
  double rough_near;  ///< for what double is enough for

  /// From (pi/2) e^tau, (pi/2) e^-tau and e^-2u.
  static UnitNode of(const R& rise, const R& fall, const R& decay);
};

/// What is known of a step, of which `per_octave` double e^tau, whatever the panel: grows as it is asked for, and is shared
/// by all grids.
template <Real R>
class UnitGrid {
 public:
  using Numbers = std::shared_ptr<const std::vector<Integer>>;
  using Nodes = std::shared_ptr<const std::vector<UnitNode<R>>>;

  static UnitGrid& of(int per_octave);
  static constexpr int bits = std::numeric_limits<R>::digits;
  explicit UnitGrid(int per_octave);

  /// h, and (pi/2) e^tau at 0, h, ... below log 2.
  R step() const;
  const std::vector<R>& octave() const { return octave_; }
  /// At 0, h, 2h, ...: `count` at least.
  Nodes nodes(int count) {
    const std::lock_guard lock(mutex_);
    return made_nodes(count);
  }
  /// 2^`bits`/(y' - y) at the nodes -`reach`, ..., `reach` at least, y the midpoint of a cell; as many on both sides of the
  /// middle.
  Numbers reciprocals(int cell, int reach);
  /// The midpoint's distances, that to the nearer end first.
  UnitNode<R> midpoint(int cell) {
    const std::lock_guard lock(mutex_);
    return made_midpoint(cell);
  }

 private:
  Nodes made_nodes(int count);
  const UnitNode<R>& made_midpoint(int cell);

  std::vector<R> octave_;
  std::mutex mutex_;
  Nodes nodes_;
  std::map<int, UnitNode<R>> midpoints_;
  std::map<int, Numbers> reciprocals_;
};

}  // namespace steadyslide::numeric::double_exponential
