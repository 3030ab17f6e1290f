#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "scene/custom_mesh.h"
#include "scene_import/foreign_world.h"
#include "scene_import/import_findings.h"

namespace smile::scene_import {

/// Files of a model: what it includes, and its meshes. They lie in the folder of the model or in
/// a search root, or below these, after all links have been followed.
class ModelFiles {
 public:
  /// @param main_file  nullopt for a text, which has no folder.
  ModelFiles(std::optional<std::filesystem::path> main_file,
             std::vector<std::filesystem::path> search_roots);

  /// True if there is such a file.
  bool Has(const std::string& name) const { return Search(name).has_value(); }
  /// Finds a file that an element names; nullopt, with a fault, if there is none.
  std::optional<std::filesystem::path> Find(const std::string& name, const Place& place,
                                            ImportFindings* findings) const;

  /// Reads a mesh and makes a shape of it.
  /// @param scale  factors along the axes of the file, none 0; negative ones mirror it.
  /// @returns the shape in the frame of the file; nullopt, with a fault, if it cannot be read.
  std::optional<ForeignShape> MeshShape(const std::string& name, const Vector3& scale,
                                        const Place& place, ImportFindings* findings);
  /// Makes a shape of the corners and triangles of a mesh; without triangles, of the convex hull.
  std::optional<ForeignShape> MeshShape(scene::SurfaceMesh surface, const Vector3& scale,
                                        const std::string& name, const Place& place,
                                        ImportFindings* findings);

 private:
  std::optional<std::filesystem::path> Search(const std::string& name) const;
  std::optional<scene::SurfaceMesh> ReadSurface(const std::string& name, const Place& place,
                                                ImportFindings* findings);

  std::vector<std::filesystem::path> folders_;
  std::map<std::filesystem::path, scene::SurfaceMesh> surfaces_;
  /// Of each file and scale: a mesh that is used many times is one.
  std::map<std::pair<std::string, std::array<double, 3>>, ForeignShape> shapes_;
  std::size_t num_triangles_ = 0;
};

}  // namespace smile::scene_import
