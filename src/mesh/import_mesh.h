#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "mesh/mesh_options.h"
#include "scene/custom_mesh.h"

namespace smile::mesh {

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
