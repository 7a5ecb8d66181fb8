#include "enclosure/contact/contact_gap.hpp"

namespace steadyslide::enclosure {

Ball contact_gap(const TractionRepresentation& form, const Place& place) {
  const ContactSet& set = form.set();
  std::size_t first = place.segment;
  std::size_t last = place.segment;
  while (first > 0 && !set.in_contact(first - 1)) --first;
  while (last + 1 < set.segments() && !set.in_contact(last + 1)) ++last;
  const bool from_left = first > 0;
  const bool from_right = last + 1 < set.segments();
  if (!from_left && !from_right) return Ball::unknown(set.bits());
  const Ball to_left = place.from_left + set.distance(first, place.segment);
  const Ball to_right = place.from_right + set.distance(place.segment + 1, last + 1);
  const bool left = from_left && (!from_right || to_left.midpoint() <= to_right.midpoint());

  const std::size_t k = form.slope_of(left ? first - 1 : last + 1);
  // Over parts of segments off the contact, from left to right.
  const auto change = [&](const std::vector<ContactPanel::Part>& parts) {
    Ball sum(0, set.bits());
    for (const ContactPanel::Part& part : parts) sum += form.gap_change(part, k);
    return sum;
  };
  Ball sum = left ? set.step(first) : -set.step(last + 1);
  for (std::size_t m = left ? first : last; m != place.segment; left ? ++m : --m) {
    const Ball risen = change(ContactPanel::graded(set, m));
    sum += left ? risen + set.step(m + 1) : -risen - set.step(m);
  }
  const bool whole = (left ? place.from_right : place.from_left).is_zero();
  const ContactPanel::Range range{Ball(0, set.bits()), left ? place.from_left : place.from_right};
  const Ball risen = change(whole ? ContactPanel::graded(set, place.segment)
                                  : ContactPanel::outward(set, place.segment, left ? Side::left : Side::right, range));
  return left ? sum + risen : sum - risen;
}

}  // namespace steadyslide::enclosure
