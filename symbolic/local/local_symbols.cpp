// The table of local actions, printed from what `act` computes.

#include "symbolic/field/formula_text.hpp"
#include "symbolic/field/rational_function.hpp"
#include "symbolic/local/local_action.hpp"

namespace steadyslide::symbolic {
namespace {

using GiNaC::ex;

const LatexNames names{{"pi", "\\pi"}};

Formula monomial_text(bool fractional, int logs) {
  Formula result;
  if (fractional) result = {"|x|^lambda", "|x|^{\\lambda}"};
  if (logs > 0) {
    const std::string power = logs > 1 ? "^" + std::to_string(logs) : "";
    result = {result.text + (result.text.empty() ? "" : " ") + "L" + power, result.latex + " L" + power};
  }
  return result;
}

Formula on_side(const LocalDensity& density, Side side) {
  Formula total;
  for (const auto& [monomial, coefficient] : density) {
    if (monomial.side != side || coefficient.is_zero()) continue;
    total = sum(total, product(canonical_text(coefficient), monomial_text(monomial.fractional, monomial.logs), names));
  }
  return total.text.empty() ? Formula{"0", "0"} : total;
}

/// Without the constant, which is on both sides the same where the density has no |x|^lambda.
void drop_constant(LocalDensity& image) {
  const LocalMonomial left{Side::left, false, 0, 0};
  const LocalMonomial right{Side::right, false, 0, 0};
  if (!image.contains(left) || !image.contains(right)) return;
  const ex common = image[left];
  image[left] = 0;
  image[right] = (image[right] - common).expand();
}

LocalSymbol line(const std::string& id, const LocalDensity& density, const LocalConstants& constants) {
  LocalSymbol symbol{id, density, act(density, constants), {}, {}, {}};
  const LocalMonomial& first = density.begin()->first;
  if (!first.fractional) drop_constant(symbol.image);
  const Formula left = on_side(symbol.image, Side::left);
  const Formula right = on_side(symbol.image, Side::right);
  const std::string where = density.size() > 1 ? "on the line" : first.side == Side::right ? "on x > 0" : "on x < 0";
  const std::string where_latex = density.size() > 1 ? "x \\ne 0" : first.side == Side::right ? "x > 0" : "x < 0";
  const Formula from = monomial_text(first.fractional, first.logs);
  symbol.statement = {"H[" + (from.text.empty() ? "1" : from.text) + " " + where + "] = " + left.text + " for x < 0, " +
                          right.text + " for x > 0; C = cot(pi lambda), S = 1/sin(pi lambda), L = log|x|",
                      "H\\left[" + (from.latex.empty() ? "1" : from.latex) + ",\\ " + where_latex +
                          "\\right] = \\begin{cases} " + left.latex + " & x < 0 \\\\ " + right.latex +
                          " & x > 0 \\end{cases}"};
  if (first.fractional) {
    symbol.strip = {"-1 < lambda < 0 on the whole half-line; cut off at |x| = 1, every lambda > -1 that is no integer",
                    "-1 < \\lambda < 0,\\ \\text{continued to}\\ \\lambda > -1,\\ \\lambda \\ne 0, 1, 2, \\dots"};
    symbol.modulo = {"cut off at |x| = 1: " + std::string(first.side == Side::right ? "-" : "") +
                         "(1/pi) sum_{k>=0} y^k/(k - lambda)^" + std::to_string(first.logs + 1) +
                         ", y = " + (first.side == Side::right ? "x" : "-x") + ": the same series on both sides of 0",
                     std::string(first.side == Side::right ? "-" : "") + "\\frac{1}{\\pi}\\sum_{k\\ge 0}\\frac{" +
                         (first.side == Side::right ? "x" : "(-x)") + "^{k}}{(k-\\lambda)^{" +
                         std::to_string(first.logs + 1) + "}}"};
  } else {
    symbol.strip = {"the finite part at lambda = 0; times x^n: the finite part at lambda = n, n = 0, 1, 2, ...",
                    "\\lambda = n,\\ n = 0, 1, 2, \\dots"};
    symbol.modulo = {
        "a constant, and the power series in x that a cut-off at |x| = 1 adds: the same on both sides of 0",
        "\\sum_{k\\ge 0} c_k x^{k}"};
  }
  return symbol;
}

}  // namespace

std::vector<LocalSymbol> local_symbols(const LocalConstants& constants) {
  std::vector<LocalSymbol> all;
  for (const bool fractional : {true, false}) {
    for (const int logs : {0, 1}) {
      for (const Side side : {Side::right, Side::left}) {
        const std::string kind = fractional ? (logs > 0 ? "power-log" : "power") : (logs > 0 ? "log" : "one");
        all.push_back(
            line(kind + (side == Side::right ? "-right" : "-left"), {{{side, fractional, 0, logs}, 1}}, constants));
      }
    }
  }
  all.push_back(line("log-line", {{{Side::left, false, 0, 1}, 1}, {{Side::right, false, 0, 1}, 1}}, constants));
  return all;
}

}  // namespace steadyslide::symbolic
