#include "model/contact_problem.hpp"

#include <algorithm>
#include <string>

#include "model/invalid_data.hpp"

namespace steadyslide {

ContactProblem::ContactProblem(Elasticity elasticity, FrictionProfile friction, Indenter indenter, Rational load,
                               Sliding sliding, std::optional<Rational> load_at, Body body)
    : elasticity_(std::move(elasticity)),
      friction_(std::move(friction)),
      indenter_(std::move(indenter)),
      load_(std::move(load)),
      sliding_(sliding),
      load_at_(std::move(load_at)),
      body_(std::move(body)) {
  if (load_ <= 0) throw InvalidData("load", "load out of range", "the load is positive", to_string(load_));
  const auto inside = [this](const Rational& x) { return indenter_.left() < x && x < indenter_.right(); };
  const std::string support = to_string(indenter_.left()) + ", " + to_string(indenter_.right());
  for (std::size_t k = 0; k < friction_.jumps().size(); ++k) {
    if (!inside(friction_.jumps()[k])) {
      throw InvalidData("friction.jumps[" + std::to_string(k) + "]", "jump outside the support",
                        "jumps lie in ]" + support + "[", to_string(friction_.jumps()[k]));
    }
  }
  if (load_at_ && !inside(*load_at_)) {
    throw InvalidData("load_at", "load outside the support", "the load acts in ]" + support + "[",
                      to_string(*load_at_));
  }
  if (elasticity_.indenter()) {
    for (const Indenter::Break& b : indenter_.breaks()) {
      if (b.step == 0 && b.wedge == 0) continue;
      throw InvalidData("indenter.pieces", "elastic indenter with a wedge or a step",
                        "the profile of an elastic indenter is smooth", "at x = " + to_string(b.x));
    }
  }
  check_body();
}

void ContactProblem::check_body() const {
  if (!body_.layers().empty()) {
    if (elasticity_.indenter())
      throw InvalidData("indenter.elastic", "elastic indenter", "on layers the indenter is rigid", "present");
    if (elasticity_.half_space() != body_.layers().front().solid)
      throw InvalidData("the elasticity of a layered body is that of its first layer");
  }
  if (!body_.period()) {
    if (indenter_.harmonics().empty()) return;
    throw InvalidData("indenter.harmonics", "harmonics without a period", "half_space.period gives their length",
                      "absent");
  }
  if (indenter_.right() - indenter_.left() > *body_.period()) {
    throw InvalidData("half_space.period", "period out of range", "it is not shorter than the support",
                      to_string(*body_.period()));
  }
  if (load_at_)
    throw InvalidData("load_at", "free attitude", "with a period the attitude is fixed", to_string(*load_at_));
}

Rational ContactProblem::coupled_friction(std::size_t piece) const {
  const Rational s = elasticity_.gamma() * friction_.values().at(piece);
  return sliding_ == Sliding::plus_x ? s : Rational(-s);
}

Rational ContactProblem::shear_ratio(std::size_t piece) const {
  const Rational& f = friction_.values().at(piece);
  return sliding_ == Sliding::plus_x ? Rational(-f) : f;
}

Rational ContactProblem::origin_of_displacement() const {
  return indenter_.left() <= 0 && indenter_.right() >= 0 ? Rational(0) : indenter_.left();
}

std::vector<ContactProblem::Piece> ContactProblem::pieces() const {
  const std::vector<Rational>& jumps = friction_.jumps();
  std::vector<Piece> result;
  Rational left = indenter_.left();
  std::size_t friction = 0;
  for (std::size_t profile = 0; profile < indenter_.pieces().size(); ++profile) {
    const Rational& to = indenter_.pieces()[profile].to;
    while (left < to) {
      if (friction < jumps.size() && jumps[friction] == left) ++friction;
      const Rational right = friction < jumps.size() ? std::min(jumps[friction], to) : to;
      result.push_back({left, right, friction, profile});
      left = right;
    }
  }
  return result;
}

ContactProblem ContactProblem::with_load(Rational load) const {
  return {elasticity_, friction_, indenter_, std::move(load), sliding_, load_at_, body_};
}

ContactProblem ContactProblem::with_friction(FrictionProfile friction) const {
  return {elasticity_, std::move(friction), indenter_, load_, sliding_, load_at_, body_};
}

ContactProblem ContactProblem::with_indenter(Indenter indenter) const {
  return {elasticity_, friction_, std::move(indenter), load_, sliding_, load_at_, body_};
}

ContactProblem ContactProblem::with_sliding(Sliding sliding) const {
  return {elasticity_, friction_, indenter_, load_, sliding, load_at_, body_};
}

ContactProblem ContactProblem::with_body(Body body) const {
  return {elasticity_, friction_, indenter_, load_, sliding_, load_at_, std::move(body)};
}

ContactProblem ContactProblem::with_jump(const Rational& c, const Rational& height) const {
  return with_friction(friction_.with_jump(c, height));
}

ContactProblem ContactProblem::moved(const Rational& scale, const Rational& shift) const {
  std::optional<Rational> load_at;
  if (load_at_) load_at = scale * *load_at_ + shift;
  const bool to_plus_x = (sliding_ == Sliding::plus_x) != (scale < 0);
  return {elasticity_,
          friction_.moved(scale, shift),
          indenter_.moved(scale, shift),
          load_,
          to_plus_x ? Sliding::plus_x : Sliding::minus_x,
          std::move(load_at),
          body_.scaled(abs(scale))};
}

}  // namespace steadyslide
