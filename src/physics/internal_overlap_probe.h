#pragma once

#include "physics/internal_compound_pairs.h"

namespace smile::physics {

/// Measures the overlap of shapes without a world: it has a dispatcher of its own.
class OverlapProbe {
 public:
  OverlapProbe();

  /// Returns the depth of the overlap [m]; 0 if there is none.
  double Depth(btCollisionShape* a, const btTransform& X_WA, btCollisionShape* b,
               const btTransform& X_WB);
  /// Returns the depth by which `a` would overlap `b` [m] if it stood at `X_WA`.
  double Depth(const btCollisionObject& a, const btTransform& X_WA, const btCollisionObject& b);

 private:
  btDefaultCollisionConfiguration collision_configuration_;
  CompoundPairAlgorithm::CreateFunc compound_pairs_;
  btCollisionDispatcher dispatcher_;
};

}  // namespace smile::physics
