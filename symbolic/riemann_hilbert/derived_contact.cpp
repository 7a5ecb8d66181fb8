#include "symbolic/riemann_hilbert/derived_contact.hpp"

#include <map>
#include <optional>
#include <stdexcept>
#include <utility>

#include "symbolic/cln/cln_number.hpp"
#include "symbolic/field/expression.hpp"
#include "symbolic/riemann_hilbert/contact_derivation.hpp"

namespace steadyslide::symbolic {

using cln::cl_F;
using GiNaC::ex;

using SymbolValues = std::map<ex, cl_F, GiNaC::ex_is_less>;

struct ContactProfile {
  Rational origin;              // lengths are measured from it
  std::vector<Rational> slope;  // psi'/c, by coefficients in the length from the origin
};

namespace {

/// A polynomial in symbols with values.
cl_F evaluate(const ex& e, const SymbolValues& values, cln::float_format_t format) {
  if (GiNaC::is_a<GiNaC::numeric>(e)) return to_cln(to_rational(GiNaC::ex_to<GiNaC::numeric>(e)), format);
  if (GiNaC::is_a<GiNaC::symbol>(e)) return values.at(e);
  if (GiNaC::is_a<GiNaC::power>(e)) {
    const cl_F base = evaluate(e.op(0), values, format);
    cl_F value = base;
    for (int n = 1; n < GiNaC::ex_to<GiNaC::numeric>(e.op(1)).to_int(); ++n) value = value * base;
    return value;
  }
  const bool is_sum = GiNaC::is_a<GiNaC::add>(e);
  if (!is_sum && !GiNaC::is_a<GiNaC::mul>(e)) throw std::logic_error("derived contact: a polynomial");
  cl_F value = evaluate(e.op(0), values, format);
  for (std::size_t k = 1; k < e.nops(); ++k) {
    const cl_F next = evaluate(e.op(k), values, format);
    value = is_sum ? value + next : value * next;
  }
  return value;
}

ContactProfile profile_of(const ContactProblem& problem) {
  const std::vector<Indenter::Piece>& pieces = problem.indenter().pieces();
  for (const Indenter::Piece& piece : pieces) {
    if (piece.profile != pieces[0].profile)
      throw std::domain_error("derived contact: one profile on the whole support");
  }
  if (problem.load_at()) throw std::domain_error("derived contact: the indenter keeps its attitude");
  const Polynomial& psi = pieces[0].profile;
  const Rational curvature = psi.coefficient(2);
  if (psi.degree() > 2 || curvature < 0) throw std::domain_error("derived contact: psi = A x^2 + B x + C with A >= 0");
  const Rational c = problem.elasticity().compliance();
  if (curvature > 0) return {-psi.coefficient(1) / (2 * curvature), {0, 2 * curvature / c}};
  const Rational centre = (problem.indenter().left() + problem.indenter().right()) / 2;
  if (psi.coefficient(1) != 0) return {centre, {psi.coefficient(1) / c}};
  return {centre, {}};
}

}  // namespace

struct DerivedContact::State {
  struct Place {
    std::optional<Rational> exact;  ///< from the origin, where it is a datum
    cl_F value;
    cl_F power;
  };

  ContactProblem problem;
  int digits;
  cln::float_format_t format;
  ContactProfile profile;
  FundamentalSolution solution;
  std::size_t first;                ///< the friction piece of panel 0
  std::vector<Rational> frictions;  ///< of the panels
  std::vector<Place> places;
  int epsilon;
  std::vector<cl_F> factor;  ///< coefficients of N

  cl_F number(const Rational& value) const { return to_cln(value, format); }
  /// x - place, x from the origin
  cl_F from(const Rational& x, const Place& place) const {
    return place.exact ? number(Rational(x - *place.exact)) : number(x) - place.value;
  }
  cl_F factor_at(const cl_F& x) const {
    cl_F value = number(Rational(0));
    for (std::size_t k = factor.size(); k-- > 0;) value = value * x + factor[k];
    return value;
  }
  bool solve();
  bool fits() const;
};

namespace {

/// Newton's method for as many polynomial conditions as unknowns, one or two, down to the digits carried.
bool newton(const std::vector<ex>& conditions, const std::vector<ex>& unknowns, SymbolValues& values, const cl_F& tiny,
            cln::float_format_t format, int limit) {
  const auto at = [&](const ex& e) { return evaluate(e, values, format); };
  std::vector<ex> derivatives;
  for (const ex& condition : conditions) {
    for (const ex& unknown : unknowns) derivatives.push_back(condition.diff(GiNaC::ex_to<GiNaC::symbol>(unknown)));
  }
  for (int step = 0; step < limit; ++step) {
    std::vector<cl_F> residuals;
    std::vector<cl_F> d;
    for (const ex& condition : conditions) residuals.push_back(at(condition));
    for (const ex& derivative : derivatives) d.push_back(at(derivative));
    std::vector<cl_F> moves;
    if (unknowns.size() == 1) {
      if (cln::zerop(d[0])) return false;
      moves = {-residuals[0] / d[0]};
    } else {
      const cl_F determinant = d[0] * d[3] - d[1] * d[2];
      if (cln::zerop(determinant)) return false;
      moves = {(residuals[1] * d[1] - residuals[0] * d[3]) / determinant,
               (residuals[0] * d[2] - residuals[1] * d[0]) / determinant};
    }
    cl_F size = cln::abs(moves[0]);
    for (std::size_t k = 0; k < unknowns.size(); ++k) {
      values.at(unknowns[k]) = values.at(unknowns[k]) + moves[k];
      if (k > 0) size = size + cln::abs(moves[k]);
    }
    if (unknowns.size() == 2 && values.at(unknowns[1]) - values.at(unknowns[0]) <= tiny) return false;
    if (size <= tiny) return true;
  }
  return false;
}

}  // namespace

/// Free ends, epsilon and N; false where the conditions have no solution, or N = 0.
bool DerivedContact::State::solve() {
  const std::vector<ex> p = symbols("p", places.size());
  const std::vector<ex> e = symbols("e", places.size());
  const GiNaC::symbol load("P_over_pi");
  std::vector<ex> slope;
  for (const Rational& a : profile.slope) slope.push_back(to_expression(a));
  const int order = solution.order();
  const PolynomialSlope derived(order, slope, power_sums(p, e, PolynomialSlope::sums_needed(order, slope.size())),
                                load);
  if (derived.factor().empty()) return false;

  SymbolValues values;
  values[load] = number(problem.load()) / cln::pi(format);
  // Wider than the contact can be: from there Newton's method comes down monotonically.
  cl_F farthest = number(Rational(problem.indenter().right() - problem.indenter().left()));
  if (slope.size() == 2) farthest = farthest + cln::sqrt(2 * values.at(load) / number(profile.slope[1]));
  for (const Place& place : places) {
    if (place.exact) farthest = farthest + cln::abs(number(*place.exact));
  }
  cl_F size = number(Rational(0));
  for (std::size_t j = 0; j < places.size(); ++j) {
    values[p[j]] = places[j].power;
    if (!places[j].exact) size = size + 4 * farthest / places[j].power;
  }
  std::vector<ex> unknowns;
  for (std::size_t j = 0; j < places.size(); ++j) {
    values[e[j]] = places[j].exact ? number(*places[j].exact) : (j == 0 ? -size : size);
    if (!places[j].exact) unknowns.push_back(e[j]);
  }
  const cl_F tiny = farthest * power_of_ten(-digits - cln_guard_digits, format);
  if (!unknowns.empty() && !newton(derived.conditions(), unknowns, values, tiny, format, 2000 + 8 * digits)) {
    return false;
  }
  for (std::size_t j = 0; j < places.size(); ++j) places[j].value = values.at(e[j]);
  for (const ex& coefficient : derived.factor()) factor.push_back(evaluate(coefficient, values, format));

  std::vector<ex> s;
  for (const Rational& friction : frictions) s.push_back(to_expression(friction));
  const PhaseField field(s);
  epsilon = solution.sign_on(field, solution.regions()[1]);
  return true;
}

bool DerivedContact::State::fits() const {
  const cl_F& left = places.front().value;
  const cl_F& right = places.back().value;
  const cl_F touch = (right - left) * power_of_ten(-digits - cln_guard_digits / 2, format);
  const auto after = [&](const cl_F& x, const Rational& y) { return x - number(Rational(y - profile.origin)) > touch; };
  const auto before = [&](const cl_F& x, const Rational& y) {
    return number(Rational(y - profile.origin)) - x > touch;
  };
  if (!(left < right)) return false;
  const std::vector<Rational>& jumps = problem.friction().jumps();
  const std::size_t last = first + frictions.size() - 1;
  // A jump inside is strictly inside, one outside may touch: then one choice of jumps fits, not two.
  if (!places.front().exact) {
    if (!after(left, problem.indenter().left())) return false;
    if (last > first && !before(left, jumps[first])) return false;
    if (first > 0 && before(left, jumps[first - 1])) return false;
  }
  if (!places.back().exact) {
    if (!before(right, problem.indenter().right())) return false;
    if (last > first && !after(right, jumps[last - 1])) return false;
    if (last < jumps.size() && after(right, jumps[last])) return false;
  }
  // epsilon N <= 0 on the contact: N is linear, or convex with epsilon = 1, so that the ends decide.
  const auto pulls = [&](const cl_F& x) { return cln::plusp(epsilon > 0 ? factor_at(x) : -factor_at(x)); };
  return !pulls(left) && !pulls(right);
}

std::vector<DerivedContact> DerivedContact::all(const ContactProblem& problem, int digits) {
  if (digits < 1) throw std::domain_error("derived contact: at least one digit; " + std::to_string(digits));
  const cln::float_format_t format = cln_format(digits + 2 * cln_guard_digits);
  const ContactProfile profile = profile_of(problem);
  const std::vector<Rational>& jumps = problem.friction().jumps();
  std::vector<DerivedContact> found;
  for (const EndKind left : {EndKind::free, EndKind::edge}) {
    for (const EndKind right : {EndKind::free, EndKind::edge}) {
      if ((left == EndKind::edge || right == EndKind::edge) && problem.elasticity().indenter()) continue;
      const std::size_t first_end = left == EndKind::edge ? 0 : jumps.size();
      for (std::size_t first = 0; first <= first_end; ++first) {
        for (std::size_t last = right == EndKind::edge ? jumps.size() : first; last <= jumps.size(); ++last) {
          State state{problem, digits, format, profile, FundamentalSolution(left, right, last - first),
                      first,   {},     {},     0,       {}};
          for (std::size_t k = first; k <= last; ++k) state.frictions.push_back(problem.coupled_friction(k));
          for (std::size_t j = 0; j < state.solution.points().size(); ++j) {
            std::optional<Rational> exact;
            if (j == 0) {
              if (left == EndKind::edge) exact = problem.indenter().left() - profile.origin;
            } else if (j + 1 == state.solution.points().size()) {
              if (right == EndKind::edge) exact = problem.indenter().right() - profile.origin;
            } else {
              exact = jumps[first + j - 1] - profile.origin;
            }
            const Exponent power = state.solution.points()[j].power.exponent(state.frictions);
            state.places.push_back({exact, state.number(Rational(0)), to_cln(power, digits + cln_guard_digits)});
          }
          if (!state.solve() || !state.fits()) continue;
          found.push_back(DerivedContact(std::make_shared<const State>(std::move(state))));
        }
      }
    }
  }
  return found;
}

Decimal DerivedContact::end(End which) const {
  const State::Place& place = which == End::left ? state_->places.front() : state_->places.back();
  return rounded(state_->profile.origin + (place.exact ? *place.exact : from_cln(place.value)), state_->digits);
}

SingularKind DerivedContact::kind(End which) const {
  const auto& points = state_->solution.points();
  return is_free(which == End::left ? points.front().kind : points.back().kind) ? SingularKind::free
                                                                                : SingularKind::edge;
}

Decimal DerivedContact::traction(const Rational& x) const {
  const State& s = *state_;
  const auto refuse = [&](const std::string& why) {
    throw std::domain_error("derived traction: " + why + "; x = " + to_string(x));
  };
  const Rational at = x - s.profile.origin;
  const cl_F from_left = s.from(at, s.places.front());
  const cl_F from_right = s.from(at, s.places.back());
  const cl_F blur = (from_left - from_right) * power_of_ten(-cln_guard_digits, s.format);
  for (const State::Place* end : {&s.places.front(), &s.places.back()}) {
    const cl_F distance = cln::abs(s.from(at, *end));
    if (cln::zerop(distance)) refuse("x is an end of the contact");
    if (!end->exact && distance < blur) refuse("x is too near a free end for the digits carried");
  }
  if (cln::minusp(from_left) || cln::plusp(from_right)) return {0, "0"};
  const cl_F factor = s.factor_at(s.number(at));
  cl_F product = s.epsilon > 0 ? factor : -factor;
  for (const State::Place& place : s.places) {
    if (cln::zerop(place.power)) continue;
    const cl_F distance = cln::abs(s.from(at, place));
    if (cln::zerop(distance)) refuse("x is a friction jump inside the contact");
    product = product * power(distance, place.power);
  }
  const std::size_t piece = s.problem.friction().piece(x, Side::left);
  product = product * cos_pi_alpha(s.problem.coupled_friction(piece), s.format);
  return rounded(from_cln(product), s.digits);
}

Derivation DerivedContact::derivation() const {
  const State& s = *state_;
  DerivationInput input{"Contact with the problem's numbers", s.solution, {}, {}, {}, {}, {}};
  for (const Rational& friction : s.frictions) input.frictions.push_back(to_expression(friction));
  for (std::size_t j = 0; j < s.places.size(); ++j) {
    const std::string text = s.places[j].exact ? s.places[j].exact->str() : "e_" + std::to_string(j);
    input.places.push_back({text, s.places[j].exact ? text : "e_{" + std::to_string(j) + "}"});
  }
  for (const Rational& a : s.profile.slope) input.slope.push_back(to_expression(a));
  input.load_over_pi = to_expression(s.problem.load()) / GiNaC::symbol("pi");
  Derivation result;
  result.title = input.title;
  result.assume("Lengths `x` are measured from this place of the user's axis.",
                {"x = 0 at " + to_string(s.profile.origin), "x = 0 \\text{ at } " + to_string(s.profile.origin)});
  for (DerivationStep& step : derive(input).steps) result.steps.push_back(std::move(step));
  for (const End which : {End::left, End::right}) {
    if (kind(which) != SingularKind::free) continue;
    const std::string name = which == End::left ? "left" : "right";
    result.conclude("Solved by Newton's method: the free " + name + " end on the user's axis.",
                    {end(which).text, end(which).text});
  }
  return result;
}

Decimal derived_traction(const ContactProblem& problem, const Rational& x, int digits) {
  const std::vector<DerivedContact> contacts = DerivedContact::all(problem, digits);
  if (contacts.size() != 1) {
    throw std::domain_error("derived traction: one contact; found " + std::to_string(contacts.size()));
  }
  return contacts[0].traction(x);
}

}  // namespace steadyslide::symbolic
