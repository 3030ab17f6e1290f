#include "record/internal_recording_files.h"

#include <system_error>
#include <vector>

#include "base/diagnostic.h"
#include "base/files.h"
#include "mesh/import_mesh.h"
#include "record/recording.h"
#include "scene_xml/mesh_files.h"
#include "scene_xml/scene_writer.h"

namespace smile::record {
namespace {

/// What the scene is made of belongs to the recording, which may outlive the original.
void WriteMeshes(const scene::SceneSpec& scene, const std::filesystem::path& folder) {
  const std::vector<scene_xml::MeshFile> files = scene_xml::MeshFilesOf(scene);
  if (!files.empty()) MakeDirectories(folder);
  for (const scene_xml::MeshFile& file : files) {
    mesh::WriteStl(file.mesh->surface, folder / file.name);
  }
}

}  // namespace

void RequireNewDirectory(const std::filesystem::path& directory) {
  if (const auto around = RecordingAround(directory)) {
    throw InputError({directory.string(), 0, "",
                      "lies within the recording " + around->string() + ", which stays as it is"});
  }
  std::error_code error;
  if (std::filesystem::exists(directory, error) && !std::filesystem::is_empty(directory, error)) {
    throw InputError({directory.string(), 0, "",
                      "exists already; a recording is never overwritten, name a new directory"});
  }
}

void WriteWorld(const std::filesystem::path& directory, const sim::Simulation& simulation) {
  MakeDirectories(directory);
  WriteMeshes(simulation.scene(), directory / scene_xml::kMeshFolder);
  WriteFile(directory / "scene.xml", scene_xml::WriteScene(simulation.scene()));
  const auto& placement = simulation.robot_placement();
  if (!placement) return;
  for (const robot::RobotFile& file : placement->files) {
    const std::filesystem::path path = directory / kRobotFolder / file.name;
    MakeDirectories(path.parent_path());
    WriteFile(path, *file.bytes);
  }
}

}  // namespace smile::record
