#pragma once
// The verification report: one HTML page that needs nothing else, no network and no file beside it.

#include <string>
#include <vector>

#include "app/figures/figures.hpp"
#include "app/report/mutants.hpp"
#include "app/tables/exponent_tables.hpp"
#include "app/verify/verify_writers.hpp"

namespace steadyslide::app {

/// What stands on the page beside the ledger. Parts that are empty are left out.
struct Supplement {
  std::vector<DrawnFigure> figures;
  std::string no_figures;  ///< why there are none, a sentence
  std::vector<TextTable> tables;
  std::vector<Mutant> mutants;
};

/// The same page for the same arguments: it has no date.
std::string report_html(const VerifyResult& result, const Supplement& supplement);

}  // namespace steadyslide::app
