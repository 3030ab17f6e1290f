#include "physics/internal_queries.h"

#include <algorithm>
#include <array>

#include "physics/internal_articulation_links.h"
#include "physics/internal_body_dynamics.h"

// Questions about contacts and overlaps. They read the contacts of the last step, or measure with a
// dispatcher of their own, and change no state.

namespace smile::physics {
namespace {

/// Greatest distance at which two objects touch [m].
constexpr double kTouching = 1e-4;

/// Returns the link of an articulation that has this collider; -1 if none has.
int LinkOf(const btCollisionObject* collider, const WorldObjects& objects) {
  for (const auto& articulation : objects.articulations()) {
    for (int link = 0; link < articulation->num_joints(); ++link) {
      if (articulation->links().collider(link) == collider) return link;
    }
  }
  return -1;
}

/// Appends the pushes of the second object on a body.
void AppendPushes(const btPersistentManifold& manifold, const Body& body,
                  const btCollisionObject& other, const WorldObjects& objects,
                  std::vector<Push>* pushes) {
  const bool body_is_a = manifold.getBody0() == &body.dynamics().bullet();
  const bool has_parts = body.dynamics().bullet().getCollisionShape()->isCompound();
  Push push{.body = body.id()};
  for (int k = 0; k < manifold.getNumContacts(); ++k) {
    const btManifoldPoint& point = manifold.getContactPoint(k);
    if (point.getAppliedImpulse() <= 0) continue;
    // Numbers of parts are set for bodies of several parts only.
    const int part = body_is_a ? point.m_index0 : point.m_index1;
    push.solid = has_parts ? static_cast<std::size_t>(part) : 0;
    push.p_WQ = FromBullet(body_is_a ? point.m_positionWorldOnA : point.m_positionWorldOnB);
    // Bullet's normal points from B to A, the direction in which A is pushed.
    push.impulse_in_world = FromBullet(point.m_normalWorldOnB) *
                            (body_is_a ? point.getAppliedImpulse() : -point.getAppliedImpulse());
    const BodyId by{static_cast<std::uint32_t>(OrderOf(&other))};
    push.by_body = objects.Find(by) != nullptr ? by : BodyId();
    push.by_link = push.by_body ? -1 : LinkOf(&other, objects);
    pushes->push_back(push);
  }
}

}  // namespace

std::vector<Push> FindPushes(std::span<const BodyId> ids, const WorldObjects& objects,
                             Engine& engine) {
  std::vector<Push> pushes;
  // Manifolds are sorted in each step; after a restore their order may differ. Those of dormant
  // islands are not among them: they have none with an object that is awake.
  engine.world.SortManifolds();
  for (const btPersistentManifold* manifold : engine.dispatcher.Manifolds()) {
    if (manifold->getNumContacts() == 0) continue;
    const std::array both{manifold->getBody0(), manifold->getBody1()};
    const auto is_awake = [](const btCollisionObject* object) {
      return object->isActive() && !object->isStaticObject();
    };
    // Impulses between objects that sleep are those of an earlier step.
    if (!is_awake(both[0]) && !is_awake(both[1])) continue;
    for (std::size_t i = 0; i < both.size(); ++i) {
      const BodyId id{static_cast<std::uint32_t>(OrderOf(both[i]))};
      if (!std::ranges::binary_search(ids, id)) continue;
      AppendPushes(*manifold, objects.body(id), *both[1 - i], objects, &pushes);
    }
  }
  return pushes;
}

std::vector<LinkContact> FindContacts(const Articulation& articulation, int link,
                                      const WorldObjects& objects, Engine& engine) {
  const btCollisionObject* collider = articulation.links().collider(link);
  // Manifolds are sorted in each step; after a restore their order may differ.
  engine.world.SortManifolds();
  std::vector<LinkContact> contacts;
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
                   [](const LinkContact& a, const LinkContact& b) { return a.body < b.body; });
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
