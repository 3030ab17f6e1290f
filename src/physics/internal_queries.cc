#include "physics/internal_queries.h"

#include <algorithm>

#include "physics/internal_articulation_links.h"
#include "physics/internal_body_dynamics.h"

// Questions about contacts and overlaps. They read the contacts of the last step, or measure with a
// dispatcher of their own, and change no state.

namespace smile::physics {
namespace {

/// Greatest distance at which two objects touch [m].
constexpr double kTouching = 1e-4;

}  // namespace

std::vector<Contact> FindContacts(const Articulation& articulation, int link,
                                  const WorldObjects& objects, Engine& engine) {
  const btCollisionObject* collider = articulation.links().collider(link);
  // Manifolds are sorted in each step; after a restore their order may differ.
  engine.world.SortManifolds();
  std::vector<Contact> contacts;
  objects.ForEachManifoldOf(collider, [&](const btPersistentManifold& manifold, Body& body) {
    // Bullet's normal is on B and points towards A: reverse it if the link is B.
    const bool link_is_a = manifold.getBody0() == collider;
    for (int k = 0; k < manifold.getNumContacts(); ++k) {
      const btManifoldPoint& point = manifold.getContactPoint(k);
      if (point.getDistance() > kTouching) continue;
      contacts.push_back(
          {.body = body.id(),
           .p_WQ = FromBullet(link_is_a ? point.m_positionWorldOnA : point.m_positionWorldOnB),
           .normal_in_world = FromBullet(point.m_normalWorldOnB) * (link_is_a ? 1.0 : -1.0),
           .distance = point.getDistance()});
    }
  });
  std::stable_sort(contacts.begin(), contacts.end(),
                   [](const Contact& a, const Contact& b) { return a.body < b.body; });
  return contacts;
}

std::vector<BodyId> FindTouchingBodies(const Body& body, const WorldObjects& objects) {
  std::vector<BodyId> bodies;
  const auto note_touches = [&bodies](const btPersistentManifold& manifold, Body& other) {
    for (int k = 0; k < manifold.getNumContacts(); ++k) {
      const btManifoldPoint& point = manifold.getContactPoint(k);
      // The distance is that before the step; a pushing contact touches in any case.
      if (point.getDistance() <= kTouching || point.getAppliedImpulse() > 0) {
        bodies.push_back(other.id());
      }
    }
  };
  objects.ForEachManifoldOf(&body.dynamics().bullet(), note_touches);
  std::sort(bodies.begin(), bodies.end());
  bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
  return bodies;
}

Overlaps FindOverlaps(const Body& moved, const RigidTransform& X_WB, double depth,
                      const WorldObjects& objects, Engine& engine) {
  const BodyId id = moved.id();
  const Body::Dynamics& dynamics = moved.dynamics();
  // Bullet's shape is given in the frame of the center of mass.
  const btTransform X_WBcm = ToBullet(X_WB * dynamics.X_BcmB().inverse());
  const PairFilter& filter = engine.broadphase.filter();
  const auto is_in_the_way = [&](const btCollisionObject& other) {
    return !filter.IsExcluded(static_cast<int>(id.value), OrderOf(&other)) &&
           engine.overlap_probe.Depth(dynamics.bullet(), X_WBcm, other) > depth;
  };
  Overlaps overlaps;
  for (const auto& other : objects.bodies()) {
    if (other->id() == id) continue;
    if (is_in_the_way(other->dynamics().bullet())) overlaps.bodies.push_back(other->id());
  }
  for (const auto& articulation : objects.articulations()) {
    // -1 is the base.
    for (int link = -1; link < articulation->num_joints(); ++link) {
      const auto* collider = articulation->links().collider(link);
      if (collider && is_in_the_way(*collider)) overlaps.with_articulation = true;
    }
  }
  return overlaps;
}

}  // namespace smile::physics
