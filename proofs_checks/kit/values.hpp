#pragma once
// What a check measures, and what a formula predicts: values by name. The runner compares them without knowing how
// either was made, and whatever the precision of the measurement it compares in one type, so that it is compiled once.

#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "proofs_checks/kit/numbers.hpp"

namespace steadyslide::proofs_checks {

/// 1e-94: far below every tolerance of the ledger, and still visible to exact arithmetic.
Rational tiny();

/// A rate of convergence, measured.
struct Order {
  double rate = 0;
  double error_bar = 0;  ///< one standard deviation
  std::string detail = {};

  bool operator==(const Order&) const = default;
};

/// A number with its error bar, read off cells. What is predicted is a number, the tolerance a number of error bars.
struct Fitted {
  double value = 0;
  double error_bar = 0;

  bool operator==(const Fitted&) const = default;
};

/// Numbers are compared to a tolerance, orders and fits within their error bars; everything else is decided.
using Value = std::variant<Number, Order, Fitted, Exponent, Rational, bool>;

class Values {
 public:
  struct Named {
    Named(std::string n, Value v) : name(std::move(n)), value(std::move(v)) {}
    template <Real R>
    Named(std::string n, const R& number) : Named(std::move(n), Value(Number(number))) {}

    std::string name;
    Value value;
  };

  Values() = default;
  Values(std::initializer_list<Named> all) : all_(all) {}
  void add(Named value) { all_.push_back(std::move(value)); }

  /// Null if there is none of this name.
  const Value* find(std::string_view name) const;
  /// The number of this name, to be changed. Throws std::logic_error if there is none.
  Number& operator[](std::string_view name);
  /// Replaces the value of this name. A case need not have every quantity: without it nothing happens.
  void set(std::string_view name, Value value);
  /// Those values that are here as well.
  void set(const Values& values);
  /// Multiplies the numbers of these names, those that are here.
  void scale(const std::vector<std::string>& names, const Number& factor);

  auto begin() const { return all_.begin(); }
  auto end() const { return all_.end(); }

 private:
  std::vector<Named> all_;
};

}  // namespace steadyslide::proofs_checks
