#include "app/results/field_text.hpp"

#include <cmath>

#include "enclosure/contact/interior_stress.hpp"
#include "enclosure/contact/nodal_forces.hpp"
#include "numeric/interior/average_stress.hpp"
#include "numeric/interior/interface_stress.hpp"
#include "numeric/interior/interior_displacement.hpp"
#include "numeric/interior/largest_stress.hpp"
#include "numeric/interior/surface_stress.hpp"
#include "numeric/solution/nodal_forces.hpp"

namespace steadyslide::app {
namespace {

using enclosure::Ball;
using numeric::Estimate;
using numeric::Real;

/// Makes texts of numbers, and notes whether all are in range.
class NumberWriter {
 public:
  explicit NumberWriter(int digits) : digits_(digits) {}

  template <Real R>
  NumberText operator()(const Estimate<R>& estimate) {
    using std::isfinite;
    in_range_ = in_range_ && (!judged_ || (isfinite(estimate.value) && isfinite(estimate.error)));
    return number_text(estimate, digits_);
  }
  NumberText operator()(const Ball& ball) const { return number_text(ball, digits_); }
  template <class Number>
  NumberText operator()(const std::optional<Number>& number) {
    return number ? (*this)(*number) : NumberText{};
  }
  /// Notes the range of the following numbers, or not.
  void judge(bool judged) { judged_ = judged; }
  std::string exactly(const Rational& value) const { return full_number(value, digits_); }
  bool in_range() const { return in_range_; }

 private:
  int digits_;
  bool in_range_ = true;
  bool judged_ = true;
};

/// Stresses as balls; stress_state.hpp does the same for estimates.
struct EnclosedState {
  Ball xx, zz, xz;
  std::optional<Ball> yy{};
  std::optional<std::array<Ball, 4>> gradient{};

  std::optional<Ball> von_mises() const {
    if (!yy) return std::nullopt;
    const auto square = [](const Ball& a) { return a * a; };
    const Ball differences = square(xx - *yy) + square(*yy - zz) + square(zz - xx);
    return sqrt(differences / Ball(2, xx.bits()) + Ball(3, xx.bits()) * square(xz));
  }
  Ball largest_shear() const {
    const Ball half = (xx - zz) / Ball(2);
    return sqrt(half * half + xz * xz);
  }
};

EnclosedState state_of(const Elasticity& elasticity, const enclosure::StressComponents& stress) {
  const auto& [xx, zz, xz, w] = stress;
  EnclosedState state{xx, zz, xz};
  const auto& body = elasticity.half_space();
  if (!body) return state;
  const auto ball = [bits = xx.bits()](const Rational& value) { return Ball(value, bits); };
  const Rational kolosov = body->kolosov(elasticity.plane());
  state.yy = ball(elasticity.plane() == Plane::strain ? body->poisson() : Rational(0)) * (xx + zz);
  const Ball trace = ball((3 - kolosov) / 4) * (xx + zz);
  const Ball rotation = ball((kolosov + 1) / 2) * w;
  const Ball twice_mu = ball(2 * body->shear_modulus());
  state.gradient = {(xx - trace) / twice_mu, (xz - rotation) / twice_mu, (xz + rotation) / twice_mu,
                    (zz - trace) / twice_mu};
  return state;
}

Column exact(const char* name) { return {name, Column::Holds::decimals}; }
Column estimated(const char* name) { return {name, Column::Holds::numbers}; }

void add(FieldText& text, FieldTable table) {
  if (!table.rows.empty()) text.tables.push_back(std::move(table));
}

/// `state_at` returns the stress at (x, z).
template <class StateAt>
void add_stresses(FieldText& text, const FieldWanted& wanted, NumberWriter& number, StateAt state_at) {
  FieldTable table{"stresses",
                   "stresses in the body (tension positive; z into the body; force per area)",
                   {exact("x"), exact("z"), estimated("sxx"), estimated("szz"), estimated("sxz"), estimated("syy"),
                    estimated("von_mises"), estimated("largest_shear")}};
  for (const auto& [x, z] : wanted.points) {
    const auto state = state_at(x, z);
    number.judge(z > 0);  // at the surface a stress may be infinite
    table.rows.push_back({number.exactly(x), number.exactly(z), number(state.xx), number(state.zz), number(state.xz),
                          number(state.yy), number(state.von_mises()), number(state.largest_shear())});
    std::array<NumberText, 4>& gradient = text.gradients.emplace_back();
    if (!state.gradient) continue;
    const auto& [x_x, x_z, z_x, z_z] = *state.gradient;
    gradient = {number(x_x), number(x_z), number(z_x), number(z_z)};
  }
  number.judge(true);
  add(text, std::move(table));
}

/// `forces_on` returns the forces on the nodes of a mesh. An error of the mesh becomes one with the file and the line.
template <class ForcesOn>
void add_nodal_forces(FieldText& text, const FieldWanted& wanted, NumberWriter& number, ForcesOn forces_on) {
  if (!wanted.mesh) return;
  FieldTable table{"nodal_forces",
                   "nodal forces on the body (normal into the body, tangential along +x)",
                   {exact("x"), estimated("normal"), estimated("tangential")}};
  const SurfaceMesh& mesh = wanted.mesh->mesh();
  try {
    const auto forces = forces_on(mesh);
    for (std::size_t i = 0; i < forces.size(); ++i) {
      table.rows.push_back({number.exactly(mesh.nodes()[i]), number(forces[i].normal), number(forces[i].tangential)});
    }
  } catch (const InvalidData& invalid) {
    throw wanted.mesh->error(invalid);
  }
  add(text, std::move(table));
}

std::optional<LargestStressText::Average> average_text(const numeric::PiecewiseTraction<double>& traction,
                                                       const Rational& over, NumberWriter& number, int digits) {
  const numeric::AverageStress<double> averages(traction, numeric::to_real<double>(over));
  const auto largest = numeric::largest_stress<double>(averages, 0);
  if (!largest) return std::nullopt;
  return LargestStressText::Average{full_number(over, digits), number(largest->von_mises), number(largest->x),
                                    number(largest->z)};
}

}  // namespace

template <Real R>
FieldText field_text(const ContactProblem& problem, const numeric::ContactSolution<R>& solution,
                     const FieldWanted& wanted, const std::optional<Rational>& over, int digits) {
  if (!wanted.any()) return {};
  NumberWriter number(digits);
  const numeric::PiecewiseTraction<R> traction = solution.piecewise_traction();
  std::optional<numeric::InteriorStress<R>> stress;
  if (wanted.has_stress()) stress.emplace(problem, solution);
  FieldText text;
  add_stresses(text, wanted, number, [&](const Rational& x, const Rational& z) {
    return z > 0 ? stress->at(x, z) : numeric::surface_stress(problem.elasticity(), solution.details_at(x));
  });
  if (!wanted.displaced.empty()) {
    FieldTable table{"displacements",
                     "displacements of the body (along x, into the body; 0 where u is 0)",
                     {exact("x"), exact("z"), estimated("ux"), estimated("uz")}};
    const numeric::InteriorDisplacement<R> displacement(traction, problem.origin_of_displacement());
    for (const auto& [x, z] : wanted.displaced) {
      const numeric::Displacement<R> there = displacement.at(x, z);
      table.rows.push_back({number.exactly(x), number.exactly(z), number(there.x), number(there.z)});
    }
    add(text, std::move(table));
  }
  if constexpr (std::same_as<R, double>) {
    FieldTable table{
        "interfaces",
        "interfaces (the largest shear and tension along each, and their places)",
        {exact("depth"), estimated("shear"), estimated("shear_x"), estimated("tension"), estimated("tension_x")}};
    const auto interfaces =
        wanted.interfaces ? numeric::interface_stresses(*stress) : std::vector<numeric::InterfaceStress>();
    for (const auto& [depth, shear, shear_x, tension, tension_x] : interfaces) {
      number.judge(tension.value > 0);  // without tension it has no place
      table.rows.push_back(
          {full_number(depth, digits), number(shear), number(shear_x), number(tension), number(tension_x)});
    }
    number.judge(true);
    add(text, std::move(table));
  }
  add_nodal_forces(text, wanted, number,
                   [&](const SurfaceMesh& mesh) { return numeric::nodal_forces<R>(traction, mesh); });
  if (wanted.largest_stress) {
    const R depth = wanted.depth ? numeric::to_real<R>(*wanted.depth) : numeric::default_depth(solution);
    LargestStressText told;
    for (const Estimate<R>& x : numeric::unbounded_places(solution)) told.unbounded_at.push_back(number(x));
    told.depth = full_number(depth, digits);
    if (const auto largest = numeric::largest_stress<R>(*stress, depth)) {
      told.von_mises = number(largest->von_mises);
      told.x = number(largest->x);
      told.z = number(largest->z);
    }
    if constexpr (std::same_as<R, double>) {
      if (over) told.average = average_text(traction, *over, number, digits);
    }
    text.largest_stress = std::move(told);
  }
  text.in_range = number.in_range();
  return text;
}

FieldText field_text(const ContactProblem& problem, const enclosure::EnclosedSolution& solution,
                     const FieldWanted& wanted, int digits) {
  NumberWriter number(digits);
  FieldText text;
  add_stresses(text, wanted, number, [&](const Rational& x, const Rational& z) {
    return state_of(problem.elasticity(), enclosure::interior_stress(solution, x, z));
  });
  add_nodal_forces(text, wanted, number, [&](const SurfaceMesh& mesh) {
    return enclosure::nodal_forces(solution, mesh.nodes(), mesh.order());
  });
  return text;
}

LargestStressText lower_bound(const ContactProblem& problem, const enclosure::EnclosedSolution& solution,
                              LargestStressText found, int digits) {
  if (found.von_mises.value.empty()) return found;
  const Rational x = parse_rational(found.x.value);
  const Rational told = parse_rational(found.z.value);
  const Indenter& indenter = problem.indenter();
  const Rational z = told > 0 ? told : (indenter.right() - indenter.left()) * parse_rational("1e-15");
  const EnclosedState state = state_of(problem.elasticity(), enclosure::interior_stress(solution, x, z));
  found.von_mises = number_text(*state.von_mises(), digits);
  found.x = {found.x.value, found.x.value, "0", true};
  found.z = {full_number(z, digits), full_number(z, digits), "0", true};
  found.proved = true;
  return found;
}

#define STEADYSLIDE_FIELDS_AS_TEXT(R)                                                                          \
  template FieldText field_text(const ContactProblem&, const numeric::ContactSolution<R>&, const FieldWanted&, \
                                const std::optional<Rational>&, int)
STEADYSLIDE_FIELDS_AS_TEXT(double);
STEADYSLIDE_FIELDS_AS_TEXT(numeric::Real50);
STEADYSLIDE_FIELDS_AS_TEXT(numeric::Real100);

}  // namespace steadyslide::app
