// The third sentence in words after theorem 2: a wedge where the friction jumps. [Bal16, theorem 2]

#include "proofs_checks/instruments/convergence/convergence_cases.hpp"
#include "proofs_checks/instruments/operators/local_power.hpp"
#include "proofs_checks/instruments/solutions/flanks.hpp"
#include "proofs_checks/instruments/solutions/local_behaviour.hpp"
#include "proofs_checks/instruments/tractions/punch.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::thm_02_remarks_wedge_and_jump {
namespace {

struct CornerCase {
  std::string name;
  ContactProblem problem;
  bool on_cells = false;

  Rational rear() const { return s_of(problem, 0); }
  Rational front() const { return s_of(problem, 1); }
  bool rises() const { return front() > rear(); }
  Rational wedge() const { return wedge_of(problem); }
};

/// Returns a corner at which the friction changes from `rear` to `front` and the slope from `left` to `right`.
CornerCase corner_case(std::string name, const Rational& rear, const Rational& front, const Rational& left,
                       const Rational& right, const Rational& load) {
  return {std::move(name),
          flanks(FrictionProfile({rear, front}, {corner}), Polynomial({0, left, 1}), Polynomial({0, right, 2}), load)};
}

CaseList<CornerCase> corners(const Context& context) {
  const Rational low(1, 3);
  const Rational eighth(1, 8);
  const ContactProblem rising = cell_case("wedge-and-jump");
  return first_when_quick<CornerCase>(context,
                                      {corner_case("wedge, f falls", 3, low, -low, 1, 6),
                                       corner_case("wedge, f rises", low, 3, -1, low, 6),
                                       corner_case("notch, f falls", 3, low, 1, 0, 4),
                                       corner_case("wedge, f falls, twice the load", 3, low, -low, 1, 12),
                                       corner_case("blunt wedge, f falls", 3, low, 0, eighth, 6),
                                       corner_case("no wedge, f falls", 3, low, 0, 0, 6),
                                       corner_case("blunt wedge, f rises", low, 3, 0, eighth, 6),
                                       corner_case("no wedge, f rises", low, 3, 0, 0, 6),
                                       corner_case("notch, f rises", low, 3, eighth, 0, 12),
                                       {"wedge, f falls, on 8192 cells", with_friction_reversed(rising), true},
                                       {"wedge, f rises, on 8192 cells", rising, true}},
                                      3, "solved problems");
}

Values limit_on_cells(const ContactProblem& problem) {
  for (const auto& point : solve_on_cells(problem, 8192)->singular_points()) {
    if (point.kind == SingularKind::wedge_and_jump) return {{"cells", point.constant.value}};
  }
  return {};
}

template <Real R>
Values measured(const CornerCase& c) {
  if (c.on_cells) {
    return c.rises() ? powers_on_cells(c.problem, SingularKind::wedge_and_jump) : limit_on_cells(c.problem);
  }
  const auto solution = solve<R>(c.problem);
  const std::size_t j = point_at(*solution, corner);
  const bool inside = in_contact(*solution, j, Side::left) && in_contact(*solution, j, Side::right);
  Values values{{"inside", Number(inside ? 1 : 0)}, {"equation", equation_error(c.problem)}};
  if (!inside) return values;
  if (c.rises()) {
    const auto s = [&c](std::size_t piece) { return to_real<R>(c.problem.coupled_friction(piece)); };
    values.add({"power", jump_power<R>(s(0), s(1)).power});
    return values;
  }
  const R left = limit_beside(*solution, j, Side::left);
  const R right = limit_beside(*solution, j, Side::right);
  values.add({"left limit", left});
  values.add({"right limit", right});
  if (c.wedge() != 0) values.add({"pressure", left < 0 && right < 0});
  return values;
}

Values predicted(const CornerCase& c) {
  const auto beta = to_real<Number>(Exponent::angle(c.rear()) - Exponent::angle(c.front()));
  const auto limit = to_real<Number>(c.wedge() / (c.front() - c.rear()));
  if (c.on_cells && !c.rises()) return {{"cells", limit}};
  if (c.on_cells) return {{"left cells", beta}, {"right cells", beta}, {"error bar", Number(0)}};
  const bool inside = c.rises() || c.wedge() >= 0;
  Values values{{"inside", Number(inside ? 1 : 0)}, {"equation", Number(0)}};
  if (!inside) return values;
  if (c.rises()) {
    values.add({"power", beta});
    return values;
  }
  values.add({"left limit", limit});
  values.add({"right limit", limit});
  if (c.wedge() != 0) values.add({"pressure", true});
  return values;
}

void set_limit(Values& p, const Rational& limit) {
  const auto value = to_real<Number>(limit);
  p.set({{"left limit", value}, {"right limit", value}, {"cells", value}});
}

}  // namespace

Claim claim() {
  return compared<CornerCase>("thm-02-remarks-wedge-and-jump")
      .cases(corners)
      .precision(Precision::quick_in_double)
      // The traction also contains a power of the distance. Therefore the limit has only as many digits as this power
      // leaves.
      .measured([]<Real R>(const CornerCase& c) { return measured<R>(c); })
      .predicted(predicted)
      .wrong("zero where `f` falls, as without the wedge", [](Values& p) { set_limit(p, 0); })
      .wrong("the sign of `[s]`", scaled({"left limit", "right limit", "cells"}, -1))
      .wrong("`D/(1+s^2)`, as for the logarithm",
             [](Values& p, const CornerCase& c) { set_limit(p, -c.wedge() / (1 + c.rear() * c.rear())); })
      .wrong("the wedge changes the power where `f` rises",
             [](Values& p, const CornerCase& c) {
               if (c.wedge() == 0) return;
               for (const char* power : {"power", "left cells", "right cells"}) {
                 if (p.find(power)) p[power] += 1;
               }
             })
      .wrong("a negative limit for any wedge: contact at a re-entrant corner where `f` falls",
             replaced({{"inside", Number(1)}}))
      .near_misses();
}

}  // namespace steadyslide::proofs_checks::thm_02_remarks_wedge_and_jump
