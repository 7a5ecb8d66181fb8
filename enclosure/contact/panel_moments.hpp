#pragma once
// The panels of a segment seen from a place beyond one of its points c, at the distance D from it, all at once:
//
//   sum_i v_i/(D + y_i),   y_i the distances of the panels' nodes from c,
//
// with panels graded towards c as towards every point. Those with y <= D/4 and those with y >= 4 D are expanded:
//
//   1/(D + y) = sum_{k<K} (-y)^k/D^(k+1) + R,   |R| <= 4^-K/D,      1/(D + y) = sum_{k<K} (-D)^k/y^(k+1) + R,   |R| <= 4^-K/y,
//
// by moments of all panels up to one, and of all from one on: beside a gap of 1e-90 stand hundreds of panels, and a place
// has a few near ones. Places are expected in a range of distances. A panel that is near or far for the whole range needs
// fewer moments the nearer or farther it is, since the terms of its expansion fall faster.
//
// The rules' remainders: a panel's far ellipse reaches 4/5 of its length beyond it. The panel is no longer than y at its
// nearer end, except the one that touches c. So -D is at least D/5, and y/5, away from the ellipse.

#include <optional>

#include "enclosure/contact/contact_panel.hpp"

namespace steadyslide::enclosure {

class PanelMoments {
 public:
  /// The least and the largest distance from which the panels are seen.
  struct Range {
    Ball least;
    Ball most;
  };

  /// `values`: v of each panel's nodes. `sizes`: bounds of what they are values of, in the panel's far ellipse and without the
  /// powers of |Y|. `c`: the side of the segment on which that point is. `distances`: none if any distance is expected.
  PanelMoments(const std::vector<ContactPanel>& panels, const std::vector<std::vector<Ball>>& values,
               const std::vector<Ball>& sizes, Side c, const std::optional<Range>& distances, Bits bits);

  /// Are all of these distances expected?
  bool cover(const Range& distances) const;

  /// The panels' sum but for those from `first` up to, not including, `last`, counted from c; enclosed, with the rules'
  /// remainders. `distance` is D. Where it is not expected, fewer panels are in the sum.
  struct Rest {
    Ball sum;
    std::size_t first;
    std::size_t last;
  };
  Rest seen_from(const Ball& distance) const;

 private:
  struct Sums {
    std::vector<Ball> moments;  ///< of y^k, or of y^-(k+1)
    Ball size;                  ///< sum |v|, or |v|/y
    Ball remainder;             ///< of the rules, times D/5, or with the pole's bound
  };

  /// How many panels have y <= D/4.
  std::size_t count_of_near(const Ball& distance) const;
  /// The first panel with y >= 4 D; never the one that touches c.
  std::size_t first_far(const Ball& distance) const;

  std::optional<Range> distances_;
  std::vector<Ball> starts_;  ///< y of the panels' nearer and farther ends
  std::vector<Ball> ends_;
  std::size_t least_near_ = 0;  ///< for the least distance
  std::size_t least_far_ = 0;
  std::vector<Sums> near_;  ///< of the first least_near_ + i panels
  std::vector<Sums> far_;   ///< of all panels from least_far_ + i on
  Bits bits_;
};

}  // namespace steadyslide::enclosure
