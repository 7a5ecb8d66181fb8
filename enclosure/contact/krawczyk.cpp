#include "enclosure/contact/krawczyk.hpp"

#include <arb_mat.h>

#include <algorithm>

namespace steadyslide::enclosure {

int count_for(Bits bits) { return static_cast<int>(bits) / 4 + 4; }

std::vector<Ball> ContactBox::unknowns(bool with_tilt) const {
  std::vector<Ball> result = log_offsets;
  result.insert(result.end(), q.begin(), q.end());
  if (with_tilt) result.push_back(tilt);
  return result;
}

ContactBox ContactBox::with(const std::vector<Ball>& unknowns) const {
  ContactBox result = *this;
  auto next = unknowns.begin();
  for (Ball& x : result.log_offsets) x = *next++;
  for (Ball& x : result.q) x = *next++;
  if (next != unknowns.end()) result.tilt = *next;
  return result;
}

TractionRepresentation ContactBox::form(const ReducedProblem& problem, int count, JacobiRules& rules) const {
  const Bits bits = rules.bits();
  BallPolynomial coefficients;
  for (const Ball& c : q) coefficients.push_back(c.at(bits));
  return {ContactSet(problem, topology, log_offsets, bits), std::move(coefficients), tilt.at(bits), count, rules};
}

ContactStart::ContactStart(const ReducedProblem& problem, const ApproximateContact& contact) {
  using Kind = ContactTopology::Kind;
  const auto anchor_at = [&](const Rational& x) {
    const Rational xi = (x - problem.frame.origin) / problem.frame.unit;
    const auto found = std::find_if(problem.anchors.begin(), problem.anchors.end(),
                                    [&](const ReducedProblem::Anchor& anchor) { return anchor.x == xi; });
    return static_cast<std::size_t>(found - problem.anchors.begin());
  };
  bool begins = true;
  std::size_t next = 0;  // the first anchor that is not yet in the points
  const auto pass = [&](std::size_t count) {
    for (; next < std::min(count, problem.anchors.size()); ++next) topology.points.push_back({next});
  };
  for (const ApproximateContact::End& end : contact.ends) {
    const std::size_t anchor = anchor_at(end.anchor);
    ContactTopology::Point point{anchor, end.beside, begins ? Kind::begins : Kind::ends, end.vanishes};
    pass(end.beside == Side::right ? anchor + 1 : anchor);
    topology.points.push_back(point);
    if (end.beside) {
      offsets.push_back(end.offset / problem.frame.unit);
    } else {
      next = anchor + 1;
    }
    begins = !begins;
  }
  pass(problem.anchors.size());
}

ContactBox ContactStart::box(Bits bits) const {
  ContactBox box{topology, {}, {}, Ball(0, bits)};
  for (const Rational& h : offsets) box.log_offsets.push_back(log(Ball(h, bits)).midpoint());
  const int free_coefficients = std::max(-topology.degree_at_infinity() - 1, 0);
  box.q.assign(static_cast<std::size_t>(free_coefficients), Ball(0, bits));
  return box;
}

namespace {

using Matrix = std::vector<std::vector<Ball>>;

/// Returns an approximate inverse of the square part; empty if there is none. Its error does not matter.
Matrix approximate_inverse(const Matrix& matrix, Bits bits) {
  const std::size_t n = matrix.size();
  arb_mat_t a;
  arb_mat_init(a, static_cast<slong>(n), static_cast<slong>(n));
  const auto entry = [&](std::size_t i, std::size_t j) {
    return arb_mat_entry(a, static_cast<slong>(i), static_cast<slong>(j));
  };
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) arb_set(entry(i, j), matrix[i][j].get());
  }
  Matrix result(arb_mat_approx_inv(a, a, bits) != 0 ? n : 0);
  for (std::size_t i = 0; i < result.size(); ++i) {
    for (std::size_t j = 0; j < n; ++j) result[i].push_back(made_by(arb_get_mid_arb, bits, entry(i, j)));
  }
  arb_mat_clear(a);
  return result;
}

/// Returns the last column of the conditions' derivatives, which is with respect to the load.
std::vector<Ball> by_load(const Matrix& derivatives) {
  std::vector<Ball> result;
  for (const std::vector<Ball>& row : derivatives) result.push_back(row.back());
  return result;
}

std::vector<Ball> product(const Matrix& matrix, const std::vector<Ball>& vector, Bits bits) {
  std::vector<Ball> result;
  for (const std::vector<Ball>& row : matrix) {
    Ball sum(0, bits);
    for (std::size_t j = 0; j < row.size(); ++j) sum += row[j] * vector[j];
    result.push_back(std::move(sum));
  }
  return result;
}

/// Rules with at most this many bits are also used as the coarse rules.
constexpr Bits few_bits = 96;

ReducedProblem at_middle_load(const ReducedProblem& problem) {
  ReducedProblem result = problem;
  result.load_radius = 0;
  return result;
}

/// Returns the form at the rules' precision. Absent if points may be out of order, or if the budget is spent before its
/// conditions are enclosed.
std::optional<TractionRepresentation> affordable_form(const ReducedProblem& problem, const ContactBox& box,
                                                      JacobiRules& rules, WorkBudget& work) {
  TractionRepresentation form = box.form(problem, count_for(rules.bits()), rules);
  if (!form.set().is_ordered()) return std::nullopt;
  work.take(ContactConditions(form).work());
  if (work.is_spent()) return std::nullopt;
  return form;
}

/// Returns an upper bound of the rounding error of x, with 8 bits to spare.
Ball rounding_of(const Ball& x, Bits bits) {
  return abs(x).upper() * power(Ball(2, bits), -static_cast<int>(bits) + 8);
}

/// Makes one attempt, with F' enclosed by the rules `coarse`.
KrawczykResult attempt(const ReducedProblem& problem, const ContactBox& box, JacobiRules& rules, JacobiRules& coarse,
                       WorkBudget& work) {
  KrawczykResult result{false, {}, box};
  const Bits bits = rules.bits();
  const std::vector<Ball> wide = box.unknowns(problem.load_at.has_value());
  std::vector<Ball> middle;
  for (const Ball& x : wide) middle.push_back(x.at(bits).midpoint());

  const auto unproved = [&](std::string reason) {
    result.reason = std::move(reason);
    return result;
  };
  const TractionRepresentation over_box = box.form(problem, count_for(coarse.bits()), coarse);
  if (!over_box.set().is_ordered()) {
    return unproved("the points of the contact set are not in order all over the box");
  }
  const ReducedProblem one_load = at_middle_load(problem);
  const std::optional<TractionRepresentation> at_middle = affordable_form(one_load, box.with(middle), rules, work);
  if (!at_middle) return unproved("the budget of work is spent before Krawczyk's operator is enclosed");
  const std::vector<Ball> values = ContactConditions(*at_middle).conditions();
  if (values.size() != wide.size() || ContactConditions(over_box).unknowns() != wide.size()) {
    return unproved("there are " + std::to_string(values.size()) + " conditions on " + std::to_string(wide.size()) +
                    " unknowns: a free end that stays on an anchor is an exact threshold");
  }
  if (wide.empty()) {
    result.proved = true;
    result.at_smallest = result.at_largest = box;
    return result;
  }
  const Matrix derivatives = ContactConditions(over_box).jacobian();
  const Matrix inverse = approximate_inverse(derivatives, bits);
  if (inverse.empty()) return unproved("the conditions' derivative is singular");
  if (!all_finite(values)) return unproved("the conditions cannot be enclosed");
  const std::vector<Ball> step = product(inverse, values, bits);
  const std::vector<Ball> moved = product(inverse, by_load(derivatives), bits);
  const Ball radius(problem.load_radius, bits);
  const Ball loads = Ball::plus_or_minus(Ball(0, bits), radius);
  std::vector<Ball> image, at_smallest, at_largest;
  for (std::size_t i = 0; i < wide.size(); ++i) {
    Ball sum = middle[i] - step[i];
    for (std::size_t j = 0; j < wide.size(); ++j) {
      Ball entry(i == j ? 1 : 0, bits);
      for (std::size_t k = 0; k < wide.size(); ++k) entry -= inverse[i][k] * derivatives[k][j];
      sum += entry * (wide[j] - middle[j]);
    }
    image.push_back(sum - moved[i] * loads);
    at_smallest.push_back(sum + moved[i] * radius);
    at_largest.push_back(sum - moved[i] * radius);
  }
  for (std::size_t i = 0; i < wide.size(); ++i) {
    if (!wide[i].contains_inside(image[i])) {
      if (all_finite(image)) result.box = box.with(image);
      return unproved("Krawczyk's operator does not map the box into itself (unknown " + std::to_string(i) + ")");
    }
  }
  result.proved = true;
  result.box = box.with(image);
  result.at_smallest = box.with(at_smallest);
  result.at_largest = box.with(at_largest);
  return result;
}

/// The result of Newton's method, and the length of its last step.
struct Approach {
  std::vector<Ball> values;
  std::vector<Ball> widths;
};

/// Newton's method from the middle of a box, with F' enclosed by the rules `coarse`. Absent if it does not converge.
std::optional<Approach> newton(const ReducedProblem& problem, const ContactBox& box, JacobiRules& rules,
                               JacobiRules& coarse, WorkBudget& work) {
  const Bits bits = rules.bits();
  const bool tilts = problem.load_at.has_value();
  Approach result;
  std::vector<Ball>& values = result.values;
  for (const Ball& x : box.unknowns(tilts)) values.push_back(x.at(bits).midpoint());
  result.widths.assign(values.size(), Ball(0, bits));
  // With the derivative at the start, each step gains the number of correct digits of the start, or of the derivative.
  Matrix inverse;
  Ball before = Ball::unknown(bits);
  // Krawczyk's operator gains the remaining digits, because its F' has more bits than these.
  const Ball enough = power(Ball(2, bits), -static_cast<int>(std::max(bits - few_bits + 8, bits * 2 / 3)));
  constexpr int most_steps = 40;
  for (int step = 0; step < most_steps && !values.empty(); ++step) {
    const ContactBox here = box.with(values);
    const std::optional<TractionRepresentation> form = affordable_form(problem, here, rules, work);
    if (!form) return std::nullopt;
    const std::vector<Ball> conditions = ContactConditions(*form).conditions();
    if (conditions.size() != values.size()) break;  // prove_zero() reports it
    if (inverse.empty()) {
      const TractionRepresentation rough = here.form(problem, count_for(coarse.bits()), coarse);
      inverse = approximate_inverse(ContactConditions(rough).jacobian(), bits);
      if (inverse.empty() && step == 0 && tilts) {
        // Under a flat punch with tilt 0 no end could be free. Any other tilt is a valid start, because the conditions
        // are affine in it.
        values.back() = Ball(1, bits);
        continue;
      }
    }
    if (inverse.empty() || !all_finite(conditions)) return std::nullopt;
    const std::vector<Ball> change = product(inverse, conditions, bits);
    Ball largest(0, bits), noise(0, bits);
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = (values[i] - change[i]).midpoint();
      result.widths[i] = abs(change[i]).upper();
      largest = max(largest, result.widths[i]);
      noise = max(noise, change[i].radius());
    }
    if (largest < enough) break;
    // The next step would be shorter by the factor of the derivative's error, which is that of the start or of the
    // coarse rules. If it would have no effect, it is not made.
    const Ball error =
        power(Ball(2, bits), 16) * max(largest, noise * power(Ball(2, bits), static_cast<int>(bits - coarse.bits())));
    if (largest * error < max(enough, noise)) {
      for (std::size_t i = 0; i < values.size(); ++i) {
        result.widths[i] = (result.widths[i] * error + change[i].radius()).upper();
      }
      break;
    }
    // At the level of rounding and of the quadrature's error, steps no longer decrease.
    if (before.is_finite() && !(largest < before * Ball(Rational(1, 16), bits))) {
      if (before < power(Ball(2, bits), -static_cast<int>(bits) / 2)) break;
      inverse.clear();
    }
    before = largest;
  }
  return result;
}

/// Makes the first steps with few bits, then doubles the bits.
std::optional<Approach> approach(const ReducedProblem& problem, ContactBox box, JacobiRules& rules, WorkBudget& work) {
  if (rules.bits() <= few_bits) return newton(problem, box, rules, rules, work);
  JacobiRules half(std::max(rules.bits() / 2, few_bits));
  if (rules.bits() > 2 * few_bits) {
    if (const auto rough = approach(problem, box, half, work)) box = box.with(rough->values);
  }
  return newton(problem, box, rules, half, work);
}

}  // namespace

KrawczykResult prove_zero(const ReducedProblem& problem, const ContactBox& box, JacobiRules& rules, WorkBudget& work) {
  if (rules.bits() <= few_bits) return attempt(problem, box, rules, rules, work);
  // A few digits of F' are sufficient, because F' is multiplied by the box's width.
  JacobiRules coarse(few_bits);
  KrawczykResult result = attempt(problem, box, rules, coarse, work);
  return result.proved ? result : attempt(problem, box, rules, rules, work);
}

KrawczykResult enclose_zero(const ReducedProblem& problem, const ContactBox& box, JacobiRules& rules,
                            WorkBudget& work) {
  const Bits bits = rules.bits();
  KrawczykResult result{false, "Newton's method does not converge", box};
  const std::optional<Approach> near = approach(problem, box, rules, work);
  if (work.is_spent()) result.reason = "the budget of work is spent before Newton's method has converged";
  if (!near) return result;
  for (int inflation = 1; inflation <= 4; ++inflation) {
    const Ball factor = power(Ball(16, bits), inflation);
    std::vector<Ball> wide;
    for (std::size_t i = 0; i < near->values.size(); ++i) {
      const Ball& x = near->values[i];
      wide.push_back(Ball::around(x, factor * (near->widths[i] + rounding_of(x, bits))));
    }
    result = prove_zero(problem, box.with(wide), rules, work);
    if (result.proved || wide.empty() || work.is_spent()) return result;
  }
  return result;
}

std::optional<ContactBox> box_for_loads(const ReducedProblem& problem, const ContactBox& guess, JacobiRules& rules,
                                        WorkBudget& work) {
  const Bits bits = rules.bits();
  const ReducedProblem one_load = at_middle_load(problem);
  const Ball radius(problem.load_radius, bits);
  std::vector<Ball> values;
  for (const Ball& x : guess.unknowns(problem.load_at.has_value())) values.push_back(x.at(bits).midpoint());
  constexpr int most_steps = 8;
  for (int i = 0; i < most_steps; ++i) {
    const ContactBox here = guess.with(values);
    const std::optional<TractionRepresentation> form = affordable_form(one_load, here, rules, work);
    if (!form) break;
    const ContactConditions at_form(*form);
    const std::vector<Ball> conditions = at_form.conditions();
    if (values.empty() || conditions.size() != values.size()) return here;  // prove_zero() reports the reason
    const Matrix derivatives = at_form.jacobian();
    const Matrix inverse = approximate_inverse(derivatives, bits);
    if (inverse.empty() || !all_finite(conditions)) break;
    const std::vector<Ball> step = product(inverse, conditions, bits);
    const std::vector<Ball> moved = product(inverse, by_load(derivatives), bits);
    Ball longest(0, bits), widest(0, bits);
    std::vector<Ball> wide;
    for (std::size_t k = 0; k < values.size(); ++k) {
      const Ball length = abs(step[k]).upper(), width = abs(moved[k] * radius).upper();
      longest = max(longest, length);
      widest = max(widest, width);
      values[k] = (values[k] - step[k]).midpoint();
      const Ball room = width * Ball(Rational(5, 4), bits) + length + rounding_of(values[k], bits);
      wide.push_back(Ball::around(values[k], room));
    }
    if (longest * Ball(16) < widest) return guess.with(wide);
  }
  return std::nullopt;
}

}  // namespace steadyslide::enclosure
