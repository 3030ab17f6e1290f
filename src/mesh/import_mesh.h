#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "scene/custom_mesh.h"

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

/// Reads STL (text or binary; the first solid), OBJ, DAE, glTF or GLB, as the file's extension
/// says.
///
/// Lengths are those of the file, axes as MeshAxes::kStanding. Vertices at the same place are one,
/// in the order in which triangles first name them; triangles without an area between their
/// corners' numbers are left out. Colors, normals and pictures are not read. No file is opened but
/// this one and, for glTF, those it names in its own folder.
///
/// @throws InputError whose file is `path`: no such file, an unknown extension, more than the
///         limits allow, cut short, damaged, empty, numbers that are none.
scene::SurfaceMesh ImportMesh(const std::filesystem::path& path, const MeshLimits& limits = {});

/// The same from memory.
/// @param extension  `stl`, `obj`, `dae`, `gltf` or `glb`, in any case, without a dot.
/// @param name       of the file, in messages.
/// @param open       for what belongs to it; without, there is nothing.
scene::SurfaceMesh ParseMesh(std::string_view bytes, std::string_view extension,
                             const MeshLimits& limits = {}, const std::string& name = "mesh",
                             const OpenNeighbour& open = {}, MeshAxes axes = MeshAxes::kStanding);

/// Binary STL: importing it gives back the same mesh, to the last bit, if each of its vertices is
/// named by a triangle, in the order of the triangles, as those of an imported mesh are.
std::string StlOf(const scene::SurfaceMesh& mesh);

/// @throws std::runtime_error naming the path and the reason.
void WriteStl(const scene::SurfaceMesh& mesh, const std::filesystem::path& path);

}  // namespace smile::mesh
