#include "scene_import/internal_model_files.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <system_error>
#include <variant>

#include "base/diagnostic.h"
#include "base/files.h"
#include "base/wording.h"
#include "mesh/convex_pieces.h"
#include "mesh/import_mesh.h"

namespace smile::scene_import {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxNameBytes = 1000;
// As those of a scene, which the meshes become a part of.
constexpr std::size_t kMaxTriangles = 400'000;

/// Mirroring turns triangles inside out.
void ScaleSurface(const Vector3& scale, scene::SurfaceMesh* surface) {
  // Of the file's axes (X, Y, Z), those of scenes are (X, -Z, Y).
  const Eigen::Vector3f factors = Vector3(scale.x(), scale.z(), scale.y()).cast<float>();
  for (Eigen::Vector3f& vertex : surface->vertices) vertex = vertex.cwiseProduct(factors);
  if (scale.prod() > 0) return;
  for (scene::SurfaceMesh::Triangle& triangle : surface->triangles) {
    std::swap(triangle[1], triangle[2]);
  }
}

/// Returns the surface of a hull.
scene::SurfaceMesh SurfaceOf(const scene::Hull& hull) {
  scene::SurfaceMesh surface;
  for (const Vector3& corner : hull.polyhedron().corners) {
    surface.vertices.push_back(corner.cast<float>());
  }
  for (const auto& face : hull.polyhedron().faces) {
    for (std::size_t i = 2; i < face.size(); ++i) {
      surface.triangles.push_back({face[0], face[i - 1], face[i]});
    }
  }
  return surface;
}

/// Returns the surface of the convex hull of corners.
scene::SurfaceMesh HullOf(scene::SurfaceMesh corners) {
  // A fan is not closed, and therefore becomes the hull of its corners.
  for (std::uint32_t i = 2; i < corners.vertices.size(); ++i) {
    corners.triangles.push_back({0, i - 1, i});
  }
  return SurfaceOf(mesh::ConvexPieces(corners).at(0));
}

/// Sets the mass of a shape to its volume and its center to that of the volume, in liters and so
/// on: readers multiply by a density.
void MeasureShape(const scene::CustomMesh& mesh, ForeignShape* shape) {
  for (const scene::Hull& piece : mesh.pieces) {
    const scene::VolumeMoments moments = scene::MomentsOf(piece);
    shape->mass += moments.volume;
    shape->center_of_mass += moments.volume * moments.center;
  }
  if (shape->mass > 0) shape->center_of_mass /= shape->mass;
}

}  // namespace

ModelFiles::ModelFiles(std::optional<fs::path> main_file, std::vector<fs::path> search_roots)
    : folders_(std::move(search_roots)) {
  if (!main_file) return;
  folders_.insert(folders_.begin(),
                  main_file->has_parent_path() ? main_file->parent_path() : fs::path("."));
}

std::optional<fs::path> ModelFiles::Search(const std::string& name) const {
  if (name.empty() || name.size() > kMaxNameBytes) return std::nullopt;
  for (const fs::path& folder : folders_) {
    std::error_code error;
    fs::path file = fs::canonical(folder / name, error);
    if (error) continue;
    const bool is_allowed = std::ranges::any_of(
        folders_, [&file](const fs::path& allowed) { return IsWithin(file, allowed); });
    if (is_allowed) return file;
  }
  return std::nullopt;
}

std::optional<fs::path> ModelFiles::Find(const std::string& name, const Place& place,
                                         ImportFindings* findings) const {
  std::optional<fs::path> file = Search(name);
  if (!file) {
    findings->Refuse(place, "found the file " + Quoted(name) +
                                ", expected one in the folder of the model, in a --path folder or "
                                "below these");
  }
  return file;
}

std::optional<scene::SurfaceMesh> ModelFiles::ReadSurface(const std::string& name,
                                                          const Place& place,
                                                          ImportFindings* findings) {
  const std::optional<fs::path> path = Find(name, place, findings);
  if (!path) return std::nullopt;
  const auto known = surfaces_.find(*path);
  if (known != surfaces_.end()) return known->second;
  try {
    scene::SurfaceMesh surface = mesh::ImportMesh(*path);
    return surfaces_[*path] = std::move(surface);
  } catch (const InputError& wrong) {
    findings->Refuse(place, "file " + Quoted(name) + ": " + wrong.diagnostics().front().message);
  }
  return std::nullopt;
}

std::optional<ForeignShape> ModelFiles::MeshShape(const std::string& name, const Vector3& scale,
                                                  const Place& place, ImportFindings* findings) {
  const std::pair key(name, std::array<double, 3>{scale.x(), scale.y(), scale.z()});
  const auto known = shapes_.find(key);
  if (known != shapes_.end()) return known->second;
  std::optional<scene::SurfaceMesh> surface = ReadSurface(name, place, findings);
  if (!surface) return std::nullopt;
  std::optional<ForeignShape> shape = MeshShape(*std::move(surface), scale, name, place, findings);
  if (shape) shapes_[key] = *shape;
  return shape;
}

std::optional<ForeignShape> ModelFiles::MeshShape(scene::SurfaceMesh surface, const Vector3& scale,
                                                  const std::string& name, const Place& place,
                                                  ImportFindings* findings) {
  try {
    ScaleSurface(scale, &surface);
    num_triangles_ +=
        surface.triangles.empty() ? surface.vertices.size() : surface.triangles.size();
    if (num_triangles_ > kMaxTriangles) {
      findings->Refuse(place, "found more than " + std::to_string(kMaxTriangles) +
                                  " triangles in all meshes, expected fewer");
      return std::nullopt;
    }
    if (surface.triangles.empty()) surface = HullOf(std::move(surface));
    std::vector<scene::Hull> pieces = mesh::ConvexPieces(surface);
    ForeignShape shape{.X_BE = CylinderFromZ().inverse()};
    MeasureShape({{}, pieces}, &shape);
    shape.geometry = scene::Custom{.file = fs::path(name).filename().string(),
                                   .scale = 1,
                                   .mesh = std::make_shared<const scene::CustomMesh>(
                                       scene::CustomMesh{std::move(surface), std::move(pieces)})};
    return shape;
  } catch (const std::invalid_argument& flat) {
    findings->Refuse(place, "mesh " + Quoted(name) + ": " + flat.what());
    return std::nullopt;
  }
}

}  // namespace smile::scene_import
