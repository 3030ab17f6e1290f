#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "math/color.h"
#include "math/rigid_transform.h"
#include "scene/shape.h"
#include "scene_import/import_findings.h"

namespace smile::scene_import {

/// Ground: the half space below its frame's z = 0.
struct GroundPlane {
  double x_span = 0, y_span = 0;  ///< as drawn [m]; 0: without end
  bool operator==(const GroundPlane&) const = default;
};

using ForeignGeometry =
    std::variant<scene::Block, scene::Cylinder, scene::Sphere, scene::Custom, GroundPlane>;

/// Shape of a body of another simulator, in the convention of SMILE's shapes: the axis of a
/// cylinder is y.
struct ForeignShape {
  Place place;
  std::string name;
  ForeignGeometry geometry;
  RigidTransform X_BE;  ///< the shape E in its body B
  std::optional<Color> color;
  bool collides = false, is_seen = false;
  double mass = 0;                    ///< [kg]; of bodies without a mass of their own
  Vector3 center_of_mass{0, 0, 0};    ///< in E [m]
  std::optional<double> friction;     ///< of SMILE: that of a contact is the product of two
  std::optional<double> restitution;  ///< as scene::Surface::restitution
  std::optional<double> rolling;      ///< as scene::Surface::rolling_friction [m]
};

enum class ForeignJointKind { kFixed, kFree, kSlide, kOther };

/// Mobility of a body relative to its parent.
struct ForeignJoint {
  ForeignJointKind kind = ForeignJointKind::kFixed;
  Place place;
  std::string word;                    ///< of the file for it, such as `hinge`
  Vector3 axis_in_world{1, 0, 0};      ///< of a slide, of unit length
  std::optional<double> lower, upper;  ///< limits of the position [m]
  double position = 0;                 ///< at the pose of the body [m]
  double damping = 0;                  ///< [N s/m]
};

/// Mass of a body, as written.
struct ForeignMass {
  double mass = 0;          ///< [kg]
  Vector3 p_BBcm{0, 0, 0};  ///< center of mass in the body's frame B [m]
  /// About the center of mass, along the axes of B [kg m2].
  std::optional<Matrix3> inertia;
};

/// Body of another simulator.
struct ForeignBody {
  Place place;
  std::string name;
  int parent = -1;  ///< index of an earlier body; -1: the world
  RigidTransform X_WB;
  ForeignJoint joint;
  std::optional<ForeignMass> mass;  ///< nullopt: that of its shapes
  std::vector<ForeignShape> shapes;
};

/// Camera that is fixed in the world: x right, y down, z forward.
struct ForeignCamera {
  Place place;
  std::string name;
  RigidTransform X_WC;
  double vertical_field_of_view = 1;  ///< [rad]
};

/// Directional light.
struct ForeignLight {
  Place place;
  Vector3 direction_in_world{0, 0, -1};  ///< in which it shines
  Color color{1, 1, 1};                  ///< factors of SMILE's usual light, within 0 and 4
};

/// World of another simulator, as far as a scene has a counterpart of it.
struct ForeignWorld {
  std::string name;
  std::vector<ForeignBody> bodies;  ///< parents first
  std::vector<ForeignCamera> cameras;
  std::vector<ForeignLight> lights;
};

/// Returns the rotation from the axes of SMILE's cylinders, which lie along y, to those of formats
/// whose cylinders lie along z. It also leads from the axes of mesh files to those of scenes.
inline RigidTransform CylinderFromZ() {
  Matrix3 R;
  R << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  return {R, Vector3::Zero()};
}

/// Limits of a model, whose source is not trusted.
inline constexpr std::size_t kMaxBodies = 10'000;
inline constexpr std::size_t kMaxShapesOfBody = 1'000;
inline constexpr double kMaxMass = 1e6;  ///< [kg]

}  // namespace smile::scene_import
