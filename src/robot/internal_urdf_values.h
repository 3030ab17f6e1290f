#pragma once

#include <string>
#include <string_view>

#include "robot/internal_urdf_parse.h"
#include "scene/articulation_spec.h"

namespace smile::robot::internal {

/// Mass of one link; its frame I has the centre of mass as origin.
struct UrdfInertial {
  double mass = 0;                    ///< [kg], 0 or more
  Matrix3 inertia = Matrix3::Zero();  ///< about I's origin, along I's axes [kg m2]
  RigidTransform X_FI;
};

/// One `<link>` or `<joint>`: turns the parser's values into ours, each one checked, and complains
/// in the element's name. All functions throw InputError.
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
  /// A shape that is no mesh, in its place in the link's frame F: Solid::X_BS is X_FS.
  scene::Solid ReadSolid(const urdf::Geometry* geometry, const urdf::Pose& origin) const;
  Vector3 ReadScale(const urdf::Mesh& mesh) const;
  Color ReadColor(const urdf::Color& color) const;
  /// Type, axis and limits of a joint that moves; a continuous one has limits far away.
  void ReadMotion(const urdf::Joint& joint, scene::LinkSpec* link) const;

 private:
  double Within(double value, double low, double high, const char* what) const;
  double Positive(double value, double high, const char* what) const;

  const UrdfDocument& document_;
  std::string_view element_, name_;
};

}  // namespace smile::robot::internal
