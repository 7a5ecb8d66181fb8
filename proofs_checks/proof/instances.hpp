#pragma once
// Instances of things: records of numbers on which the formulas of words are run. A row of the table "Instances" of a
// facts file says how to draw them:
//
//   | of | quantities |
//   |---|---|
//   | rising-jump | `s_l in [-5, 5]`, `s_r in ]s_l, 9]`, `p = (arctan(s_l) - arctan(s_r))/pi` |
//   | traction, wedge | like wedge, `D in {-1, 0, 1}`, `t(d) = D log(d)/pi`, where `D > 0` |
//   | grows(T) | by solved-loads |
//
// The row is of a thing, of several things together, or of the fact that a rule gives: there the numbers do not depend
// on each other more than the row says, so that each premise of the rule fails in some instances. An interval gives a
// random rational, often an end or 0; braces give one of their values; a name with a bracket is a function; `where`
// drops other instances; `like` begins with the quantities of another row; `by` takes the instances of a solver,
// proofs_checks/instances/. `idle` names a premise of the rule which no instance shows to be needed, `count` says how
// many instances there are, and a quantity `accuracy` how far numbers may differ that are equal.

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "proofs_checks/proof/formula.hpp"

namespace steadyslide::proofs_checks {

struct InstanceRow;

/// How to draw instances.
class InstanceFamily {
 public:
  using RowOf = std::function<const InstanceRow&(const std::string& of)>;

  /// Throws std::logic_error if an item does not have one of the forms above.
  InstanceFamily(const InstanceRow& row, const RowOf& row_of);

  /// Returns the instances, the same at each call: those of the solver, or `count` random ones if the row has no count.
  /// Throws std::logic_error if the conditions exclude nearly all.
  std::vector<Instance> instances(std::size_t count) const;
  const std::set<std::string>& names() const { return names_; }
  const std::vector<std::string>& idle() const { return idle_; }

 private:
  struct Quantity {
    enum class Kind { value, interval, choice, condition };
    Kind kind;
    std::string name;
    std::vector<Formula> formulas;
    bool with_from = false, with_to = false;  ///< the ends of an interval belong to it
  };

  void add(const InstanceRow& row, const RowOf& row_of);
  void add_quantity(const std::string& item);

  std::string of_;
  std::string solver_;
  std::vector<Quantity> quantities_;
  std::map<std::string, Instance::Function> functions_;
  std::set<std::string> names_;
  std::vector<std::string> idle_;
  std::optional<std::size_t> count_;
};

/// Instances that need a solver, by name.
struct InstanceSource {
  std::string_view name;
  std::string_view quantities;  ///< their names, "P, c, t"
  std::vector<Instance> (*instances)();
};
std::span<const InstanceSource> instance_sources();

}  // namespace steadyslide::proofs_checks
