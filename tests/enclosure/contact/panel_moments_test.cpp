// The moments of distant panels agree with the sum over their nodes.

#include "enclosure/contact/panel_moments.hpp"
#include "enclosure/contact/gap_contact.hpp"

namespace steadyslide::enclosure {

TEST_CASE("panels seen from afar by their moments: the sum over their nodes, from either side and any distance") {
  const GapContact notch(-69, -69);  // a gap of 1e-30
  const auto ten_to = [&](int exponent) { return power(Ball(10, notch.bits), exponent); };
  const std::vector<std::optional<PanelMoments::DistanceRange>> ranges = {
      std::nullopt,
      PanelMoments::DistanceRange{Ball(0, 64), ten_to(-29)},
      PanelMoments::DistanceRange{ten_to(-21), ten_to(-9)},
      PanelMoments::DistanceRange{ten_to(-3), ten_to(2)},
  };
  for (const Side c : {Side::left, Side::right}) {
    const std::size_t segment = c == Side::left ? 3 : 0;
    JacobiRules rules(notch.bits);
    std::vector<ContactPanel> panels;
    std::vector<std::vector<Ball>> values;
    std::vector<Ball> sizes;
    for (ContactPanel::Interval& part : ContactPanel::graded(notch.set, segment)) {
      panels.emplace_back(notch.set, std::move(part), -1, std::nullopt, 40, rules);
      values.emplace_back();
      for (const ContactPanel::Node& node : panels.back().nodes()) values.back().push_back(node.weight);
      sizes.push_back(Ball(1, 64));
    }
    REQUIRE(panels.size() > 90);
    for (const std::optional<PanelMoments::DistanceRange>& range : ranges) {
      CAPTURE(range ? range->most.to_double() : 0);
      const PanelMoments moments(panels, values, sizes, c, range, notch.bits);
      std::vector<Ball> distances;
      for (const int exponent : {-32, -30, -20, -10, -3, 0, 1})
        distances.push_back(Ball(3, notch.bits) * ten_to(exponent));
      for (const Rational& beyond : {9_r / 10, 4_r / 5, 3_r / 5}) {
        if (!range) continue;
        distances.push_back(range->most / Ball(beyond, notch.bits));
        if (range->least.is_positive()) distances.push_back(range->least * Ball(beyond, notch.bits));
      }
      for (const Ball& distance : distances) {
        CAPTURE(distance.to_double());
        const PanelMoments::Rest rest = moments.seen_from(distance);
        Ball all(0, notch.bits), near = rest.sum;
        for (std::size_t n = 0; n < panels.size(); ++n) {
          const std::size_t at = c == Side::left ? n : panels.size() - 1 - n;
          Ball sum(0, notch.bits);
          for (std::size_t i = 0; i < values[at].size(); ++i) {
            const ContactPanel::Node& node = panels[at].nodes()[i];
            sum += values[at][i] / (distance + (c == Side::left ? node.from_left : node.from_right));
          }
          all += sum;
          if (n >= rest.first && n < rest.last) near += sum;
        }
        if (moments.cover({distance, distance})) CHECK(rest.last - rest.first < 12);
        CHECK(near.contains(all.midpoint()));
        CHECK(near.radius() < all * power(Ball(10, 64), -30));
      }
    }
  }
}

}  // namespace steadyslide::enclosure
