#include "enclosure/contact/enclosed_solution.hpp"

namespace steadyslide::enclosure {

using Kind = ContactTopology::Kind;

namespace {

bool is_in_support(const SurfacePoint& place) {
  return !place.from_left.is_negative() && !place.from_right.is_negative();
}

/// Returns the point of the contact set at exactly this place.
std::optional<std::size_t> point_at(const SurfacePoint& place) {
  if (place.from_left.is_zero()) return place.segment;
  if (place.from_right.is_zero()) return place.segment + 1;
  return std::nullopt;
}

}  // namespace

EnclosedSolution::EnclosedSolution(ContactProblem problem, const ContactProof& proof, unsigned threads)
    : problem_(std::move(problem)),
      bits_(proof.bits),
      reduced_(std::make_shared<ReducedProblem>(proof.problem)),
      rules_(std::make_shared<JacobiRules>(bits_)),
      compliance_(problem_.elasticity().compliance(), bits_),
      unit_(reduced_->frame.unit, bits_),
      origin_(reduced_->frame.origin, bits_),
      form_(proof.box.form(*reduced_, count_for(bits_), *rules_)),
      tilt_(proof.box.tilt),
      threads_(threads) {}

Ball EnclosedSolution::user(const Ball& xi) const { return origin_ + unit_ * xi; }

Ball EnclosedSolution::amplitude(std::size_t j, std::size_t segment) const {
  const SurfacePoint at = set().place_of(j, segment);
  const LocalValue b = form_.regular_factor(at);
  return Ball(set().sign(segment)) * set().cos_alpha(segment) * form_.modulus(at, j) * b.analytic();
}

EnclosedSolution::End EnclosedSolution::end(std::size_t j) const {
  const ContactTopology::Point& point = set().point(j);
  const std::size_t segment = point.kind == Kind::begins ? j : j - 1;
  const SingularKind kind = end_kind(point.vanishes, j == 0 || j + 1 == set().points());
  // A place of the data stays exact.
  const Ball x = point.beside ? user(set().x(j)) : Ball(reduced_->place(point.anchor), bits_);
  return {x, kind, set().exponent(j), -amplitude(j, segment) * power(unit_, -set().power(j))};
}

std::vector<ContactComponentOf<Ball>> EnclosedSolution::contact() const {
  std::vector<ContactComponentOf<Ball>> result;
  for (const ContactSet::Run& run : set().components()) {
    End left = end(run.first), right = end(run.last + 1);
    const Ball width = right.x - left.x;
    result.push_back({std::move(left), std::move(right), width});
  }
  return result;
}

Ball EnclosedSolution::stress_intensity(std::size_t j, const Ball& coefficient) const {
  return coefficient * power(Ball(2) * Ball::pi(bits_), -Ball(set().exponent(j), bits_));
}

std::optional<InnerTerms> EnclosedSolution::inner_terms_at(std::size_t j) const {
  return inner_terms(set().interval(j - 1).s, set().interval(j).s, reduced_->anchors[set().point(j).anchor]);
}

std::vector<EnclosedSolution::Point> EnclosedSolution::singular_points() const {
  std::vector<Point> result;
  const Ball pi = Ball::pi(bits_);
  for (std::size_t j = 0; j < set().points(); ++j) {
    const bool on_left = in_contact_at(j, Side::left), on_right = in_contact_at(j, Side::right);
    if (set().point(j).is_end()) {
      End here = end(j);
      StressIntensityOf<Ball> k;
      (on_left ? k.left : k.right) = stress_intensity(j, here.intensity);
      result.push_back({here.x, here.kind, std::move(here.exponent), here.intensity, Ball(0, bits_), std::move(k)});
      continue;
    }
    if (!on_left || !on_right) continue;
    const std::optional<InnerTerms> terms = inner_terms_at(j);
    if (!terms) continue;
    const Ball x(reduced_->place(set().point(j).anchor), bits_);
    if (local_terms(terms->kind).has_power) {
      const Ball theta = -amplitude(j, j) / set().cos_alpha(j) * power(unit_, -set().power(j));
      const auto beside = [&](std::size_t segment) {
        const Rational& s = set().interval(segment).s;
        return stress_intensity(j, theta) / sqrt(Ball(Rational(1 + s * s), bits_));
      };
      result.push_back(
          {x, terms->kind, set().exponent(j), theta, Ball(terms->constant, bits_), {beside(j - 1), beside(j)}});
      continue;
    }
    // The limit from the left of t - theta log|x - c|/pi, |x - c| in the user's unit.
    const Ball theta(terms->logarithm, bits_);
    result.push_back({x, terms->kind, std::nullopt, theta, amplitude(j, j - 1) - theta * log(unit_) / pi, {}});
  }
  return result;
}

EnclosedSolution::Resultants EnclosedSolution::resultants() const {
  const std::size_t values = problem_.friction().values().size();
  std::vector<Ball> loads(values, Ball(0, bits_));
  for (std::size_t k = 0; k < set().segments(); ++k) {
    if (set().in_contact(k)) loads[set().interval(k).friction] -= unit_ * ContactLoad(form_, threads_).load_on(k);
  }
  Resultants result{Ball(0, bits_), Ball(0, bits_), Ball(0, bits_), Ball(0, bits_), {}};
  for (const Ball& load : loads) result.normal += load;
  const Ball load(problem_.load(), bits_);
  for (std::size_t k = 0; k < values; ++k) {
    // The load is known exactly.
    result.load_share.push_back(loads[k] / load);
    result.effective_friction += Ball(problem_.friction().values()[k], bits_) * result.load_share[k];
  }
  result.tangential = result.effective_friction * load;
  result.centre_of_pressure = user(ContactConditions(form_).centre_of_pressure());
  return result;
}

std::optional<Ball> EnclosedSolution::tilt() const {
  if (!problem_.load_at()) return std::nullopt;
  return compliance_ * tilt_;
}

std::optional<Rational> EnclosedSolution::exact(std::size_t j) const {
  if (set().point(j).beside) return std::nullopt;
  return reduced_->anchors[set().point(j).anchor].x;
}

SurfacePoint EnclosedSolution::seen_from(std::size_t segment, const Rational& xi) const {
  const Ball at(xi, bits_);
  const std::optional<Rational> left = exact(segment);
  const std::optional<Rational> right = exact(segment + 1);
  return {segment, left ? Ball(Rational(xi - *left), bits_) : at - set().x(segment),
          right ? Ball(Rational(*right - xi), bits_) : set().x(segment + 1) - at};
}

std::optional<ContactPanel::DistanceRange> EnclosedSolution::range(std::size_t segment, const Rational& from,
                                                                   const Rational& to) const {
  const Ball zero(0, bits_);
  const SurfacePoint first = seen_from(segment, from);
  const SurfacePoint last = seen_from(segment, to);
  if (first.from_right <= zero || last.from_left <= zero) return std::nullopt;
  const auto clipped = [&](const Ball& inside, const Ball& beyond, const Ball& end) {
    if (beyond <= zero) return end;
    return beyond > zero ? inside : Ball::unknown(bits_);
  };
  return ContactPanel::DistanceRange{clipped(first.from_left, first.from_left, zero),
                                     clipped(last.from_left, last.from_right, set().length(segment))};
}

std::optional<SurfacePoint> EnclosedSolution::place(const Rational& x, Side side) const {
  const Rational xi = (x - reduced_->frame.origin) / reduced_->frame.unit;
  const Ball at(xi, bits_);
  const auto segment_at = [&]() -> std::optional<std::size_t> {
    if (xi <= reduced_->anchors.front().x && (side == Side::left || xi < reduced_->anchors.front().x)) return 0;
    for (std::size_t k = 0; k < set().segments(); ++k) {
      const std::optional<Rational> right = exact(k + 1);
      if (right ? (side == Side::left ? xi <= *right : xi < *right) : at < set().x(k + 1)) return k;
      if (!right && !(at > set().x(k + 1))) return std::nullopt;
    }
    return set().segments() - 1;
  };
  const std::optional<std::size_t> k = segment_at();
  if (!k) return std::nullopt;
  return seen_from(*k, xi);
}

bool EnclosedSolution::in_contact_at(std::size_t j, Side side) const {
  if (side == Side::left) return j > 0 && set().in_contact(j - 1);
  return j < set().segments() && set().in_contact(j);
}

Ball EnclosedSolution::traction_limit(std::size_t j, Side side) const {
  if (!in_contact_at(j, side)) return Ball(0, bits_);
  const std::size_t segment = side == Side::left ? j - 1 : j;
  if (set().point(j).is_end() || !set().is_regular(j)) {
    if (set().power(j).is_negative()) return Ball::infinity(-1, bits_);
    if (set().point(j).is_end()) return Ball(0, bits_);
  }
  const std::optional<InnerTerms> terms = inner_terms_at(j);
  if (!terms) return amplitude(j, segment);
  return set().is_regular(j) ? Ball::infinity(-1, bits_) : Ball(terms->constant, bits_);
}

Ball EnclosedSolution::traction_at(const SurfacePoint& place) const {
  if (!is_in_support(place) || !set().in_contact(place.segment)) return Ball(0, bits_);
  return Ball(set().sign(place.segment)) * set().cos_alpha(place.segment) * form_.modulus(place) *
         form_.regular_factor(place).value();
}

Ball EnclosedSolution::slope_limit(std::size_t j, Side side) const {
  const bool contact = in_contact_at(j, side);
  const ContactTopology::Point& point = set().point(j);
  if (!contact && point.is_end() && !point.vanishes) return Ball::infinity(side == Side::left ? -1 : 1, bits_);
  const auto beside = [&](bool left) { return set().place_of(j, left ? j - 1 : j); };
  // At a free end the surface continues along the profile of the contact.
  if (contact || point.is_end()) return compliance_ * form_.profile_slope(beside((side == Side::left) == contact));
  return slope_at(beside(j == set().segments() || (side == Side::left && j > 0)));
}

Ball EnclosedSolution::slope_at(const SurfacePoint& place) const {
  const Ball profile = form_.profile_slope(place);
  if (is_in_support(place) && set().in_contact(place.segment)) return compliance_ * profile;
  // Beyond all points Y has the sign of z^S.
  int sign = set().sign(place.segment);
  if (place.from_left.is_negative()) sign = set().degree_at_infinity() % 2 == 0 ? 1 : -1;
  if (place.from_right.is_negative()) sign = 1;
  return compliance_ * (profile - Ball(sign) * form_.modulus(place) * form_.regular_factor(place).value());
}

template <class Limit, class Value>
EnclosedSolution::TwoSided EnclosedSolution::two_sided(const Rational& x, Limit limit, Value value) const {
  const auto from = [&](Side side) {
    const std::optional<SurfacePoint> at = place(x, side);
    if (!at) return Ball::unknown(bits_);
    const std::optional<std::size_t> point = point_at(*at);
    return point ? limit(*point, side) : value(*at);
  };
  return {from(Side::left), from(Side::right)};
}

EnclosedSolution::TwoSided EnclosedSolution::traction(const Rational& x) const {
  return two_sided(
      x, [&](std::size_t j, Side side) { return traction_limit(j, side); },
      [&](const SurfacePoint& at) { return traction_at(at); });
}

EnclosedSolution::TwoSided EnclosedSolution::slope(const Rational& x) const {
  return two_sided(
      x, [&](std::size_t j, Side side) { return slope_limit(j, side); },
      [&](const SurfacePoint& at) { return slope_at(at); });
}

std::optional<Ball> EnclosedSolution::gap(const Rational& x) const {
  std::optional<Ball> lowest;  // the lower of the two gaps at a step
  for (const Side side : {Side::left, Side::right}) {
    const std::optional<SurfacePoint> at = place(x, side);
    if (!at) return Ball::unknown(bits_);
    const std::optional<std::size_t> point = point_at(*at);
    // There is no gap outside the support.
    if (!is_in_support(*at) || (point && *point == (side == Side::left ? 0 : set().segments()))) continue;
    const bool contact = set().in_contact(at->segment) || (point && set().point(*point).is_end());
    const Ball here = contact ? Ball(0, bits_) : compliance_ * unit_ * ContactConditions(form_).gap_at(*at);
    lowest = lowest ? min(*lowest, here) : here;
  }
  return lowest;
}

}  // namespace steadyslide::enclosure
