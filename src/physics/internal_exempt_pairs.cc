#include "physics/internal_exempt_pairs.h"

#include "physics/internal_body_dynamics.h"

namespace smile::physics {

using mechanics::BodyPair;

bool ExemptPairs::CanMove(const BodyPair& pair) const {
  // Both are looked up first: each must exist.
  const Body &a = objects_.body(pair.first), &b = objects_.body(pair.second);
  return !a.is_static() || !b.is_static();
}

bool ExemptPairs::IsAnyAwake(const BodyPair& pair) const {
  return objects_.body(pair.first).is_awake() || objects_.body(pair.second).is_awake();
}

double ExemptPairs::OverlapDepth(const BodyPair& pair) const {
  const btRigidBody& a = objects_.body(pair.first).dynamics().bullet();
  const btRigidBody& b = objects_.body(pair.second).dynamics().bullet();
  return engine_.overlap_probe.Depth(a, a.getWorldTransform(), b);
}

void ExemptPairs::Exclude(const BodyPair& pair) {
  engine_.broadphase.Exclude(objects_.body(pair.first).dynamics().bullet(),
                             objects_.body(pair.second).dynamics().bullet(), &engine_.dispatcher);
}

void ExemptPairs::Include(const BodyPair& pair) {
  // The two are a pair again, which only those in the world become.
  for (const BodyId id : {pair.first, pair.second}) objects_.body(id).dynamics().ReturnToWorld();
  engine_.broadphase.filter().Include(static_cast<int>(pair.first.value),
                                      static_cast<int>(pair.second.value));
}

}  // namespace smile::physics
