#pragma once

#include <string>

#include "interchange/exported_world.h"
#include "interchange/mesh_table.h"
#include "xml/writer.h"

namespace smile::interchange {

/// Writer of what the links of models consist of in SDFormat: pose, mass, shapes, cameras.
class SdfLinks {
 public:
  /// Both must outlive this.
  SdfLinks(const MeshTable& meshes, std::string mesh_folder, xml::Writer* xml)
      : meshes_(meshes), mesh_folder_(std::move(mesh_folder)), xml_(*xml) {}

  void WritePose(const RigidTransform& X);
  void WriteInertial(const scene::MassProperties& mass);
  void WriteSolids(const std::vector<scene::Solid>& solids, double friction, double restitution);
  void WriteVisuals(const std::vector<scene::Visual>& visuals);
  void WriteCamera(const ExportedCamera& camera, const std::string& name);

 private:
  /// Writes the pose and the geometry of a shape.
  void WriteShape(const scene::VisualShape& shape, const RigidTransform& X_LG);
  void WriteMesh(const std::string& name);
  void WriteSurface(double friction, double restitution);

  const MeshTable& meshes_;
  std::string mesh_folder_;
  xml::Writer& xml_;
};

}  // namespace smile::interchange
