#include "symbolic/field/field_linear.hpp"

#include <algorithm>
#include <utility>

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;

/// True if the factor vanishes nowhere: a power of a number, of a radical, of 1 + s^2 or of the symbol pi, or one of
/// the elements `known` to be without zeros.
bool vanishes_nowhere(const PhaseField& field, const ex& factor, const FieldRow& known) {
  if (GiNaC::is_a<GiNaC::numeric>(factor)) return true;
  if (GiNaC::is_a<GiNaC::power>(factor)) return vanishes_nowhere(field, factor.op(0), known);
  if (GiNaC::is_a<GiNaC::mul>(factor)) {
    for (std::size_t k = 0; k < factor.nops(); ++k) {
      if (!vanishes_nowhere(field, factor.op(k), known)) return false;
    }
    return true;
  }
  if (GiNaC::is_a<GiNaC::symbol>(factor) && GiNaC::ex_to<GiNaC::symbol>(factor).get_name() == "pi") return true;
  for (const ex& element : known) {
    if (GiNaC::is_a<GiNaC::numeric>((factor / element).normal())) return true;
  }
  for (const PhaseField::Radical& radical : field.radicals()) {
    if (ex(radical.root).is_equal(factor)) return true;
    const ex quotient = radical.square.is_zero() ? ex(0) : (factor / radical.square).normal();
    if (GiNaC::is_a<GiNaC::numeric>(quotient) && !quotient.is_zero()) return true;
  }
  return false;
}

/// Returns the factors of the numerator that can vanish. The element can be a divisor where none of them does.
std::vector<ex> vanishing_factors(const PhaseField& field, const ex& element, const FieldRow& known) {
  const ex product = GiNaC::factor(element.numer().expand());
  std::vector<ex> factors;
  const auto keep = [&](const ex& factor) {
    if (vanishes_nowhere(field, factor, known)) return;
    factors.push_back(GiNaC::is_a<GiNaC::power>(factor) ? factor.op(0) : factor);
  };
  if (!GiNaC::is_a<GiNaC::mul>(product)) {
    keep(product);
  } else {
    for (std::size_t k = 0; k < product.nops(); ++k) keep(product.op(k));
  }
  return factors;
}

/// Returns the text of the factor, up to its sign.
std::string condition(const PhaseField& field, const ex& factor) {
  const std::string text = field.text(factor);
  return text[0] == '-' ? field.text(-factor) : text;
}

}  // namespace

std::set<std::string> nonvanishing_of(const PhaseField& field, const ex& divisor) {
  std::set<std::string> result;
  for (const ex& factor : vanishing_factors(field, field.canonical(divisor), {}))
    result.insert(condition(field, factor));
  return result;
}

LinearSolution solve(const PhaseField& field, std::size_t unknowns, std::vector<FieldRow> rows, FieldRow rhs,
                     const FieldRow& known) {
  for (FieldRow& row : rows) {
    for (ex& entry : row) entry = field.canonical(entry);
  }
  for (ex& entry : rhs) entry = field.canonical(entry);

  LinearSolution solution{true, FieldRow(unknowns), {}, {}, {}};
  std::vector<std::size_t> pivots;  // the unknown that each reduced row determines
  for (std::size_t column = 0; column < unknowns; ++column) {
    // Prefer a pivot that vanishes nowhere, because any other adds a condition; then prefer the row with the most
    // zeros.
    std::size_t found = rows.size();
    auto best = std::pair(true, unknowns + 1);
    for (std::size_t row = pivots.size(); row < rows.size(); ++row) {
      if (rows[row][column].is_zero()) continue;
      const auto filled = std::count_if(rows[row].begin(), rows[row].end(), [](const ex& e) { return !e.is_zero(); });
      const auto cost =
          std::pair(!vanishing_factors(field, rows[row][column], known).empty(), static_cast<std::size_t>(filled));
      if (cost < best) {
        best = cost;
        found = row;
      }
    }
    if (found == rows.size()) {
      solution.free.push_back(column);
      continue;
    }
    const std::size_t at = pivots.size();
    std::swap(rows[at], rows[found]);
    std::swap(rhs[at], rhs[found]);
    const ex pivot = rows[at][column];
    solution.nonvanishing.merge(nonvanishing_of(field, pivot));
    for (ex& entry : rows[at]) entry = field.canonical(entry / pivot);
    rhs[at] = field.canonical(rhs[at] / pivot);
    for (std::size_t row = 0; row < rows.size(); ++row) {
      if (row == at || rows[row][column].is_zero()) continue;
      const ex factor = rows[row][column];
      for (std::size_t k = 0; k < unknowns; ++k) rows[row][k] = field.canonical(rows[row][k] - factor * rows[at][k]);
      rhs[row] = field.canonical(rhs[row] - factor * rhs[at]);
    }
    pivots.push_back(column);
  }
  for (std::size_t row = pivots.size(); row < rows.size(); ++row) {
    if (!rhs[row].is_zero()) solution.solvable = false;
  }
  for (std::size_t row = 0; row < pivots.size(); ++row) solution.particular[pivots[row]] = rhs[row];
  for (const std::size_t unknown : solution.free) {
    FieldRow vector(unknowns);
    vector[unknown] = 1;
    for (std::size_t row = 0; row < pivots.size(); ++row) vector[pivots[row]] = -rows[row][unknown];
    solution.kernel.push_back(vector);
  }
  return solution;
}

ex determinant(const PhaseField& field, const std::vector<FieldRow>& rows) {
  if (rows.empty()) return 1;
  ex sum = 0;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    std::vector<FieldRow> minor(rows.begin() + 1, rows.end());
    for (FieldRow& row : minor) row.erase(row.begin() + static_cast<std::ptrdiff_t>(k));
    const ex term = rows[0][k] * determinant(field, minor);
    sum += k % 2 == 0 ? term : ex(-term);
  }
  return field.canonical(sum);
}

}  // namespace steadyslide::symbolic
