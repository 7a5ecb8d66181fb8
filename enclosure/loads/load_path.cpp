#include "enclosure/loads/load_path.hpp"

#include <algorithm>

#include "enclosure/loads/closing_gap.hpp"
#include "enclosure/loads/contact_anchors.hpp"
#include "enclosure/loads/contact_change.hpp"
#include "enclosure/number/task_threads.hpp"
#include "model/invalid_data.hpp"

namespace steadyslide::enclosure {
namespace {

using Stretch = LoadStretch::Kind;

/// A load and its zero.
struct SolvedLoad {
  Rational load;
  ContactBox zero;
};

/// Returns a prediction on the line through two zeros; if their anchors differ, the nearer zero.
ContactBox predicted(const ReducedProblem& problem, const std::optional<SolvedLoad>& before, const SolvedLoad& here,
                     const Rational& load) {
  if (!before) return here.zero;
  const std::optional<ContactBox> earlier = with_anchors_of(problem, before->zero, here.zero.topology);
  if (!earlier) return here.zero;
  const Ball ratio(Rational((load - here.load) / (here.load - before->load)), load_interval_bits);
  std::vector<Ball> values = here.zero.unknowns();
  std::ranges::transform(earlier->unknowns(), values, values.begin(),
                         [&](const Ball& from, const Ball& to) { return (to + (to - from) * ratio).midpoint(); });
  return here.zero.with(values);
}

struct Failure {
  Rational load;
  std::string reason;
};

/// Proved and unproved intervals of some loads, in the order of the attempts.
struct Found {
  std::vector<LoadStretch> proved;
  std::vector<Failure> failures;

  void add(Found&& more) {
    std::move(more.proved.begin(), more.proved.end(), std::back_inserter(proved));
    std::move(more.failures.begin(), more.failures.end(), std::back_inserter(failures));
  }
  std::nullopt_t fail(const Rational& load, std::string reason) {
    failures.push_back({load, std::move(reason)});
    return std::nullopt;
  }
};

/// The result of steps from one load to another.
struct March {
  Rational reached;
  Found found;
  WorkBudget rest = WorkBudget(0);
};

class Follower {
 public:
  Follower(const ContactProblem& problem, const Frame& frame, const ContactAtLoad& contact_at,
           const LoadPathOptions& options)
      : problem_(problem, frame),
        contact_at_(contact_at),
        options_(options),
        rules_(options.bits),
        threads_(options.threads) {
    has_notch_ = std::ranges::any_of(problem_.anchors, [](const auto& anchor) { return anchor.wedge < 0; });
  }

  /// Proves as many loads as possible. Returns stretches for all loads: the proved ones, and the unproved ones in
  /// between.
  std::vector<LoadStretch> follow(const Rational& from, const Rational& to) {
    WorkBudget work(options_.work);
    found_ = fill(from, to, 12, work);
    std::sort(found_.proved.begin(), found_.proved.end(),
              [](const LoadStretch& a, const LoadStretch& b) { return a.from < b.from; });
    const auto low = [&](std::size_t i) { return i > 0 ? found_.proved[i - 1].to : from; };
    const auto high = [&](std::size_t i) { return i < found_.proved.size() ? found_.proved[i].from : to; };
    const auto is_open = [&](std::size_t i) {
      return low(i) < high(i) || (i > 0 && i < found_.proved.size() && !are_joined(i));
    };
    // Unproved loads whose distance is below the width of an event become one stretch. Proved loads between them are
    // useless.
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i <= found_.proved.size(); ++i) {
      if (!is_open(i)) continue;
      if (!open.empty() && low(i) - high(open.back()) <= options_.width * high(i)) {
        found_.proved.erase(found_.proved.begin() + static_cast<std::ptrdiff_t>(open.back()),
                            found_.proved.begin() + static_cast<std::ptrdiff_t>(i));
        i = open.back();
      } else {
        open.push_back(i);
      }
    }
    std::vector<LoadStretch> result;
    auto next = open.begin();
    for (std::size_t i = 0; i <= found_.proved.size(); ++i) {
      if (next != open.end() && *next == i) {
        result.push_back(certify_load_range(i, low(i), high(i)));
        ++next;
      }
      if (i < found_.proved.size()) result.push_back(found_.proved[i]);
    }
    return result;
  }

 private:
  /// Fills the loads from `low` to `high`. A part in which almost nothing can be proved stays open. Parallel tasks get
  /// half of the budget each.
  Found fill(const Rational& low, const Rational& high, int depth, WorkBudget& work) {
    Found found;
    if (depth == 0 || high - low <= options_.width * high) return found;
    if (work.is_spent()) {
      found.fail((low + high) / 2, "the budget of work is spent");
      return found;
    }
    // For a closing gap, a proof at its first load is sufficient.
    if (has_notch_ && !options_.intervals_alone) {
      const std::optional<SolvedLoad> first = start_at(low, found, work);
      const std::optional<Rational> up = first ? close_gap(*first, high, found, work) : std::nullopt;
      if (up) {
        found.add(fill(*up, high, depth - 1, work));
        return found;
      }
    }
    // An event may lie exactly at one of these loads, especially if the data are round numbers.
    for (const int sixteenths : {7, 11, 4, 14, 1}) {
      const Rational load = low + (high - low) * Rational(sixteenths, 16);
      const std::optional<SolvedLoad> start = start_at(load, found, work);
      if (!start) continue;
      Found from_here;
      const std::optional<Rational> closed =
          options_.intervals_alone ? std::nullopt : close_gap(*start, high, from_here, work);
      const WorkBudget half = work.half();
      const auto upwards = [&] { return closed ? March{*closed, {}, half} : march(*start, high, half); };
      const auto downwards = [&] { return march(*start, low, work); };
      std::pair<March, March> marches = threads_.both(upwards, downwards);
      auto& up = marches.first;
      auto& down = marches.second;
      work = down.rest;
      work.give_back(up.rest);
      from_here.add(std::move(up.found));
      from_here.add(std::move(down.found));
      const bool hardly_any = (up.reached - down.reached) * 64 < high - low;
      if (hardly_any) from_here.proved.clear();
      found.add(std::move(from_here));
      if (hardly_any) continue;
      WorkBudget for_above = work.half();
      auto [below, above] = threads_.both([&] { return fill(low, down.reached, depth - 1, work); },
                                          [&] { return fill(up.reached, high, depth - 1, for_above); });
      work.give_back(for_above);
      found.add(std::move(below));
      found.add(std::move(above));
      return found;
    }
    return found;
  }

  std::optional<SolvedLoad> start_at(const Rational& load, Found& found, WorkBudget& work) {
    const std::optional<ApproximateContact> contact = contact_at_(load);
    if (!contact) return found.fail(load, "the solver finds no solution");
    const ContactStart start(problem_, *contact);
    if (std::string fault = start.topology.fault(problem_); !fault.empty()) return found.fail(load, std::move(fault));
    KrawczykResult zero = enclose_zero(problem_.for_loads(load, load), start.box(options_.bits), rules_, work);
    if (!zero.proved) return found.fail(load, std::move(zero.reason));
    return SolvedLoad{load, std::move(zero.box)};
  }

  /// If the contact has a gap that can only close: proves all loads up to the closing load, and then as many as
  /// possible up to `limit`. Returns the load reached; absent if the contact is of another kind, or not proved.
  std::optional<Rational> close_gap(const SolvedLoad& here, const Rational& limit, Found& found, WorkBudget& work) {
    const std::optional<ContactBox> full = closed_gap(problem_, here.zero);
    if (!full) return std::nullopt;
    const auto from = full_contact_from(problem_, *full, here.load, limit, options_.width, rules_, work);
    if (!from || from->refuted == here.load) return std::nullopt;
    const ReducedProblem at_load = problem_.for_loads(here.load, here.load);
    ContactBox box = here.zero;
    const Ball width = power(Ball(2), -static_cast<int>(options_.bits) / 2);
    for (Ball& h : box.log_offsets) h = Ball::plus_or_minus(h, width);
    KrawczykResult zero = prove_zero(at_load, box, rules_, work);
    const ContactBox image = zero.box;
    ContactProof proof = prove_signs(at_load, std::move(zero), rules_, work);
    if (!proof.proved) return found.fail(here.load, std::move(proof.reason));
    LoadInterval first{here.load, here.load, image, image, std::move(box), std::move(proof)};
    found.proved.push_back({Stretch::closing, here.load, from->refuted, std::move(first), {}});
    if (!from->proved && from->refuted < limit) found.fail(limit, "whether the gap has closed is not decided");
    if (!from->proved) return from->refuted;
    March onward = march({*from->proved, *full}, limit, work);
    work = onward.rest;
    found.add(std::move(onward.found));
    return onward.reached;
  }

  /// Makes steps towards `limit`, as far as intervals are proved.
  March march(SolvedLoad here, const Rational& limit, WorkBudget work) {
    here.zero = with_nearest_anchors(problem_, here.zero);
    Found found;
    std::optional<SolvedLoad> before;
    Rational step = (limit - here.load) / 4;
    const Rational least = options_.width * std::min(here.load, limit) / 8;
    // The number of successful proofs before a longer step is tried. It grows next to an event, where longer steps
    // fail.
    constexpr int most_patience = 16;
    int patience = 2;
    int proved_in_turn = 0;
    bool grown = false;
    while (here.load != limit) {
      const Rational most = options_.longest * here.load;
      if (abs(step) > most) step = limit > here.load ? most : -most;
      if (abs(limit - here.load) <= abs(step)) step = limit - here.load;
      std::optional<std::pair<SolvedLoad, SolvedLoad>> next = stepped(before, here, here.load + step, found, work);
      if (!next) {
        if (grown) patience = std::min(2 * patience, most_patience);
        grown = false;
        proved_in_turn = 0;
        if (abs(step) < least || work.is_spent()) break;
        step /= 2;
        continue;
      }
      before = std::move(next->first);
      here = std::move(next->second);
      here.zero = with_nearest_anchors(problem_, here.zero);
      if (grown) patience = 2;
      grown = ++proved_in_turn >= patience;
      if (!grown) continue;
      proved_in_turn = 0;
      step *= 2;
    }
    return {here.load, std::move(found), work};
  }

  /// Proves the loads between here and `load`. Returns the zeros at both; absent if the proof fails.
  std::optional<std::pair<SolvedLoad, SolvedLoad>> stepped(const std::optional<SolvedLoad>& before,
                                                           const SolvedLoad& here, const Rational& load, Found& found,
                                                           WorkBudget& work) {
    const bool upwards = here.load < load;
    const Rational& from = upwards ? here.load : load;
    const Rational& to = upwards ? load : here.load;
    LoadInterval interval =
        prove_loads(problem_, from, to, predicted(problem_, before, here, (from + to) / 2), rules_, work);
    if (!interval.proof.proved) return found.fail(load, interval.proof.reason);
    std::pair zeros(SolvedLoad{here.load, interval.at_from}, SolvedLoad{load, interval.at_to});
    if (!upwards) std::swap(zeros.first.zero, zeros.second.zero);
    found.proved.push_back({Stretch::proved, from, to, std::move(interval), {}});
    return zeros;
  }

  /// True if stretch i and the one before it, which meet, are joined. (For a closing gap no box contains the zero at
  /// the last load.)
  bool are_joined(std::size_t i) {
    const LoadStretch& before = found_.proved[i - 1];
    WorkBudget work;
    return before.kind == Stretch::proved &&
           enclosure::are_joined(*before.interval, *found_.proved[i].interval, rules_, work);
  }

  /// Returns the stretch before the proved interval i, from `low` to `high`.
  LoadStretch certify_load_range(std::size_t i, const Rational& low, const Rational& high) const {
    const bool inside = i > 0 && i < found_.proved.size();
    if (inside) {
      const ContactBox& before = found_.proved[i - 1].interval->at_to;
      const ContactBox& after = found_.proved[i].interval->at_from;
      const bool same = with_anchors_of(problem_, before, after.topology).has_value();
      if (low < high && !same) return {Stretch::event, low, high, {}, contact_change(problem_, before, after)};
      const char* const no_branch = same ? "whether the solutions on both sides are one branch is not proved"
                                         : "two solutions are proved at this load";
      if (low == high) return {Stretch::open, low, high, {}, no_branch};
    }
    // The reason of the last attempt is the best one, because that was the shortest interval.
    std::string reason = "nothing was tried";
    for (const Failure& failure : found_.failures) {
      if (low <= failure.load && failure.load <= high) reason = failure.reason;
    }
    return {Stretch::open, low, high, {}, reason};
  }

  ReducedProblem problem_;
  const ContactAtLoad& contact_at_;
  LoadPathOptions options_;
  JacobiRules rules_;
  bool has_notch_ = false;
  TaskThreads threads_;
  Found found_;
};

}  // namespace

std::vector<LoadStretch> follow_loads(const ContactProblem& problem, const Rational& from, const Rational& to,
                                      const ContactAtLoad& contact_at, const LoadPathOptions& options) {
  if (from <= 0 || to <= from) {
    throw InvalidData("load", "these are no loads from the smaller to the larger", "0 < from < to",
                      "from " + to_string(from) + " to " + to_string(to));
  }
  if (options.width <= 0) {
    throw InvalidData("width", "an event has no width", "0 < width", to_string(options.width));
  }
  const std::optional<ApproximateContact> largest = contact_at(to);
  const Frame frame = frame_of(problem, largest.value_or(ApproximateContact{}));
  return Follower(problem, frame, contact_at, options).follow(from, to);
}

}  // namespace steadyslide::enclosure
