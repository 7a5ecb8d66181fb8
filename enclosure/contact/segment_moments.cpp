#include "enclosure/contact/segment_moments.hpp"

#include <algorithm>
#include <cmath>

namespace steadyslide::enclosure {
namespace {

/// Returns the number of terms for a place at a distance of half the segment's length.
std::size_t terms(Bits bits) { return static_cast<std::size_t>(bits) + 4; }

}  // namespace

std::vector<Ball> SegmentMoments::of_weights(const ContactSet& set, std::size_t segment,
                                             const std::vector<ContactPanel>& panels, int degree) {
  const Bits bits = set.bits();
  const Ball half_length = set.length(segment) / Ball(2);
  std::vector<Ball> result(terms(bits) + static_cast<std::size_t>(std::max(degree, 0)) + 1, Ball(0, bits));
  for (const ContactPanel& panel : panels) {
    std::vector<Ball> weights, points;
    for (const ContactPanel::Node& node : panel.nodes()) {
      weights.push_back(node.weight);
      points.push_back(node.from_left - half_length);
    }
    add_moments(result, weights, points);
  }
  return result;
}

SegmentMoments::SegmentMoments(const ContactSet& set, std::size_t segment, const std::vector<ContactPanel>& panels,
                               const std::vector<Ball>& moments_of_weights, const BallPolynomial& polynomial,
                               const std::vector<Ball>& sizes, Bits bits)
    : bits_(bits), half_length_(set.length(segment) / Ball(2)), size_(0, 64), remainder_(0, 64), reach_(0, 64) {
  const BallPolynomial around = shifted(polynomial, set.x(segment) + half_length_);
  for (std::size_t k = 0; k < terms(bits_); ++k) {
    Ball sum(0, bits_);
    for (std::size_t m = 0; m < around.size(); ++m) sum += around[m] * moments_of_weights[k + m];
    moments_.push_back(std::move(sum));
  }
  for (std::size_t n = 0; n < panels.size(); ++n) {
    nodes_ += panels[n].nodes().size();
    remainder_ += panels[n].remainder(sizes[n], Ellipse::far);
    for (const ContactPanel::Node& node : panels[n].nodes()) size_ += node.weight.at(64) * sizes[n];
    reach_ = max(reach_, panels[n].reach(Ellipse::far));
  }
}

std::optional<Ball> SegmentMoments::seen_from(const Ball& distance, Side facing) const {
  const Ball to_middle = distance + half_length_;
  const Ball ratio = (half_length_.at(64) / to_middle.at(64)).upper();
  if (!(ratio * Ball(2) < Ball(1)) || !(distance.radius() * power(Ball(2, 64), 20) < distance)) return std::nullopt;
  const double bits_per_term = -std::log2(ratio.to_double()) * 0.999;
  const auto count = static_cast<std::size_t>(static_cast<double>(bits_) / bits_per_term) + 2;
  // One division costs as much as three products.
  if (count > std::min(3 * nodes_, moments_.size())) return std::nullopt;
  Ball inverse = Ball(1) / to_middle;
  if (facing == Side::left) inverse = -inverse;
  Ball sum(0, to_middle.bits());
  for (std::size_t k = count; k-- > 0;) {
    const Bits needed = bits_ - static_cast<Bits>(static_cast<double>(k) * bits_per_term);
    const Bits shown = std::max(needed, Bits{0}) + 16;
    arb_mul(sum.get(), sum.get(), inverse.get(), shown);
    arb_add(sum.get(), sum.get(), moments_[k].get(), shown);
  }
  sum *= abs(inverse);
  const Ball cut = size_ * power(ratio, static_cast<int>(count)) / (Ball(1) - ratio);
  return Ball::plus_or_minus(sum, cut / to_middle.at(64) + remainder_ * pole_bound((distance.at(64) - reach_).lower()));
}

}  // namespace steadyslide::enclosure
