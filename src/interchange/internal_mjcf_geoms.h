#pragma once

#include "interchange/exported_world.h"
#include "interchange/mesh_table.h"
#include "xml/writer.h"

namespace smile::interchange {

/// Writer of what bodies and links have in common in MJCF: pose, mass, shapes, cameras.
class MjcfGeoms {
 public:
  /// Both must outlive this.
  MjcfGeoms(const MeshTable& meshes, xml::Writer* xml) : meshes_(meshes), xml_(*xml) {}

  /// Writes attributes of the present element.
  void WritePose(const RigidTransform& X);
  void WriteInertial(const scene::MassProperties& mass);
  /// @param rolling  resistance [m].
  void WriteSolid(const scene::Solid& solid, double friction, double rolling);
  void WriteVisual(const scene::Visual& visual);
  void WriteCamera(const ExportedCamera& camera);

 private:
  /// @param X_BG  pose of the shape.
  void WriteShape(const scene::VisualShape& shape, const RigidTransform& X_BG);

  const MeshTable& meshes_;
  xml::Writer& xml_;
};

/// Writes the meshes as assets.
void WriteMjcfAssets(const MeshTable& meshes, xml::Writer* xml);

}  // namespace smile::interchange
