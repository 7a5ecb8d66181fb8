#pragma once
// The sum over all panels of a segment for a place beyond one of its points c, at the distance D from c:
//
//   sum_i v_i/(D + y_i),   with the distances y_i of the panels' nodes from c,
//
// for panels that are graded towards c as towards every point. Panels with y <= D/4 and panels with y >= 4 D are
// expanded:
//
//   1/(D + y) = sum_{k<K} (-y)^k/D^(k+1) + R,   |R| <= 4^-K/D,      1/(D + y) = sum_{k<K} (-D)^k/y^(k+1) + R,   |R| <= 4^-K/y,
//
// with moments of all panels up to one, and of all panels from one on. Beside a gap of 1e-90 there are hundreds of
// panels, and a place has only a few near ones. Places lie in an expected range of distances. A panel that is nearer or
// farther than the whole range needs fewer moments, because the terms of its expansion decrease faster.
//
// The rules' remainders: a panel's far ellipse reaches 4/5 of its length beyond it. A panel is not longer than y at its
// nearer end, except the one that touches c. So the ellipse begins beyond c, or at -4/5 of the length of the panel that
// touches c, which is at most D/4 if the panel is expanded: the distance of -D from it is at least 4 D/5. For panels
// with y >= 4 D it is at least y/5, and the rules' remainders contain the distance itself.

#include <optional>

#include "enclosure/contact/contact_panel.hpp"

namespace steadyslide::enclosure {

class PanelMoments {
 public:
  /// The smallest and the largest distance of places.
  struct DistanceRange {
    Ball least;
    Ball most;
  };

  /// `values` are v at each panel's nodes. `sizes` are bounds of the function with these values, in the panel's far
  /// ellipse and without the powers of |Y|. `c` is the side of the segment on which point c lies. `distances` is absent
  /// if any distance is expected. Sums have the values' precision, expansions are cut at about 2^-bits.
  PanelMoments(const std::vector<ContactPanel>& panels, const std::vector<std::vector<Ball>>& values,
               const std::vector<Ball>& sizes, Side c, const std::optional<DistanceRange>& distances, Bits bits);

  /// True if all these distances are in the expected range.
  bool cover(const DistanceRange& distances) const;

  /// The enclosed sum over all panels except `first` to `last` - 1, counted from c, with the rules' remainders.
  /// `distance` is D. If it is outside the expected range, fewer panels are in the sum.
  struct Rest {
    Ball sum;
    std::size_t first;
    std::size_t last;
  };
  Rest seen_from(const Ball& distance) const;

 private:
  struct Sums {
    std::vector<Ball> moments;  ///< moments of y^k, or of y^-(k+1)
    Ball size;                  ///< sum |v|, or |v|/y
    Ball remainder;             ///< remainder of the rules, times 4 D/5, or with the pole's bound
  };

  /// Returns the number of panels with y <= D/4.
  std::size_t count_of_near(const Ball& distance) const;
  /// Returns the first panel with y >= 4 D; never the one that touches c.
  std::size_t first_far(const Ball& distance) const;

  std::optional<DistanceRange> distances_;
  std::vector<Ball> starts_;  ///< y at the panels' nearer and farther ends
  std::vector<Ball> ends_;
  std::size_t least_near_ = 0;  ///< for the smallest distance
  std::size_t least_far_ = 0;
  std::vector<Sums> near_;  ///< sums of the first least_near_ + i panels
  std::vector<Sums> far_;   ///< sums of all panels from least_far_ + i on
  Bits bits_;
};

}  // namespace steadyslide::enclosure
