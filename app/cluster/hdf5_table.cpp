#include "app/cluster/hdf5_table.hpp"

#include <hdf5.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "app/embedded.hpp"
#include "app/results/rows.hpp"
#include "app/terminal/failure.hpp"

namespace steadyslide::app {
namespace {

/// Throws if a handle or a status of the HDF5 library is negative, which means an error.
template <class Result>
Result checked(Result result) {
  if (result < 0) throw Failure(ExitCode::failed, "the HDF5 library has failed");
  return result;
}

/// A handle of the HDF5 library.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(checked(id)), close_(close) {}
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() { close_(id_); }

  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

using NamedCells = std::vector<std::string>;

/// Returns the columns of a table in CSV. The first cell of each is its name.
std::vector<NamedCells> columns_of(std::string_view table) {
  std::vector<NamedCells> columns;
  for (const std::vector<std::string>& row : csv_rows(table)) {
    columns.resize(std::max(columns.size(), row.size()));
    for (std::size_t k = 0; k < row.size(); ++k) columns[k].push_back(row[k]);
  }
  return columns;
}

/// Empty unless every cell is a number or empty.
std::optional<std::vector<double>> numbers_of(const NamedCells& cells) {
  std::vector<double> numbers;
  for (std::size_t k = 1; k < cells.size(); ++k) {
    double number = std::numeric_limits<double>::quiet_NaN();
    const char* const last = cells[k].data() + cells[k].size();
    if (!cells[k].empty() && std::from_chars(cells[k].data(), last, number).ptr != last) return std::nullopt;
    numbers.push_back(number);
  }
  return numbers;
}

hid_t string_type() {
  const hid_t type = checked(H5Tcopy(H5T_C_S1));
  checked(H5Tset_size(type, H5T_VARIABLE));
  checked(H5Tset_cset(type, H5T_CSET_UTF8));
  return type;
}

/// A dataset, or the values of an attribute.
struct Data {
  hid_t type;
  const void* values;
};

void write(const Handle& file, const NamedCells& column, const Data& data) {
  const hsize_t rows = column.size() - 1;
  const Handle space(H5Screate_simple(1, &rows, nullptr), H5Sclose);
  const Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  checked(H5Pset_obj_track_times(properties, false));
  const Handle set(H5Dcreate2(file, column.front().c_str(), data.type, space, H5P_DEFAULT, properties, H5P_DEFAULT),
                   H5Dclose);
  checked(H5Dwrite(set, data.type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data.values));
}

}  // namespace

std::string hdf5_of(const std::string& table) {
  checked(H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr));
  // The file is made in memory: the caller writes its bytes as a whole or not at all.
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  checked(H5Pset_fapl_core(access, std::size_t{1} << 20, false));
  const Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
  checked(H5Pset_obj_track_times(creation, false));
  checked(H5Pset_link_creation_order(creation, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED));
  const Handle file(H5Fcreate("table", H5F_ACC_TRUNC, creation, access), H5Fclose);
  const Handle strings(string_type(), H5Tclose);
  const std::vector<NamedCells> columns = columns_of(table);
  for (const NamedCells& column : columns) {
    const auto numbers = &column == &columns.back() ? std::nullopt : numbers_of(column);
    if (numbers) {
      write(file, column, {H5T_NATIVE_DOUBLE, numbers->data()});
      continue;
    }
    std::vector<const char*> words;
    for (std::size_t k = 1; k < column.size(); ++k) words.push_back(column[k].c_str());
    write(file, column, {strings, words.data()});
  }
  const Handle one(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle attribute(H5Acreate2(file, "steadyslide", strings, one, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  checked(H5Awrite(attribute, strings, &version));
  checked(H5Fflush(file, H5F_SCOPE_GLOBAL));
  const ssize_t size = checked(H5Fget_file_image(file, nullptr, 0));
  std::string bytes(static_cast<std::size_t>(size), '\0');
  checked(H5Fget_file_image(file, bytes.data(), bytes.size()));
  return bytes;
}

}  // namespace steadyslide::app
