#pragma once

#include <string>

namespace steadyslide::app {

/// The bytes of an HDF5 file with a dataset for each column of a table in CSV: 64-bit numbers, NaN where a cell is empty,
/// if all other cells are numbers; else UTF-8 strings. The last column, failed_condition, is strings always. The same table
/// gives the same bytes. Throws Failure.
std::string hdf5_of(const std::string& table);

}  // namespace steadyslide::app
