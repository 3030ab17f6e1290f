#pragma once

#include <map>
#include <memory>
#include <utility>

#include "physics/internal_shapes.h"

namespace smile::physics {

/// Collision algorithm for two shapes of which at least one is made of parts, with one contact
/// manifold per pair of parts. The manifold contains the pair of part numbers (PartPairOf), so that
/// a saved contact finds its manifold again; the manifolds of Bullet's own compound algorithms
/// are indistinguishable.
class CompoundPairAlgorithm : public btCollisionAlgorithm {
 public:
  struct CreateFunc : btCollisionAlgorithmCreateFunc {
    btCollisionAlgorithm* CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                   const btCollisionObjectWrapper* a,
                                                   const btCollisionObjectWrapper* b) override;
    /// Registers this for each pair with a compound; must outlive the dispatcher.
    void RegisterWith(btCollisionDispatcher* dispatcher);
  };

  /// While alive, algorithms process all pairs of parts, including those whose boxes do not
  /// overlap, so that each manifold exists before saved points are restored. Applies to the current
  /// thread.
  class AllPartPairsScope {
   public:
    AllPartPairsScope() { is_active_ = true; }
    ~AllPartPairsScope() { is_active_ = false; }
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
    btCollisionAlgorithm* algorithm;
    btPersistentManifold* manifold = nullptr;
    bool are_close = true;  ///< in this step
  };
  using PartNumbers = std::pair<int, int>;  ///< of A, of B

  /// An object with its parts.
  struct Parts;
  static btCollisionObjectWrapper Wrap(const Parts& parts, int part);
  void UpdatePairs(const Parts& a, const Parts& b);
  void Collide(PartPair& pair, const btCollisionObjectWrapper& a, const btCollisionObjectWrapper& b,
               const btDispatcherInfo& info, btManifoldResult* result);
  void Free(const PartPair& pair);
  bool AreClear(const btTransform& X_AB) const;
  void MeasureClearance(const Parts& a, const Parts& b, const btTransform& X_AB);

  /// How far the objects were apart at least, beyond the distance at which contact begins [m], when
  /// B was at X_AB. Until they have moved by this against each other, there is nothing to find.
  struct Clearance {
    btScalar distance;
    btTransform X_AB;
    btScalar radius_b;  ///< of the farthest point of B about its origin [m]
  };
  std::unique_ptr<Clearance> clearance_;
  bool was_processed_ = false;
  std::map<PartNumbers, PartPair> pairs_;  ///< those that are close, or still have contacts
};

/// Returns the number of the pair of parts that a manifold belongs to; 0 for bodies of one part
/// each.
inline int PartPairOf(const btPersistentManifold* manifold) { return manifold->m_companionIdA; }

}  // namespace smile::physics
