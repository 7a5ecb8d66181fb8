#include "proofs_checks/kit/values.hpp"

#include <algorithm>
#include <stdexcept>

namespace steadyslide::proofs_checks {

Rational tiny() {
  static const Rational value = parse_rational("1e-94");
  return value;
}

const Value* Values::find(std::string_view name) const {
  const auto found = std::ranges::find(all_, name, &Named::name);
  return found == all_.end() ? nullptr : &found->value;
}

Number& Values::operator[](std::string_view name) {
  const auto found = std::ranges::find(all_, name, &Named::name);
  if (found == all_.end()) throw std::logic_error("no value is called " + std::string(name));
  if (auto* number = std::get_if<Number>(&found->value)) return *number;
  throw std::logic_error("not a number: " + std::string(name));
}

void Values::set(std::string_view name, Value value) {
  const auto found = std::ranges::find(all_, name, &Named::name);
  if (found != all_.end()) found->value = std::move(value);
}

void Values::set(const Values& values) {
  for (const Named& named : values) set(named.name, named.value);
}

void Values::scale(const std::vector<std::string>& names, const Number& factor) {
  for (const std::string& name : names) {
    if (find(name)) (*this)[name] *= factor;
  }
}

}  // namespace steadyslide::proofs_checks
