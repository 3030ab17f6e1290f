#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "scene/shape.h"
#include "scene_xml/internal_allowed_folders.h"
#include "scene_xml/internal_sources.h"

namespace smile::scene_xml {

struct SceneLimits;

/// Cache of the mesh files of a scene: each is read and decomposed once.
class MeshCache {
 public:
  /// @param main_file  nullptr for a text without a file; must outlive this, as the limits.
  MeshCache(const std::filesystem::path* main_file,
            const std::vector<std::filesystem::path>& search_roots, const SceneLimits& limits);

  /// Finds `custom->file` as for an included file; sets its mesh and the name by which the scene's
  /// own file would find it.
  ///
  /// @param place  of the element that refers to it.
  /// @returns false, with `fault` in words that follow the file's name, if there is no valid mesh.
  bool Fetch(const Sources& sources, const SourceLocation& place, scene::Custom* custom,
             std::string* fault);

 private:
  struct CachedMesh {
    std::shared_ptr<const scene::CustomMesh> mesh;  // null: there was a fault
    std::string fault;
  };

  CachedMesh Read(const AllowedFolders::FoundFile& file);

  bool has_folder_;
  AllowedFolders folders_;
  const SceneLimits& limits_;
  std::map<std::filesystem::path, CachedMesh> meshes_;  // by canonical name
  std::size_t num_bytes_ = 0, num_triangles_ = 0;
};

}  // namespace smile::scene_xml
