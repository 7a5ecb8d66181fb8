#include "enclosure/contact/panel_moments.hpp"

namespace steadyslide::enclosure {

PanelMoments::PanelMoments(const std::vector<ContactPanel>& panels, const std::vector<std::vector<Ball>>& values,
                           const std::vector<Ball>& sizes, Side c, Bits bits)
    : bits_(bits) {
  const std::size_t count = panels.size();
  const std::size_t terms = static_cast<std::size_t>(bits) / 2 + 4;
  const bool left = c == Side::left;
  const auto at = [&](std::size_t n) { return left ? n : count - 1 - n; };
  const auto y_of = [&](const ContactPanel::Node& node) -> const Ball& {
    return left ? node.from_left : node.from_right;
  };
  for (std::size_t n = 0; n < count; ++n) {
    const ContactPanel::Part& part = panels[at(n)].part();
    starts_.push_back(left ? part.from_left : part.from_right);
    ends_.push_back(starts_.back() + part.length);
  }
  const Sums nothing{std::vector<Ball>(terms, Ball(0, bits)), Ball(0, 64), Ball(0, 64)};
  up_to_.assign(count + 1, nothing);
  from_.assign(count + 1, nothing);
  const auto rule_error = [&](std::size_t n) { return panels[at(n)].remainder(sizes[at(n)], Ellipse::far); };
  for (std::size_t n = 0; n < count; ++n) {
    Sums& sums = up_to_[n + 1] = up_to_[n];
    for (std::size_t i = 0; i < panels[at(n)].nodes().size(); ++i) {
      const Ball& y = y_of(panels[at(n)].nodes()[i]);
      Ball term = values[at(n)][i];
      sums.size += abs(term).upper().at(64);
      for (Ball& moment : sums.moments) {
        moment += term;
        term *= y;
      }
    }
    sums.remainder += rule_error(n);
  }
  for (std::size_t n = count; n-- > 1;) {  // the first one touches c
    Sums& sums = from_[n] = from_[n + 1];
    for (std::size_t i = 0; i < panels[at(n)].nodes().size(); ++i) {
      const Ball inverse = Ball(1) / y_of(panels[at(n)].nodes()[i]);
      Ball term = values[at(n)][i] * inverse;
      sums.size += abs(term).upper().at(64);
      for (Ball& moment : sums.moments) {
        moment += term;
        term *= inverse;
      }
    }
    sums.remainder += rule_error(n) * pole_bound((starts_[n] - panels[at(n)].reach(Ellipse::far)).at(64));
  }
}

PanelMoments::Rest PanelMoments::seen_from(const Ball& distance) const {
  const std::size_t count = starts_.size();
  const Ball four(4, 64);
  Rest rest{Ball(0, bits_), 0, count};
  while (rest.first < count && four * ends_[rest.first] <= distance) ++rest.first;
  while (rest.last > rest.first && rest.last > 1 && starts_[rest.last - 1] >= four * distance) --rest.last;
  const Ball cut = power(Ball(2, 64), -2 * static_cast<int>(up_to_[0].moments.size()));
  if (rest.first > 0) {
    const Sums& near = up_to_[rest.first];
    const Ball inverse = Ball(-1) / distance;
    Ball sum(0, bits_);
    for (std::size_t k = near.moments.size(); k-- > 0;) sum = sum * inverse + near.moments[k];
    // -sum/D * (-1): 1/(D + y) = -(sum_k y^k (-1/D)^k) (-1/D).
    sum *= -inverse;
    rest.sum += Ball::plus_or_minus(sum, (near.size * cut + near.remainder * Ball(5)) * pole_bound(distance.at(64)));
  }
  if (rest.last < count) {
    const Sums& beyond = from_[rest.last];
    Ball sum(0, bits_);
    for (std::size_t k = beyond.moments.size(); k-- > 0;) sum = sum * -distance + beyond.moments[k];
    rest.sum += Ball::plus_or_minus(sum, beyond.size * cut + beyond.remainder);
  }
  return rest;
}

}  // namespace steadyslide::enclosure
