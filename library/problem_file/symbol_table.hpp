#pragma once
// The symbols of a body as a table k,W,gamma V (table_reader.hpp), one row for each wave number. Every error message
// names the file and the line.

#include <string>
#include <string_view>
#include <vector>

#include "model/body.hpp"

namespace steadyslide::library {

inline constexpr std::size_t max_symbol_rows = 100000;

/// Throws InvalidFile.
std::vector<SymbolRow> parse_symbols(std::string_view text, const std::string& name);

}  // namespace steadyslide::library
