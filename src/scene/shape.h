#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "math/color.h"
#include "math/rigid_transform.h"
#include "scene/bond.h"
#include "scene/control.h"
#include "scene/custom_mesh.h"

namespace smile::scene {

/// Cuboid centered at the origin.
struct Block {
  Vector3 size{0.1, 0.1, 0.1};  ///< full lengths along x, y, z [m]
  bool operator==(const Block&) const = default;
};

/// Cylinder centered at the origin, its axis along **y**.
struct Cylinder {
  double radius = 0.05;  ///< [m]
  double length = 0.1;   ///< along y [m]
  int sides = 32;        ///< facets when drawn
  bool operator==(const Cylinder&) const = default;
};

struct Sphere {
  double radius = 0.05;  ///< [m]
  bool operator==(const Sphere&) const = default;
};

/// Container, open at the top (+z); the origin is the center of the outer cuboid.
struct Box {
  Vector3 size{0.1, 0.1, 0.1};  ///< outer lengths [m]
  double thickness = 0.005;     ///< of floor and walls [m]
  bool operator==(const Box&) const = default;
};

/// Frustum of a pyramid, closed at both ends: two regular polygons about the **z** axis, their
/// first corners towards +x. One radius may be 0: a pyramid.
struct Frustum {
  double radius_top = 0.05;     ///< to the corners at z = +height / 2 [m]
  double radius_bottom = 0.05;  ///< to the corners at z = -height / 2 [m]
  double height = 0.1;          ///< along z [m]
  int sides = 3;
  bool operator==(const Frustum&) const = default;
};

/// Hollow ring about the **z** axis with flat ends: the space between two regular polygons, their
/// first corners towards +x. With an inner radius of 0 it is a disc.
struct Ring {
  double radius_outer = 0.1;   ///< to the corners [m]
  double radius_inner = 0.05;  ///< to the corners, less than the outer one [m]
  double height = 0.1;         ///< along z [m]
  int sides = 32;
  bool operator==(const Ring&) const = default;
};

/// Triangle mesh from a file, with the origin of the file.
struct Custom {
  /// Name of the file, relative to the scene's folder or a search root. Not compared: copies of a
  /// scene and its meshes are equal.
  std::string file;
  double scale = 0.1;  ///< length of the mesh's unit [m]
  /// Shared by all shapes from the same file; never null in a scene that was read.
  std::shared_ptr<const CustomMesh> mesh;
  bool operator==(const Custom& other) const;  ///< compares the meshes, not their file names
};

/// Rigidly joined parts; the origin is the center of mass, wherever the parts are.
struct Composite {
  std::vector<Part> parts;  ///< controls among them
  std::vector<GuestPoint> guests;
  std::vector<HostPoint> hosts;
  bool operator==(const Composite&) const;
};

using Shape = std::variant<Block, Cylinder, Sphere, Box, Frustum, Ring, Custom, Composite,
                           ToggleSwitch, IndicatorLights, CustomControl>;

/// Shape with a pose: the whole of an object, or a part of a composite.
struct Part {
  /// Unique for whole objects, controls and pointable parts; otherwise as in the file, or empty.
  std::string id;
  RigidTransform X_PE;        ///< this element E in its parent P (the world for a whole object)
  bool is_pointable = false;  ///< the demonstrator may point at it
  /// Inside a state of a custom control: the next state when triggered; -1: no change. Unset:
  /// inherited from the parent.
  std::optional<int> next_state;
  /// Inside a state of a custom control: what triggers it. Unset: inherited from the parent; hands
  /// only at the top.
  std::optional<TriggerRule> trigger;
  Color color;  ///< of a simple shape or switch; the others have none of their own
  Shape shape;

  bool operator==(const Part&) const = default;
};

inline bool Custom::operator==(const Custom& other) const {
  return scale == other.scale &&
         (mesh == other.mesh || (mesh && other.mesh && *mesh == *other.mesh));
}
inline bool Composite::operator==(const Composite& other) const {
  return parts == other.parts && guests == other.guests && hosts == other.hosts;
}
inline bool CustomControl::State::operator==(const State& other) const {
  return name == other.name && parts == other.parts;
}

inline bool IsControl(const Shape& shape) {
  return std::holds_alternative<ToggleSwitch>(shape) ||
         std::holds_alternative<IndicatorLights>(shape) ||
         std::holds_alternative<CustomControl>(shape);
}

}  // namespace smile::scene
