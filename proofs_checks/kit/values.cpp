#include "proofs_checks/kit/values.hpp"

#include <algorithm>
#include <stdexcept>

namespace steadyslide::proofs_checks {

const Value* Values::find(std::string_view name) const {
  const auto found = std::ranges::find(all_, name, &Named::name);
  return found == all_.end() ? nullptr : &found->value;
}

Value& Values::existing(std::string_view name) {
  const auto found = std::ranges::find(all_, name, &Named::name);
  if (found == all_.end()) throw std::logic_error("no value is called " + std::string(name));
  return found->value;
}

Number& Values::operator[](std::string_view name) {
  if (auto* number = std::get_if<Number>(&existing(name))) return *number;
  throw std::logic_error("not a number: " + std::string(name));
}

void Values::set(std::string_view name, Value value) { existing(name) = std::move(value); }

}  // namespace steadyslide::proofs_checks
