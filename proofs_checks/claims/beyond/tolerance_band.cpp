#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "numeric/variational/lemke.hpp"
#include "proofs_checks/instruments/cells/dense_algebra.hpp"
#include "proofs_checks/instruments/cells/interior_point.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks::tolerance_band {
namespace {

/// Two problems on one mesh, with the same places of friction jumps. The first friction is nondecreasing. In some pairs
/// the profiles or the frictions are equal.
struct Band {
  std::string name;
  CellMesh mesh;
  std::array<CellFrictionSteps, 2> friction;
  std::array<Polynomial, 2> profile;
  Rational load;
  std::optional<Rational> load_at;
};

Band random_band(Random& random, std::size_t k, Trend trend) {
  constexpr std::array<Cells, 3> kinds{Cells::equal, Cells::unequal, Cells::graded};
  CellFrictionSteps first = random_steps(random, trend, 3, 3), second = first;
  if (k % 3 != 1) {
    for (Rational& s : second.s)
      s = k % 4 == 0 ? Rational(s + random.between(0, Rational(1, 10))) : random.between(0, 2);
  }
  if (k % 2 == 1) std::tie(first, second) = std::pair(mirrored(first), mirrored(second));
  const Rational load = random.between(Rational(1, 5), 4);
  std::optional<Rational> load_at;
  if (random.below(4) == 0) load_at = random.between(Rational(-1, 2), Rational(1, 2));
  const Polynomial profile = random_profile(random, k % 3 == 0);
  const Polynomial other = k % 5 == 0 && k % 3 != 1 ? profile : random_profile(random, k % 2 == 0);
  return {"pair " + std::to_string(k) + (load_at ? ", tilting" : ""),
          random_cells(random, cell_problem(first), kinds[k % 3], 16 + random.below(24)),
          {first, second},
          {profile, other},
          load,
          load_at};
}

auto bands(Trend trend) {
  return [trend](const Context& context) {
    return random_cases(context, "tolerance-band", 200, 12, "random meshes, profiles and frictions in pairs",
                        [trend](Random& random, std::size_t k) { return random_band(random, k, trend); });
  };
}

/// Energy identity and bounds, in units of the load: `energy` times b_0, `jumps` times the sum over the jumps, and so
/// on.
struct Bound {
  Number energy = 1;
  double jumps = 0.5;
  double drift = 1;
  double gaps = 1;
  double of_profile = 2;
  double of_friction = 1;
};

void check(Findings& findings, const Bound& said, const Band& c) {
  std::vector<Eigen::VectorXd> forces, gap, profile;
  for (std::size_t n = 0; n < 2; ++n) {
    const DiscreteProblem problem(cell_problem(c.friction[n], c.profile[n], c.load, c.load_at), c.mesh);
    const auto solved = numeric::variational::lemke(problem, 100 * static_cast<int>(c.mesh.size()));
    if (!solved.reached) {
      for (const char* name : {"energy", "share", "force"}) findings.skip(name);
      return;
    }
    const std::vector<double> gap_of_cell = gaps(problem, solved.state);
    forces.push_back(forces_of(problem, solved.state));
    gap.push_back(vector_of(c.mesh.size(), [&](std::size_t i) { return gap_of_cell[i]; }));
    profile.push_back(vector_of(c.mesh.size(), [&](std::size_t i) { return problem.profile()[i]; }));
  }
  const GalerkinOperator first = operator_of(c.friction[0], c.mesh), second = operator_of(c.friction[1], c.mesh);
  const Eigen::VectorXd q = forces[0] - forces[1];
  const Eigen::VectorXd drift = (gap_of_forces(first, c.mesh) - gap_of_forces(second, c.mesh)) * forces[1];
  const auto& [s, places] = c.friction[0];
  double jumps = 0, share = 0, rise = 0, change = to_real<double>(s[0] - c.friction[1].s[0]);
  double force = to_real<double>(s.back()) - to_real<double>(c.friction[1].s.back());
  double largest = std::abs(change);
  for (std::size_t k = 0; k < places.size(); ++k) {
    const Eigen::VectorXd left = weights_of(c.mesh, c.mesh.place(places[k]));
    const auto step = to_real<double>(Rational(s[k + 1] - s[k]));
    const auto other = to_real<double>(Rational(c.friction[1].s[k + 1] - c.friction[1].s[k]));
    jumps += step * std::pow(left.dot(q), 2);
    share = std::max(share, std::sqrt(std::max(step, 0.0)) * std::abs(left.dot(q)));
    force -= step * left.dot(forces[0]) - other * left.dot(forces[1]);
    rise += step;
    change += step - other;
    largest = std::max(largest, std::abs(change));
  }
  const Eigen::MatrixXd logarithm = symmetric_part(c.mesh, first, false);
  const double energy = q.dot(logarithm * q);
  const std::array<double, 4> terms{q.dot(profile[0] - profile[1]), q.dot(drift), gap[0].dot(forces[1]),
                                    gap[1].dot(forces[0])};
  // Two solutions may be the same: contact in one cell.
  double size = forces[0].dot(logarithm * forces[0]) + energy + std::abs(jumps);
  for (const double term : terms) size += std::abs(term);
  findings.compare("energy", static_cast<double>(said.energy) * energy + said.jumps * jumps,
                   -terms[0] - said.drift * terms[1] - said.gaps * (terms[2] + terms[3]), size);
  const double bound = said.of_profile * (profile[0] - profile[1]).cwiseAbs().maxCoeff() + said.of_friction * largest;
  findings.compare("share", share, std::sqrt(2 * bound));
  findings.compare("force", std::abs(force), largest + std::sqrt(2 * bound * rise));
}

}  // namespace

Claim claim() {
  return formula_claim<Band, Bound>("tolerance-band")
      .cases(bands(Trend::rising))
      .precision(Precision::in_double)
      .checked(check)
      .wrong("the jumps without the factor 1/2", &Bound::jumps, 1.0)
      .wrong("`-D` for `D`", &Bound::drift, -1.0)
      .wrong("without the pairings of gaps and pressures", &Bound::gaps, 0.0)
      .wrong("`R` without the frictions", &Bound::of_friction, 0.0)
      .wrong("`R` without the profiles", &Bound::of_profile, 0.0)
      .near_miss("the energy", [](Bound& said, const Number&) { said.energy *= 1 + 1e-7; });
}

}  // namespace steadyslide::proofs_checks::tolerance_band
