#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene_spec.h"

namespace smile::scene_xml {

/// The folder beside a written scene that its meshes belong into.
inline constexpr const char* kMeshFolder = "meshes";

/// A mesh of a scene and the name under which the written scene finds it.
struct MeshFile {
  std::string name;  ///< in kMeshFolder: letters, digits, `_` and `-`, then `.stl`; unique
  std::shared_ptr<const scene::CustomMesh> mesh;
};

/// What WriteScene()'s text names: mesh::WriteStl() of each makes the scene whole. In the order in
/// which the scene first has them; a mesh that is used many times is one file.
std::vector<MeshFile> MeshFilesOf(const scene::SceneSpec& scene);

/// What the `shape` description of an object says when the file says nothing.
/// @param element  the name of the shape's element.
std::string ShapeWordOf(const scene::Shape& shape, std::string_view element);

/// Of a mesh: the name of its file up to the first dot.
std::string WordOfMeshFile(std::string_view file);

}  // namespace smile::scene_xml
