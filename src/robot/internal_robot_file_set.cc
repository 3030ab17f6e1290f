#include "robot/internal_robot_file_set.h"

#include <algorithm>
#include <utility>

#include "base/diagnostic.h"
#include "base/wording.h"
#include "mesh/convex_pieces.h"
#include "mesh/import_mesh.h"

// All files of a robot: each is read once, counted against the limits, and kept with its name for
// recordings. Meshes are imported once per file and scale.

namespace smile::robot::internal {
namespace {

// Limits for all files of a robot together.
constexpr std::size_t kMaxFiles = 400;
constexpr std::size_t kMaxBytes = 128u << 20;
constexpr std::size_t kMaxTriangles = 600'000;

constexpr float kMaxCoordinate = 100;  // [m]

/// Coarse pieces: robots only need their outer shape for contacts.
constexpr mesh::PieceLimits kPieceLimits{.max_pieces = 8, .max_corners = 32};

bool IsPlainName(const std::string& name) {
  return !name.empty() && name != "." && name != ".." &&
         name.find_first_of("/\\:") == std::string::npos;
}

/// Returns a mesh scaled along each axis; checks its size.
scene::SurfaceMesh Scaled(scene::SurfaceMesh mesh, const Vector3& scale) {
  for (Eigen::Vector3f& vertex : mesh.vertices) {
    vertex = vertex.cast<double>().cwiseProduct(scale).cast<float>();
    if (vertex.cwiseAbs().maxCoeff() < kMaxCoordinate) continue;
    throw BadReference(" reaches " + NumberText(vertex.cwiseAbs().maxCoeff()) +
                       " m from the origin, expected less than 100");
  }
  if (scale.prod() < 0) {  // a mirrored mesh is inside out
    for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  }
  return mesh;
}

}  // namespace

void RobotFileSet::Keep(const FoundFile& file) {
  for (const RobotFile& other : files_) {
    if (other.name != file.name) continue;
    // Kept files share a folder, so two different files must not have one name.
    // The pointer first, as the same file is fetched many times.
    if (other.bytes == file.bytes || *other.bytes == *file.bytes) return;
    throw BadReference(" would be stored as " + Quoted(file.name) +
                       ", like another file of the robot, expected different names");
  }
  num_bytes_ += file.bytes->size();
  if (files_.size() >= kMaxFiles || num_bytes_ > kMaxBytes) {
    throw BadReference(" exceeds the limit, expected at most " + std::to_string(kMaxFiles) +
                       " files and " + std::to_string(kMaxBytes) + " bytes for a robot");
  }
  files_.push_back({file.name, file.bytes});
}

FoundFile RobotFileSet::Fetch(const FoundFile& from, const std::string& reference,
                              std::size_t max_bytes) {
  FoundFile file = finder_->Find(from, reference, max_bytes);
  Keep(file);
  return file;
}

std::optional<FoundFile> RobotFileSet::FetchSideFile(const FoundFile& urdf, std::size_t max_bytes) {
  std::optional<FoundFile> file = finder_->FindSideFile(urdf, max_bytes);
  if (file) Keep(*file);
  return file;
}

scene::SurfaceMesh RobotFileSet::Import(const FoundFile& file) {
  // The limit on triangles is for the whole robot.
  const mesh::MeshLimits limits{.max_triangles = kMaxTriangles - num_triangles_};
  const std::string extension = file.path.extension().string();
  const auto open = [&](const std::string& name, std::size_t max_bytes) {
    if (!IsPlainName(name)) {
      // A mesh may name further files, such as the buffers of glTF; they must not lead elsewhere.
      throw BadReference(": it refers to " + Quoted(name) + ", expected a file beside it");
    }
    return *Fetch(file, name, max_bytes).bytes;
  };
  try {
    scene::SurfaceMesh surface =
        mesh::ParseMesh(*file.bytes, extension.empty() ? extension : extension.substr(1), limits,
                        file.path.string(), open, mesh::MeshAxes::kAsWritten);
    num_triangles_ += surface.triangles.size();
    return surface;
  } catch (const InputError& error) {
    throw BadReference(" (" + file.path.string() + "): " + error.diagnostics().front().message);
  }
}

std::pair<RobotFileSet::Key, RobotFileSet::Mesh> RobotFileSet::FetchSurface(
    const FoundFile& from, const std::string& reference, const Vector3& scale) {
  // Fetched even if the mesh is known, since its key contains the file's name.
  const FoundFile file = Fetch(from, reference, mesh::MeshLimits().max_file_bytes);
  const Key key{file.name, scale.x(), scale.y(), scale.z()};
  auto entry = drawn_.find(key);
  if (entry == drawn_.end()) {
    const scene::CustomMesh mesh{.surface = Scaled(Import(file), scale), .pieces = {}};
    entry = drawn_.emplace(key, std::make_shared<const scene::CustomMesh>(mesh)).first;
  }
  return *entry;
}

RobotFileSet::Mesh RobotFileSet::FetchDrawn(const FoundFile& from, const std::string& reference,
                                            const Vector3& scale) {
  return FetchSurface(from, reference, scale).second;
}

const std::vector<scene::Hull>& RobotFileSet::FetchPieces(const FoundFile& from,
                                                          const std::string& reference,
                                                          const Vector3& scale) {
  const auto [key, mesh] = FetchSurface(from, reference, scale);
  const auto entry = pieces_.find(key);
  if (entry != pieces_.end()) return entry->second;
  try {
    return pieces_.emplace(key, mesh::ConvexPieces(mesh->surface, kPieceLimits)).first->second;
  } catch (const std::invalid_argument& error) {  // it is flat
    throw BadReference(": " + std::string(error.what()));
  }
}

}  // namespace smile::robot::internal
