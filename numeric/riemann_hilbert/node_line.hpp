#pragma once
// The quadrature nodes x_i of a contact as sources on a line, in double, whose panels are those of the contact and the
// segments without contact. With the rule's weights w_i of either sign and g_k = sum_m a_m x^m, for a kernel K,
//
//   sum_i w_i (g - g_k) K(x_i) = F[w g] - sum_m a_m F[w x^m],   F[v] = sum_i v_i K(x_i),
//
// is a difference of sums that are as large as w g, while w (g - g_k) may be small: its error is counted as that of
// sum_i |w_i K(x_i)| (max |g| + sum_m |a_m| max |x|^m).

#include <span>

#include "numeric/hierarchical/cell_moments.hpp"
#include "numeric/number/estimate.hpp"
#include "numeric/riemann_hilbert/jacobi_panels.hpp"

namespace steadyslide::numeric {

class NodeLine {
 public:
  /// Segments first..end-1.
  struct Segments {
    std::size_t first;
    std::size_t end;
  };
  /// The panels of some segments from left to right, all in contact, with the index of each one's first node.
  struct Panels {
    Segments segments;
    std::size_t first_panel;  ///< their numbers count from this one
    std::vector<SegmentPart<double>> parts;
    std::vector<std::size_t> first_node;
  };
  /// A panel of the contact, or a segment without contact.
  struct Leaf {
    SegmentPart<double> part;
    std::size_t panel;
  };
  /// Of a leaf, at distances from its ends.
  struct Place {
    std::size_t leaf;
    double from_left;
    double from_right;
  };

  /// `y` has to outlive it.
  NodeLine(const SignedFundamentalSolution<double>& y, const Panels& panels,
           std::span<const SurfacePoint<double>> nodes, std::span<const double> weights);

  const std::vector<double>& lengths() const { return lengths_; }
  const std::vector<hierarchical::Source>& sources() const { return sources_; }
  /// Of the sums: w g, then w x^m for m = 0, 1, ..., the last one |w|.
  const std::vector<std::vector<double>>& weights() const { return weights_; }

  const Leaf& leaf(std::size_t k) const { return leaves_[k]; }
  /// The first leaf of a segment, and the one after the last.
  std::size_t first_leaf(std::size_t segment) const { return first_leaf_[segment - segments_.first]; }
  bool is_left_of(const SurfacePoint<double>& at) const {
    return at.segment >= static_cast<std::ptrdiff_t>(segments_.end);
  }
  bool is_right_of(const SurfacePoint<double>& at) const {
    return at.segment < static_cast<std::ptrdiff_t>(segments_.first);
  }
  /// From the line's nearer end to a place beyond it.
  double distance_beyond(const SurfacePoint<double>& at) const {
    return is_left_of(at) ? y_->distance(at, segments_.end) : -y_->distance(at, segments_.first);
  }
  /// On the line.
  Place place(const SurfacePoint<double>& at) const;
  /// sum_i w_i (g - g_k) K(x_i) from the sums, the error in units of 4 epsilon.
  Estimate<double> combined(const std::vector<double>& slope, const std::vector<double>& sums) const;

 private:
  void add_panel(std::size_t panel, const SegmentPart<double>& part, std::size_t first, std::size_t end,
                 std::span<const SurfacePoint<double>> nodes, std::span<const double> weights);
  std::size_t leaf_at(const SurfacePoint<double>& at) const;

  const SignedFundamentalSolution<double>* y_;
  Segments segments_;
  std::vector<double> lengths_;
  std::vector<hierarchical::Source> sources_;
  std::vector<std::vector<double>> weights_;
  std::vector<Leaf> leaves_;
  std::vector<std::size_t> first_leaf_;  ///< of each segment, and one more
  double largest_slope_ = 0;
  double largest_place_ = 0;
};

}  // namespace steadyslide::numeric
