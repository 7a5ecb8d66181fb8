#pragma once
// Gauss-Jacobi rules, each made once: for each number of nodes and pair of powers, balls that are the same only if midpoint
// and radius are. May be shared between threads.

#include <map>
#include <mutex>

#include "enclosure/quadrature/jacobi_rule.hpp"

namespace steadyslide::enclosure {

class JacobiRules {
 public:
  explicit JacobiRules(Bits bits) : bits_(bits) {}

  Bits bits() const { return bits_; }
  std::size_t size() const { return rules_.size(); }

  /// Stays valid as long as this object. Throws as JacobiRule does.
  const JacobiRule& operator()(int count, const Ball& left, const Ball& right);

 private:
  struct Key {
    int count;
    Ball left;
    Ball right;
  };
  struct Before {
    bool operator()(const Key& a, const Key& b) const;
  };

  Bits bits_;
  std::map<Key, JacobiRule, Before> rules_;
  std::mutex in_use_;
};

}  // namespace steadyslide::enclosure
