#pragma once
// The Riemann-Hilbert problem of sliding contact, derived from the operator.
//
//   Phi(z) = (1/2 pi i) int t(x')/(x'-z) dx',   t = Phi+ - Phi-,   (1/pi) PV int t/(x'-x) dx' = i (Phi+ + Phi-),
//
// so that A t = psi' on the contact K is linear in Phi+ and Phi-; solved for Phi+ it is Phi+ = G Phi- + psi' source,
// G = (s-i)/(s+i) = -e^{2 pi i alpha}. The fundamental solution Y(z) = prod (z-e_j)^{p_j} runs over the ends of K and
// the friction jumps inside. On the line Y+- = |Y| e^{+-i pi sigma}, sigma = sum of the p_j with e_j > x; what is asked
// of Y is Y+ = G Y- on K, Y+ = Y- off K: crossing a point multiplies e^{2 pi i sigma} by a known quotient, and that
// leaves p_j up to an integer. [Bal16, (3), theorem 36]

#include <optional>

#include "symbolic/field/comparison.hpp"
#include "symbolic/field/phase_field.hpp"

namespace steadyslide::symbolic {

/// Phi+ = ratio * Phi- + psi' * source.
struct JumpRelation {
  GiNaC::ex ratio;
  GiNaC::ex source;
};
/// Solved from h (Phi+ + Phi-) + s d (Phi+ - Phi-) = psi'; Plemelj's formulas are h = i and d = 1.
JumpRelation jump_relation(const GiNaC::ex& s, const GiNaC::ex& h, const GiNaC::ex& d = 1);

/// The form with these expressions for alpha_0, alpha_1, ...
GiNaC::ex expression(const AngleForm& form, const std::vector<GiNaC::ex>& alphas);

enum class EndKind { edge, free };
enum class PointKind { left_edge, left_free, jump, right_edge, right_free };
bool is_free(PointKind kind);
/// Is the form, whatever the frictions, in ]-1, 0[ at an edge, in ]0, 1[ at a free end; at a jump, is it a difference
/// of angles that vanishes where the frictions are the same?
bool is_admissible(PointKind kind, const AngleForm& form);
/// exp(2 pi i form) G(right) = G(left), with 1 for G off the contact; frictions 0 and 1 of the field.
void compare_crossing(Comparison& comparison, const PhaseField& field, PointKind kind, const AngleForm& form);

/// The exponent at a point, for the frictions 0 on its left and 1 on its right (where there is contact): of the class
/// that G leaves, the one member in ]-1, 0[ at an edge (infinite, integrable) and in ]0, 1[ at a free end, for all
/// frictions; at a jump the one that vanishes with the jump.
AngleForm derived_exponent(PointKind kind);

/// One interval of contact with panels of constant friction.
struct Component {
  EndKind left;
  EndKind right;
  std::size_t panels = 1;
};

class FundamentalSolution {
 public:
  /// Components from left to right; frictions are numbered by panels, left to right.
  explicit FundamentalSolution(std::vector<Component> components);
  /// One component.
  FundamentalSolution(EndKind left, EndKind right, std::size_t jumps)
      : FundamentalSolution({{left, right, jumps + 1}}) {}
  /// The same points with other exponents: for wrong variants.
  FundamentalSolution with_powers(const std::vector<AngleForm>& powers) const;

  struct Point {
    PointKind kind;
    AngleForm power;
  };
  /// An interval of the line between neighbouring points, left to right: before the first, ..., after the last.
  struct Region {
    std::optional<std::size_t> friction;  ///< absent off the contact
    std::size_t component;                ///< the one it is in, or the next on the right
    AngleForm sigma;
  };
  const std::vector<Point>& points() const { return points_; }
  const std::vector<Region>& regions() const { return regions_; }
  std::size_t panels() const;
  int free_ends() const;
  AngleForm power_sum() const { return regions_.front().sigma; }
  /// S with Y ~ z^S at infinity. Throws std::domain_error where the exponents do not sum to an integer.
  int order() const;
  /// epsilon = (s+i) Y+ cos(pi alpha)/|Y| on the region, a panel. Throws std::domain_error where it is not +-1.
  int sign_on(const PhaseField& field, const Region& region) const;
  /// Y+/Y- is G on every panel and 1 elsewhere. Field: the frictions of the panels.
  void compare(Comparison& comparison, const PhaseField& field) const;

 private:
  void make_regions();

  std::vector<Component> components_;
  std::vector<Point> points_;
  std::vector<Region> regions_;
};

}  // namespace steadyslide::symbolic
