#include "library/problem_file/surface_files.hpp"

#include <fmt/format.h>

#include <cstdlib>

#include "library/problem_file/input_file.hpp"
#include "library/problem_file/table_reader.hpp"

namespace steadyslide::library {
namespace {

void check_room(const TableReader& reader, std::size_t count, const std::string& what, std::size_t most = max_points) {
  if (count < most) return;
  throw reader.error("too many " + what, fmt::format("there are at most {}", most), "more");
}

}  // namespace

std::vector<DepthPoint> parse_depth_points(std::string_view text, const std::string& name) {
  TableReader reader(name, {"a table of points", "x,z", {"x", "z"}, 2});
  std::vector<DepthPoint> points;
  reader.read(text, [&](std::vector<Rational>& row) {
    check_room(reader, points.size(), "points");
    if (row[1] < 0) throw reader.error("z: outside the body", "the depth z is at least 0", to_string(row[1]));
    points.push_back({std::move(row[0]), std::move(row[1])});
  });
  if (points.empty()) throw reader.error("no points", "there is at least one line x,z", "0 points");
  return points;
}

std::vector<DepthPoint> read_depth_points(const std::string& name) {
  return parse_depth_points(read_input(name, "a table of points"), name);
}

std::vector<Rational> parse_places(std::string_view text, const std::string& name, std::size_t most) {
  TableReader reader(name, {"a table of places", "x", {"x"}, 1});
  std::vector<Rational> places;
  reader.read(text, [&](std::vector<Rational>& row) {
    check_room(reader, places.size(), "places", most);
    places.push_back(std::move(row[0]));
  });
  if (places.empty()) throw reader.error("no places", "there is at least one line x", "0 places");
  return places;
}

std::vector<Rational> read_places(const std::string& name, std::size_t most) {
  return parse_places(read_input(name, "a table of places"), name, most);
}

MeshFile::MeshFile(std::string_view text, std::string name) : name_(std::move(name)) {
  TableReader reader(name_, {"a mesh", "x or x,order", {"x", "order"}, 1});
  std::vector<Rational> nodes;
  std::optional<int> order;
  std::size_t columns = 0;
  reader.read(text, [&](std::vector<Rational>& row) {
    check_room(reader, nodes.size(), "nodes");
    if (nodes.empty()) columns = row.size();
    if (row.size() != columns) {
      throw reader.error("wrong number of columns", "all lines of a mesh have as many as its first one",
                         fmt::format("{} columns", row.size()));
    }
    const Rational of_row = columns == 2 ? row[1] : Rational(1);
    if (of_row != 1 && of_row != 2) {
      throw reader.error("order: wrong order", "elements are of order 1 or 2", to_string(of_row));
    }
    if (order && of_row != *order) {
      throw reader.error("order: another order", "a mesh has elements of one order",
                         fmt::format("{} after {}", to_string(of_row), *order));
    }
    order = of_row == 1 ? 1 : 2;
    nodes.push_back(std::move(row[0]));
    lines_.push_back(reader.line());
  });
  if (nodes.empty()) throw reader.error("no nodes", "a mesh has an element at least", "0 nodes");
  try {
    mesh_.emplace(std::move(nodes), *order);
  } catch (const InvalidData& invalid) {
    throw error(invalid);
  }
}

InvalidFile MeshFile::error(const InvalidData& invalid) const {
  const std::size_t bracket = invalid.field().find('[');
  const std::size_t node = bracket == std::string::npos
                               ? lines_.size() - 1
                               : std::strtoul(invalid.field().c_str() + bracket + 1, nullptr, 10);
  return InvalidFile(fmt::format("{}:{}: x: {}", name_, lines_[node], invalid.what()));
}

MeshFile read_mesh(const std::string& name) { return {read_input(name, "a mesh"), name}; }

}  // namespace steadyslide::library
