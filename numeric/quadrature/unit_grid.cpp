#include "numeric/quadrature/unit_grid.hpp"

#include <algorithm>
#include <cmath>

namespace steadyslide::numeric::double_exponential {
namespace {

template <Real R>
R log_two() {
  return log(R(2));
}

template <Real R>
R rise_at(const R& octaves) {
  return pi<R>() / 2 * exp(R(octaves * log_two<R>()));
}

template <Real R>
R fall_at(const R& rise) {
  return pi<R>() * pi<R>() / (4 * rise);
}

}  // namespace

template <Real R>
Integer shifted(const R& x, int shift) {
  Integer result;
  if (x == 0) return result;
  mpz_ptr z = result.backend().data();
  const mpfr_exp_t exponent = mpfr_get_z_2exp(z, x.backend().data()) + shift;
  exponent < 0 ? mpz_tdiv_q_2exp(z, z, static_cast<mp_bitcnt_t>(-exponent))
               : mpz_mul_2exp(z, z, static_cast<mp_bitcnt_t>(exponent));
  return result;
}

template <Real R>
R shifted_back(const Integer& sum, int shift) {
  return ldexp(R(sum), -shift);
}

template <Real R>
std::vector<R> decays(const R& p, const std::vector<R>& rise, std::size_t count) {
  const std::size_t octave = rise.size();
  std::vector<R> falling(std::max(count, octave)), rising(count), result(count);
  for (std::size_t i = 0; i < falling.size(); ++i) {
    falling[i] = i < octave ? R(exp(-p * rise[i])) : R(falling[i - octave] * falling[i - octave]);
  }
  for (std::size_t i = 0; i < count; ++i) {
    const R square = i == 0 ? R(falling[0] * falling[0]) : i < octave ? falling[octave - i] : rising[i - octave];
    rising[i] = i < octave ? R(1 / sqrt(square)) : R(sqrt(square));
    result[i] = falling[i] * rising[i];
  }
  return result;
}

template <Real R>
UnitNode<R> UnitNode<R>::of(const R& rise, const R& fall, const R& decay) {
  const R far = 1 / (1 + decay);
  const R near = decay * far;
  const R both = near * far;
  const R rate = rise + fall;
  return {near, far, log(far), rate, both, both * rate * rate, static_cast<double>(near)};
}

template <Real R>
UnitGrid<R>& UnitGrid<R>::of(int per_octave) {
  static std::mutex mutex;
  static std::map<int, UnitGrid> known;
  const std::lock_guard lock(mutex);
  return known.try_emplace(per_octave, per_octave).first->second;
}

template <Real R>
UnitGrid<R>::UnitGrid(int per_octave) {
  for (int i = 0; i < per_octave; ++i) octave_.push_back(rise_at(R(i) / per_octave));
}

template <Real R>
typename UnitGrid<R>::Numbers UnitGrid<R>::reciprocals(int cell, int reach) {
  const std::lock_guard lock(mutex_);
  Numbers& known = reciprocals_[cell];
  if (known && static_cast<int>(known->size()) > 2 * reach) return known;
  const Nodes nodes = made_nodes(reach + 1);
  const UnitNode<R>& place = made_midpoint(cell);
  const bool right = cell >= 0;
  std::vector<Integer> made;
  for (int i = -reach; i <= reach; ++i) {
    const UnitNode<R>& node = (*nodes)[static_cast<std::size_t>(std::abs(i))];
    // From the end that is nearer to y: distances to it are known best.
    const R& distance = (i > 0) == right ? node.near : node.far;
    made.push_back(shifted(R(1 / (right ? R(place.near - distance) : R(distance - place.near))), bits));
  }
  known = std::make_shared<const std::vector<Integer>>(std::move(made));
  return known;
}

template <Real R>
typename UnitGrid<R>::Nodes UnitGrid<R>::made_nodes(int count) {
  if (!nodes_ || static_cast<int>(nodes_->size()) < count) {
    std::vector<UnitNode<R>> made;
    const auto size = static_cast<std::size_t>(count);
    const std::vector<R> decay = decays(R(1), octave_, size);
    for (std::size_t i = 0; i < size; ++i) {
      const R rise = ldexp(octave_[i % octave_.size()], static_cast<int>(i / octave_.size()));
      made.push_back(UnitNode<R>::of(rise, fall_at(rise), decay[i]));
    }
    nodes_ = std::make_shared<const std::vector<UnitNode<R>>>(std::move(made));
  }
  return nodes_;
}

template <Real R>
const UnitNode<R>& UnitGrid<R>::made_midpoint(int cell) {
  const auto known = midpoints_.find(cell);
  if (known != midpoints_.end()) return known->second;
  const R rise = rise_at(R(std::abs(2 * cell + 1)) / (2 * octave_.size()));
  const R fall = fall_at(rise);
  return midpoints_.emplace(cell, UnitNode<R>::of(rise, fall, exp(R(fall - rise)))).first->second;
}

template <Real R>
R UnitGrid<R>::step() const {
  return log_two<R>() / octave_.size();
}

#define STEADYSLIDE_INSTANTIATE(R)                                                           \
  template Integer shifted(const R& x, int shift);                                           \
  template R shifted_back(const Integer& sum, int shift);                                    \
  template std::vector<R> decays(const R& p, const std::vector<R>& rise, std::size_t count); \
  template struct UnitNode<R>;                                                               \
  template class UnitGrid<R>;
STEADYSLIDE_INSTANTIATE(Real50)
STEADYSLIDE_INSTANTIATE(Real100)
#undef STEADYSLIDE_INSTANTIATE

}  // namespace steadyslide::numeric::double_exponential
