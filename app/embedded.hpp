#pragma once
// Files of the source tree that the build puts into the executable (cmake/embed.cmake).

#include <string>
#include <string_view>

#include "library/text/version.hpp"

namespace steadyslide::app {

using library::version;
using library::version_date;

/// Returns the commit that a program with the ledger was built from; empty if it is not known.
std::string commit();

namespace embedded {

// Help texts. The text of a command is a description and, after an empty line, the text below its options.
extern const std::string_view help_program;  ///< the text below the commands
extern const std::string_view help_problem;  ///< the text on problem files
extern const std::string_view help_exponents;
extern const std::string_view help_table;
extern const std::string_view help_solve;
extern const std::string_view help_solve_manual;  ///< in the manual page alone
extern const std::string_view help_design;
extern const std::string_view help_sweep;
extern const std::string_view help_wear;
extern const std::string_view help_verify;
extern const std::string_view help_figures;
extern const std::string_view help_report;

extern const std::string_view preamble_tex;       ///< the beginning of a LaTeX document with tables
extern const std::string_view rough_surface_csv;  ///< a trace for a figure

// Parts of the report.
extern const std::string_view report_html;  ///< the page, with names in braces at the places to fill in
extern const std::string_view tools_html;   ///< above the ledger: filter, order, folds
extern const std::string_view guide_html;   ///< instructions for reading the ledger
extern const std::string_view report_css;
extern const std::string_view report_js;
extern const std::string_view sketch_svg;  ///< docs/sketch.svg
extern const std::string_view result_txt;  ///< the main result, with formulas between backticks
extern const std::string_view references_md;
extern const std::string_view theory_md;  ///< symbols, and the words and data of the tables of exponents
extern const std::string_view mutants_csv;

}  // namespace embedded
}  // namespace steadyslide::app
