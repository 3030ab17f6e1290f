#include "world/grasp_rule.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

// Decides what a gripper has between its fingers: bodies that both fingers touch, each at a face
// towards it, at about the same depth. Without the last condition a gripper would grasp a body that
// stands across its fingertips at two unrelated corners.

namespace smile::world {
namespace {

/// Least cosine between a contact normal and the closing direction: 45 degrees.
constexpr double kFacing = 0.7071;

/// Least cosine between a contact normal and the axis of a suction cup: 30 degrees.
constexpr double kFlat = 0.8660;

/// Sorts ids and removes duplicates.
std::vector<physics::BodyId> EachOnce(std::vector<physics::BodyId> bodies) {
  std::sort(bodies.begin(), bodies.end());
  bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
  return bodies;
}

}  // namespace

std::vector<physics::BodyId> GraspedBodies(std::span<const physics::LinkContact> left,
                                           std::span<const physics::LinkContact> right,
                                           const RigidTransform& X_WG, double opening) {
  // In the tool's frame G, fingers close along y and point along z.
  const Vector3 across = X_WG.rotation().col(1), along = X_WG.rotation().col(2);
  // Greatest difference in depth of two opposite points [m].
  // At most a sixteenth of a half turn (11 degrees) between the line through the points and the
  // closing direction.
  const double max_offset = opening * std::tan(std::numbers::pi / 16);
  std::vector<physics::BodyId> bodies;
  for (const physics::LinkContact& a : left) {
    if (a.normal_in_world.dot(across) < kFacing) continue;
    for (const physics::LinkContact& b : right) {
      if (b.body != a.body || b.normal_in_world.dot(across) > -kFacing) continue;
      if (std::abs((a.p_WQ - b.p_WQ).dot(along)) > max_offset) continue;
      bodies.push_back(a.body);
    }
  }
  return EachOnce(std::move(bodies));
}

std::vector<physics::BodyId> BodiesBetweenJaws(std::span<const physics::LinkContact> left,
                                               std::span<const physics::LinkContact> right) {
  std::vector<physics::BodyId> bodies;
  for (const physics::LinkContact& a : left) {
    for (const physics::LinkContact& b : right) {
      if (b.body != a.body) continue;
      // Normals point from the body to the jaws, so each should point along the line to its jaw.
      const Vector3 line = a.p_WQ - b.p_WQ;
      const double least = kFacing * line.norm();
      if (a.normal_in_world.dot(line) <= least || b.normal_in_world.dot(line) >= -least) continue;
      bodies.push_back(a.body);
    }
  }
  return EachOnce(std::move(bodies));
}

std::optional<physics::BodyId> BodyAtCup(std::span<const physics::LinkContact> contacts,
                                         const RigidTransform& X_WG, double radius) {
  std::optional<physics::BodyId> nearest;
  double least = radius;
  for (const physics::LinkContact& contact : contacts) {
    // A body in front of the cup has a normal back into the cup.
    if (-contact.normal_in_world.dot(X_WG.rotation().col(2)) < kFlat) continue;
    const double distance = (contact.p_WQ - X_WG.translation()).norm();
    // Contacts are ordered by body, so equal distances have one answer, too.
    if (distance > least || (nearest && distance == least)) continue;
    least = distance;
    nearest = contact.body;
  }
  return nearest;
}

}  // namespace smile::world
