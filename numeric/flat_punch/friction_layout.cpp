#include "numeric/flat_punch/friction_layout.hpp"

#include <stdexcept>

namespace steadyslide::numeric {

template <Real R>
FrictionLayout<R>::FrictionLayout(const std::vector<R>& lengths, const std::vector<Rational>& s) {
  if (lengths.empty() || lengths.size() != s.size()) throw std::invalid_argument("a strip has a length and an s");
  for (std::size_t k = 0; k < s.size(); ++k) {
    if (!(lengths[k] > 0)) throw std::invalid_argument("a strip has a length > 0");
    const Exponent angle = Exponent::angle(s[k]);
    strips_.push_back(
        {lengths[k], length_, R(0), to_real<R>(angle), to_real<R>(half - angle), to_real<R>(half + angle)});
    length_ += lengths[k];
  }
  // From the right as a sum, too: a difference would lose a last strip that is short.
  R from_right = 0;
  for (auto strip = strips_.rbegin(); strip != strips_.rend(); ++strip) {
    strip->from_right = from_right;
    from_right += strip->length;
  }
}

template <Real R>
FrictionLayout<R> FrictionLayout<R>::of(const ContactProblem& problem) {
  std::vector<Rational> ends{problem.indenter().left()};
  ends.insert(ends.end(), problem.friction().jumps().begin(), problem.friction().jumps().end());
  ends.push_back(problem.indenter().right());
  std::vector<R> lengths;
  std::vector<Rational> s;
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    lengths.push_back(to_real<R>(ends[k + 1] - ends[k]));
    s.push_back(problem.coupled_friction(k));
  }
  return {lengths, s};
}

template <Real R>
FrictionLayout<R> FrictionLayout<R>::periodic(const std::vector<Rational>& shares, const std::vector<Rational>& s,
                                              int periods) {
  std::vector<R> lengths;
  std::vector<Rational> all;
  for (int k = 0; k < periods; ++k) {
    for (const Rational& share : shares) lengths.push_back(to_real<R>(2 * share / periods));
    all.insert(all.end(), s.begin(), s.end());
  }
  return {lengths, all};
}

template <Real R>
R FrictionLayout<R>::moment(int j) const {
  R sum = 0;
  for (const FrictionStrip<R>& strip : strips_) {
    sum += strip.alpha * (2 * strip.length / length_) * (j == 0 ? R(1) : middle(strip));
  }
  return sum;
}

template class FrictionLayout<double>;
template class FrictionLayout<Real50>;
template class FrictionLayout<Real100>;

}  // namespace steadyslide::numeric
