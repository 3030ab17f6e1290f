#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "interchange/exported_world.h"

namespace smile::interchange {

/// Triangles with a name, at the scale at which they are used.
struct NamedMesh {
  std::string name;
  bool is_convex = false;        ///< a hull, which may collide; otherwise it is only drawn
  std::vector<Vector3> corners;  ///< [m]
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counter-clockwise seen from outside
};

/// All meshes of a world, each once, in the order in which bodies and links use them.
class MeshTable {
 public:
  explicit MeshTable(const ExportedWorld& world);

  const std::vector<NamedMesh>& meshes() const { return meshes_; }
  /// Return the name of a mesh of the world.
  const std::string& NameOf(const scene::Hull& hull) const;
  const std::string& NameOf(const scene::DrawnMesh& mesh) const;

 private:
  using MeshKey = std::pair<const scene::CustomMesh*, double>;  ///< the mesh and its scale

  void Add(const scene::VisualShape& shape);
  void AddHull(const scene::Hull& hull);
  void AddDrawn(const scene::DrawnMesh& mesh);
  void AddAll(const std::vector<scene::Solid>& solids);
  void AddAll(const std::vector<scene::Visual>& visuals);

  std::vector<NamedMesh> meshes_;
  std::map<scene::Hull, std::size_t> hulls_;
  std::map<MeshKey, std::size_t> drawn_;
};

}  // namespace smile::interchange
