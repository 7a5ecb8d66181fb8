#include "symbolic/cln/cln_closed_form.hpp"

#include <stdexcept>
#include <string>
#include <utility>

#include "symbolic/cln/cln_number.hpp"

namespace steadyslide::symbolic {

/// A contact end or a jump: exact where it is a datum of the problem.
struct ClnClosedForm::State {
  struct Place {
    Rational exact;  ///< what is known exactly of the place
    cln::cl_F rest;  ///< place - exact
    cln::cl_F power;
  };

  ContactProblem problem;
  int digits;
  cln::float_format_t format;
  cln::cl_F factor;           ///< K
  std::vector<Place> places;  ///< left end, jumps inside, right end
  std::size_t first_jump;
  std::size_t last_jump;

  cln::cl_F from(const Rational& x, const Place& place) const {
    return to_cln(Rational(x - place.exact), format) - place.rest;
  }
  Decimal where(const Place& place) const { return rounded(place.exact + from_cln(place.rest), digits); }
};

namespace {

using cln::cl_F;

struct Numbers {
  int digits;
  cln::float_format_t format;

  cl_F operator()(const Rational& value) const { return to_cln(value, format); }
  cl_F operator()(const Exponent& value) const { return to_cln(value, digits + cln_guard_digits); }
};

Numbers numbers(int digits) {
  if (digits < 1) throw std::domain_error("closed form: at least one digit; " + std::to_string(digits));
  return {digits, cln_format(digits + 2 * cln_guard_digits)};
}

const Polynomial& one_profile(const ContactProblem& problem) {
  const std::vector<Indenter::Piece>& pieces = problem.indenter().pieces();
  for (const Indenter::Piece& piece : pieces) {
    if (piece.profile != pieces[0].profile) throw std::domain_error("closed form: one profile on the whole support");
  }
  if (problem.load_at()) throw std::domain_error("closed form: the indenter keeps its attitude");
  return pieces[0].profile;
}

Exponent alpha(const ContactProblem& problem, std::size_t piece) {
  return Exponent::angle(problem.coupled_friction(piece));
}

/// A choice of the jumps inside the contact, first <= index < last, and the parabola's two equations for it:
/// sum p r = 0 and sum p r^2 = moment.
struct Equations {
  cl_F power_left;
  cl_F power_right;
  cl_F first_sum;   ///< sum of beta c over the jumps inside
  cl_F second_sum;  ///< sum of beta c^2, minus the moment
  cl_F size;        ///< a length that the contact does not exceed by orders of magnitude
};

struct Ends {
  cl_F left;
  cl_F right;
};

/// Newton's method from a zone that is far too wide: the residuals decrease monotonically from there, to the pair with
/// left < right. False if there is no such pair.
bool solve(const Equations& e, const Numbers& number, Ends& ends) {
  ends = {-e.size, e.size};
  const cl_F tiny = e.size * power_of_ten(-number.digits - cln_guard_digits, number.format);
  const int limit = 2000 + 8 * number.digits;
  for (int step = 0; step < limit; ++step) {
    const cl_F one = e.power_left * ends.left + e.power_right * ends.right + e.first_sum;
    const cl_F two = e.power_left * ends.left * ends.left + e.power_right * ends.right * ends.right + e.second_sum;
    const cl_F width = ends.right - ends.left;
    if (width <= tiny) return false;
    // Cramer's rule for  p_l dl + p_r dr = -one,  2 p_l l dl + 2 p_r r dr = -two.
    const cl_F left_step = (two / 2 - one * ends.right) / (e.power_left * width);
    const cl_F right_step = (one * ends.left - two / 2) / (e.power_right * width);
    ends = {ends.left + left_step, ends.right + right_step};
    if (cln::abs(left_step) + cln::abs(right_step) <= tiny) return true;
  }
  return false;
}

}  // namespace

ClnClosedForm ClnClosedForm::flat_punch(const ContactProblem& problem, int digits) {
  const Numbers number = numbers(digits);
  if (one_profile(problem).degree() > 0) throw std::domain_error("flat punch: the profile is constant");
  if (problem.elasticity().indenter()) throw std::domain_error("flat punch: the indenter is rigid");
  const std::vector<Rational>& jumps = problem.friction().jumps();
  const cl_F zero = number(Rational(0));

  std::vector<State::Place> places;
  places.push_back({problem.indenter().left(), zero, number(-half - alpha(problem, 0))});
  for (std::size_t k = 0; k < jumps.size(); ++k) {
    places.push_back({jumps[k], zero, number(alpha(problem, k) - alpha(problem, k + 1))});
  }
  places.push_back({problem.indenter().right(), zero, number(alpha(problem, jumps.size()) - half)});
  const cl_F factor = number(problem.load()) / cln::pi(number.format);
  return ClnClosedForm(
      std::make_shared<const State>(State{problem, digits, number.format, factor, std::move(places), 0, jumps.size()}));
}

std::vector<ClnClosedForm> ClnClosedForm::parabola(const ContactProblem& problem, int digits) {
  const Numbers number = numbers(digits);
  const Polynomial& psi = one_profile(problem);
  const Rational curvature = psi.coefficient(2);
  if (psi.degree() != 2 || curvature <= 0) throw std::domain_error("parabola: psi = A x^2 + B x + C with A > 0");
  const Rational vertex = -psi.coefficient(1) / (2 * curvature);
  const Rational radius = problem.elasticity().compliance() / (2 * curvature);
  const cl_F moment = number(Rational(2 * problem.load() * radius)) / cln::pi(number.format);

  const std::vector<Rational>& jumps = problem.friction().jumps();
  std::vector<Rational> from_vertex;
  std::vector<cl_F> beta;
  cl_F farthest = cln::sqrt(moment);
  for (std::size_t k = 0; k < jumps.size(); ++k) {
    from_vertex.push_back(jumps[k] - vertex);
    beta.push_back(number(alpha(problem, k) - alpha(problem, k + 1)));
    farthest = farthest + cln::abs(number(from_vertex[k]));
  }
  const Rational left_edge = problem.indenter().left() - vertex;
  const Rational right_edge = problem.indenter().right() - vertex;

  std::vector<ClnClosedForm> found;
  for (std::size_t first = 0; first <= jumps.size(); ++first) {
    Equations e{number(half - alpha(problem, first)), number(Rational(0)), number(Rational(0)), -moment, farthest};
    for (std::size_t last = first; last <= jumps.size(); ++last) {
      if (last > first) {
        const cl_F c = number(from_vertex[last - 1]);
        e.first_sum = e.first_sum + beta[last - 1] * c;
        e.second_sum = e.second_sum + beta[last - 1] * c * c;
      }
      e.power_right = number(half + alpha(problem, last));
      e.size = number(Rational(4)) * (farthest / e.power_left + farthest / e.power_right);
      Ends ends{e.size, e.size};
      if (!solve(e, number, ends)) continue;

      // A jump inside is strictly inside, one outside may touch: then one choice of jumps fits, not two.
      const cl_F touch = (ends.right - ends.left) * power_of_ten(-digits - cln_guard_digits / 2, number.format);
      const auto after = [&](const cl_F& x, const Rational& place) { return x - number(place) > touch; };
      const auto before = [&](const cl_F& x, const Rational& place) { return number(place) - x > touch; };
      bool fits = after(ends.left, left_edge) && before(ends.right, right_edge);
      if (last > first)
        fits = fits && before(ends.left, from_vertex[first]) && after(ends.right, from_vertex[last - 1]);
      if (first > 0) fits = fits && !before(ends.left, from_vertex[first - 1]);
      if (last < jumps.size()) fits = fits && !after(ends.right, from_vertex[last]);
      if (!fits) continue;

      const cl_F zero = number(Rational(0));
      std::vector<State::Place> places;
      places.push_back({vertex, ends.left, e.power_left});
      for (std::size_t k = first; k < last; ++k) places.push_back({jumps[k], zero, beta[k]});
      places.push_back({vertex, ends.right, e.power_right});
      found.push_back(ClnClosedForm(std::make_shared<const State>(
          State{problem, digits, number.format, number(Rational(1 / radius)), std::move(places), first, last})));
    }
  }
  return found;
}

Decimal ClnClosedForm::left() const { return state_->where(state_->places.front()); }
Decimal ClnClosedForm::right() const { return state_->where(state_->places.back()); }
std::size_t ClnClosedForm::first_jump() const { return state_->first_jump; }
std::size_t ClnClosedForm::last_jump() const { return state_->last_jump; }

Decimal ClnClosedForm::traction(const Rational& x) const {
  const State& s = *state_;
  const auto refuse = [&](const std::string& why) {
    throw std::domain_error("traction: " + why + "; x = " + to_string(x));
  };
  const cl_F from_left = s.from(x, s.places.front());
  const cl_F from_right = s.from(x, s.places.back());
  const cl_F blur = (from_left - from_right) * power_of_ten(-cln_guard_digits, s.format);
  for (const State::Place* end : {&s.places.front(), &s.places.back()}) {
    const bool exact = cln::zerop(end->rest);
    const cl_F distance = cln::abs(s.from(x, *end));
    if (cln::zerop(distance)) refuse("x is an end of the contact");
    if (!exact && distance < blur) refuse("x is too near a free end for the digits carried");
  }
  if (cln::minusp(from_left) || cln::plusp(from_right)) return {0, "0"};

  cl_F product = s.factor;
  for (const State::Place& place : s.places) {
    const cl_F distance = cln::abs(s.from(x, place));
    if (cln::zerop(place.power)) continue;
    if (cln::zerop(distance)) refuse("x is a friction jump inside the contact");
    product = product * power(distance, place.power);
  }
  const std::size_t piece = s.problem.friction().piece(x, Side::left);
  product = product * cos_pi_alpha(s.problem.coupled_friction(piece), s.format);
  return rounded(-from_cln(product), s.digits);
}

}  // namespace steadyslide::symbolic
