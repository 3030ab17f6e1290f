#pragma once

#include <string>
#include <string_view>

#include "robot/internal_urdf_parse.h"
#include "scene/articulation_spec.h"

namespace smile::robot::internal {

/// Greatest speed [rad/s or m/s] and effort [N m or N] of a joint.
inline constexpr double kMaxRate = 1e4, kMaxEffort = 1e6;

/// Mass properties of one link; its frame I has the center of mass as origin.
struct UrdfInertial {
  double mass = 0;                    ///< [kg], 0 or more
  Matrix3 inertia = Matrix3::Zero();  ///< about I's origin, along I's axes [kg m2]
  RigidTransform X_FI;
};

/// Converts the values of one `<link>` or `<joint>` from the parser's types and checks each; errors
/// name the element. All functions throw InputError.
class UrdfElement {
 public:
  /// Keeps references: the document and the name must outlive it.
  UrdfElement(const UrdfDocument& document, std::string_view element, std::string_view name)
      : document_(document), element_(element), name_(name) {}

  [[noreturn]] void Fail(const std::string& message) const {
    document_.Fail(element_, name_, message);
  }

  RigidTransform ReadPose(const urdf::Pose& pose) const;
  UrdfInertial ReadInertial(const urdf::Inertial& inertial) const;
  /// Returns a shape other than a mesh, in the link's frame F: Solid::X_BS is X_FS.
  scene::Solid ReadSolid(const urdf::Geometry* geometry, const urdf::Pose& origin) const;
  Vector3 ReadScale(const urdf::Mesh& mesh) const;
  Color ReadColor(const urdf::Color& color) const;
  /// Reads type, axis and limits of a movable joint; a continuous one gets very wide limits.
  void ReadMotion(const urdf::Joint& joint, scene::LinkSpec* link) const;

 private:
  double Within(double value, double low, double high, const char* what) const;
  double Positive(double value, double high, const char* what) const;

  const UrdfDocument& document_;
  std::string_view element_, name_;
};

}  // namespace smile::robot::internal
