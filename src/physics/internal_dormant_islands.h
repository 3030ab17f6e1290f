#pragma once

#include <BulletCollision/BroadphaseCollision/btDbvt.h>

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "mechanics/joint_order.h"
#include "physics/definitions.h"
#include "physics/internal_bullet.h"
#include "physics/internal_exact_world.h"

namespace smile::physics {

class StatelessBroadphase;

/// Islands that are left out of Bullet's world while they sleep and nothing comes near, so that a
/// step costs what is awake and not what there is. A static body (a fixture) that nothing in the
/// world comes near is an island of its own.
///
/// Leaving out changes no bit of any result: a step does not change a sleeping island, and an
/// island returns, with its pairs and contacts, before the first step that could. Which islands are
/// left out is therefore not part of the state.
class DormantIslands {
 public:
  /// All must outlive it.
  DormantIslands(ExactWorld& world, Dispatcher& dispatcher, StatelessBroadphase& broadphase);
  DormantIslands(const DormantIslands&) = delete;
  DormantIslands& operator=(const DormantIslands&) = delete;

  /// Returns true if no body is awake.
  bool AllSleep();
  /// Returns the sum of the hashes of all bodies. Takes a time that depends on those in the world,
  /// and none if nothing has happened since all sleep.
  std::uint64_t HashOfBodies();
  /// Call after each step: leaves out islands that sleep and are near nothing that can move, with
  /// their joints, and fixtures that nothing in the world is near.
  void LeaveOut();
  /// Call in each step when islands are known: notes with each joint its place in the order in
  /// which Bullet solves them, which depends on all joints.
  void OrderJoints();
  /// Call when all bounding boxes are known: returns the islands that the box of an object in the
  /// world overlaps, unless the two never collide.
  void ReturnReached();
  /// Returns the islands of bodies that are about to change, or all islands if one is static. Those
  /// that are in the world stay there.
  void Return(std::span<btRigidBody* const> bodies);
  /// Returns all islands, for changes of what there is or of what may collide.
  void ReturnAll();

  /// Returns all contact manifolds, those in the world first, in its order.
  std::vector<btPersistentManifold*> AllManifolds() const;
  /// Returns the number of a period in which the state of a body and its contacts are the same: as
  /// long as its island is left out, or, if it is in the world (a negative number), as nothing
  /// happens there. No other period has the same number.
  std::int64_t PeriodOf(const btRigidBody& body) const;

  /// Returns the present moment, for ForEachChangedSince().
  Moment now() const { return {.period = period_in_world_, .next_island = next_key_}; }
  /// Calls visit(const btRigidBody&) for each body whose state may have changed since a moment.
  /// Takes a time that does not depend on the others.
  template <class Visit>
  void ForEachChangedSince(const Moment& moment, Visit visit) const;

 private:
  struct Island {
    std::vector<btRigidBody*> bodies;  ///< in their order
    std::vector<btTypedConstraint*> joints;
    std::uint64_t hash = 0;               ///< sum over the bodies, as they were left out
    std::vector<btDbvtNode*> boxes;       ///< in boxes_, of the bodies
    std::vector<btBroadphasePair> pairs;  ///< their algorithms have the contact manifolds
  };
  using Islands = std::map<int, Island>;

  template <class Visit>
  void ForEachPresent(Visit visit) const;
  void NoteChange();
  bool CountStepsAsleep();
  std::set<int> FindTagsThatStay() const;
  Islands FindIslandsToLeave() const;
  void TakePairs(Islands* leaving);
  void TakeJoints(Islands* leaving);
  void Put(Islands::iterator island);

  ExactWorld& world_;
  Dispatcher& dispatcher_;
  StatelessBroadphase& broadphase_;
  Islands islands_;         ///< by the number of their period, which their bodies contain
  int next_key_ = 0;        ///< above all numbers ever in use
  std::uint64_t hash_ = 0;  ///< sum of the hashes of the bodies that are left out
  mechanics::JointOrder joint_order_;
  /// What is known while all sleep, until something happens.
  bool all_sleep_ = false;
  std::optional<std::uint64_t> hash_of_bodies_;
  std::int64_t period_in_world_ = -1;  ///< falls with each change; see PeriodOf()
  btDbvt boxes_;  ///< of all bodies that are left out, to find those that an object reaches
};

/// Calls visit(const btRigidBody&) for each body in the world, and for links of kinematic robots
/// that never move.
template <class Visit>
void DormantIslands::ForEachPresent(Visit visit) const {
  for (const btRigidBody* body : All(world_.getNonStaticRigidBodies())) visit(*body);
  for (const btCollisionObject* object : All(world_.getCollisionObjectArray())) {
    const btRigidBody* body = btRigidBody::upcast(object);
    if (body != nullptr && body->isStaticObject()) visit(*body);
  }
}

template <class Visit>
void DormantIslands::ForEachChangedSince(const Moment& moment, Visit visit) const {
  // Nothing has happened to a body, nor was an island left out or returned.
  if (moment.period == period_in_world_) return;
  ForEachPresent(visit);
  for (auto island = islands_.lower_bound(moment.next_island); island != islands_.end(); ++island) {
    for (const btRigidBody* body : island->second.bodies) visit(*body);
  }
}

}  // namespace smile::physics
