#pragma once
// The limit of work for the searches of a proof; beyond it the answer is "not proved". Work is counted, not timed, so
// the answer is the same on every machine. A unit is a term of a sum in a 64-bit word.

#include <algorithm>
#include <cstdint>

namespace steadyslide::enclosure {

class WorkBudget {
 public:
  /// The budget of one proof. Spending it takes five to ten seconds. Most successful proofs need a hundredth of it.
  static constexpr std::int64_t usual = 200'000'000;

  explicit WorkBudget(std::int64_t most = usual) : left_(most) {}

  /// Takes this work, or the rest if the rest is less.
  void take(std::int64_t work) { left_ -= std::min(work, left_); }
  bool is_spent() const { return left_ == 0; }
  std::int64_t left() const { return left_; }
  /// Returns half of the rest, for parallel tasks, so that the result of a task does not depend on which is first.
  WorkBudget half() {
    left_ /= 2;
    return WorkBudget(left_);
  }
  void give_back(const WorkBudget& rest) { left_ += rest.left_; }

 private:
  std::int64_t left_;
};

}  // namespace steadyslide::enclosure
