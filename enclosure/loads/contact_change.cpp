#include "enclosure/loads/contact_change.hpp"

#include <algorithm>
#include <sstream>

namespace steadyslide::enclosure {
namespace {

constexpr Bits change_bits = 64;

/// A zone of contact: its two points, and where they are.
struct Zone {
  std::size_t first;
  std::size_t last;
  Ball left;
  Ball right;
};

class Change {
 public:
  Change(const ReducedProblem& problem, const ContactBox& before, const ContactBox& after)
      : problem_(problem),
        sets_{ContactSet(problem, before.topology, before.log_offsets, change_bits),
              ContactSet(problem, after.topology, after.log_offsets, change_bits)},
        zones_{zones(0), zones(1)} {}

  std::string words() const {
    std::vector<std::string> changes;
    // Zones that have places in common belong together: from left to right.
    std::size_t i = 0, j = 0;
    while (i < zones_[0].size() || j < zones_[1].size()) {
      const std::size_t i_from = i, j_from = j;
      if (j == zones_[1].size() || (i < zones_[0].size() && zones_[0][i].right < zones_[1][j].left)) {
        ++i;
      } else if (i == zones_[0].size() || zones_[1][j].right < zones_[0][i].left) {
        ++j;
      } else {
        ++i, ++j;
        for (bool more = true; more;) {
          more = false;
          while (i < zones_[0].size() && !(zones_[1][j - 1].right < zones_[0][i].left)) ++i, more = true;
          while (j < zones_[1].size() && !(zones_[0][i - 1].right < zones_[1][j].left)) ++j, more = true;
        }
      }
      group(i_from, i, j_from, j, changes);
    }
    std::string result;
    for (const std::string& change : changes) result += (result.empty() ? "" : " and ") + change;
    return result;
  }

 private:
  std::vector<Zone> zones(std::size_t of) const {
    std::vector<Zone> result;
    for (const ContactSet::Run& run : sets_[of].components()) {
      result.push_back({run.first, run.last + 1, sets_[of].x(run.first), sets_[of].x(run.last + 1)});
    }
    return result;
  }

  std::string place(const Ball& xi) const {
    const Ball x = Ball(problem_.frame.origin, change_bits) + Ball(problem_.frame.unit, change_bits) * xi;
    std::ostringstream text;
    text.precision(4);
    text << x.to_double();
    return "near x = " + text.str();
  }

  /// "the friction jump at x = 0.2".
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

  /// Anchors strictly between two neighbouring zones of a set.
  std::vector<std::size_t> anchors_between(std::size_t of, const Zone& left, const Zone& right) const {
    std::vector<std::size_t> result;
    for (std::size_t j = left.last + 1; j < right.first; ++j) result.push_back(sets_[of].point(j).anchor);
    return result;
  }

  /// Every gap among zones i to j - 1 of a set.
  void gaps(std::size_t of, std::size_t i, std::size_t j, std::vector<std::string>& changes) const {
    for (; i + 1 < j; ++i) {
      const Zone& left = zones_[of][i];
      const Zone& right = zones_[of][i + 1];
      const std::vector<std::size_t> over = anchors_between(of, left, right);
      const std::string where =
          over.size() == 1 ? "over " + anchor(over.front()) : place((left.right + right.left) / Ball(2));
      if (of == 1) {
        changes.push_back("a gap opens " + where);
      } else {
        changes.push_back((over.size() == 1 ? "the gap closes " : "two zones of contact meet ") + where);
      }
    }
  }

  void group(std::size_t i, std::size_t i_to, std::size_t j, std::size_t j_to,
             std::vector<std::string>& changes) const {
    const auto middle = [](const Zone& zone) { return (zone.left + zone.right) / Ball(2); };
    if (j == j_to) {
      changes.push_back("a zone of contact vanishes " + place(middle(zones_[0][i])));
    } else if (i == i_to) {
      changes.push_back("a zone of contact is born " + place(middle(zones_[1][j])));
    } else if (i_to - i > 1 && j_to - j > 1) {
      changes.push_back("zones of contact change from " + place(zones_[0][i].left) + " to " +
                        place(zones_[0][i_to - 1].right));
    } else {
      gaps(0, i, i_to, changes);
      gaps(1, j, j_to, changes);
      end("left", sets_[0].point(zones_[0][i].first), sets_[1].point(zones_[1][j].first), changes);
      end("right", sets_[0].point(zones_[0][i_to - 1].last), sets_[1].point(zones_[1][j_to - 1].last), changes);
    }
  }

  void end(const std::string& side, const ContactTopology::Point& before, const ContactTopology::Point& after,
           std::vector<std::string>& changes) const {
    const std::string name = "the " + side + " end of contact ";
    // Free ends lie between an anchor and the next one.
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
  ContactSet sets_[2];
  std::vector<Zone> zones_[2];
};

}  // namespace

std::string contact_change(const ReducedProblem& problem, const ContactBox& before, const ContactBox& after) {
  return Change(problem, before, after).words();
}

}  // namespace steadyslide::enclosure
