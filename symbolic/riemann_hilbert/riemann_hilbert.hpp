#pragma once
// The Riemann-Hilbert problem of sliding contact, derived from the operator.
//
//   Phi(z) = (1/2 pi i) int t(x')/(x'-z) dx',   t = Phi+ - Phi-,   (1/pi) PV int t/(x'-x) dx' = i (Phi+ + Phi-),
//
// so that A t = psi' on the contact K is linear in Phi+ and Phi-; solved for Phi+ it is Phi+ = G Phi- + psi' source,
// G = (s-i)/(s+i) = -e^{2 pi i alpha}. The fundamental solution Y(z) = prod (z-e_j)^{p_j} runs over the ends of K and
// the friction jumps inside. On the line Y+- = |Y| e^{+-i pi sigma}, sigma = sum of the p_j with e_j > x. Y must
// satisfy Y+ = G Y- on K and Y+ = Y- outside K. So across each point e^{2 pi i sigma} is multiplied by a known
// quotient, which determines p_j up to an integer. [Bal16, (3), theorem 36]

#include <optional>

#include "symbolic/field/comparison.hpp"
#include "symbolic/field/phase_field.hpp"

namespace steadyslide::symbolic {

/// Phi+ = ratio * Phi- + psi' * source.
struct JumpRelation {
  GiNaC::ex ratio;
  GiNaC::ex source;
};
/// Solves h (Phi+ + Phi-) + s d (Phi+ - Phi-) = psi' for Phi+. Plemelj's formulas give h = i and d = 1.
JumpRelation jump_relation(const GiNaC::ex& s, const GiNaC::ex& h, const GiNaC::ex& d = 1);

/// Returns the form with these expressions for alpha_0, alpha_1, ...
GiNaC::ex expression(const AngleForm& form, const std::vector<GiNaC::ex>& alphas);

enum class EndKind { edge, free };
enum class PointKind { left_edge, left_free, jump, right_edge, right_free };
bool is_free(PointKind kind);
/// True if, for all frictions, the form lies in ]-1, 0[ at an edge or in ]0, 1[ at a free end. At a jump, true if the
/// form is a difference of angles that vanishes for equal frictions.
bool is_admissible(PointKind kind, const AngleForm& form);
/// Adds the equation exp(2 pi i form) G(right) = G(left), with G = 1 outside the contact. The frictions are 0 and 1 of
/// the field.
void compare_crossing(Comparison& comparison, const PhaseField& field, PointKind kind, const AngleForm& form);

/// Returns the exponent at a point, with friction 0 on its left and friction 1 on its right (if there is contact). G
/// determines it up to an integer. For all frictions it lies in ]-1, 0[ at an edge (infinite, integrable traction) and
/// in ]0, 1[ at a free end; at a jump it is the exponent that vanishes with the jump.
AngleForm derived_exponent(PointKind kind);

/// One contact component with panels of constant friction.
struct Component {
  EndKind left;
  EndKind right;
  std::size_t panels = 1;
};

class FundamentalSolution {
 public:
  /// Takes the components from left to right. Frictions have the numbers of the panels, from left to right.
  explicit FundamentalSolution(std::vector<Component> components);
  /// Takes one component.
  FundamentalSolution(EndKind left, EndKind right, std::size_t jumps)
      : FundamentalSolution({{left, right, jumps + 1}}) {}
  /// Returns the same points with other exponents, for wrong variants.
  FundamentalSolution with_powers(const std::vector<AngleForm>& powers) const;

  struct Point {
    PointKind kind;
    AngleForm power;
  };
  /// An interval of the line between neighbouring points, or before the first point, or after the last one.
  struct Region {
    std::optional<std::size_t> friction;  ///< absent outside the contact
    std::size_t component;                ///< the component that contains it, or the next one on the right
    AngleForm sigma;
  };
  const std::vector<Point>& points() const { return points_; }
  const std::vector<Region>& regions() const { return regions_; }
  std::size_t panels() const;
  int free_ends() const;
  AngleForm power_sum() const { return regions_.front().sigma; }
  /// Returns S with Y ~ z^S at infinity. Throws std::domain_error if the sum of the exponents is not an integer.
  int order() const;
  /// Returns epsilon = (s+i) Y+ cos(pi alpha)/|Y| on the region, which is a panel. Throws std::domain_error if it is
  /// not +-1.
  int sign_on(const PhaseField& field, const Region& region) const;
  /// Adds the equations Y+/Y- = G on every panel and Y+/Y- = 1 elsewhere. The field has the frictions of the panels.
  void compare(Comparison& comparison, const PhaseField& field) const;

 private:
  void make_regions();

  std::vector<Component> components_;
  std::vector<Point> points_;
  std::vector<Region> regions_;
};

}  // namespace steadyslide::symbolic
