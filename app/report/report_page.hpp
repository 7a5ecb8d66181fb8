#pragma once
// The verification report: one HTML page that needs nothing else, no network and no file beside it.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/figures/figures.hpp"
#include "app/tables/exponent_tables.hpp"
#include "app/verify/verify_writers.hpp"

namespace steadyslide::app {

/// A row of docs/mutants.csv: a deliberate fault in the program, and what notices it.
struct Mutant {
  std::string id;
  std::string file;
  std::string change;
  std::string killer;
  std::string evidence;
};

/// Lines after the first, which names the columns id,file,change,killer,evidence. Fields may be quoted, with "" for a
/// quote and line breaks inside; a line with fewer fields leaves the rest empty.
std::vector<Mutant> read_mutants(std::string_view csv);

/// What stands on the page beside the ledger. Parts that are empty are left out.
struct Supplement {
  std::vector<DrawnFigure> figures;
  std::string no_figures;  ///< why there are none, a sentence
  std::vector<TextTable> tables;
  std::vector<Mutant> mutants;
  std::vector<std::pair<std::string, std::string>> made = {};  ///< how the page was made: what, and its name
};

/// The date, the program, its commit, compiler and libraries.
std::vector<std::pair<std::string, std::string>> made_now();

/// The same page for the same arguments.
std::string report_html(const VerifyResult& result, const Supplement& supplement);

}  // namespace steadyslide::app
