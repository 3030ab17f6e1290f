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

/// A cuboid about the origin.
struct Block {
  Vector3 size{0.1, 0.1, 0.1};  ///< full lengths along x, y, z [m]
  bool operator==(const Block&) const = default;
};

/// A cylinder about the origin, its axis along **y**.
struct Cylinder {
  double radius = 0.05;  ///< [m]
  double length = 0.1;   ///< along y [m]
  int sides = 32;        ///< facets of its picture
  bool operator==(const Cylinder&) const = default;
};

struct Sphere {
  double radius = 0.05;  ///< [m]
  bool operator==(const Sphere&) const = default;
};

/// A container, open at the top (+z); the origin is the centre of the outer cuboid.
struct Box {
  Vector3 size{0.1, 0.1, 0.1};  ///< outer lengths [m]
  double thickness = 0.005;     ///< of floor and walls [m]
  bool operator==(const Box&) const = default;
};

/// A pyramid cut off at the top, closed at both ends: two regular polygons about the **z** axis,
/// their first corners towards +x. One radius may be 0, then it comes to a point.
struct Frustum {
  double radius_top = 0.05;     ///< to the corners at z = +height / 2 [m]
  double radius_bottom = 0.05;  ///< to the corners at z = -height / 2 [m]
  double height = 0.1;          ///< along z [m]
  int sides = 3;
  bool operator==(const Frustum&) const = default;
};

/// A ring about the **z** axis with flat ends, really hollow: the space between two regular
/// polygons, their first corners towards +x. Without an inner radius it is a disc.
struct Ring {
  double radius_outer = 0.1;   ///< to the corners [m]
  double radius_inner = 0.05;  ///< to the corners, less than the outer one [m]
  double height = 0.1;         ///< along z [m]
  int sides = 32;
  bool operator==(const Ring&) const = default;
};

/// A triangle mesh from a file, its origin where the file has it.
struct Custom {
  /// Where it was read, seen from the scene's folder or a search root. Not compared: copies of a
  /// scene and its meshes are equal.
  std::string file;
  double scale = 0.1;  ///< length of the mesh's unit [m]
  /// Shared by all that are made of the same file; never null in a scene that was read.
  std::shared_ptr<const CustomMesh> mesh;
  bool operator==(const Custom& other) const;  ///< compares the meshes, not where they are
};

/// Parts joined rigidly; its origin is its centre of mass, wherever the parts are.
struct Composite {
  std::vector<Part> parts;  ///< controls among them
  std::vector<GuestPoint> guests;
  std::vector<HostPoint> hosts;
  bool operator==(const Composite&) const;
};

using Shape = std::variant<Block, Cylinder, Sphere, Box, Frustum, Ring, Custom, Composite,
                           ToggleSwitch, IndicatorLights, CustomControl>;

/// A shape in its place: the whole of an object, or a part of a composite.
struct Part {
  /// Unique for whole objects, controls and what is pointable; else as in the file, or empty.
  std::string id;
  RigidTransform X_PE;        ///< this element E in its parent P (the world for a whole object)
  bool is_pointable = false;  ///< the demonstrator may point at it
  /// Inside a state of a custom control: the state it leads to when triggered; -1 leads nowhere.
  /// Unset: what its parent says.
  std::optional<int> next_state;
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
