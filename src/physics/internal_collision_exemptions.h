#pragma once

#include "mechanics/body_pairs.h"
#include "physics/internal_world_objects.h"

namespace smile::physics {

/// Pairs of bodies that were inside each other when their joint ended. They collide again in two
/// stages: first not at all, then as a close fit; see World::IgnoreCollisionUntilSeparated().
class CollisionExemptions {
 public:
  /// All must outlive it.
  CollisionExemptions(const WorldConfig& config, const WorldObjects& objects, Engine& engine);

  void IgnoreUntilSeparated(BodyId a, BodyId b);
  /// Ends the exemptions of a body that is about to be removed.
  void EndAllOf(BodyId id);
  void EndAll();
  /// Call before each step: turns ignored pairs that overlap by no more than the play into close
  /// fits, and ends the close fits of pairs that are apart.
  void Update();

  void Save(Snapshot* snapshot) const;
  /// Returns true if these are the exemptions of the snapshot.
  bool AreThoseOf(const Snapshot& snapshot) const;
  /// Adopts the exemptions of a snapshot of the same objects. Call EndAll() before.
  void Restore(const Snapshot& snapshot);
  void AddTo(StateHash* hash) const;

 private:
  using BodyPair = mechanics::BodyPair;

  template <class IsOver>
  void EndIgnoring(IsOver is_over);
  double OverlapDepth(const BodyPair& pair) const;
  bool IsAnyAwake(const BodyPair& pair) const;

  const WorldConfig& config_;
  const WorldObjects& objects_;
  Engine& engine_;
  mechanics::BodyPairs ignored_, close_fits_;
};

}  // namespace smile::physics
