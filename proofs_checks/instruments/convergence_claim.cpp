// The solver on cells, which knows no exponents, against the Riemann-Hilbert solution: ends, resultants, intensities
// and exponents, at the rates that theory predicts.

#include <cmath>
#include <map>
#include <stdexcept>

#include "proofs_checks/instruments/convergence_claim.hpp"
#include "proofs_checks/instruments/convergence_study.hpp"
#include "proofs_checks/kit/findings.hpp"

namespace steadyslide::proofs_checks {
namespace {

/// A wrong variant of what is predicted; with the defaults, the right one.
struct Variant {
  double rate_offset = 0;
  bool friction_reversed = false;  ///< in the reference
  bool angle_reversed = false;     ///< in the exponents
  double end_offset = 0;           ///< of the reference's ends, in cells
  double intensity_offset = 0;     ///< of the reference's, in tolerances
};

/// A study is long, and a claim and all its controls look at the same one.
class Studies {
 public:
  explicit Studies(ContactProblem problem) : problem_(std::move(problem)) {}

  const ConvergenceStudy& of(bool quick) {
    const auto found = studies_.find(quick);
    if (found != studies_.end()) return found->second;
    return studies_.emplace(quick, study(problem_, quick ? StudyPlan::quick() : StudyPlan::full())).first->second;
  }

 private:
  ContactProblem problem_;
  std::map<bool, ConvergenceStudy> studies_;
};

class Comparison {
 public:
  Comparison(Findings& findings, const ConvergenceStudy& study, const SolvedQuantities& exact, const Variant& variant,
             bool quick)
      : findings_(findings), study_(study), exact_(exact), variant_(variant), quick_(quick) {}

  void resultants(const std::vector<std::string>& names) {
    const std::size_t first = std::size_t{1} << (quick_ ? 6 : 8);
    for (std::size_t k = 0; k < names.size(); ++k) {
      rate("error of the " + names[k], first,
           [&](const MeshLevel& level) { return resultant_error(level, exact_, k); });
    }
  }

  /// Reading adds an error of its own, of first order: what is of second order is not seen beside it.
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
      const double exact = exact_.intensities[k] * (1 + variant_.intensity_offset * tolerance);
      findings_.compare(quantity, relative_difference(found[k], exact));
    }
  }

  void ends() {
    const std::vector<std::string> routes{"cells in contact", "solution of the Riemann-Hilbert problem"};
    const Quantity free{"place of a free end of contact, in cells", routes, 1};
    const Quantity edge{"place of an end at an edge or step", routes, 1e-14};
    for (const MeshLevel& level : study_.levels) {
      for (const OnMesh& mesh : level.meshes) {
        findings_.begin_case(std::to_string(mesh.cells) + " cells");
        const auto& found = mesh.solved.ends;
        findings_.require(found.size() == exact_.ends.size(), "another number of contact ends");
        for (std::size_t i = 0; i < found.size(); ++i) {
          const double off = std::abs(found[i].x - exact_.ends[i].x - variant_.end_offset * mesh.cell_length);
          findings_.require(found[i].exact == exact_.ends[i].exact, "an edge or step is one for one solver only");
          findings_.compare(found[i].exact ? edge : free, found[i].exact ? off : off / mesh.cell_length);
        }
      }
    }
  }

  void exponents() {
    const std::vector<std::string> routes{"fit to the cells", "local equation"};
    const Quantity bar{"error bar of an exponent that is read off the cells", {}, quick_ ? 0.05 : 0.01};
    const Quantity agrees{"distance of the exponents, in error bars", routes, 1};
    const Quantity excludes{"error bar over the distance to the exponent with alpha of the other sign", {}, 1};
    for (const ReadExponent& read : study_.exponents) {
      findings_.begin_case("x = " + std::to_string(read.x));
      const double right = numeric::to_real<double>(variant_.angle_reversed ? read.reversed : read.derived);
      const double wrong = numeric::to_real<double>(variant_.angle_reversed ? read.derived : read.reversed);
      const double value = read.found.value;
      const double error = read.found.error;
      findings_.compare(bar, error);
      findings_.compare(agrees, std::abs(value - right) / error);
      findings_.compare(excludes, error / std::abs(value - wrong));
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
        std::to_string(study_.levels.back().cells) + " cells";
    findings_.begin_case("all levels");
    findings_.require(!std::isnan(measured.value), "no rate of " + what + ": an error is not positive and finite");
    findings_.measure(
        {what, measured.value, measured.error_bar, study_.rate + variant_.rate_offset, quick_ ? 0.25 : 0.1, detail});
  }

  Findings& findings_;
  const ConvergenceStudy& study_;
  const SolvedQuantities& exact_;
  const Variant& variant_;
  bool quick_;
};

Claim claim_of_case(const ConvergenceCase& the_case) {
  const auto studies = std::make_shared<Studies>(the_case.problem);
  const ContactProblem& problem = the_case.problem;
  const auto check = [problem, studies](const Context& context, const Variant& variant) {
    return gather([&] {
      const ConvergenceStudy& study = studies->of(context.quick);
      const SolvedReference exact = reference(variant.friction_reversed ? with_friction_reversed(problem) : problem);
      Findings findings;
      Comparison comparison(findings, study, exact.solved, variant, context.quick);
      comparison.resultants(resultant_names(problem));
      comparison.intensities();
      comparison.ends();
      comparison.exponents();
      return findings.evidence("from 64 to " + std::to_string(study.levels.back().cells) + " cells; intensities and " +
                               "exponents on " + std::to_string(study.fine.cells));
    });
  };
  const bool jumps = problem.friction().values().size() > 1;
  // Plain: the tolerances are lengths of cells, which the study knows and no prediction does.
  return make_claim<Variant>(
      claim_text("vi-convergence-" + the_case.name), check, {},
      {{"a rate higher by one", {.rate_offset = 1}},
       {jumps ? "the reference with the friction values in the other order" : "the reference sliding the other way",
        {.friction_reversed = true}},
       {"exponents with alpha's sign reversed", {.angle_reversed = true}},
       {"every end two cells further right", {.end_offset = 2}},
       {"near miss: intensities off by ten times what the finest mesh allows", {.intensity_offset = 10}}});
}

}  // namespace

Claim convergence_claim(std::string_view name) {
  for (const ConvergenceCase& the_case : convergence_cases()) {
    if (the_case.name == name) return claim_of_case(the_case);
  }
  throw std::logic_error("no such case: " + std::string(name));
}

}  // namespace steadyslide::proofs_checks
