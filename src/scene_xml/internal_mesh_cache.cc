#include "scene_xml/internal_mesh_cache.h"

#include <algorithm>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "base/diagnostic.h"
#include "mesh/convex_pieces.h"
#include "mesh/import_mesh.h"
#include "scene_xml/scene_limits.h"

// Meshes are by far the most expensive part of a scene: reading and, above all, cutting them into
// convex pieces. Each file is processed once, however many objects use it, and the limits hold for
// the scene as a whole.

namespace smile::scene_xml {

namespace fs = std::filesystem;

MeshCache::MeshCache(const fs::path* main_file, const std::vector<fs::path>& search_roots,
                     const SceneLimits& limits)
    : has_folder_(main_file != nullptr), folders_(main_file, search_roots), limits_(limits) {}

bool MeshCache::Fetch(const Sources& sources, const SourceLocation& place, scene::Custom* custom,
                      std::string* fault) {
  // The main file may be a text without a folder, unlike included files.
  const bool is_text = place.file == 0 && !has_folder_;
  const fs::path folder = FolderOf(sources.FileOf(place));
  AllowedFolders::Search search = folders_.Find(is_text ? nullptr : &folder, custom->file);
  if (!search.found) {
    *fault = search.expected;
    return false;
  }
  auto cached = meshes_.find(search.found->canonical);
  // Faults are cached as well: a bad file is read once, but reported wherever it is used.
  if (cached == meshes_.end()) {
    cached = meshes_.emplace(search.found->canonical, Read(*search.found)).first;
  }
  if (!cached->second.mesh) {
    *fault = " (" + search.found->name.string() + "): " + cached->second.fault;
    return false;
  }
  custom->mesh = cached->second.mesh;
  custom->file = folders_.NameFromScene(search.found->canonical);
  return true;
}

MeshCache::CachedMesh MeshCache::Read(const AllowedFolders::FoundFile& file) {
  if (meshes_.size() >= static_cast<std::size_t>(limits_.max_files)) {
    return {.fault = "found more than " + std::to_string(limits_.max_files) +
                     " mesh files in the scene, expected fewer"};
  }
  std::error_code error;
  // Size and triangles are limited over all meshes, and the size is checked before the file is
  // read.
  const std::uintmax_t size = fs::file_size(file.canonical, error);
  // num_bytes_ never exceeds the limit, so the difference does not wrap around.
  if (!error && size > limits_.max_mesh_bytes - num_bytes_) {
    return {.fault = "found more than " + std::to_string(limits_.max_mesh_bytes) +
                     " bytes in the scene's mesh files, expected fewer"};
  }
  try {
    mesh::MeshLimits mesh_limits;
    mesh_limits.max_file_bytes =
        std::min(mesh_limits.max_file_bytes, limits_.max_mesh_bytes - num_bytes_);
    scene::SurfaceMesh surface = mesh::ImportMesh(file.canonical, mesh_limits);
    if (!error) num_bytes_ += size;
    num_triangles_ += surface.triangles.size();
    if (num_triangles_ > limits_.max_mesh_triangles) {
      return {.fault = "found more than " + std::to_string(limits_.max_mesh_triangles) +
                       " triangles in the scene's mesh files, expected fewer"};
    }
    // After all limits: this step is the slow one.
    std::vector<scene::Hull> pieces = mesh::ConvexPieces(surface);
    return {.mesh = std::make_shared<const scene::CustomMesh>(
                scene::CustomMesh{std::move(surface), std::move(pieces)})};
  } catch (const InputError& wrong) {
    // One finding per mesh; its file and line are those of the element that names it.
    return {.fault = wrong.diagnostics().front().message};
  } catch (const std::exception& wrong) {  // a mesh without volume, or an I/O error
    return {.fault = WithoutPath(wrong.what(), file.canonical.string())};
  }
}

}  // namespace smile::scene_xml
