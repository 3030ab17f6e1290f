#pragma once

#include <map>
#include <string>

#include "interchange/internal_usd_writer.h"

namespace smile::interchange {

/// Writer of what bodies and links have in common in USD: pose, mass, colliders, visuals.
class UsdBodies {
 public:
  /// Both must outlive this.
  UsdBodies(const ExportedMotion& motion, UsdWriter* usd);

  /// Writes the materials of all frictions and restitutions in use; before the bodies.
  void WriteMaterials(const ExportedWorld& world);
  /// Writes a rigid body without its end.
  /// @param mass   nullptr: it is static.
  /// @param frame  of the motion; -1: nothing is drawn of it, and it stands at X_WB.
  /// @param never_collides_with  paths of other bodies.
  void OpenBody(const std::string& name, const RigidTransform& X_WB,
                const scene::MassProperties* mass, int frame,
                const std::vector<std::string>& never_collides_with = {});
  void WriteSolids(const std::vector<scene::Solid>& solids, double friction, double restitution);
  void WriteVisuals(int frame);

 private:
  using Material = std::pair<double, double>;  ///< friction and restitution

  void AddMaterial(double friction, double restitution);
  void WriteMass(const scene::MassProperties& mass);
  void WriteShape(const scene::VisualShape& shape, const RigidTransform& X, const Color& color,
                  const std::string& name, const Material* material);
  void WriteSurface(const Material* material, const Color& color);

  const ExportedMotion& motion_;
  UsdWriter& usd_;
  std::vector<double> codes_;                  ///< of the moments
  std::map<Material, std::string> materials_;  ///< their paths
};

}  // namespace smile::interchange
