#pragma once

#include "base/state_hash.h"
#include "mechanics/body_pairs.h"
#include "mechanics/snapshot.h"

namespace smile::mechanics {

/// Pairs of bodies of a world, for CollisionExemptions.
class CollidingPairs {
 public:
  virtual ~CollidingPairs() = default;
  /// Returns false if nothing can push either of them.
  virtual bool CanMove(const BodyPair& pair) const = 0;
  virtual bool IsAnyAwake(const BodyPair& pair) const = 0;
  /// Returns the overlap of a pair [m], measured without creating contacts.
  virtual double OverlapDepth(const BodyPair& pair) const = 0;
  /// Ends the collisions of a pair.
  virtual void Exclude(const BodyPair& pair) = 0;
  /// Lets a pair collide again.
  virtual void Include(const BodyPair& pair) = 0;
};

/// Pairs of bodies that were inside each other when their joint ended. They collide again in two
/// stages: first not at all, then as a close fit, with some play.
class CollisionExemptions {
 public:
  /// @param pairs  must outlive it.
  /// @param play  overlap of a close fit up to which its contacts bear no load [m].
  /// @param eases_close_fits  false to let pairs collide at once without a close fit.
  CollisionExemptions(CollidingPairs* pairs, double play, bool eases_close_fits);

  /// @throws std::invalid_argument if the two are the same.
  void IgnoreUntilSeparated(BodyId a, BodyId b);
  /// Ends the exemptions of a body that is about to be removed.
  void EndAllOf(BodyId id);
  void EndAll();
  /// Call before each step: turns ignored pairs that overlap by no more than the play into close
  /// fits, and ends the close fits of pairs that are apart.
  void Update();
  const BodyPairs& close_fits() const { return close_fits_; }

  void Save(Snapshot* snapshot) const;
  /// Returns true if these are the exemptions of the snapshot.
  bool AreThoseOf(const Snapshot& snapshot) const;
  /// Adopts the exemptions of a snapshot of the same objects. Call EndAll() before.
  void Restore(const Snapshot& snapshot);
  void AddTo(StateHash* hash) const;

 private:
  template <class IsOver>
  void EndIgnoring(IsOver is_over);

  CollidingPairs* world_;
  double play_;
  bool eases_close_fits_;
  BodyPairs ignored_, close_fits_;
};

}  // namespace smile::mechanics
