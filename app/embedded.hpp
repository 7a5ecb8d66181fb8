#pragma once
// Files of the source tree that are put into the executable by the build (cmake/embed.cmake).

#include <string_view>

#include "library/text/version.hpp"

namespace steadyslide::app {

using library::version;

namespace embedded {

// What --help says: of a command what it does and, after an empty line, what stands below its options.
extern const std::string_view help_program;  ///< below the commands
extern const std::string_view help_problem;  ///< of problem files
extern const std::string_view help_exponents;
extern const std::string_view help_table;
extern const std::string_view help_solve;
extern const std::string_view help_solve_manual;  ///< in the manual page alone
extern const std::string_view help_design;
extern const std::string_view help_sweep;
extern const std::string_view help_verify;
extern const std::string_view help_figures;
extern const std::string_view help_report;

extern const std::string_view preamble_tex;       ///< what a document of tables begins with
extern const std::string_view rough_surface_csv;  ///< a trace for a figure

// What the report is made of.
extern const std::string_view report_html;  ///< the page, with places in braces for what it is about
extern const std::string_view tools_html;   ///< above the ledger: filter, order, folds
extern const std::string_view guide_html;   ///< how to read the ledger
extern const std::string_view report_css;
extern const std::string_view report_js;
extern const std::string_view sketch_svg;  ///< the problem
extern const std::string_view result_txt;  ///< the main result, with formulas between backticks
extern const std::string_view references_md;
extern const std::string_view theory_md;  ///< symbols, and the words and data of the tables of exponents
extern const std::string_view mutants_csv;

}  // namespace embedded
}  // namespace steadyslide::app
