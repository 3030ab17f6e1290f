#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace smile::mesh {

/// What a mesh file may cost: files come from anywhere.
struct MeshLimits {
  std::size_t max_file_bytes = 64u << 20;  ///< of the file and what belongs to it together
  std::size_t max_triangles = 200'000;
  std::size_t max_vertices = 600'000;  ///< after those at the same place became one

  bool operator==(const MeshLimits&) const = default;
};

/// How a mesh lies in its file.
enum class MeshAxes {
  kStanding,  ///< what stands along Y there stands along z here, as scenes have it: (X, -Z, Y)
  kAsWritten  ///< (X, Y, Z), whatever the file says is up, as descriptions of robots have it
};

/// Reads a file that belongs to a mesh file, by its plain name, at most so many bytes.
/// @throws InputError when there is none that may be read.
using OpenNeighbour = std::function<std::string(const std::string& name, std::size_t max_bytes)>;

}  // namespace smile::mesh
