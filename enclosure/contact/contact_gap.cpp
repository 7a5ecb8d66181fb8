#include "enclosure/contact/contact_gap.hpp"

namespace steadyslide::enclosure {

using Kind = ContactTopology::Kind;

Ball ContactGap::step(std::size_t j) const {
  if (set_.point(j).beside) return Ball(0, set_.bits());
  return Ball(set_.problem().anchors[set_.point(j).anchor].step, set_.bits());
}

Ball ContactGap::change(const std::vector<ContactPanel::Part>& parts, std::size_t k) const {
  Ball sum(0, set_.bits());
  for (const ContactPanel::Part& part : parts) sum += form_.gap_change(part, k);
  return sum;
}

Ball ContactGap::at(const Place& place) const {
  const Bits bits = set_.bits();
  std::size_t first = place.segment;
  std::size_t last = place.segment;
  while (first > 0 && !set_.in_contact(first - 1)) --first;
  while (last + 1 < set_.segments() && !set_.in_contact(last + 1)) ++last;
  const bool from_left = first > 0;
  const bool from_right = last + 1 < set_.segments();
  if (!from_left && !from_right) return Ball::unknown(bits);
  const Ball to_left = place.from_left + set_.distance(first, place.segment);
  const Ball to_right = place.from_right + set_.distance(place.segment + 1, last + 1);
  const bool left = from_left && (!from_right || to_left.midpoint() <= to_right.midpoint());

  Ball sum = left ? step(first) : -step(last + 1);
  const std::size_t k = form_.slope_of(left ? first - 1 : last + 1);
  for (std::size_t m = left ? first : last; m != place.segment; left ? ++m : --m) {
    const Ball risen = change(ContactPanel::graded(set_, m), k);
    sum += left ? risen + step(m + 1) : -risen - step(m);
  }
  const Side from = left ? Side::left : Side::right;
  const ContactPanel::Range range{Ball(0, bits), left ? place.from_left : place.from_right};
  const bool whole = (left ? place.from_right : place.from_left).is_zero();
  const Ball risen = change(
      whole ? ContactPanel::graded(set_, place.segment) : ContactPanel::outward(set_, place.segment, from, range), k);
  return left ? sum + risen : sum - risen;
}

}  // namespace steadyslide::enclosure
