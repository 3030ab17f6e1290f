#pragma once

#include <array>
#include <map>
#include <string>
#include <utility>

#include "interchange/internal_usd_writer.h"

namespace smile::interchange {

/// Writer of what bodies and links have in common in USD: pose, mass, colliders, visuals.
class UsdBodies {
 public:
  /// Both must outlive this.
  UsdBodies(const ExportedMotion& motion, UsdWriter* usd);

  /// Writes the materials of all frictions, restitutions and colors in use; before the bodies.
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
  using Material = std::pair<double, double>;            ///< friction and restitution
  using Paint = std::pair<std::array<double, 3>, bool>;  ///< linear color, and whether it glows

  /// How a shape is seen and touched.
  struct Surface {
    Paint paint;
    const Material* material = nullptr;  ///< nullptr: it is only seen
  };

  void AddMaterial(double friction, double restitution);
  void WritePaints();
  void WriteShader(const Paint& paint);
  void WriteMass(const scene::MassProperties& mass);
  void WriteShape(const scene::VisualShape& shape, const RigidTransform& X, const std::string& name,
                  const Surface& surface);
  void WriteSurface(const Surface& surface);

  const ExportedMotion& motion_;
  UsdWriter& usd_;
  std::vector<double> codes_;                  ///< of the moments
  std::map<Material, std::string> materials_;  ///< their paths
  std::map<Paint, std::string> paints_;        ///< their paths
};

}  // namespace smile::interchange
