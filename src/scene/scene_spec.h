#pragma once

#include <optional>
#include <string>
#include <vector>

#include "math/color.h"
#include "scene/camera_spec.h"
#include "scene/lighting.h"
#include "scene/mechanism.h"
#include "scene/shape.h"
#include "scene/tool.h"

namespace smile::scene {

/// Default unit of files, that of the original program; C++ uses meters. 1 unit = 0.1 m unless the
/// scene says otherwise.
inline constexpr double kMetersPerUnit = 0.1;

/// Version of the physics. A recording keeps the version it was made with, so that it replays to
/// the same bits; docs/decisions/physics.md lists what each version changed.
inline constexpr int kPhysicsVersion = 6;

/// Name and value of the author's choice, for the recording's symbolic log.
struct Description {
  std::string name, value;
  bool operator==(const Description&) const = default;
};

/// Contact properties of an object.
struct Surface {
  /// Coefficient of friction; that of a contact is the product of both. The table has 0.6.
  double friction = 0.6;
  /// Fraction of the speed kept when it bounces off the table; between two objects, the product.
  double restitution = 0;
  /// Distance by which the support of a rolling object is shifted from the middle of its contact
  /// towards its motion, which slows it [m]. Unset: 1 mm for objects with parts other than blocks
  /// and boxes, 0 otherwise.
  std::optional<double> rolling_friction;

  bool operator==(const Surface&) const = default;
};

/// Object: a rigid body that can be grasped and is listed in recordings.
struct ObjectSpec {
  Part whole;         ///< its parent frame is the world W
  double mass = 1.0;  ///< [kg]; 0 = static, it never moves
  /// Center of mass in the object's frame: its origin by default [m].
  Vector3 center_of_mass = Vector3::Zero();
  std::vector<Description> descriptions;  ///< `shape` first, then as in the file
  Surface surface;
  std::optional<ToolSpec> tool;  ///< nullopt: it is no tool

  const std::string& id() const { return whole.id; }
  const RigidTransform& pose_in_world() const { return whole.X_PE; }
  bool is_static() const { return mass == 0; }
  bool operator==(const ObjectSpec&) const = default;
};

enum class TablePattern { kPlain, kStripes, kChecks };

/// The table top: z = 0 is its surface, the world origin its center.
struct TableSpec {
  double x_span = 2.0;     ///< [m]
  double y_span = 1.2;     ///< [m]
  double thickness = 0.4;  ///< [m]
  Color color{1, 1, 1};
  TablePattern pattern = TablePattern::kPlain;
  Color pattern_color{0.8, 0.8, 0.8};  ///< of every second stripe or square
  double pattern_span = 0.1;           ///< width of a stripe or square [m]
  bool operator==(const TableSpec&) const = default;
};

/// Scene as plain values: world frame W, SI units.
struct SceneSpec {
  std::string name;
  double meters_per_unit = kMetersPerUnit;  ///< length of the file's unit [m]
  TableSpec table;
  /// In the order of the file, members of sliders and pieces of chains among them; ids are unique.
  std::vector<ObjectSpec> objects;
  std::vector<SliderSpec> sliders;  ///< in the order of the file
  std::vector<ChainSpec> chains;    ///< in the order of the file
  std::vector<CameraSpec> cameras;  ///< in the order of the file; ids are unique among them
  std::vector<CameraOffset> camera_offsets;  ///< in the order of the file; at most one of a camera
  Lighting lighting;
  int physics_version = kPhysicsVersion;  ///< older only in a recording's scene; in no scene file

  bool operator==(const SceneSpec&) const = default;
};

}  // namespace smile::scene
