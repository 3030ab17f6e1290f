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

/// A file that a robot is read from.
struct FoundFile {
  std::string name;            ///< as RobotFile::name
  std::filesystem::path path;  ///< for people
  std::shared_ptr<const std::string> bytes;
};

/// Why a file that was named cannot be had, in words that follow its name.
class BadReference : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Finds the files that files of a robot name, and reads each once however often it is named.
class FileFinder {
 public:
  virtual ~FileFinder() = default;
  /// @param from       the file that names it.
  /// @param reference  as written: `package://PKG/…`, `file://…` or a path.
  /// @throws BadReference
  virtual FoundFile Find(const FoundFile& from, const std::string& reference,
                         std::size_t max_bytes) = 0;
  /// The side file of a URDF; nullopt when there is none and none was asked for.
  virtual std::optional<FoundFile> FindSideFile(const FoundFile& urdf,
                                                std::size_t max_bytes) const = 0;
};

/// Looks where people keep them.
/// @param urdf_path  its folder, that of `options.side_file` and the package roots may be read.
std::unique_ptr<FileFinder> MakeOriginalFinder(const std::filesystem::path& urdf_path,
                                               const RobotReaderOptions& options);
/// Looks among the kept ones.
std::unique_ptr<FileFinder> MakeKeptFinder(const OpenRobotFile& open);

/// Set of all files of a robot that is being read, each read once; meshes are returned ready for
/// use.
class RobotFileSet {
 public:
  explicit RobotFileSet(std::unique_ptr<FileFinder> finder) : finder_(std::move(finder)) {}

  /// Adds a file. @throws BadReference if another one has the same name.
  void Keep(const FoundFile& file);
  /// @throws BadReference
  FoundFile Fetch(const FoundFile& from, const std::string& reference, std::size_t max_bytes);
  std::optional<FoundFile> FetchSideFile(const FoundFile& urdf, std::size_t max_bytes);

  using Mesh = std::shared_ptr<const scene::CustomMesh>;
  /// What is drawn of a mesh: as it lies in the link's frame, without pieces.
  /// @param scale  along x, y and z.
  /// @throws BadReference
  Mesh FetchDrawn(const FoundFile& from, const std::string& reference, const Vector3& scale);
  /// What collides: a few pieces. @throws BadReference
  const std::vector<scene::Hull>& FetchPieces(const FoundFile& from, const std::string& reference,
                                              const Vector3& scale);

  std::vector<RobotFile> TakeFiles() { return std::move(files_); }

 private:
  using Key = std::tuple<std::string, double, double, double>;  // name of the file, scale

  scene::SurfaceMesh Import(const FoundFile& file);
  /// The mesh of a key, and the key; imported at most once.
  std::pair<Key, Mesh> FetchSurface(const FoundFile& from, const std::string& reference,
                                    const Vector3& scale);

  std::unique_ptr<FileFinder> finder_;
  std::vector<RobotFile> files_;
  std::map<Key, Mesh> drawn_;
  std::map<Key, std::vector<scene::Hull>> pieces_;
  std::size_t num_bytes_ = 0, num_triangles_ = 0;
};

}  // namespace smile::robot::internal
