#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace smile::mesh {

/// Limits of a mesh file, whose source is not trusted.
struct MeshLimits {
  std::size_t max_file_bytes = 64u << 20;  ///< the file and its buffers together
  std::size_t max_triangles = 200'000;
  std::size_t max_vertices = 600'000;  ///< after merging vertices at the same place

  bool operator==(const MeshLimits&) const = default;
};

/// Convention of a mesh file's axes.
enum class MeshAxes {
  kStanding,  ///< the file's Y is up and becomes z, as in scenes: (X, -Z, Y)
  kAsWritten  ///< (X, Y, Z), whatever the file names as up, as in robot descriptions
};

/// Reads a file that belongs to a mesh file, by its plain name, at most `max_bytes`.
/// @throws InputError if it is missing or must not be read.
using OpenNeighbour = std::function<std::string(const std::string& name, std::size_t max_bytes)>;

}  // namespace smile::mesh
