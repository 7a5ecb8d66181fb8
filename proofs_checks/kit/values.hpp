#pragma once
// Measured and predicted values by name. The runner compares them without knowing how they were made. It compares in
// one type at every precision of the measurement, so that it is compiled once.

#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "proofs_checks/kit/numbers.hpp"

namespace steadyslide::proofs_checks {

/// Returns 1e-94: far below every tolerance of the ledger, and still visible to exact arithmetic.
Rational tiny();

/// A measured rate of convergence.
struct Order {
  double rate = 0;
  double error_bar = 0;  ///< one standard deviation
  std::string detail = {};

  bool operator==(const Order&) const = default;
};

/// A number with its error bar, fitted on cells. Its prediction is a number, its tolerance a number of error bars.
struct Fitted {
  double value = 0;
  double error_bar = 0;

  bool operator==(const Fitted&) const = default;
};

/// A value of a quantity. Numbers are compared to a tolerance, orders and fitted numbers within their error bars; the
/// other types are decided exactly.
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

  /// Returns the value of this name, or null if there is none.
  const Value* find(std::string_view name) const;
  /// Returns the number of this name, which the caller may change. Throws std::logic_error if there is none.
  Number& operator[](std::string_view name);
  /// Replaces the value of this name. Does nothing if the case does not have this quantity.
  void set(std::string_view name, Value value);
  /// Replaces the values that are present in both.
  void set(const Values& values);
  /// Multiplies the numbers of these names by a factor. Names that are not present are ignored.
  void scale(const std::vector<std::string>& names, const Number& factor);

  auto begin() const { return all_.begin(); }
  auto end() const { return all_.end(); }

 private:
  std::vector<Named> all_;
};

}  // namespace steadyslide::proofs_checks
