#include "proofs_checks/instruments/convergence/convergence_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

#include "proofs_checks/instruments/convergence/convergence_study.hpp"

namespace steadyslide::proofs_checks {

namespace {

using Row = std::vector<std::string>;

std::string text(const char* format, double value) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, format, value);
  return buffer;
}

std::string line(const Row& row) {
  std::string result = "|";
  for (const std::string& cell : row) result += " " + cell + " |";
  return result + "\n";
}

std::string head(const Row& row) { return line(row) + line(Row(row.size(), "---")); }

/// Returns the largest distance of a contact end from the exact one on any mesh of the level, in cells.
double worst_end(const MeshLevel& level, const SolvedQuantities& exact) {
  double worst = 0;
  for (const OnMesh& mesh : level.meshes) {
    for (std::size_t i = 0; i < exact.ends.size(); ++i) {
      worst = std::max(worst, std::abs(mesh.solved.ends.at(i).x - exact.ends[i].x) / mesh.cell_length);
    }
  }
  return worst;
}

/// A table with an error for each column and its rate from the level before.
class ErrorTable {
 public:
  using Error = std::function<double(const MeshLevel&, std::size_t)>;

  ErrorTable(const std::vector<std::string>& names, Error error) : error_(std::move(error)), before_(names.size(), 0) {}

  static Row columns(Row before, const std::vector<std::string>& names) {
    for (const std::string& name : names) {
      before.push_back(name);
      before.emplace_back("rate");
    }
    return before;
  }

  Row row(Row before, const MeshLevel& level) {
    for (std::size_t k = 0; k < before_.size(); ++k) {
      const double error = error_(level, k);
      before.push_back(text("%.1e", error));
      before.push_back(before_[k] > 0 ? text("%.2f", std::log2(before_[k] / error)) : "");
      before_[k] = error;
    }
    return before;
  }

 private:
  Error error_;
  std::vector<double> before_;
};

std::string resultants_table(const ConvergenceCase& the_case, const ConvergenceStudy& study,
                             const SolvedQuantities& exact) {
  const std::vector<std::string> names = resultant_names(the_case.problem);
  ErrorTable table(names, [&](const MeshLevel& level, std::size_t k) { return resultant_error(level, exact, k); });
  std::string result = head(ErrorTable::columns({"cells", "ends, in cells"}, names));
  for (const MeshLevel& level : study.levels) {
    result += line(table.row({std::to_string(level.cells), text("%.2f", worst_end(level, exact))}, level));
  }
  return result;
}

/// Returns the proved bounds on the first mesh of each level. Returns an empty text if there are none.
std::string bounds_table(const ConvergenceCase& the_case, const ConvergenceStudy& study) {
  const std::vector<std::string> names = resultant_names(the_case.problem);
  std::string result;
  for (const MeshLevel& level : study.levels) {
    if (!level.bound) continue;
    Row row{std::to_string(level.cells), text("%.1e", level.bound->energy.to_double())};
    Row columns{"cells", "energy"};
    for (std::size_t k = 0; const enclosure::Ball* ball = proved_resultant(*level.bound, k); ++k) {
      columns.insert(columns.end(), {names[k], "±"});
      row.insert(row.end(), {text("%.6f", ball->to_double()), text("%.1e", ball->radius().to_double())});
    }
    if (result.empty()) result = "\nProved:\n\n" + head(columns);
    result += line(row);
  }
  return result;
}

std::string intensities_table(const ConvergenceStudy& study, const SolvedReference& exact) {
  ErrorTable table(exact.intensity_names,
                   [&](const MeshLevel& level, std::size_t k) { return intensity_error(level, exact.solved, k); });
  std::string result = head(ErrorTable::columns({"cells"}, exact.intensity_names));
  for (const MeshLevel& level : study.levels) {
    if (level.cells >= first_with_intensities) result += line(table.row({std::to_string(level.cells)}, level));
  }
  return result;
}

std::string exponents_table(const ConvergenceStudy& study) {
  std::string result = head({"x", "side", "read", "error bar", "derived", "with the other sign of α"});
  for (const ReadExponent& read : study.exponents) {
    result += line({text("%.4f", read.x), read.side == Side::left ? "left" : "right", text("%.5f", read.found.value),
                    text("%.0e", read.found.error), text("%.5f", to_real<double>(read.derived)),
                    text("%.5f", to_real<double>(read.reversed))});
  }
  return result;
}

}  // namespace

std::string convergence_document(bool quick) {
  StudyPlan plan = StudyPlan::full();
  if (quick) plan = {std::size_t{1} << 9, std::size_t{1} << 9, StudyPlan::Exponents::none};
  std::string result;
  for (const ConvergenceCase& the_case : convergence_cases()) {
    const ConvergenceStudy found = study(the_case.problem, plan);
    const SolvedReference exact = reference(the_case.problem);
    result +=
        "\n### " + the_case.name + "\n\nFor " + the_case.what + "; expected rate " + text("%.0f", found.rate) + ".\n\n";
    result += resultants_table(the_case, found, exact.solved) + bounds_table(the_case, found);
    if (!quick) result += "\n" + intensities_table(found, exact) + "\n" + exponents_table(found);
  }
  return result;
}

}  // namespace steadyslide::proofs_checks
