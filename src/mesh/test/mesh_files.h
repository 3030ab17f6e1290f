#pragma once

#include <unistd.h>

#include <filesystem>
#include <string>

#include "base/files.h"
#include "scene/custom_mesh.h"

namespace smile::mesh {

/// Folder of test files, removed afterwards.
class MeshFolder {
 public:
  MeshFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "smile_mesh_XXXXXX").string();
    path_ = mkdtemp(name.data());
  }
  ~MeshFolder() { std::filesystem::remove_all(path_); }
  MeshFolder(const MeshFolder&) = delete;
  MeshFolder& operator=(const MeshFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path Write(const std::string& name, const std::string& bytes) const {
    MakeDirectories((path_ / name).parent_path());
    WriteFile(path_ / name, bytes);
    return path_ / name;
  }

 private:
  std::filesystem::path path_;
};

/// Returns a cuboid from one corner to the other, both in the axes of an imported mesh.
inline scene::SurfaceMesh Cuboid(const Eigen::Vector3f& low, const Eigen::Vector3f& high) {
  scene::SurfaceMesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.vertices.emplace_back(i & 1 ? high.x() : low.x(), i & 2 ? high.y() : low.y(),
                               i & 4 ? high.z() : low.z());
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

}  // namespace smile::mesh
