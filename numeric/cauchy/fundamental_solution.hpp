#pragma once
// The fundamental solution of the Riemann-Hilbert problem on one contact component,
//
//   Y(z) = prod_j (z - e_j)^{p_j},   e_0 < e_1 < ... < e_n: left end, friction jumps, right end,
//
// cut along the contact [e_0, e_n] when the p_j sum to an integer S; Y ~ z^S at infinity. Panel k is ]e_k, e_{k+1}[.
// On it Y+- = |Y| exp(+-i pi sigma_k), sigma_k = sum of p_j over e_j > x. [Bal16, theorem 36, reconstructed]
//
// In double with many points, the cost of a value is that of the points near it (DistantPowers in the source).

#include <memory>
#include <span>
#include <vector>

#include "model/direction.hpp"
#include "numeric/number/node.hpp"
#include "numeric/number/once.hpp"
#include "numeric/number/power.hpp"

namespace steadyslide::numeric {

class DistantPowers;
template <Real R>
class DistanceProduct;

/// Y+ is the limit on the cut from above (Im z > 0), Y- from below.
enum class BoundaryLimit { plus, minus };

template <Real R>
struct Complex {
  R re;
  R im;
};

template <Real R>
class FundamentalSolution {
 public:
  /// Takes lengths[k] = e_{k+1} - e_k > 0, as accurate as possible, and one more power than lengths.
  FundamentalSolution(const R& left_end, std::vector<R> lengths, std::vector<Power<R>> powers);

  /// Takes adjacent panels, and one more power than panels. Powers may be zero.
  FundamentalSolution(std::vector<Panel<R>> panels, std::vector<Power<R>> powers);

  std::size_t panel_count() const { return panels_.size(); }
  const Panel<R>& panel(std::size_t k) const { return panels_[k]; }
  const std::vector<Power<R>>& powers() const { return powers_; }
  R point(std::size_t j) const { return j == 0 ? panels_.front().left : panels_[j - 1].right; }

  /// Returns |Y| at a node of panel k.
  R modulus(std::size_t k, const Node<R>& node) const;
  /// Computes |Y| at many points of panel k, given by their distances from its ends. In double the error is 4 units in
  /// the last place for the given distances and powers (numeric/number/power_product.hpp), plus the rounding of the
  /// sums of lengths in the distances from other points. For more than 512 panels it computes the points one by one, as
  /// modulus() does. In higher precision all returned digits are correct.
  void moduli(std::size_t k, std::span<const R> from_left, std::span<const R> from_right, std::span<R> values) const;
  /// Returns |Y| at a node of panel k without the powers of the panel's two ends. This is analytic there.
  R smooth_modulus(std::size_t k, const Node<R>& node) const;
  /// Returns |Y| at a distance d > 0 to the left of e_0 (Side::left) or to the right of e_n.
  R modulus_beyond(Side side, const R& distance) const;
  /// Returns the same without the power of that end.
  R smooth_modulus_beyond(Side side, const R& distance) const;
  /// Returns prod_{i != j} |e_j - e_i|^{p_i}, the amplitude of |x - e_j|^{p_j} at e_j.
  R amplitude(std::size_t j) const;

  /// Returns sigma_k.
  R phase(std::size_t k) const;
  Complex<R> boundary(std::size_t k, const Node<R>& node, BoundaryLimit limit) const;
  /// Returns Y(z); z is not real.
  Complex<R> at(const Complex<R>& z) const;

  /// Returns an estimate of the relative error of |Y| at a node. It contains the rounding of every power, and
  /// `end_error`, the absolute error of e_0 and e_n.
  R relative_error(std::size_t k, const Node<R>& node, const R& end_error) const;

 private:
  /// Returns null if there are few points, or if R is not double.
  const DistantPowers* distant() const;
  /// Returns the product of all powers at a place of panel k, without the points for which skips(j) is true.
  template <class Skips>
  R product(std::size_t k, const R& from_left, const R& from_right, const Skips& skips) const;
  template <class Skips>
  R product(std::size_t k, const R& from_left, const R& from_right, const Skips& skips,
            DistanceProduct<R>& scratch) const;
  template <class Skips>
  R product_beyond(Side side, const R& distance, const Skips& skips) const;

  std::vector<Panel<R>> panels_;
  std::vector<Power<R>> powers_;
  std::shared_ptr<const Once<DistantPowers>> distant_;  ///< computed at first use; copies share it
};

}  // namespace steadyslide::numeric
