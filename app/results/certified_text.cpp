#include "app/results/certified_text.hpp"

#include <algorithm>

#include "enclosure/loads/tolerance_band.hpp"
#include "library/answer/enclosed_contact.hpp"
#include "library/proof/certificate.hpp"
#include "library/solve/warnings.hpp"

namespace steadyslide::app {
namespace {

using enclosure::Ball;
using enclosure::EnclosedSolution;

/// The largest relative radius among numbers that are not 0.
Ball relative_radius(const std::vector<Ball>& balls) {
  Ball largest(0);
  for (const Ball& ball : balls) {
    if (!ball.is_zero()) largest = max(largest, ball.radius() / abs(ball));
  }
  return largest.upper();
}

class CertifiedWriter {
 public:
  CertifiedWriter(SolutionText& text, const Problem& problem, const enclosure::ContactProof& proof, int digits,
                  unsigned threads)
      : text_(text), problem_(problem.contact), solution_(problem.contact, proof, threads), digits_(digits) {}

  void write(const std::vector<Rational>& places, const FieldWanted& field) {
    const EnclosedContact solved(problem_, solution_);
    std::vector<Ball> ends;
    std::vector<Ball> intensities;
    set_contact(text_, solved.contact(), *this);
    for (const auto& [left, right, width] : solved.contact()) {
      ends.insert(ends.end(), {left.x, right.x});
      intensities.insert(intensities.end(), {left.intensity, right.intensity});
    }
    const Ball whole = solved.width();
    for (Ball& x : ends) x = whole + (x - x.midpoint());  // errors relative to the contact's length

    const std::vector<EnclosedSolution::Point> points = solution_.singular_points();
    set_singular_points(text_, points, *this);
    for (const EnclosedSolution::Point& point : points) intensities.push_back(point.intensity);

    text_.resultants = answer::resultants_of<ResultantsText>(solved, *this);
    // A number without an enclosure is not shown.
    text_.component_load.assign(text_.contact.size(), {});
    if (text_.contact.size() == 1) text_.component_load = {number(solved.forces().normal)};

    text_.samples.clear();
    for (const Rational& x : places) text_.samples.push_back(sample(x));
    const std::optional<LargestStressText> largest = std::move(text_.field.largest_stress);
    text_.field = field_text(problem_, solution_, field, digits_);
    if (largest) text_.field.largest_stress = lower_bound(problem_, solution_, *largest, digits_);
    text_.errors = {{"ends", upper_text(relative_radius(ends))},
                    {"traction", upper_text(relative_radius(intensities))},
                    {"resultants", upper_text(relative_radius(solved.forces().load_share))}};
  }

  // Makes texts of numbers (solution_text.hpp), and of quantities of the table (library/answer/quantities.hpp).
  NumberText number(const Ball& ball) const { return number_text(ball, digits_); }
  NumberText intensity(const Ball& ball) const { return number(ball); }
  NumberText operator()(const Ball& ball) const { return number(ball); }
  static bool told() { return true; }
  int digits() const { return digits_; }
  /// A finite largest pressure is not enclosed. An infinite one stays as the solver found it.
  ResultantsText::Largest operator()(EnclosedContact::NotEnclosed) const {
    const ResultantsText::Largest& found = text_.resultants.largest_pressure;
    return found.value.value == "inf" ? found : ResultantsText::Largest{};
  }

 private:
  /// One number if the limits may be equal.
  LimitText limits(const EnclosedSolution::TwoSided& limits, const EnclosedSolution::TwoSided& traction) const {
    const auto& [left, right] = limits;
    if (left.is_infinity() || right.is_infinity()) {
      return infinite_limits({number(left), number(right)}, {number(traction.left), number(traction.right)});
    }
    if (!left.overlaps(right)) return {number(left), number(right)};
    const NumberText both = number(Ball::hull(left, right));
    return {both, both};
  }

  SampleText sample(const Rational& x) const {
    const EnclosedSolution::TwoSided traction = solution_.traction(x);
    const auto shear = [&](const Ball& t, Side side) {
      const Rational ratio = problem_.shear_ratio(problem_.friction().piece(x, side));
      if (ratio == 0) return Ball(0, t.bits());  // also under an infinite pressure
      return t.is_infinity() ? Ball::infinity(-sign(ratio), t.bits()) : Ball(ratio, t.bits()) * t;
    };
    const std::optional<Ball> gap = solution_.gap(x);
    const EnclosedSolution::TwoSided slope = solution_.slope(x);
    return {full_number(x, digits_),
            limits(traction, traction),
            limits({shear(traction.left, Side::left), shear(traction.right, Side::right)}, traction),
            gap ? number(*gap) : NumberText{},
            limits(slope, slope),
            {},
            {},
            {},
            friction(x)};
  }

  std::pair<std::string, std::string> friction(const Rational& x) const {
    const Indenter& indenter = problem_.indenter();
    if (x < indenter.left() || x > indenter.right()) return {};
    const FrictionProfile& profile = problem_.friction();
    return {exact_text(profile.at(x, Side::left)), exact_text(profile.at(x, Side::right))};
  }

  SolutionText& text_;
  const ContactProblem& problem_;
  EnclosedSolution solution_;
  int digits_;
};

}  // namespace

void certify(SolutionText& text, const Problem& problem, const enclosure::ContactProof& proof,
             const SolutionWanted& wanted, unsigned threads) {
  ProofText told{proof.proved, proof.reason, {}, proof.bits, proof.intervals, {}};
  if (proof.where) told.x = format_number(*proof.where, 6);
  if (!proof.proved) {
    if (text.failed_condition.empty()) text.failed_condition = "not proved: " + told.why_not();
    text.proof = std::move(told);
    return;
  }
  std::vector<Rational> places = wanted.at;
  for (std::size_t i = places.size(); i < text.samples.size(); ++i) {
    places.push_back(parse_rational(text.samples[i].x));
  }
  text.digits = wanted.digits;
  CertifiedWriter(text, problem, proof, wanted.digits, threads).write(places, wanted.field);
  told.certificate = certificate(problem.contact, proof, wanted.digits);
  text.proof = std::move(told);
  // The proof replaces the conditions that the approximation failed.
  text.failed_condition.clear();
  std::erase_if(text.warnings,
                [](const std::string& line) { return line.find(estimated_error_warning) != std::string::npos; });
  text.in_range = true;
}

void add_bound(SolutionText& text, const Problem& problem, const enclosure::CellBound& bound) {
  BoundText told{bound.proved, bound.reason, bound.cells, {}, {}, {}};
  if (bound.proved) {
    // A bound has few digits: its error is shown with the value.
    const auto told_with_error = [](const Ball& ball) {
      constexpr int digits = 6;
      NumberText number = number_text(ball, digits);
      number.shown = number.value + " +/- " + number.error;
      return number;
    };
    told.certificate = certificate(problem.contact, bound);
    told.energy = upper_text(bound.energy);
    told.largest_gap = upper_text(bound.largest_gap);
    ResultantsText& resultants = text.resultants;
    resultants.load_share.clear();
    for (const Ball& share : bound.load_share) resultants.load_share.push_back(told_with_error(share));
    resultants.effective_friction = told_with_error(bound.effective_friction);
    resultants.friction_force = told_with_error(bound.effective_friction * Ball(problem.contact.load(), 64));
  } else if (text.failed_condition.empty()) {
    text.failed_condition = "not proved: " + bound.reason;
  }
  text.bound = std::move(told);
}

StretchText stretch_text(const enclosure::LoadStretch& stretch, int digits) {
  using Kind = enclosure::LoadStretch::Kind;
  const bool is_proved = stretch.kind == Kind::proved || stretch.kind == Kind::closing;
  const char* status = is_proved ? "proved" : stretch.kind == Kind::event ? "event" : "open";
  return {full_number(stretch.from, digits), full_number(stretch.to, digits), status, stretch.words};
}

namespace {

constexpr enclosure::Bits tolerance_bits = 64;
constexpr int shown_digits = 6;

/// Returns the number with its error; unknown if the text is empty.
Ball ball_of(const NumberText& number) {
  if (number.value.empty()) return Ball::unknown(tolerance_bits);
  const auto part = [](const std::string& text) { return Ball(parse_rational(text), tolerance_bits); };
  return Ball::plus_or_minus(part(number.value), part(number.error));
}

IntervalText interval_text(const Ball& ball) {
  return {lower_text(ball, shown_digits), upper_text(ball, shown_digits)};
}

}  // namespace

ToleranceText tolerance_text(const ContactProblem& problem, const Tolerance& tolerance, const ResultantsText& solved) {
  const enclosure::ToleranceBand band(problem, tolerance.profile, tolerance.friction);
  const Ball load(problem.load(), tolerance_bits);
  ToleranceText result;
  result.profile = exact_text(tolerance.profile);
  result.friction = exact_text(tolerance.friction);
  result.energy = upper_text(band.energy());
  result.proved = solved.effective_friction.proved;
  for (std::size_t k = 0; k < solved.load_share.size(); ++k) {
    result.load_share.push_back(interval_text(band.load_share(k, ball_of(solved.load_share[k]))));
    result.proved = result.proved && solved.load_share[k].proved;
  }
  const Ball friction = band.effective_friction(ball_of(solved.effective_friction));
  result.effective_friction = interval_text(friction);
  result.friction_force = interval_text(load * friction);
  return result;
}

}  // namespace steadyslide::app
