#pragma once

#include <span>
#include <string>

#include "scene/scene_spec.h"

namespace smile::scene_xml {

/// Names of meshes in a written scene.
enum class MeshNames {
  kBeside,       ///< in kMeshFolder beside it, where MeshFilesOf() are to be written
  kWhereTheyAre  ///< where the scene that was read found them: for a text to be kept in its place
};

/// Returns the scene as a self-contained file: everything expanded, every value written out, ids as
/// they were assigned, in the unit of the scene.
///
/// Reading the text back gives the same scene, exactly: every length, mass, angle and matrix to the
/// last bit (negative zeros become zeros). So a simulation of the text is a simulation of `scene`,
/// which is what recordings rely on. The meshes it names are those of MeshFilesOf() (mesh_files.h),
/// to the last bit too. Not kept, because the scene language cannot express them: - the name, which
/// is that of the file; - a table thickness other than 4 units; - colors finer than 8 bits per
/// channel that have no name; - descriptions that do not begin with `shape`.
///
/// Lengths are written with as many digits as metres need (internal_units.h). A rotation is written
/// as `rotation` when its three angles give back the same matrix, as they do for nearly everything
/// that was read from angles; else, for poses out of a simulation, as `rotationMatrix`.
///
/// @param scene  a scene that the reader could return: finite numbers, valid and unique ids,
///               rotations within 1e-9 of a rotation matrix, no mesh null.
/// @param origins  a comment before each object, such as SceneReading::origins; empty for none.
std::string WriteScene(const scene::SceneSpec& scene, std::span<const std::string> origins = {},
                       MeshNames mesh_names = MeshNames::kBeside);

}  // namespace smile::scene_xml
