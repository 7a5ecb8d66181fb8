#pragma once
// The verification report: one HTML page that needs no network and no other file.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/figures/figures.hpp"
#include "app/tables/exponent_tables.hpp"
#include "app/verify/verify_writers.hpp"

namespace steadyslide::app {

/// A row of docs/mutants.csv: a deliberate fault in the program, and the check that finds it.
struct Mutant {
  std::string id;
  std::string file;
  std::string change;
  std::string killer;
  std::string evidence;
};

/// Returns the rows after the first one, which names the columns id,file,change,killer,evidence. A field may be quoted;
/// it then may contain line breaks, and "" stands for a quotation mark. If a row has fewer fields, the others are
/// empty.
std::vector<Mutant> read_mutants(std::string_view csv);

/// The parts of the page besides the ledger. The page leaves out empty ones.
struct Supplement {
  std::vector<DrawnFigure> figures;
  std::string no_figures;  ///< a sentence with the reason, if there are no figures
  std::vector<TextTable> tables;
  std::vector<Mutant> mutants;
  std::vector<std::pair<std::string, std::string>> made = {};  ///< for example "compiler" and its name
};

/// Returns the date, the program, and its commit, compiler and libraries.
std::vector<std::pair<std::string, std::string>> made_now();

/// Returns the page. The same arguments give the same page.
std::string report_html(const VerifyResult& result, const Supplement& supplement);

}  // namespace steadyslide::app
