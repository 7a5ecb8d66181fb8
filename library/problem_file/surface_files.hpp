#pragma once
// Points below the surface, places and nodes on it, as tables (table_reader.hpp):
//
//   x         places of samples,
//   x,z       points of stresses and displacements, z >= 0 the depth,
//   x         nodes of linear elements, x increasing,
//   x,order   the same with elements of order 1 or 2, one order for all; order 2: every second node is a midside one.
//
// All in the user's unit of length, exact. Every error message names the file and the line.

#include <optional>
#include <string>
#include <vector>

#include "library/problem_file/file_error.hpp"
#include "model/invalid_data.hpp"
#include "model/surface_mesh.hpp"

namespace steadyslide::library {

inline constexpr std::size_t max_points = 1000000;

struct DepthPoint {
  Rational x;
  Rational z;
};

/// These functions throw InvalidFile "NAME:LINE: what is wrong; the rule; the value".
std::vector<DepthPoint> parse_depth_points(std::string_view text, const std::string& name);
std::vector<DepthPoint> read_depth_points(const std::string& name);

/// Throws like parse_depth_points, also if there are more than `most` places.
std::vector<Rational> parse_places(std::string_view text, const std::string& name, std::size_t most);
std::vector<Rational> read_places(const std::string& name, std::size_t most);

class MeshFile {
 public:
  /// Throws like parse_depth_points.
  MeshFile(std::string_view text, std::string name);

  const SurfaceMesh& mesh() const { return *mesh_; }
  /// Returns the error of an invalid mesh with its line: the line of the node if the field is "nodes[i]", otherwise the
  /// last line.
  InvalidFile error(const InvalidData& invalid) const;

 private:
  std::string name_;
  std::vector<std::size_t> lines_;  ///< the line of each node
  std::optional<SurfaceMesh> mesh_;
};

MeshFile read_mesh(const std::string& name);

}  // namespace steadyslide::library
