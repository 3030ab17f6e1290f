#include "brain/internal_robot_files.h"

#include "base/files.h"

namespace smile::brain {

std::string WriteRobotFiles(const std::vector<robot::RobotFile>& files,
                            const std::filesystem::path& folder) {
  if (files.empty()) return "";
  for (const robot::RobotFile& file : files) {
    MakeDirectories((folder / file.name).parent_path());
    WriteFile(folder / file.name, *file.bytes);
  }
  return (folder / files.front().name).string();
}

}  // namespace smile::brain
