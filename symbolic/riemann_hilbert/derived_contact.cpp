#include "symbolic/riemann_hilbert/derived_contact.hpp"

#include <map>
#include <optional>
#include <stdexcept>
#include <utility>

#include "symbolic/cln/cln_contact.hpp"
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

/// Returns the value of a polynomial for given values of its symbols.
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
  const Polynomial& psi = pieces[0].profile;
  for (const Indenter::Piece& piece : pieces) {
    if (piece.profile != psi) throw std::domain_error("derived contact: one profile on the whole support");
  }
  if (problem.load_at()) throw std::domain_error("derived contact: the indenter keeps its attitude");
  const Rational curvature = psi.coefficient(2);
  if (psi.degree() > 2 || curvature < 0) throw std::domain_error("derived contact: psi = A x^2 + B x + C with A >= 0");
  const Rational c = problem.elasticity().compliance();
  if (curvature > 0) return {-psi.coefficient(1) / (2 * curvature), {0, 2 * curvature / c}};
  const Rational centre = (problem.indenter().left() + problem.indenter().right()) / 2;
  if (psi.coefficient(1) != 0) return {centre, {psi.coefficient(1) / c}};
  return {centre, {}};
}

}  // namespace

struct DerivedContact::State : ClnContact {
  std::vector<Rational> slope;  ///< psi'/c, by coefficients in the length from the origin
  FundamentalSolution solution;
  std::vector<Rational> frictions = {};  ///< of the panels

  /// From the origin.
  Rational datum(const ClnPoint& place) const { return place.exact - origin; }
  cl_F length(const ClnPoint& place) const { return place.is_datum ? number(datum(place)) : place.rest; }
  bool solve();
  bool fits() const;
};

namespace {

/// Newton's method for one or two polynomial conditions and the same number of unknowns, to full working precision.
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

/// Computes the free ends and N, with the sign of epsilon. Returns false if the conditions have no solution, or if
/// N = 0.
bool DerivedContact::State::solve() {
  const std::vector<ex> p = symbols("p", places.size());
  const std::vector<ex> e = symbols("e", places.size());
  const GiNaC::symbol load("P_over_pi");
  std::vector<ex> exact_slope;
  for (const Rational& a : slope) exact_slope.emplace_back(to_expression(a));
  const int order = solution.order();
  const PolynomialSlope derived(order, exact_slope, power_sums(p, e, PolynomialSlope::sums_needed(order, slope.size())),
                                load);
  if (derived.factor().empty()) return false;

  SymbolValues values;
  values[load] = number(problem.load()) / cln::pi(format);
  // A width that the contact cannot exceed. From there Newton's method decreases monotonically.
  cl_F farthest = number(Rational(problem.indenter().right() - problem.indenter().left()));
  if (slope.size() == 2) farthest = farthest + cln::sqrt(2 * values.at(load) / number(slope[1]));
  for (const ClnPoint& place : places) {
    if (place.is_datum) farthest = farthest + cln::abs(length(place));
  }
  cl_F size = number(Rational(0));
  for (std::size_t j = 0; j < places.size(); ++j) {
    values[p[j]] = places[j].power;
    if (!places[j].is_datum) size = size + 4 * farthest / places[j].power;
  }
  std::vector<ex> unknowns;
  for (std::size_t j = 0; j < places.size(); ++j) {
    values[e[j]] = places[j].is_datum ? length(places[j]) : (j == 0 ? -size : size);
    if (!places[j].is_datum) unknowns.push_back(e[j]);
  }
  const cl_F tiny = farthest * power_of_ten(-digits - cln_guard_digits, format);
  if (!unknowns.empty() && !newton(derived.conditions(), unknowns, values, tiny, format, 2000 + 8 * digits)) {
    return false;
  }
  for (std::size_t j = 0; j < places.size(); ++j) {
    if (!places[j].is_datum) places[j].rest = values.at(e[j]);
  }
  std::vector<ex> s;
  for (const Rational& friction : frictions) s.emplace_back(to_expression(friction));
  const bool positive = solution.sign_on(PhaseField(s), solution.regions()[1]) > 0;
  for (const ex& coefficient : derived.factor()) {
    const cl_F value = evaluate(coefficient, values, format);
    factor.push_back(positive ? value : -value);
  }
  return true;
}

bool DerivedContact::State::fits() const {
  const cl_F left = length(places.front());
  const cl_F right = length(places.back());
  // Check epsilon N <= 0 on the contact. N is linear, or convex with epsilon = 1, so the values at the ends decide.
  return left < right && free_ends_fit() && !cln::plusp(factor_at(left)) && !cln::plusp(factor_at(right));
}

std::vector<DerivedContact> DerivedContact::all(const ContactProblem& problem, int digits) {
  if (digits < 1) throw std::domain_error("derived contact: at least one digit; " + std::to_string(digits));
  const cln::float_format_t format = cln_format(digits + 2 * cln_guard_digits);
  const auto [origin, slope] = profile_of(problem);
  const std::vector<Rational>& jumps = problem.friction().jumps();
  std::vector<DerivedContact> found;
  for (const EndKind left : {EndKind::free, EndKind::edge}) {
    for (const EndKind right : {EndKind::free, EndKind::edge}) {
      if ((left == EndKind::edge || right == EndKind::edge) && problem.elasticity().indenter()) continue;
      const std::size_t first_end = left == EndKind::edge ? 0 : jumps.size();
      for (std::size_t first = 0; first <= first_end; ++first) {
        for (std::size_t last = right == EndKind::edge ? jumps.size() : first; last <= jumps.size(); ++last) {
          State state{
              {problem, digits, format, origin, first, last}, slope, FundamentalSolution(left, right, last - first)};
          for (std::size_t k = first; k <= last; ++k) state.frictions.push_back(problem.coupled_friction(k));
          const std::size_t right_end = state.solution.points().size() - 1;
          for (std::size_t j = 0; j <= right_end; ++j) {
            const auto& [kind, power] = state.solution.points()[j];
            const Rational datum = j == 0           ? problem.indenter().left()
                                   : j == right_end ? problem.indenter().right()
                                                    : jumps[first + j - 1];
            state.places.push_back({is_free(kind) ? origin : datum, state.number(0),
                                    to_cln(power.exponent(state.frictions), digits + cln_guard_digits),
                                    !is_free(kind)});
          }
          if (!state.solve() || !state.fits()) continue;
          found.push_back(DerivedContact(std::make_shared<const State>(std::move(state))));
        }
      }
    }
  }
  return found;
}

Decimal DerivedContact::end(End which) const { return state_->end(which); }

SingularKind DerivedContact::kind(End which) const {
  const auto& points = state_->solution.points();
  return is_free(which == End::left ? points.front().kind : points.back().kind) ? SingularKind::free
                                                                                : SingularKind::edge;
}

Decimal DerivedContact::traction(const Rational& x) const { return state_->traction(x); }

Derivation DerivedContact::derivation() const {
  const State& s = *state_;
  DerivationInput input{s.solution, {}, {}, {}, {}};
  for (const Rational& friction : s.frictions) input.frictions.emplace_back(to_expression(friction));
  for (std::size_t j = 0; j < s.places.size(); ++j) {
    const std::string index = std::to_string(j);
    const std::string datum = s.datum(s.places[j]).str();
    input.places.push_back(s.places[j].is_datum ? Formula{datum, datum} : Formula{"e_" + index, "e_{" + index + "}"});
  }
  for (const Rational& a : s.slope) input.slope.emplace_back(to_expression(a));
  input.load_over_pi = to_expression(s.problem.load()) / GiNaC::symbol("pi");
  Derivation result;
  result.title = "Contact with the problem's numbers";
  result.assume("Lengths `x` are measured from this place of the user's axis.",
                {"x = 0 at " + to_string(s.origin), "x = 0 \\text{ at } " + to_string(s.origin)});
  for (DerivationStep& step : derive(input).steps) result.steps.push_back(std::move(step));
  for (const End which : {End::left, End::right}) {
    if (kind(which) != SingularKind::free) continue;
    const std::string name = which == End::left ? "left" : "right";
    result.conclude("Solved by Newton's method: the free " + name + " end on the user's axis.",
                    {end(which).text, end(which).text});
  }
  return result;
}

}  // namespace steadyslide::symbolic
