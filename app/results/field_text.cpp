#include "app/results/field_text.hpp"

#include <cmath>

#include "enclosure/contact/interior_stress.hpp"
#include "enclosure/contact/nodal_forces.hpp"
#include "numeric/interior/largest_stress.hpp"
#include "numeric/solution/nodal_forces.hpp"

namespace steadyslide::app {
namespace {

using enclosure::Ball;
using numeric::Estimate;
using numeric::Real;

/// What `forces` makes of the mesh, which knows its file.
template <class Forces>
auto on_mesh(const MeshFile& mesh, const Forces& forces) {
  try {
    return forces();
  } catch (const InvalidData& invalid) {
    throw mesh.error(invalid);
  }
}

/// Texts of estimates, and whether all are numbers.
template <Real R>
class EstimateWriter {
 public:
  explicit EstimateWriter(int digits) : digits_(digits) {}

  NumberText operator()(const Estimate<R>& estimate) {
    using std::isfinite;
    in_range_ = in_range_ && isfinite(estimate.value) && isfinite(estimate.error);
    return number_text(estimate, digits_);
  }
  NumberText operator()(const std::optional<Estimate<R>>& estimate) {
    return estimate ? (*this)(*estimate) : NumberText{};
  }
  bool in_range() const { return in_range_; }

 private:
  int digits_;
  bool in_range_ = true;
};

/// In balls, what stress_state.hpp says of estimates.
struct EnclosedState {
  enclosure::StressComponents stress;
  std::optional<Ball> yy{}, von_mises{};
  std::vector<Ball> gradient{};
};

EnclosedState state_of(const Elasticity& elasticity, const enclosure::StressComponents& stress) {
  EnclosedState state{stress};
  const auto& body = elasticity.half_space();
  if (!body) return state;
  const long bits = stress.xx.bits();
  const auto ball = [&](const Rational& value) { return Ball(value, bits); };
  const Rational kolosov = body->kolosov(elasticity.plane());
  const auto& [xx, zz, xz, w] = stress;
  const Ball yy = ball(elasticity.plane() == Plane::strain ? body->poisson() : Rational(0)) * (xx + zz);
  const auto square = [](const Ball& a) { return a * a; };
  const Ball differences = square(xx - yy) + square(yy - zz) + square(zz - xx);
  state.yy = yy;
  state.von_mises = sqrt(differences / ball(2) + ball(3) * square(xz));
  const Ball trace = ball((3 - kolosov) / 4) * (xx + zz);
  const Ball rotation = ball((kolosov + 1) / 2) * w;
  const Ball twice_mu = ball(2 * body->shear_modulus());
  state.gradient = {(xx - trace) / twice_mu, (xz - rotation) / twice_mu, (xz + rotation) / twice_mu,
                    (zz - trace) / twice_mu};
  return state;
}

}  // namespace

template <Real R>
FieldText field_text(const numeric::ContactSolution<R>& solution, const FieldWanted& wanted, int digits) {
  FieldText text;
  if (!wanted.any()) return text;
  EstimateWriter<R> number(digits);
  const numeric::InteriorStress<R> interior(solution);
  for (const auto& [x, z] : wanted.points) {
    const numeric::StressState<R> state = interior.at(x, z);
    StressText row{full_number(x, digits),
                   full_number(z, digits),
                   number(state.xx),
                   number(state.zz),
                   number(state.xz),
                   number(state.yy),
                   number(state.von_mises()),
                   number(state.largest_shear()),
                   {}};
    if (const auto& gradient = state.gradient) {
      row.gradient = {number(gradient->x_x), number(gradient->x_z), number(gradient->z_x), number(gradient->z_z)};
    }
    text.stresses.push_back(std::move(row));
  }
  if (wanted.mesh) {
    const SurfaceMesh& mesh = wanted.mesh->mesh();
    const auto forces = on_mesh(*wanted.mesh, [&] { return numeric::nodal_forces<R>(interior.traction(), mesh); });
    for (std::size_t i = 0; i < forces.size(); ++i) {
      text.nodal_forces.push_back(
          {full_number(mesh.nodes()[i], digits), number(forces[i].normal), number(forces[i].tangential)});
    }
  }
  if (wanted.largest_stress) {
    const R depth = wanted.depth ? numeric::to_real<R>(*wanted.depth) : numeric::default_depth(solution);
    LargestStressText told;
    for (const Estimate<R>& x : numeric::unbounded_places(solution)) told.unbounded_at.push_back(number(x));
    told.depth = full_number(depth, digits);
    if (const auto largest = numeric::largest_stress(interior, depth)) {
      told.von_mises = number(largest->von_mises);
      told.x = number(largest->x);
      told.z = number(largest->z);
    }
    text.largest_stress = std::move(told);
  }
  text.in_range = number.in_range();
  return text;
}

FieldText field_text(const ContactProblem& problem, const enclosure::EnclosedSolution& solution,
                     const FieldWanted& wanted, int digits) {
  FieldText text;
  const auto number = [&](const Ball& ball) { return number_text(ball, digits); };
  for (const auto& [x, z] : wanted.points) {
    const EnclosedState state = state_of(problem.elasticity(), enclosure::interior_stress(solution, x, z));
    const auto& [xx, zz, xz, w] = state.stress;
    const Ball half = (xx - zz) / Ball(2);
    StressText row{full_number(x, digits), full_number(z, digits), number(xx), number(zz), number(xz), {}, {}, {}, {}};
    row.largest_shear = number(sqrt(half * half + xz * xz));
    if (state.yy) {
      row.yy = number(*state.yy);
      row.von_mises = number(*state.von_mises);
      for (std::size_t i = 0; i < row.gradient.size(); ++i) row.gradient[i] = number(state.gradient[i]);
    }
    text.stresses.push_back(std::move(row));
  }
  if (wanted.mesh) {
    const SurfaceMesh& mesh = wanted.mesh->mesh();
    const auto forces =
        on_mesh(*wanted.mesh, [&] { return enclosure::nodal_forces(solution, mesh.nodes(), mesh.order()); });
    for (std::size_t i = 0; i < forces.size(); ++i) {
      text.nodal_forces.push_back(
          {full_number(mesh.nodes()[i], digits), number(forces[i].normal), number(forces[i].tangential)});
    }
  }
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
  found.von_mises = number_text(*state.von_mises, digits);
  found.x = {found.x.value, found.x.value, "0", true};
  found.z = {full_number(z, digits), full_number(z, digits), "0", true};
  found.proved = true;
  return found;
}

#define STEADYSLIDE_FIELDS_AS_TEXT(R) \
  template FieldText field_text(const numeric::ContactSolution<R>&, const FieldWanted&, int)
STEADYSLIDE_FIELDS_AS_TEXT(double);
STEADYSLIDE_FIELDS_AS_TEXT(numeric::Real50);
STEADYSLIDE_FIELDS_AS_TEXT(numeric::Real100);

}  // namespace steadyslide::app
