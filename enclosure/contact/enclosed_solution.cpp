#include "enclosure/contact/enclosed_solution.hpp"

namespace steadyslide::enclosure {

using Kind = ContactTopology::Kind;

EnclosedSolution::EnclosedSolution(ContactProblem problem, const ContactProof& proof)
    : problem_(std::move(problem)),
      bits_(proof.bits),
      reduced_(std::make_shared<ReducedProblem>(proof.problem)),
      rules_(std::make_shared<JacobiRules>(bits_)),
      unit_(reduced_->frame.unit, bits_),
      origin_(reduced_->frame.origin, bits_),
      form_(proof.box.form(*reduced_, count_for(bits_), *rules_)),
      tilt_(proof.box.tilt) {}

Ball EnclosedSolution::user(const Ball& xi) const { return origin_ + unit_ * xi; }

Ball EnclosedSolution::amplitude(std::size_t j, std::size_t segment) const {
  const bool at_left = j == segment;
  const Ball zero(0, bits_);
  const Place at{segment, at_left ? zero : set().length(segment), at_left ? set().length(segment) : zero};
  const LocalValue b = form_.regular_factor(at);
  return Ball(set().sign(segment)) * set().cos_alpha(segment) * form_.modulus(at, j) * b.regular;
}

EnclosedSolution::End EnclosedSolution::end(std::size_t j) const {
  const ContactTopology::Point& point = set().point(j);
  const std::size_t segment = point.kind == Kind::begins ? j : j - 1;
  SingularKind kind = SingularKind::free;
  if (!point.vanishes) kind = j == 0 || j + 1 == set().points() ? SingularKind::edge : SingularKind::step;
  // An exact place of the data stays exact.
  const Ball x =
      point.beside
          ? user(set().x(j))
          : Ball(Rational(reduced_->frame.origin + reduced_->frame.unit * reduced_->anchors[point.anchor].x), bits_);
  return {x, kind, set().exponent(j), -amplitude(j, segment) * power(unit_, -set().power(j))};
}

std::vector<std::pair<EnclosedSolution::End, EnclosedSolution::End>> EnclosedSolution::contact() const {
  std::vector<std::pair<End, End>> result;
  for (const ContactSet::Run& run : set().components()) result.emplace_back(end(run.first), end(run.last + 1));
  return result;
}

std::vector<EnclosedSolution::Point> EnclosedSolution::singular_points() const {
  std::vector<Point> result;
  const Ball pi = Ball::pi(bits_);
  for (std::size_t j = 1; j + 1 < set().points(); ++j) {
    if (set().point(j).is_end() || !set().in_contact(j)) continue;
    const ReducedProblem::Anchor& anchor = reduced_->anchors[set().point(j).anchor];
    const Rational& s_left = set().interval(j - 1).s;
    const Rational& s_right = set().interval(j).s;
    const Rational wedge = set().interval(j).slope(anchor.x) - set().interval(j - 1).slope(anchor.x);
    const bool jumps = s_left != s_right;
    if (!jumps && wedge == 0) continue;
    const Ball x(Rational(reduced_->frame.origin + reduced_->frame.unit * anchor.x), bits_);
    if (jumps) {
      const Ball theta = -amplitude(j, j) / set().cos_alpha(j) * power(unit_, -set().power(j));
      result.push_back({x, wedge == 0 ? SingularKind::friction_jump : SingularKind::wedge_and_jump, set().exponent(j),
                        theta, Ball(Rational(wedge / (s_right - s_left)), bits_)});
      continue;
    }
    // The limit from the left of t - theta log|x - c|/pi, |x - c| in the user's unit.
    const Ball theta(Rational(wedge / (1 + s_left * s_left)), bits_);
    result.push_back({x, SingularKind::wedge, std::nullopt, theta, amplitude(j, j - 1) - theta * log(unit_) / pi});
  }
  return result;
}

EnclosedSolution::Resultants EnclosedSolution::resultants() const {
  const std::size_t values = problem_.friction().values().size();
  std::vector<Ball> loads(values, Ball(0, bits_));
  // The intervals of the reduced problem are the pieces of the problem.
  const std::vector<ContactProblem::Piece> pieces = problem_.pieces();
  std::size_t piece = 0;
  for (std::size_t k = 0; k < set().segments(); ++k) {
    if (k > 0 && !set().point(k).beside) ++piece;
    if (set().in_contact(k)) loads[pieces[piece].friction] -= unit_ * ContactLoad(form_).load_on(k);
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
  return Ball(problem_.elasticity().compliance(), bits_) * tilt_;
}

std::optional<Place> EnclosedSolution::place(const Rational& x, Side side) const {
  const Rational xi = (x - reduced_->frame.origin) / reduced_->frame.unit;
  const Ball at(xi, bits_);
  const auto exact = [&](std::size_t j) {
    return set().point(j).beside ? std::nullopt : std::optional(reduced_->anchors[set().point(j).anchor].x);
  };
  for (std::size_t k = 0; k < set().segments(); ++k) {
    const std::optional<Rational> left = exact(k);
    const std::optional<Rational> right = exact(k + 1);
    const bool after = left ? (side == Side::right ? xi >= *left : xi > *left) : at > set().x(k);
    const bool before = right ? (side == Side::left ? xi <= *right : xi < *right) : at < set().x(k + 1);
    if (!after || !before) continue;
    const Ball from_left = left ? Ball(Rational(xi - *left), bits_) : at - set().x(k);
    const Ball from_right = right ? Ball(Rational(*right - xi), bits_) : set().x(k + 1) - at;
    return Place{k, from_left, from_right};
  }
  return std::nullopt;
}

Ball EnclosedSolution::traction_at(const Place& place) const {
  if (!set().in_contact(place.segment)) return Ball(0, bits_);
  return Ball(set().sign(place.segment)) * set().cos_alpha(place.segment) * form_.modulus(place) *
         form_.regular_factor(place).value();
}

Ball EnclosedSolution::slope_at(const Place& place) const {
  const Ball profile = form_.profile_slope(place);
  const Ball c(problem_.elasticity().compliance(), bits_);
  if (set().in_contact(place.segment)) return c * profile;
  return c * (profile - Ball(set().sign(place.segment)) * form_.modulus(place) * form_.regular_factor(place).value());
}

EnclosedSolution::TwoSided EnclosedSolution::traction(const Rational& x) const {
  const auto limit = [&](Side side) {
    const std::optional<Place> at = place(x, side);
    return at ? traction_at(*at) : Ball::unknown(bits_);
  };
  return {limit(Side::left), limit(Side::right)};
}

EnclosedSolution::TwoSided EnclosedSolution::slope(const Rational& x) const {
  const auto limit = [&](Side side) {
    const std::optional<Place> at = place(x, side);
    return at ? slope_at(*at) : Ball::unknown(bits_);
  };
  return {limit(Side::left), limit(Side::right)};
}

}  // namespace steadyslide::enclosure
