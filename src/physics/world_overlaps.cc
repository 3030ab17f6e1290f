// What overlaps in a World, and what may.

#include <algorithm>
#include <stdexcept>

#include "physics/internal_articulation_links.h"
#include "physics/internal_engine.h"
#include "physics/world.h"

namespace smile::physics {
namespace {

/// Two that pass through each other and overlap by no more than this have come apart: what merely
/// touches must not fall through [m].
constexpr double kApart = 0.0005;

}  // namespace

void World::LetPass(BodyId a, BodyId b) {
  if (a == b) throw std::invalid_argument("world: a body cannot pass through itself");
  const std::pair<BodyId, BodyId> pair = std::minmax(a, b);
  if (body(a).is_static() && body(b).is_static()) return;
  const auto place = std::lower_bound(passing_.begin(), passing_.end(), pair);
  if (place != passing_.end() && *place == pair) return;
  passing_.insert(place, pair);
  engine_->broadphase.Exclude(*body(a).bullet_, *body(b).bullet_, &engine_->dispatcher);
}

template <class IsOver>
void World::EndPassing(IsOver is_over) {
  std::erase_if(passing_, [this, &is_over](const auto& pair) {
    if (!is_over(pair)) return false;
    engine_->broadphase.filter().Include(static_cast<int>(pair.first.value),
                                         static_cast<int>(pair.second.value));
    return true;
  });
}

void World::EndPassingOf(BodyId id) {
  EndPassing([id](const auto& pair) { return pair.first == id || pair.second == id; });
}

void World::EndAllPassing() {
  EndPassing([](const auto&) { return true; });
}

void World::EndPassingApart() {
  EndPassing([this](const auto& pair) {
    const Body &a = body(pair.first), &b = body(pair.second);
    if (!a.is_awake() && !b.is_awake()) return false;
    return OverlapDepth(a, a.bullet_->getWorldTransform(), *b.bullet_) <= kApart;
  });
}

double World::OverlapDepth(const Body& a, const btTransform& X_WAcm,
                           const btCollisionObject& b) const {
  return engine_->overlap_probe.Depth(a.bullet_->getCollisionShape(), X_WAcm,
                                      const_cast<btCollisionShape*>(b.getCollisionShape()),
                                      b.getWorldTransform());
}

Overlaps World::OverlapsAt(BodyId id, const RigidTransform& X_WB, double depth) const {
  const Body& moved = body(id);
  const btTransform X_WBcm = ToBullet(X_WB * moved.X_BcmB_.inverse());
  const PairFilter& filter = engine_->broadphase.filter();
  const auto is_in_the_way = [&](const btCollisionObject& other) {
    return !filter.IsExcluded(static_cast<int>(id.value), OrderOf(&other)) &&
           OverlapDepth(moved, X_WBcm, other) > depth;
  };
  Overlaps overlaps;
  for (const auto& other : bodies_) {
    if (other->id() == id) continue;
    if (is_in_the_way(*other->bullet_)) overlaps.bodies.push_back(other->id());
  }
  for (const auto& articulation : articulations_) {
    for (int link = -1; link < articulation->num_joints(); ++link) {
      const auto* collider = articulation->links_->collider(link);
      if (collider && is_in_the_way(*collider)) overlaps.with_articulation = true;
    }
  }
  return overlaps;
}

}  // namespace smile::physics
