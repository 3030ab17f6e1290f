#pragma once

#include <vector>

#include "physics/internal_bullet.h"

namespace smile::physics {

/// Collides two shapes of which at least one is made of parts, with one contact manifold per pair
/// of parts. The pair of part numbers is kept in the manifold (PartPairOf), so that a saved contact
/// finds its manifold again; the manifolds of Bullet's own compound algorithms cannot be told
/// apart.
class CompoundPairAlgorithm : public btCollisionAlgorithm {
 public:
  struct CreateFunc : btCollisionAlgorithmCreateFunc {
    btCollisionAlgorithm* CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                   const btCollisionObjectWrapper* a,
                                                   const btCollisionObjectWrapper* b) override;
    /// Lets the dispatcher use this for every pair with a compound; must outlive it.
    void RegisterWith(btCollisionDispatcher* dispatcher);
  };

  /// While alive, algorithms look at all pairs of parts, also at those whose boxes do not overlap,
  /// so that every manifold exists before saved points are put back. Used on one thread at a time.
  class LookAtAllPairs {
   public:
    LookAtAllPairs() { is_active_ = true; }
    ~LookAtAllPairs() { is_active_ = false; }
    static bool is_active() { return is_active_; }

   private:
    static thread_local bool is_active_;
  };

  explicit CompoundPairAlgorithm(const btCollisionAlgorithmConstructionInfo& info)
      : btCollisionAlgorithm(info) {}
  ~CompoundPairAlgorithm() override;

  void processCollision(const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b,
                        const btDispatcherInfo& info, btManifoldResult* result) override;
  btScalar calculateTimeOfImpact(btCollisionObject*, btCollisionObject*, const btDispatcherInfo&,
                                 btManifoldResult*) override {
    return 1;
  }
  void getAllContactManifolds(btManifoldArray& manifolds) override;

 private:
  struct PartPair {
    int part_a, part_b;
    btCollisionAlgorithm* algorithm;
    btPersistentManifold* manifold;
  };

  void MakePartPairs(const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b);
  void Collide(PartPair& pair, const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b,
               const btDispatcherInfo& info, btManifoldResult* result);

  std::vector<PartPair> pairs_;
};

/// Which parts of two bodies a manifold belongs to; 0 for bodies of one part each.
inline int PartPairOf(const btPersistentManifold* manifold) { return manifold->m_companionIdA; }

}  // namespace smile::physics
