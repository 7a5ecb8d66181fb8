// In place of library/problem_file/symbol_table.cpp: the page has no files.

#include "library/problem_file/symbol_table.hpp"

#include "library/problem_file/file_error.hpp"

namespace steadyslide::library {

std::vector<SymbolRow> parse_symbols(std::string_view, const std::string& name) {
  throw InvalidFile(name + ": symbols of a body; the Explorer reads no files beside a problem; symbol");
}

}  // namespace steadyslide::library
