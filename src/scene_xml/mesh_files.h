#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene_spec.h"

namespace smile::scene_xml {

/// Folder for meshes beside a written scene.
inline constexpr const char* kMeshFolder = "meshes";

/// Mesh of a scene, with the name under which the written scene refers to it.
struct MeshFile {
  std::string name;  ///< in kMeshFolder: letters, digits, `_` and `-`, then `.stl`; unique
  std::shared_ptr<const scene::CustomMesh> mesh;
};

/// Returns the mesh files that the text of WriteScene() refers to; write each with
/// mesh::WriteStl(). In the order of first use; a mesh that is used many times is one file.
std::vector<MeshFile> MeshFilesOf(const scene::SceneSpec& scene);

/// Returns the default value of an object's `shape` description.
/// @param element  the name of the shape's element.
std::string ShapeWordOf(const scene::Shape& shape, std::string_view element);

/// Returns the name of a mesh file up to the first dot.
std::string WordOfMeshFile(std::string_view file);

}  // namespace smile::scene_xml
