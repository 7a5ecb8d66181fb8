#pragma once
// How much work the searches of a proof may take, before it says that nothing is proved: counted, not timed, so that the answer
// is the same on every machine. A unit is a term of a sum in a 64-bit word.

#include <algorithm>
#include <cstdint>

namespace steadyslide::enclosure {

class WorkBudget {
 public:
  /// The budget of one proof. It is spent in five to ten seconds. Most proofs that succeed take a hundredth of it.
  static constexpr std::int64_t usual = 200'000'000;

  explicit WorkBudget(std::int64_t most = usual) : left_(most) {}

  /// Takes what is left, if that is less.
  void take(std::int64_t work) { left_ -= std::min(work, left_); }
  bool is_spent() const { return left_ == 0; }
  std::int64_t left() const { return left_; }
  /// Half of what is left, for a task beside others: what each of them does is not up to who is first.
  WorkBudget half() {
    left_ /= 2;
    return WorkBudget(left_);
  }
  void give_back(const WorkBudget& rest) { left_ += rest.left_; }

 private:
  std::int64_t left_;
};

}  // namespace steadyslide::enclosure
