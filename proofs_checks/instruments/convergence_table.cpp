#include "proofs_checks/instruments/convergence_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

#include "proofs_checks/instruments/convergence_study.hpp"

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

/// The farthest free end from the exact one on any mesh of the level, in cells.
double worst_end(const MeshLevel& level, const SolvedQuantities& exact) {
  double worst = 0;
  for (const OnMesh& mesh : level.meshes) {
    for (std::size_t i = 0; i < exact.ends.size(); ++i) {
      worst = std::max(worst, std::abs(mesh.solved.ends.at(i).x - exact.ends[i].x) / mesh.cell_length);
    }
  }
  return worst;
}

/// For each column an error and the rate from the level before.
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
                    text("%.0e", read.found.error), text("%.5f", numeric::to_real<double>(read.derived)),
                    text("%.5f", numeric::to_real<double>(read.reversed))});
  }
  return result;
}

constexpr auto introduction =
    R"(# Convergence of the solver on cells

Made by `convergence-table > docs/convergence.md`; a test computes the numbers again.

The solver on N equal cells knows no exponents. Here it meets the Riemann–Hilbert solution, which is made of them. Each
row is the root mean square over 7 meshes of N, N + 1, … cells, or over 21 where the expected rate is 2, so that ends
and jumps fall everywhere within a cell; the ends are the worst of them. "rate" is the power of N since the row before.
Intensities are relative to the exact ones, and need 2048 cells.

The expected rate is the least λ + λ* + 2 over the singular points of the contact, λ* being the exponent of the adjoint
problem, where s has the other sign: 1 at an edge, at a step and at a friction jump (λ + λ* = −1), 2 at a free end (0),
3 at a wedge. A friction jump costs as much as an edge because the adjoint solution must be as strong there as
|x−c|^(−1−β). Reading an intensity off the cells has an error of its own, of about first order: the fits leave ten
cells out, however long a cell is. It shows where the solution's own error is small: at some edges, and wherever the
expected rate is 2.

Exponents are read on 16384 cells, each side of a friction jump by itself.
)";

}  // namespace

std::string convergence_document(bool quick) {
  StudyPlan plan = StudyPlan::full();
  if (quick) plan = {std::size_t{1} << 9, std::size_t{1} << 9, StudyPlan::Exponents::none};
  std::string result = introduction;
  for (const ConvergenceCase& the_case : convergence_cases()) {
    const ConvergenceStudy found = study(the_case.problem, plan);
    const SolvedReference exact = reference(the_case.problem);
    result +=
        "\n## " + the_case.name + "\n\nFor " + the_case.what + "; expected rate " + text("%.0f", found.rate) + ".\n\n";
    result += resultants_table(the_case, found, exact.solved);
    if (!quick) result += "\n" + intensities_table(found, exact) + "\n" + exponents_table(found);
  }
  return result;
}

}  // namespace steadyslide::proofs_checks
