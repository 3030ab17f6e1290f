#pragma once

#include "physics/internal_compound_pairs.h"

namespace smile::physics {

/// Measures how deep shapes overlap without touching any world: it has a dispatcher of its own.
class OverlapProbe {
 public:
  OverlapProbe();

  /// How deep they overlap [m]; zero or less when they do not.
  double Depth(btCollisionShape* a, const btTransform& X_WA, btCollisionShape* b,
               const btTransform& X_WB);
  /// How deep `a` would overlap `b` [m] if it stood at `X_WA`.
  double Depth(const btCollisionObject& a, const btTransform& X_WA, const btCollisionObject& b);

 private:
  btDefaultCollisionConfiguration collision_configuration_;
  CompoundPairAlgorithm::CreateFunc compound_pairs_;
  btCollisionDispatcher dispatcher_;
};

}  // namespace smile::physics
