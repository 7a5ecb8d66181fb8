#include "symbolic/riemann_hilbert/closed_form_derivation.hpp"

#include <stdexcept>

#include "symbolic/field/expression.hpp"
#include "symbolic/riemann_hilbert/contact_derivation.hpp"
#include "symbolic/riemann_hilbert/derived_contact.hpp"

namespace steadyslide::symbolic {

using GiNaC::ex;

Derivation closed_form_derivation(ClosedFormKind kind, int jumps) {
  if (jumps < 0) throw std::domain_error("closed form: the number of jumps is not negative");
  const ex load = GiNaC::symbol("P") / GiNaC::symbol("pi");
  const GiNaC::symbol delta("delta");
  const GiNaC::symbol radius("R");
  const GiNaC::symbol vertex("v");
  const GiNaC::symbol kappa("kappa");
  const std::vector<ex> none;
  const std::vector<ex> tilt{delta};
  const std::vector<ex> bowl{-vertex / radius, 1 / radius};
  struct Shape {
    std::string name;
    EndKind left;
    EndKind right;
    std::vector<ex> slope;
  };
  const auto shape = [&]() -> Shape {
    switch (kind) {
      case ClosedFormKind::flat_punch: return {"Flat punch", EndKind::edge, EndKind::edge, none};
      case ClosedFormKind::tilted_punch: return {"Tilted flat punch", EndKind::edge, EndKind::edge, tilt};
      case ClosedFormKind::lifted_punch:
        return {"Tilted flat punch, right edge lifted", EndKind::edge, EndKind::free, tilt};
      case ClosedFormKind::parabola: return {"Parabola", EndKind::free, EndKind::free, bowl};
      case ClosedFormKind::parabola_left_edge:
        return {"Parabola against a left edge", EndKind::edge, EndKind::free, bowl};
      case ClosedFormKind::parabola_right_edge:
        return {"Parabola against a right edge", EndKind::free, EndKind::edge, bowl};
      case ClosedFormKind::parabola_two_edges: return {"Parabola in full contact", EndKind::edge, EndKind::edge, bowl};
      case ClosedFormKind::quartic: return {"Quartic", EndKind::free, EndKind::free, {0, 0, 0, kappa}};
    }
    throw std::domain_error("closed form: a kind");
  }();
  const FundamentalSolution y(shape.left, shape.right, static_cast<std::size_t>(jumps));
  DerivationInput input{shape.name + ", " + std::to_string(jumps) + (jumps == 1 ? " friction jump" : " friction jumps"),
                        y,
                        symbols("s", y.panels()),
                        {},
                        shape.slope,
                        load,
                        {{"delta", "\\delta"}, {"kappa", "\\kappa"}}};
  for (std::size_t j = 0; j < y.points().size(); ++j) {
    input.places.push_back({"e_" + std::to_string(j), "e_{" + std::to_string(j) + "}"});
  }
  return derive(input);
}

Derivation closed_form_derivation(int jumps) { return closed_form_derivation(ClosedFormKind::flat_punch, jumps); }

std::vector<Derivation> riemann_hilbert_derivations(const ContactProblem& problem) {
  std::vector<Derivation> all;
  for (const DerivedContact& contact : DerivedContact::all(problem, 30)) all.push_back(contact.derivation());
  return all;
}

}  // namespace steadyslide::symbolic
