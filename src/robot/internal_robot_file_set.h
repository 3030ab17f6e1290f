#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include "robot/robot_options.h"
#include "scene/custom_mesh.h"

namespace smile::robot::internal {

/// A file of a robot.
struct FoundFile {
  std::string name;            ///< as RobotFile::name
  std::filesystem::path path;  ///< for messages
  std::shared_ptr<const std::string> bytes;
};

/// Error for a file that cannot be read; the message continues a sentence that begins with its
/// name.
class BadReference : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Finds the files that a robot's files refer to, and reads each once.
class FileFinder {
 public:
  virtual ~FileFinder() = default;
  /// Returns a file.
  /// @param from       the file that refers to it.
  /// @param reference  as written: `package://PKG/…`, `file://…` or a path.
  /// @throws BadReference
  virtual FoundFile Find(const FoundFile& from, const std::string& reference,
                         std::size_t max_bytes) = 0;
  /// Returns the side file of a URDF; nullopt if it is missing and was not requested.
  virtual std::optional<FoundFile> FindSideFile(const FoundFile& urdf,
                                                std::size_t max_bytes) const = 0;
};

/// Makes a finder for files in their original folders.
/// @param urdf_path  its folder, that of `options.side_file` and the package roots may be read.
std::unique_ptr<FileFinder> MakeOriginalFinder(const std::filesystem::path& urdf_path,
                                               const RobotReaderOptions& options);
/// Makes a finder for the files of a kept robot.
std::unique_ptr<FileFinder> MakeKeptFinder(const OpenRobotFile& open);

/// Set of all files of a robot that is being read, each read once; meshes are returned ready for
/// use.
class RobotFileSet {
 public:
  explicit RobotFileSet(std::unique_ptr<FileFinder> finder) : finder_(std::move(finder)) {}

  /// Adds a file.
  /// @throws BadReference if another one has the same name.
  void Keep(const FoundFile& file);
  /// Finds a file and adds it.
  /// @throws BadReference
  FoundFile Fetch(const FoundFile& from, const std::string& reference, std::size_t max_bytes);
  std::optional<FoundFile> FetchSideFile(const FoundFile& urdf, std::size_t max_bytes);

  using Mesh = std::shared_ptr<const scene::CustomMesh>;
  /// Returns a mesh for drawing: in the link's frame, without convex pieces.
  /// @param scale  along x, y and z.
  /// @throws BadReference
  Mesh FetchDrawn(const FoundFile& from, const std::string& reference, const Vector3& scale);
  /// Returns a few convex pieces for collisions.
  /// @throws BadReference
  const std::vector<scene::Hull>& FetchPieces(const FoundFile& from, const std::string& reference,
                                              const Vector3& scale);

  std::vector<RobotFile> TakeFiles() { return std::move(files_); }

 private:
  using Key = std::tuple<std::string, double, double, double>;  // name of the file, scale

  scene::SurfaceMesh Import(const FoundFile& file);
  /// Returns the key and the mesh of a reference; imported at most once.
  std::pair<Key, Mesh> FetchSurface(const FoundFile& from, const std::string& reference,
                                    const Vector3& scale);

  std::unique_ptr<FileFinder> finder_;
  std::vector<RobotFile> files_;
  std::map<Key, Mesh> drawn_;
  std::map<Key, std::vector<scene::Hull>> pieces_;
  std::size_t num_bytes_ = 0, num_triangles_ = 0;
};

}  // namespace smile::robot::internal
