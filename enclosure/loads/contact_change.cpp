#include "enclosure/loads/contact_change.hpp"

#include <algorithm>
#include <sstream>

namespace steadyslide::enclosure {
namespace {

constexpr Bits change_bits = 64;

/// A contact set and its contact zones.
struct Zones {
  Zones(const ReducedProblem& problem, const ContactBox& box)
      : set(problem, box.topology, box.log_offsets, change_bits), runs(set.components()) {}

  std::size_t size() const { return runs.size(); }
  // The ends of zone i: points and their places.
  std::size_t first(std::size_t i) const { return runs[i].first; }
  std::size_t last(std::size_t i) const { return runs[i].last + 1; }
  const Ball& left(std::size_t i) const { return set.x(first(i)); }
  const Ball& right(std::size_t i) const { return set.x(last(i)); }
  Ball middle(std::size_t i) const { return (left(i) + right(i)) / 2; }

  ContactSet set;
  std::vector<ContactSet::Run> runs;
};

class Change {
 public:
  Change(const ReducedProblem& problem, const ContactBox& before, const ContactBox& after)
      : problem_(problem), before_(problem, before), after_(problem, after) {}

  std::string words() const {
    std::vector<std::string> changes;
    // Zones with common places belong together. Go from left to right.
    std::size_t i = 0, j = 0;
    while (i < before_.size() || j < after_.size()) {
      const std::size_t i_from = i, j_from = j;
      if (j == after_.size() || (i < before_.size() && before_.right(i) < after_.left(j))) {
        ++i;
      } else if (i == before_.size() || after_.right(j) < before_.left(i)) {
        ++j;
      } else {
        ++i, ++j;
        for (bool more = true; more;) {
          more = false;
          while (i < before_.size() && !(after_.right(j - 1) < before_.left(i))) ++i, more = true;
          while (j < after_.size() && !(before_.right(i - 1) < after_.left(j))) ++j, more = true;
        }
      }
      group(i_from, i, j_from, j, changes);
    }
    std::string result;
    for (const std::string& change : changes) result += (result.empty() ? "" : " and ") + change;
    return result;
  }

 private:
  std::string place(const Ball& xi) const {
    const Ball x = Ball(problem_.frame.origin, change_bits) + Ball(problem_.frame.unit, change_bits) * xi;
    std::ostringstream text;
    text.precision(4);
    text << x.to_double();
    return "near x = " + text.str();
  }

  /// Returns text such as "the friction jump at x = 0.2".
  std::string anchor(std::size_t k) const {
    const ReducedProblem::Anchor& at = problem_.anchors[k];
    std::string kind = "the place";
    if (k == 0 || k + 1 == problem_.anchors.size()) {
      kind = "the support's edge";
    } else if (at.step != 0) {
      kind = "the step";
    } else if (at.wedge != 0) {
      kind = "the wedge";
    } else if (problem_.intervals[k - 1].s != problem_.intervals[k].s) {
      kind = "the friction jump";
    }
    return kind + " at x = " + to_string(problem_.place(k));
  }

  /// Adds every gap between the zones i to j - 1.
  void gaps(const Zones& zones, std::size_t i, std::size_t j, std::vector<std::string>& changes) const {
    for (; i + 1 < j; ++i) {
      // A gap over one anchor is named after the anchor.
      const std::size_t next = zones.last(i) + 1;
      const bool over_anchor = next + 1 == zones.first(i + 1);
      const std::string where = over_anchor ? "over " + anchor(zones.set.point(next).anchor)
                                            : place((zones.right(i) + zones.left(i + 1)) / 2);
      const char* const closes = over_anchor ? "the gap closes " : "two zones of contact meet ";
      changes.push_back((&zones == &after_ ? "a gap opens " : closes) + where);
    }
  }

  void group(std::size_t i, std::size_t i_to, std::size_t j, std::size_t j_to,
             std::vector<std::string>& changes) const {
    if (j == j_to) {
      changes.push_back("a zone of contact vanishes " + place(before_.middle(i)));
    } else if (i == i_to) {
      changes.push_back("a zone of contact is born " + place(after_.middle(j)));
    } else if (i_to - i > 1 && j_to - j > 1) {
      changes.push_back("zones of contact change from " + place(before_.left(i)) + " to " +
                        place(before_.right(i_to - 1)));
    } else {
      gaps(before_, i, i_to, changes);
      gaps(after_, j, j_to, changes);
      end("left", before_.set.point(before_.first(i)), after_.set.point(after_.first(j)), changes);
      end("right", before_.set.point(before_.last(i_to - 1)), after_.set.point(after_.last(j_to - 1)), changes);
    }
  }

  void end(const std::string& side, const ContactTopology::Point& before, const ContactTopology::Point& after,
           std::vector<std::string>& changes) const {
    const std::string name = "the " + side + " end of contact ";
    // A free end lies between an anchor and the next one.
    const auto interval = [](const ContactTopology::Point& p) { return p.anchor - (*p.beside == Side::left ? 1 : 0); };
    if (before.beside && after.beside) {
      const std::size_t from = interval(before), to = interval(after);
      for (std::size_t k = std::min(from, to); k < std::max(from, to); ++k)
        changes.push_back(name + "passes " + anchor(k + 1));
    } else if (after.beside) {
      changes.push_back(name + "leaves " + anchor(before.anchor));
    } else if (before.beside) {
      changes.push_back(name + "reaches " + anchor(after.anchor));
    } else if (before.anchor != after.anchor) {
      changes.push_back(name + "moves from " + anchor(before.anchor) + " to " + anchor(after.anchor));
    } else if (before.vanishes != after.vanishes) {
      changes.push_back("the traction " + std::string(after.vanishes ? "vanishes" : "no longer vanishes") + " at " +
                        anchor(after.anchor));
    }
  }

  const ReducedProblem& problem_;
  Zones before_;
  Zones after_;
};

}  // namespace

std::string contact_change(const ReducedProblem& problem, const ContactBox& before, const ContactBox& after) {
  return Change(problem, before, after).words();
}

}  // namespace steadyslide::enclosure
