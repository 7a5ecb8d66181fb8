#include "symbolic/cln/cln_closed_form.hpp"

#include <stdexcept>
#include <string>
#include <utility>

#include "symbolic/cln/cln_contact.hpp"

namespace steadyslide::symbolic {

struct ClnClosedForm::State : ClnContact {};

namespace {

using cln::cl_F;

struct Numbers {
  int digits;
  cln::float_format_t format;

  explicit Numbers(int digits) : digits(digits), format(format_for(digits, "closed form")) {}
  cl_F operator()(const Rational& value) const { return to_cln(value, format); }
  cl_F operator()(const Exponent& value) const { return to_cln(value, digits + cln_guard_digits); }
};

Exponent alpha(const ContactProblem& problem, std::size_t piece) {
  return Exponent::angle(problem.coupled_friction(piece));
}

/// One choice of the jumps inside the contact, first <= index < last, with the two equations of the parabola: sum p
/// r = 0 and sum p r^2 = moment.
struct Equations {
  cl_F power_left;
  cl_F power_right;
  cl_F first_sum;   ///< sum of beta c over the jumps inside
  cl_F second_sum;  ///< sum of beta c^2, minus the moment
  cl_F size;        ///< a length; the contact is not longer by orders of magnitude
};

struct Ends {
  cl_F left;
  cl_F right;
};

/// Newton's method from a zone that is far too wide. From there the residuals decrease monotonically to the pair with
/// left < right. Returns false if there is no such pair.
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
  const Numbers number(digits);
  if (one_profile(problem, "closed form").degree() > 0) throw std::domain_error("flat punch: the profile is constant");
  if (problem.elasticity().indenter()) throw std::domain_error("flat punch: the indenter is rigid");
  const std::vector<Rational>& jumps = problem.friction().jumps();
  const cl_F zero = number(Rational(0));

  State found{{"traction", problem, digits, number.format, 0, 0, jumps.size()}};
  found.factor = {-number(problem.load()) / cln::pi(number.format)};
  found.places.push_back({problem.indenter().left(), zero, number(-half - alpha(problem, 0)), true});
  for (std::size_t k = 0; k < jumps.size(); ++k) {
    found.places.push_back({jumps[k], zero, number(alpha(problem, k) - alpha(problem, k + 1)), true});
  }
  found.places.push_back({problem.indenter().right(), zero, number(alpha(problem, jumps.size()) - half), true});
  return ClnClosedForm(std::make_shared<const State>(std::move(found)));
}

std::vector<ClnClosedForm> ClnClosedForm::parabola(const ContactProblem& problem, int digits) {
  const Numbers number(digits);
  const Polynomial& psi = one_profile(problem, "closed form");
  const Rational curvature = psi.coefficient(2);
  if (psi.degree() != 2 || curvature <= 0) throw std::domain_error("parabola: psi = A x^2 + B x + C with A > 0");
  const Rational vertex = -psi.coefficient(1) / (2 * curvature);
  const Rational radius = problem.elasticity().compliance() / (2 * curvature);
  const cl_F moment = number(Rational(2 * problem.load() * radius)) / cln::pi(number.format);

  const std::vector<Rational>& jumps = problem.friction().jumps();
  std::vector<cl_F> from_vertex, beta;
  cl_F farthest = cln::sqrt(moment);
  for (std::size_t k = 0; k < jumps.size(); ++k) {
    from_vertex.push_back(number(Rational(jumps[k] - vertex)));
    beta.push_back(number(alpha(problem, k) - alpha(problem, k + 1)));
    farthest = farthest + cln::abs(from_vertex[k]);
  }

  std::vector<ClnClosedForm> found;
  for (std::size_t first = 0; first <= jumps.size(); ++first) {
    Equations e{number(half - alpha(problem, first)), number(Rational(0)), number(Rational(0)), -moment, farthest};
    for (std::size_t last = first; last <= jumps.size(); ++last) {
      if (last > first) {
        const cl_F& c = from_vertex[last - 1];
        e.first_sum = e.first_sum + beta[last - 1] * c;
        e.second_sum = e.second_sum + beta[last - 1] * c * c;
      }
      e.power_right = number(half + alpha(problem, last));
      e.size = number(Rational(4)) * (farthest / e.power_left + farthest / e.power_right);
      Ends ends{e.size, e.size};
      if (!solve(e, number, ends)) continue;

      State state{{"traction", problem, digits, number.format, vertex, first, last}};
      state.factor = {-number(Rational(1 / radius))};
      state.places.push_back({vertex, ends.left, e.power_left, false});
      for (std::size_t k = first; k < last; ++k) {
        state.places.push_back({jumps[k], number(Rational(0)), beta[k], true});
      }
      state.places.push_back({vertex, ends.right, e.power_right, false});
      if (state.free_ends_fit()) found.push_back(ClnClosedForm(std::make_shared<const State>(std::move(state))));
    }
  }
  return found;
}

Decimal ClnClosedForm::left() const { return state_->end(End::left); }
Decimal ClnClosedForm::right() const { return state_->end(End::right); }
std::size_t ClnClosedForm::first_jump() const { return state_->first_jump; }
std::size_t ClnClosedForm::last_jump() const { return state_->last_jump; }
Decimal ClnClosedForm::traction(const Rational& x) const { return state_->traction(x); }

}  // namespace steadyslide::symbolic
