#include "symbolic/local/local_form.hpp"

#include <algorithm>
#include <stdexcept>

#include "symbolic/field/field_linear.hpp"
#include "symbolic/field/rational_function.hpp"
#include "symbolic/local/local_form_signs.hpp"

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;
using GiNaC::symbol;

struct System {
  std::vector<FieldRow> rows;
  FieldRow rhs;
};

/// Returns the local equations of a density that is linear in the unknowns.
System system_of(const LocalPlace& place, const LocalConstants& constants, const LocalDensity& density,
                 const std::vector<symbol>& unknowns) {
  GiNaC::exmap zero;
  for (const symbol& u : unknowns) zero[u] = 0;
  System system;
  for (const LocalEquation& equation : local_equations(place, constants, density)) {
    FieldRow row;
    for (const symbol& u : unknowns) row.push_back(equation.lhs.diff(u));
    if (std::all_of(row.begin(), row.end(), [](const ex& e) { return e.is_zero(); })) continue;
    system.rows.push_back(row);
    system.rhs.push_back(equation.rhs - equation.lhs.subs(zero));
  }
  return system;
}

/// Returns two formulas, one below the other.
std::string gathered(const std::string& first, const std::string& second) {
  return "\\begin{gathered} " + first + " \\\\ " + second + " \\end{gathered}";
}

/// Returns the same place with one order of the slopes, whose jump is D.
LocalPlace with_jump(const LocalPlace& place, const ex& jump) {
  LocalPlace result = place;
  result.left.slopes = {0};
  result.right.slopes = {jump};
  return result;
}

class Solver {
 public:
  explicit Solver(const LocalPlace& place)
      : frame_(place), form_{place, frame_, std::nullopt, {}, {}, {}, {}, {}, {}, symbol("theta"), {}} {
    if (place.left.slopes.size() < 3 || place.right.slopes.size() < 3) {
      throw std::domain_error("local form: slopes to the order 2");
    }
    for (const Side side : {Side::left, Side::right}) {
      if (place.in_contact(side)) sides_.push_back(side);
    }
  }

  LocalForm solve() {
    form_.kind = kind();
    describe(form_, frame_);
    if (const std::optional<ex> cotangent = characteristic()) {
      choose_branch(lowest_integrable(*cotangent));
    }
    integers();
    order_terms();
    form_.derivation.conclude("Leading form and the next orders, the largest term first. " + legend(form_),
                              form_text(form_));
    add_conditions(form_, frame_);
    return std::move(form_);
  }

 private:
  bool both() const { return sides_.size() == 2; }

  std::optional<SingularKind> kind() const {
    const LocalPlace& place = form_.place;
    if (!both()) return end_kind(place.beyond == Beyond::indenter, place.beyond == Beyond::nothing);
    bool wedge = false;
    for (std::size_t n = 0; n < 3; ++n) {
      wedge = wedge || !frame_.field().are_equal(place.left.slopes[n], place.right.slopes[n]).holds;
    }
    return inner_kind(!frame_.one_friction(), wedge ? 1 : 0);
  }

  std::vector<symbol> unknowns(const std::string& name) const {
    std::vector<symbol> result;
    for (const Side side : sides_) result.emplace_back(name + "_" + suffix(side));
    return result;
  }

  void record(const std::set<std::string>& nonvanishing) {
    form_.nonvanishing.insert(nonvanishing.begin(), nonvanishing.end());
  }

  /// Returns the zero C of the determinant, where C = cot(pi lambda) is free; absent if the determinant vanishes
  /// nowhere.
  std::optional<ex> characteristic() {
    const symbol cotangent("C");
    const symbol cosecant("S");
    const PhaseField field({form_.place.left.friction, form_.place.right.friction, cotangent});
    const std::vector<symbol> amplitudes = unknowns("A");
    LocalDensity density;
    for (std::size_t k = 0; k < sides_.size(); ++k) density[{sides_[k], true, 0, 0}] = amplitudes[k];
    const System system = system_of(form_.place, {cotangent, field.friction(2).r, frame_.pi()}, density, amplitudes);
    Formula equations;
    for (std::size_t k = 0; k < system.rows.size(); ++k) {
      Formula line;
      for (std::size_t u = 0; u < amplitudes.size(); ++u) {
        const std::string name = amplitudes[u].get_name();
        const Formula factor{name, sides_[u] == Side::left ? "A_-" : "A_+"};
        const ex readable = field.canonical(system.rows[k][u]).subs(field.friction(2).r == cosecant);
        line = sum(line, product(canonical_text(readable), factor, frame_.names()));
      }
      equations.text += (k > 0 ? ";  " : "") + line.text + " = 0";
      equations.latex += (k > 0 ? ",\\qquad " : "") + line.latex + " = 0";
    }
    form_.derivation.act(both() ? "Try `A_l |x|^lambda` on `x < 0` and `A_r |x|^lambda` on `x > 0`, `lambda` no "
                                  "integer, with `C = cot(pi lambda)`, `S = 1/sin(pi lambda)`, `S^2 = 1 + C^2`: the "
                                  "coefficients of `|x|^lambda` in `H t + s t` on either side."
                                : "Try `A d^lambda` on the side in contact, `lambda` no integer, with `C = cot(pi "
                                  "lambda)`: the coefficient of `d^lambda` in `H t + s t` there.",
                         equations);
    const ex value = determinant(field, system.rows);
    const Formula text = product(field.text(value), {}, frame_.names());
    const ex slope = value.expand().coeff(cotangent, 1);
    const ex rest = value.expand().coeff(cotangent, 0);
    if (frame_.field().is_identically_zero(slope).holds) {
      form_.derivation.conclude(
          "The determinant does not depend on `lambda` and vanishes nowhere: no power but the integers.",
          {text.text + " > 0", text.latex + " > 0"});
      return std::nullopt;
    }
    const ex root = frame_.field().canonical(-rest / slope);
    record(nonvanishing_of(frame_.field(), slope));
    const Formula root_text = frame_.text(root);
    form_.derivation.act("The determinant vanishes for one value of the cotangent.",
                         {text.text + " = 0,  cot(pi lambda) = " + root_text.text,
                          text.latex + " = 0,\\qquad \\cot\\pi\\lambda = " + root_text.latex});
    return root;
  }

  /// Returns the power in ]-1, 0[ with this cotangent, which is the lowest integrable one.
  AngleForm lowest_integrable(const ex& cotangent) {
    const PhaseField& field = frame_.field();
    const ex squared = field.canonical((cotangent + field.i()) / (cotangent - field.i()));
    std::vector<AngleForm> candidates;
    // If numbers make two candidates equal, the first one is correct for all frictions.
    for (const int halves : both() ? std::vector{0, 1} : std::vector{1, 0}) {
      for (const int sign : {1, -1}) {
        const int left = form_.place.in_contact(Side::left) ? sign : 0;
        const int right = form_.place.in_contact(Side::right) ? sign : 0;
        candidates.push_back(local_exponent(halves, left, both() ? -right : right));
      }
    }
    const auto named = std::ranges::find_if(
        candidates, [&](const AngleForm& lambda) { return field.are_equal(field.phase(lambda, 2), squared).holds; });
    if (named == candidates.end()) throw std::domain_error("local form: no angle has this cotangent");
    AngleForm lambda = *named;
    const std::optional<int> below = frame_.floor(lambda, form_.place.friction_increases);
    if (!below) throw std::domain_error("local form: say which friction is larger");
    const Formula any = frame_.text(lambda);
    lambda += AngleForm(-2 * (*below + 1));
    const Formula text = frame_.text(lambda);
    form_.derivation.conclude(
        "`e^{2 i pi lambda} = (C + i)/(C - i)` is the phase of this angle, so that `lambda` is it up to integers; the "
        "lowest power that is integrable lies between `-1` and `0`.",
        {"lambda = " + any.text + " + k;  lowest: " + text.text,
         gathered("\\lambda = " + any.latex + " + k,\\quad k = 0, \\pm 1, \\dots",
                  "\\lambda_{\\min} = " + text.latex)});
    return lambda;
  }

  /// Returns the amplitudes of x^n |x|^lambda on the sides in contact, normalised to cos(pi alpha) on the right.
  FieldRow amplitudes(const AngleForm& lambda) {
    const std::vector<symbol> all = unknowns("A");
    LocalDensity density;
    for (std::size_t k = 0; k < sides_.size(); ++k) density[{sides_[k], true, 0, 0}] = all[k];
    const System system = system_of(form_.place, frame_.constants(lambda), density, all);
    const LinearSolution solution = symbolic::solve(frame_.field(), all.size(), system.rows, system.rhs);
    record(solution.nonvanishing);
    if (solution.kernel.size() != 1) throw std::domain_error("local form: the determinant has no such root");
    FieldRow result = solution.kernel[0];
    if (both()) {
      for (ex& entry : result) entry = frame_.field().canonical(entry * frame_.friction(Side::right).cos);
    }
    return result;
  }

  void choose_branch(AngleForm lambda) {
    FieldRow vector = amplitudes(lambda);
    if (both()) {
      const ex ratio = frame_.field().canonical(vector[0] / vector[1]);
      const ex positive = frame_.friction(Side::left).cos / frame_.friction(Side::right).cos;
      const Formula text = frame_.text(ratio);
      const Formula equal{"A_l : A_r = " + text.text, "A_- : A_+ = " + text.latex};
      if (frame_.field().are_equal(ratio, -positive).holds) {
        form_.derivation.act(
            "Of this power the amplitudes have opposite signs: it dominates `t`, and `t <= 0` excludes it.", equal);
        lambda += AngleForm(2);
        vector = amplitudes(lambda);
      }
      form_.ratio = frame_.field().canonical(vector[0] / vector[1]);
      if (!frame_.field().are_equal(*form_.ratio, positive).holds) {
        throw std::domain_error("local form: no power of one sign");
      }
      const Formula kept = frame_.text(*form_.ratio);
      form_.derivation.conclude(
          "The power with amplitudes of one sign; their ratio is `cos(pi alpha_l) : cos(pi alpha_r)`, and the same for "
          "`x^n` times it, `n = 1, 2, ...`: `H` commutes with `x` up to constants. The determinant is linear in `C`, "
          "so that its root is simple and no logarithm goes with it.",
          {"lambda = " + frame_.text(lambda).text + ",  A_l : A_r = " + kept.text,
           gathered("\\lambda = " + frame_.text(lambda).latex,
                    "A_- : A_+ = \\cos\\pi\\alpha_- : \\cos\\pi\\alpha_+ = " + kept.latex)});
    } else if (form_.kind == SingularKind::free && penetrates(form_, frame_, lambda)) {
      lambda += AngleForm(2);
      if (penetrates(form_, frame_, lambda)) throw std::domain_error("local form: no free end");
    }
    form_.exponent = lambda;
    for (int n = 0; n < 3; ++n) {
      const ex amplitude = n == 0 ? ex(form_.theta) : ex(symbol("theta_" + std::to_string(n)));
      LocalFormTerm term{true, n, 0, 0, 0, false, {}};
      for (std::size_t k = 0; k < sides_.size(); ++k) {
        // At an end amplitudes belong to d^(lambda + n), d = |x|.
        const ex mirrored = !both() && sides_[k] == Side::left && n % 2 != 0 ? -1 : 1;
        (sides_[k] == Side::left ? term.left : term.right) = -amplitude * mirrored * (both() ? vector[k] : ex(1));
      }
      form_.terms.push_back(term);
    }
    if (!both()) add_outside(form_, frame_);
  }

  /// Adds the terms x^n, x^n log|x|, x^n log^2|x|, with the jump D of the slope's coefficient at x^n.
  void integers() {
    const symbol jump("D");
    std::vector<symbol> all;
    LocalDensity density;
    for (const int logs : {2, 1, 0}) {
      for (auto side = sides_.rbegin(); side != sides_.rend(); ++side) {
        all.emplace_back("a" + std::to_string(logs) + suffix(*side));
        density[{*side, false, 0, logs}] = all.back();
      }
    }
    const LocalPlace one = with_jump(form_.place, jump);
    const System system = system_of(one, {0, 0, frame_.pi()}, density, all);
    const FieldRow known =
        form_.exponent && both() ? FieldRow{form_.place.left.friction - form_.place.right.friction} : FieldRow{};
    const LinearSolution solution = symbolic::solve(frame_.field(), all.size(), system.rows, system.rhs, known);
    record(solution.nonvanishing);
    if (!solution.solvable) throw std::domain_error("local form: the slopes admit no contact");
    if (!both()) {
      if (!solution.kernel.empty()) throw std::domain_error("local form: an integer power at an end");
      form_.derivation.conclude(
          "Integer powers of `d` would leave logarithms in `H t`, and logarithms their squares: there are none. What "
          "`H t` leaves is the slope of the indenter, continued.");
      return;
    }
    describe_integers(solution.particular, all, jump);
    for (int n = 0; n < 3; ++n) {
      const auto order = static_cast<std::size_t>(n);
      const ex d = form_.place.right.slopes[order] - form_.place.left.slopes[order];
      const auto at = [&](std::size_t k) { return frame_.field().canonical(solution.particular[k].subs(jump == d)); };
      // all: right and left for log^2, log, 1.
      for (std::size_t k = 0; k < all.size(); k += 2) {
        if (at(k).is_zero() && at(k + 1).is_zero()) continue;
        form_.terms.push_back({false, n, 2 - static_cast<int>(k) / 2, at(k + 1), at(k), true, {}});
      }
      for (std::size_t k = 0; k < solution.kernel.size(); ++k) {
        if (solution.kernel.size() != 1 || !frame_.field().are_equal(solution.kernel[k][4], 1).holds) {
          throw std::domain_error("local form: an unexpected freedom");
        }
        const symbol amplitude("a_" + std::to_string(n));
        form_.terms.push_back({false, n, 0, amplitude, amplitude, false, {}});
      }
    }
  }

  void describe_integers(const FieldRow& particular, const std::vector<symbol>& all, const symbol& jump) {
    const bool jumps = !frame_.one_friction();
    const Formula constant = frame_.text(particular[4]);
    const Formula logarithm = frame_.text(frame_.pi() * particular[2]);
    form_.derivation.act(
        "Integer powers: `x^n`, `x^n log|x|`, `x^n log^2|x|` on either side, `D` the jump of `psi_bar'` at that order. "
        "`H[x^n, x > 0] = -x^n log|x|/pi`, `H[x^n log|x|] = pi x^n H(x)` up to analytic functions, squares leave "
        "cubes. " +
            std::to_string(all.size()) + " unknowns at each order `n`, the same system for every `n`.",
        {"(" + jump.get_name() + " = psi_bar'(c+) - psi_bar'(c-) at n = 0)", "D = [\\bar\\psi'] \\text{ at } n = 0"});
    if (jumps) {
      form_.derivation.conclude("The logarithms vanish at every order, and the coefficient is one on both sides.",
                                {"x^n: " + constant.text, "x^{n}:\\quad " + constant.latex});
    } else {
      form_.derivation.conclude(
          "The squares vanish; the logarithm and the step that goes with it are forced, and one power series, the same "
          "on both sides, is free.",
          {"x^n log|x|/pi: " + logarithm.text + ",  x^n H(x): " + constant.text,
           "x^{n}\\tfrac{\\log|x|}{\\pi}:\\quad " + logarithm.latex + ",\\qquad x^{n}H(x):\\quad " + constant.latex});
    }
  }

  /// Orders the terms, the largest near the point first. lambda lies in ]-1, 0[ or in ]0, 1[.
  void order_terms() {
    const int fraction = form_.exponent ? 2 * *frame_.floor(*form_.exponent, form_.place.friction_increases) + 1 : 0;
    const auto rank = [&](const LocalFormTerm& term) {
      return std::tuple(2 * term.order + (term.fractional ? fraction : 0), -term.logs, !term.forced);
    };
    std::stable_sort(form_.terms.begin(), form_.terms.end(),
                     [&](const LocalFormTerm& a, const LocalFormTerm& b) { return rank(a) < rank(b); });
    for (LocalFormTerm& term : form_.terms) term.text = term_text(form_, frame_, term);
  }

  LocalFrame frame_;
  LocalForm form_;
  std::vector<Side> sides_;
};

}  // namespace

LocalDensity LocalForm::density() const {
  LocalDensity result;
  for (const LocalFormTerm& term : terms) {
    for (const Side side : {Side::left, Side::right}) {
      const ex& coefficient = side == Side::left ? term.left : term.right;
      if (place.in_contact(side)) result += {{{side, term.fractional, term.order, term.logs}, coefficient}};
    }
  }
  return result;
}

LocalForm derive_local_form(const LocalPlace& place) { return Solver(place).solve(); }

}  // namespace steadyslide::symbolic
