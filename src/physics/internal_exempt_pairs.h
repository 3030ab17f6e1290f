#pragma once

#include "mechanics/collision_exemptions.h"
#include "physics/internal_world_objects.h"

namespace smile::physics {

/// Pairs of bodies of a World, as its mechanics::CollisionExemptions use them.
class ExemptPairs : public mechanics::CollidingPairs {
 public:
  /// Both must outlive it.
  ExemptPairs(const WorldObjects& objects, Engine& engine) : objects_(objects), engine_(engine) {}

  bool CanMove(const mechanics::BodyPair& pair) const override;
  bool IsAnyAwake(const mechanics::BodyPair& pair) const override;
  double OverlapDepth(const mechanics::BodyPair& pair) const override;
  void Exclude(const mechanics::BodyPair& pair) override;
  void Include(const mechanics::BodyPair& pair) override;

 private:
  const WorldObjects& objects_;
  Engine& engine_;
};

}  // namespace smile::physics
