#pragma once

#include "physics/internal_bullet.h"

namespace smile::physics {

/// Collision algorithm for two boxes that keeps the contact points of a face while it rests
/// (WorldConfig::has_firm_contacts).
///
/// Bullet finds the points of two boxes again in each step. Where an edge of one box lies on an
/// edge of the other, rounding decides which corner is found, the points and their impulses change,
/// and a high stack never comes to an exact rest.
class BoxPairAlgorithm : public btCollisionAlgorithm {
 public:
  struct CreateFunc : btCollisionAlgorithmCreateFunc {
    btCollisionAlgorithm* CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                   const btCollisionObjectWrapper* a,
                                                   const btCollisionObjectWrapper* b) override;
  };

  BoxPairAlgorithm(const btCollisionAlgorithmConstructionInfo& info,
                   const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b);
  ~BoxPairAlgorithm() override;

  void processCollision(const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b,
                        const btDispatcherInfo& info, btManifoldResult* result) override;
  btScalar calculateTimeOfImpact(btCollisionObject*, btCollisionObject*, const btDispatcherInfo&,
                                 btManifoldResult*) override {
    return 1;
  }
  void getAllContactManifolds(btManifoldArray& manifolds) override {
    manifolds.push_back(manifold_);
  }

 private:
  btPersistentManifold* manifold_;
};

}  // namespace smile::physics
