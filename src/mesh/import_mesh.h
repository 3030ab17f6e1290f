#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "mesh/mesh_options.h"
#include "scene/custom_mesh.h"

namespace smile::mesh {

/// Reads STL (text or binary; the first solid), OBJ, DAE, glTF or GLB, according to the file's
/// extension.
///
/// Lengths are those of the file, axes as in MeshAxes::kStanding. Vertices at the same place become
/// one, in the order in which triangles first name them; triangles with two equal corners are left
/// out. Colors, normals and textures are not read. No file is opened except this one and, for glTF,
/// those it names in its own folder.
///
/// @throws InputError whose file is `path`: missing file, unknown extension, limits exceeded, or
///         content that is truncated, damaged, empty or not numeric.
scene::SurfaceMesh ImportMesh(const std::filesystem::path& path, const MeshLimits& limits = {});

/// Parses a mesh in memory.
/// @param extension  `stl`, `obj`, `dae`, `gltf` or `glb`, in any case, without a dot.
/// @param name       file name for messages.
/// @param open       reads files that belong to it; if empty, no such file can be opened.
scene::SurfaceMesh ParseMesh(std::string_view bytes, std::string_view extension,
                             const MeshLimits& limits = {}, const std::string& name = "mesh",
                             const OpenNeighbour& open = {}, MeshAxes axes = MeshAxes::kStanding);

/// Returns binary STL. Importing it returns the same mesh, to the last bit, if each of its vertices
/// is named by a triangle, in the order of the triangles, as in an imported mesh.
std::string StlOf(const scene::SurfaceMesh& mesh);

/// Writes StlOf() to a file.
/// @throws std::runtime_error with the path and the reason.
void WriteStl(const scene::SurfaceMesh& mesh, const std::filesystem::path& path);

}  // namespace smile::mesh
