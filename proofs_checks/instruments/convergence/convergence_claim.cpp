// Compares the cell solver, which uses no exponents, with the Riemann-Hilbert solution: contact ends, resultants,
// intensities and exponents, at the rates that theory predicts.

#include "proofs_checks/instruments/convergence/convergence_claim.hpp"

#include <cmath>
#include <map>

#include "enclosure/cells/cell_bound.hpp"
#include "proofs_checks/instruments/convergence/convergence_study.hpp"
#include "proofs_checks/instruments/solutions/local_behaviour.hpp"
#include "proofs_checks/instruments/tractions/surface.hpp"
#include "proofs_checks/kit/claim_builder.hpp"

namespace steadyslide::proofs_checks {
namespace {

/// The prediction for a problem, in the units of the study. The defaults are the right prediction; other values are
/// wrong variants.
struct Prediction {
  bool friction_reversed = false;  ///< reverse the friction of the reference
  double rate_offset = 0;
  bool angle_reversed = false;  ///< reverse the sign of alpha in the exponents
  double end_offset = 0;        ///< offset of the reference's ends, in cells
  double intensity_offset = 0;  ///< offset of the reference's intensities, in tolerances
  double resultant_offset = 0;  ///< offset of the reference's resultants, in radii of the proved interval
};

class Comparison {
 public:
  Comparison(Findings& findings, const ConvergenceStudy& study, const SolvedQuantities& exact,
             const Prediction& predicted, bool quick)
      : findings_(findings), study_(study), exact_(exact), predicted_(predicted), quick_(quick) {}

  void resultants(const std::vector<std::string>& names) {
    const std::size_t first = std::size_t{1} << (quick_ ? 6 : 8);
    for (std::size_t k = 0; k < names.size(); ++k) {
      rate("error of the " + names[k], first,
           [&](const MeshLevel& level) { return resultant_error(level, exact_, k); });
    }
  }

  /// Compares with the proved bounds. A theorem gives them from the energy on every mesh, independently of the rates.
  void proved_resultants() {
    for (const MeshLevel& level : study_.levels) {
      if (!level.bound) continue;
      findings_.begin_case(std::to_string(level.cells) + " cells");
      for (std::size_t k = 0; const enclosure::Ball* ball = proved_resultant(*level.bound, k); ++k) {
        const double radius = ball->radius().to_double();
        const double exact = exact_.resultants[k] + predicted_.resultant_offset * radius;
        findings_.compare(proved_, std::abs(ball->to_double() - exact) / radius);
      }
    }
  }

  /// The fit to the cells adds an error of first order. It hides an error of second order, so that no rate is measured
  /// then.
  void intensities() {
    if (!quick_ && study_.rate < 2) {
      rate("error of the stress intensities, root mean square", first_with_intensities, [&](const MeshLevel& level) {
        std::vector<double> errors;
        for (std::size_t k = 0; k < exact_.intensities.size(); ++k) errors.push_back(intensity_error(level, exact_, k));
        return root_mean_square(errors);
      });
    }
    const double tolerance = 1 / static_cast<double>(study_.fine.cells);
    const Quantity quantity{"stress intensity on the finest mesh",
                            {"fit to the cells", "solution of the Riemann-Hilbert problem"},
                            tolerance};
    const std::vector<double>& found = study_.fine.solved.intensities;
    findings_.require(found.size() == exact_.intensities.size(), "another number of singular points");
    for (std::size_t k = 0; k < found.size(); ++k) {
      findings_.begin_case(std::to_string(study_.fine.cells) + " cells, intensity " + std::to_string(k + 1));
      const double exact = exact_.intensities[k] * (1 + predicted_.intensity_offset * tolerance);
      findings_.compare(quantity, relative_difference(found[k], exact));
    }
  }

  void ends() {
    for (const MeshLevel& level : study_.levels) {
      for (const OnMesh& mesh : level.meshes) {
        findings_.begin_case(std::to_string(mesh.cells) + " cells");
        const auto& found = mesh.solved.ends;
        findings_.require(found.size() == exact_.ends.size(), "another number of contact ends");
        for (std::size_t i = 0; i < found.size(); ++i) {
          const double off = std::abs(found[i].x - exact_.ends[i].x - predicted_.end_offset * mesh.cell_length);
          findings_.require(found[i].exact == exact_.ends[i].exact, "an edge or step is one for one solver only");
          findings_.compare(found[i].exact ? edge_ : free_, found[i].exact ? off : off / mesh.cell_length);
        }
      }
    }
  }

  void exponents() {
    const Quantity bar{"error bar of an exponent that is read off the cells", {}, quick_ ? 0.05 : 0.01};
    const Quantity agrees{"distance of the exponents, in error bars", {"fit to the cells", "local equation"}, 1};
    const Quantity excludes{"error bar over the distance to the exponent with `alpha` of the other sign", {}, 1};
    for (const ReadExponent& read : study_.exponents) {
      findings_.begin_case("x = " + std::to_string(read.x));
      auto right = to_real<double>(read.derived);
      auto wrong = to_real<double>(read.reversed);
      if (predicted_.angle_reversed) std::swap(right, wrong);
      findings_.compare(bar, read.found.error);
      findings_.compare(agrees, std::abs(read.found.value - right) / read.found.error);
      findings_.compare(excludes, read.found.error / std::abs(read.found.value - wrong));
    }
  }

 private:
  template <class Error>
  void rate(const std::string& what, std::size_t first, const Error& error) {
    std::vector<Level> levels;
    for (const MeshLevel& level : study_.levels) {
      if (level.cells >= first) levels.push_back({static_cast<double>(level.cells), error(level)});
    }
    const Rate measured = fitted_rate(levels);
    const std::string detail =
        std::to_string(levels.size()) + " levels from " + std::to_string(first) + " cells on, root mean squares of " +
        std::to_string(study_.levels.front().meshes.size()) + " meshes; " + short_text(levels.back().error) + " on " +
        std::to_string(study_.levels.back().cells) + " cells" + proved_energies();
    findings_.begin_case("all levels");
    findings_.require(!std::isnan(measured.value), "no rate of " + what + ": an error is not positive and finite");
    findings_.measure(
        {what, measured.value, measured.error_bar, study_.rate + predicted_.rate_offset, quick_ ? 0.25 : 0.1, detail});
  }

  /// Returns the proved errors of the energy, in parts of P^2, on the first mesh of each level. Returns an empty text
  /// if none is proved.
  std::string proved_energies() const {
    std::string result;
    for (const MeshLevel& level : study_.levels) {
      if (level.bound) result += (result.empty() ? "" : ", ") + short_text(level.bound->energy.to_double());
    }
    return result.empty() ? result : "; proved of the energy's error, level by level: at most " + result;
  }

  const std::vector<std::string> ends_routes_{"cells in contact", "solution of the Riemann-Hilbert problem"};
  const Quantity free_{"place of a free end of contact, in cells", ends_routes_, 1};
  const Quantity proved_{"distance from the middle of what is proved of a load share or of the friction, in its radii",
                         {"solution of the Riemann-Hilbert problem", "energy bound of the cells"},
                         1};
  const Quantity edge_{"place of an end at an edge or step", ends_routes_, 1e-14};
  Findings& findings_;
  const ConvergenceStudy& study_;
  const SolvedQuantities& exact_;
  const Prediction& predicted_;
  bool quick_;
};

}  // namespace

Claim convergence_claim(std::string_view id) {
  const ContactProblem problem = cell_case(claim_text(id).convergence);
  const auto cases = [problem](const Context& context) -> CaseList<ContactProblem> {
    const StudyPlan plan = context.quick ? StudyPlan::quick() : StudyPlan::full();
    return {{problem},
            "from 64 to " + std::to_string(plan.last) + " cells; intensities and exponents on " +
                std::to_string(plan.fine)};
  };
  const bool bounded = !problem.friction().jumps().empty() && enclosure::why_energy_bounds_nothing(problem).empty();
  auto claim =
      formula_claim<ContactProblem, Prediction>(std::string(id))
          .cases(cases)
          .precision(Precision::in_double)
          // A study takes long. Therefore a claim and all its controls use the same study.
          .checked(
              [studies = std::make_shared<std::map<bool, ConvergenceStudy>>()](
                  Findings& findings, const Prediction& predicted, const ContactProblem& p, const Context& context) {
                ConvergenceStudy& found = (*studies)[context.quick];
                if (found.levels.empty()) found = study(p, context.quick ? StudyPlan::quick() : StudyPlan::full());
                const SolvedReference exact = reference(predicted.friction_reversed ? with_friction_reversed(p) : p);
                Comparison comparison(findings, found, exact.solved, predicted, context.quick);
                comparison.resultants(resultant_names(p));
                comparison.proved_resultants();
                comparison.intensities();
                comparison.ends();
                comparison.exponents();
              })
          .wrong("a rate higher by one", &Prediction::rate_offset, 1)
          .wrong(problem.friction().values().size() > 1 ? "the reference with the friction values in the other order"
                                                        : "the reference sliding the other way",
                 &Prediction::friction_reversed, true)
          .wrong("exponents with `alpha`'s sign reversed", &Prediction::angle_reversed, true)
          .wrong("every end two cells further right", &Prediction::end_offset, 2)
          .wrong("near miss: intensities off by ten times what the finest mesh allows", &Prediction::intensity_offset,
                 10);
  return bounded ? std::move(claim).wrong("resultants off by twice what is proved", &Prediction::resultant_offset, 2)
                 : std::move(claim);
}

}  // namespace steadyslide::proofs_checks
