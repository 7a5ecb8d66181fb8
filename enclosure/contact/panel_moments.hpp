#pragma once
// The panels of a segment seen from a place beyond one of its points c, at the distance D from it, all at once:
//
//   sum_i v_i/(D + y_i),   y_i the distances of the panels' nodes from c,
//
// with panels graded towards c as towards every point. Those with y <= D/4 and those with y >= 4 D are expanded:
//
//   1/(D + y) = sum_{k<K} (-y)^k/D^(k+1) + R,   |R| <= 4^-K/D,      1/(D + y) = sum_{k<K} (-D)^k/y^(k+1) + R,   |R| <= 4^-K/y,
//
// by moments of all panels up to one, and of all from one on: a gap of 1e-90 has hundreds of panels, and a place a few near
// ones. The rules' remainders: a panel's far ellipse reaches 4/5 of its length beyond it, which is no longer than y at its
// nearer end (but for the one that touches c), so that -D is at least D/5, and y/5, away from it.

#include "enclosure/contact/contact_panel.hpp"

namespace steadyslide::enclosure {

class PanelMoments {
 public:
  /// `values`: v of each panel's nodes. `sizes`: bounds of what they are values of, in the panel's far ellipse and without the
  /// powers of |Y|. `c`: the side of the segment on which that point is.
  PanelMoments(const std::vector<ContactPanel>& panels, const std::vector<std::vector<Ball>>& values,
               const std::vector<Ball>& sizes, Side c, Bits bits);

  /// The panels' sum but for those from `first` up to, not including, `last`, counted from c; enclosed, with the rules'
  /// remainders. `distance` is D.
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

  std::vector<Ball> starts_;  ///< y of the panels' nearer and farther ends
  std::vector<Ball> ends_;
  std::vector<Sums> up_to_;  ///< of the first n panels
  std::vector<Sums> from_;   ///< of all panels from n on
  Bits bits_;
};

}  // namespace steadyslide::enclosure
