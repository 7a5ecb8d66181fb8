#pragma once

#include <string>

namespace steadyslide::app {

/// Returns the bytes of an HDF5 file with a dataset for each column of a table in CSV. A column is 64-bit numbers, NaN
/// for an empty cell, if all other cells are numbers; otherwise it is UTF-8 strings. The last column, failed_condition,
/// is always strings. The same table gives the same bytes. Throws Failure.
std::string hdf5_of(const std::string& table);

}  // namespace steadyslide::app
