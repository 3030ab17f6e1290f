#include "interchange/mesh_table.h"

#include "base/overloaded.h"

namespace smile::interchange {

MeshTable::MeshTable(const ExportedWorld& world) {
  for (const ExportedBody& body : world.bodies) {
    AddAll(body.spec.solids);
    AddAll(body.visuals);
  }
  if (!world.robot) return;
  AddAll(world.robot->spec->base_solids);
  AddAll(world.robot->base.visuals);
  for (const scene::LinkSpec& link : world.robot->spec->links) AddAll(link.solids);
  for (const ExportedLink& link : world.robot->links) AddAll(link.visuals);
}

const std::string& MeshTable::NameOf(const scene::Hull& hull) const {
  return meshes_[hulls_.at(hull)].name;
}

const std::string& MeshTable::NameOf(const scene::DrawnMesh& mesh) const {
  return meshes_[drawn_.at({mesh.mesh.get(), mesh.scale})].name;
}

void MeshTable::AddAll(const std::vector<scene::Solid>& solids) {
  for (const scene::Solid& solid : solids) Add(scene::VisualShapeOf(solid.shape));
}

void MeshTable::AddAll(const std::vector<scene::Visual>& visuals) {
  for (const scene::Visual& visual : visuals) Add(visual.shape);
}

void MeshTable::Add(const scene::VisualShape& shape) {
  std::visit(
      Overloaded{[this](const scene::Hull& hull) { AddHull(hull); },
                 [this](const scene::DrawnMesh& mesh) { AddDrawn(mesh); }, [](const auto&) {}},
      shape);
}

void MeshTable::AddHull(const scene::Hull& hull) {
  const auto [found, is_new] = hulls_.try_emplace(hull, meshes_.size());
  if (!is_new) return;
  NamedMesh named{.name = "hull_" + std::to_string(hulls_.size()), .is_convex = true};
  named.corners = hull.polyhedron().corners;
  for (const scene::Polyhedron::Face& face : hull.polyhedron().faces) {
    for (std::size_t corner = 2; corner < face.size(); ++corner) {
      named.triangles.push_back({face[0], face[corner - 1], face[corner]});
    }
  }
  meshes_.push_back(std::move(named));
}

void MeshTable::AddDrawn(const scene::DrawnMesh& mesh) {
  const auto [found, is_new] =
      drawn_.try_emplace(MeshKey(mesh.mesh.get(), mesh.scale), meshes_.size());
  if (!is_new) return;
  NamedMesh named{.name = "mesh_" + std::to_string(drawn_.size())};
  for (const auto& vertex : mesh.mesh->surface.vertices) {
    named.corners.emplace_back(vertex.cast<double>() * mesh.scale);
  }
  named.triangles = mesh.mesh->surface.triangles;
  meshes_.push_back(std::move(named));
}

}  // namespace smile::interchange
