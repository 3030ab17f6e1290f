#include "recording/recording_files.h"

#include <system_error>

#include "base/diagnostic.h"
#include "base/files.h"
#include "recording/beginning.h"
#include "recording/recording.h"
#include "recording/scene_files.h"

namespace smile::recording {
void RequireNewDirectory(const std::filesystem::path& directory) {
  // A recording inside another one would become part of it.
  if (const auto around = RecordingAround(directory)) {
    throw InputError({directory.string(), 0, "",
                      "is inside the recording " + around->string() + ", which is not changed"});
  }
  // An abandoned beginning contains no recording and is replaced.
  if (IsAbandoned(directory)) return;
  std::error_code error;
  if (std::filesystem::exists(directory, error) && !std::filesystem::is_empty(directory, error)) {
    throw InputError(
        {directory.string(), 0, "",
         "exists already, expected a new directory; recordings are never overwritten"});
  }
}

void WriteWorld(const std::filesystem::path& directory, const model::Model& model) {
  MakeDirectories(directory);
  // Meshes and robot files are copied: the recording may outlive the originals.
  WriteSceneFiles(model.scene(), directory / "scene.xml");
  const auto& placement = model.robot_placement();
  if (!placement) return;
  for (const robot::RobotFile& file : placement->files) {
    const std::filesystem::path path = directory / kRobotFolder / file.name;
    MakeDirectories(path.parent_path());
    WriteFile(path, *file.bytes);
  }
}

}  // namespace smile::recording
