#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene_import/foreign_world.h"

namespace smile::scene_import {

/// Bodies that move as one, as an object O of a scene.
struct MergedObject {
  Place place;
  std::string name;
  RigidTransform X_WO;
  bool is_static = false;
  double mass = 0;                 ///< [kg]
  Vector3 moment{0, 0, 0};         ///< mass times center of mass, in O [kg m]
  std::optional<Matrix3> inertia;  ///< as written, if it is one body
  int num_bodies = 0;
  std::vector<ForeignShape> shapes;  ///< X_BE is X_OE
};

/// Slide between two objects, of which the second moves along the axis.
struct MergedSlide {
  std::size_t first = 0, second = 0;
  ForeignJoint joint;
};

struct MergedWorld {
  std::vector<MergedObject> objects;
  std::vector<MergedSlide> slides;
};

/// Returns the objects of a world: bodies that nothing lets move apart are one. Joints without a
/// counterpart hold their body where it is, with a remark.
MergedWorld MergeBodies(const ForeignWorld& world, ImportFindings* findings);

}  // namespace smile::scene_import
