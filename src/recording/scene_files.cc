#include "recording/scene_files.h"

#include <vector>

#include "base/files.h"
#include "mesh/import_mesh.h"
#include "scene_xml/mesh_files.h"
#include "scene_xml/scene_writer.h"

namespace smile::recording {

void WriteSceneFiles(const scene::SceneSpec& scene, const std::filesystem::path& file) {
  const std::filesystem::path folder = file.parent_path() / scene_xml::kMeshFolder;
  const std::vector<scene_xml::MeshFile> meshes = scene_xml::MeshFilesOf(scene);
  if (!meshes.empty()) MakeDirectories(folder);
  for (const scene_xml::MeshFile& mesh : meshes) {
    // Before the scene that refers to them.
    mesh::WriteStl(mesh.mesh->surface, folder / mesh.name);
  }
  WriteFile(file, scene_xml::WriteScene(scene));
}

}  // namespace smile::recording
