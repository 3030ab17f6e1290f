#pragma once

#include <BulletCollision/BroadphaseCollision/btDbvt.h>

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "physics/internal_bullet.h"

namespace smile::physics {

class Dispatcher;
class ExactWorld;
class StatelessBroadphase;

/// Islands that are left out of Bullet's world while they sleep and nothing comes near, so that a
/// step costs what is awake and not what there is.
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
  /// Call after each step: leaves out islands that sleep, have no joints, and are near nothing that
  /// can move.
  void LeaveOut();
  /// Call when all bounding boxes are known: returns the islands that the box of an object in the
  /// world overlaps, unless the two never collide.
  void ReturnReached();
  /// Returns the island of a body that is about to change, or all islands for a static body;
  /// nothing changes if it is in the world.
  void Return(const btRigidBody& body);
  /// Returns all islands, for changes of what there is or of what may collide.
  void ReturnAll();

  /// Returns all contact manifolds, those in the world first, in its order.
  std::vector<btPersistentManifold*> AllManifolds() const;
  /// Returns the number of a period in which the state of a body and its contacts are the same: as
  /// long as it is left out, or as all sleep. No other period has the same number. Returns nothing
  /// if the next step may change the body.
  std::optional<int> PeriodOf(const btRigidBody& body);

 private:
  struct Island {
    std::vector<btRigidBody*> bodies;
    std::uint64_t hash = 0;               ///< sum over the bodies, as they were left out
    std::vector<btDbvtNode*> boxes;       ///< in boxes_, of the bodies
    std::vector<btBroadphasePair> pairs;  ///< their algorithms have the contact manifolds
  };
  using Islands = std::map<int, Island>;

  void NoteChange();
  bool CountStepsAsleep();
  Islands FindIslandsToLeave() const;
  void TakePairs(Islands* leaving);
  void Put(Islands::iterator island);

  ExactWorld& world_;
  Dispatcher& dispatcher_;
  StatelessBroadphase& broadphase_;
  Islands islands_;         ///< by the number of their period, which their bodies contain
  int next_key_ = 0;        ///< above all numbers ever in use
  std::uint64_t hash_ = 0;  ///< sum of the hashes of the bodies that are left out
  /// What is known while all sleep, until something happens.
  bool all_sleep_ = false;
  int rest_ = 0;  ///< number of the period, see PeriodOf()
  std::optional<std::uint64_t> hash_of_bodies_;
  btDbvt boxes_;  ///< of all bodies that are left out, to find those that an object reaches
};

}  // namespace smile::physics
