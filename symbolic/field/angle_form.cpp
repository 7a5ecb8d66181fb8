#include "symbolic/field/angle_form.hpp"

#include <cstdlib>

namespace steadyslide::symbolic {

AngleForm::AngleForm(int halves, std::map<std::size_t, int> times) : halves_(halves), times_(std::move(times)) {
  std::erase_if(times_, [](const auto& term) { return term.second == 0; });
}

std::pair<int, int> AngleForm::twice_bounds() const {
  int spread = 0;
  for (const auto& [k, factor] : times_) spread += std::abs(factor);
  return {halves_ - spread, halves_ + spread};
}

AngleForm AngleForm::renamed(const std::vector<std::size_t>& index) const {
  AngleForm result(halves_);
  for (const auto& [k, factor] : times_) result += AngleForm(0, {{index.at(k), factor}});
  return result;
}

Exponent AngleForm::exponent(const std::vector<Rational>& frictions) const {
  Exponent sum(Rational(halves_, 2));
  for (const auto& [k, factor] : times_) {
    const Exponent angle = Exponent::angle(frictions.at(k));
    for (int n = 0; n < std::abs(factor); ++n) sum += factor > 0 ? angle : -angle;
  }
  return sum;
}

AngleForm& AngleForm::operator+=(const AngleForm& other) {
  halves_ += other.halves_;
  for (const auto& [k, factor] : other.times_) {
    if ((times_[k] += factor) == 0) times_.erase(k);
  }
  return *this;
}

AngleForm AngleForm::operator-() const {
  AngleForm result(-halves_);
  for (const auto& [k, factor] : times_) result.times_[k] = -factor;
  return result;
}

}  // namespace steadyslide::symbolic
