#pragma once

#include <cstddef>

namespace smile::scene_xml {

/// Limits on the cost of a scene file, which is untrusted input. Each limit, if exceeded, is a
/// diagnostic.
struct SceneLimits {
  std::size_t max_file_bytes = 32u << 20;  ///< of all files together
  int max_depth = 256;                     ///< elements inside one another; at most 256
  int max_elements = 100'000;  ///< in all files together; as many again out of templates
  int max_objects = 100'000;   ///< whole objects, pieces of chains among them
  int max_attributes = 256;    ///< of one element
  int max_files = 256;         ///< the scene and all it includes; as many meshes
  std::size_t max_mesh_bytes = 128u << 20;   ///< of all mesh files together
  std::size_t max_mesh_triangles = 400'000;  ///< of all mesh files together
  int max_instances = 64;                    ///< of templates inside one another
  int max_diagnostics = 1'000;  ///< listed, at least 1; one more says that there are more
};

}  // namespace smile::scene_xml
