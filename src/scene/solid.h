#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "scene/hull.h"
#include "scene/scene_spec.h"

namespace smile::scene {

/// Convex shape that physics collides and a camera draws directly.
using SolidShape = std::variant<Block, Cylinder, Sphere, Hull>;

/// Property of a piece that contact can trigger.
struct Trigger {
  TriggerRule rule;
  /// Direction in which it is pushed in, in the body's frame: against the axis of its part, which
  /// is z, or y for a cylinder.
  Vector3 inward_in_body = Vector3::Zero();
  int next_state = -1;  ///< of its custom control; -1: none, or a switch

  bool operator==(const Trigger&) const = default;
};

/// Convex piece of a body B.
struct Solid {
  SolidShape shape;
  RigidTransform X_BS;
  Color color;
  std::string part_id;               ///< of the part it belongs to
  int control = -1;                  ///< index of its control, see ControlsOf(); -1: none
  int variant = 0;                   ///< it is present only while the control has this variant
  std::optional<Button> button{};    ///< of a switch; nullopt: none
  std::optional<Trigger> trigger{};  ///< nullopt: nothing but hands can trigger it

  bool operator==(const Solid&) const = default;
};

/// Returns all convex pieces of an object in its own frame, in the order of the file: its collision
/// shapes. A box becomes its floor and four walls, a ring its segments, a composite the pieces of
/// its parts, a control the pieces of all its variants. Lights collide whether they are on or not.
///
/// A ring of more than 64 sides has 64 pieces; its outside stays exact, its hole is round within
/// half a percent.
std::vector<Solid> SolidsOf(const Part& whole);

/// Returns the table top, in the world.
Solid TableSolid(const TableSpec& table);

/// Returns the number of pieces of SolidsOf(), without making them.
std::size_t NumSolidsOf(const Part& whole);

/// Mass, and rotational inertia about the center of mass: the body's origin by default, whatever
/// its shape (scene files rely on this). The mass is spread evenly over the pieces' volume.
struct MassProperties {
  double mass = 0;                    ///< [kg]
  Vector3 center = Vector3::Zero();   ///< of mass, in the body's frame [m]
  Matrix3 inertia = Matrix3::Zero();  ///< about the center, along the body's axes [kg m2]

  bool operator==(const MassProperties&) const = default;
};
/// @param center  of mass, in the body's frame [m].
MassProperties MassPropertiesOf(const std::vector<Solid>& solids, double mass,
                                const Vector3& center = Vector3::Zero());

}  // namespace smile::scene
