#include "enclosure/cells/lowest_gap.hpp"

namespace steadyslide::enclosure {
namespace {

/// Ends are multiples of 2^-20, so all places are multiples of 2^-44.
constexpr int most_halvings = 24;
/// The cost is mostly logarithms.
constexpr std::int64_t work_of_interval = 100;

class Search {
 public:
  Search(const CellGap& gap, const Ball& mean, const Ball& low, WorkBudget& work)
      : gap_(gap),
        logarithms_(gap.bits()),
        mean_(mean),
        least_(low.upper()),
        work_(work),
        result_{Ball(0), low.upper()} {}

  LowestGap run() {
    for (std::size_t i = 0; i < gap_.size(); ++i) {
      for (const GapPart& part : gap_.parts(i)) {
        search(part, part.from, part.to, part.value(part.from, logarithms_), part.value(part.to, logarithms_), 0);
      }
      if (work_.is_spent()) {
        result_.unfinished = i;
        break;
      }
    }
    return std::move(result_);
  }

 private:
  /// `at_z0` and `at_z1` are H without its rest at z0 and z1.
  void search(const GapPart& part, double z0, double z1, const Ball& at_z0, const Ball& at_z1, int halvings) {
    const Ball lower = (min(at_z0, at_z1) - part.rest - part.dip(z0, z1)).lower();
    work_.take(work_of_interval);
    if (lower >= enough() || work_.is_spent() || halvings == most_halvings || !lower.is_finite()) {
      result_.bound = result_.intervals++ == 0 ? lower : min(result_.bound, lower).lower();
      return;
    }
    const double middle = (z0 + z1) / 2;
    const Ball value = part.value(middle, logarithms_);
    least_ = min(least_, value - part.rest).upper();
    result_.somewhere = min(result_.somewhere, value + part.rest).upper();
    // Search the lower half first, because its result may make the other half unnecessary.
    const bool left = at_z0 < at_z1;
    if (left) search(part, z0, middle, at_z0, value, halvings + 1);
    search(part, middle, z1, value, at_z1, halvings + 1);
    if (!left) search(part, z0, middle, at_z0, value, halvings + 1);
  }

  /// Returns a sufficient value of the bound. The search minimises H without its rest, because halving does not reduce
  /// the rest.
  Ball enough() const { return least_ - (mean_ - least_) / Ball(256); }

  const CellGap& gap_;
  NearLogarithms logarithms_;
  const Ball& mean_;
  Ball least_;
  WorkBudget& work_;
  LowestGap result_;
};

}  // namespace

LowestGap lowest_gap(const CellGap& gap, const Ball& mean, const Ball& low, WorkBudget& work) {
  return Search(gap, mean, low, work).run();
}

}  // namespace steadyslide::enclosure
