// What overlaps in a World, and what may.

#include <algorithm>
#include <stdexcept>

#include "physics/internal_articulation_links.h"
#include "physics/internal_engine.h"
#include "physics/world.h"

namespace smile::physics {
namespace {

/// Two that pass through each other and overlap by no more than this collide again: what merely
/// touches must not fall through. A close fit has as much play [m].
constexpr double kCloseFitDepth = ExactWorld::kCloseFitPlay;

using BodyPair = std::pair<BodyId, BodyId>;

void InsertSorted(const BodyPair& pair, std::vector<BodyPair>* pairs) {
  const auto place = std::ranges::lower_bound(*pairs, pair);
  if (place == pairs->end() || *place != pair) pairs->insert(place, pair);
}

}  // namespace

void World::LetPass(BodyId a, BodyId b) {
  if (a == b) throw std::invalid_argument("world: a body cannot pass through itself");
  const BodyPair pair = std::minmax(a, b);
  if (body(a).is_static() && body(b).is_static()) return;
  if (std::ranges::binary_search(passing_, pair)) return;
  std::erase(close_fits_, pair);
  InsertSorted(pair, &passing_);
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
  const auto is_of = [id](const BodyPair& pair) { return pair.first == id || pair.second == id; };
  EndPassing(is_of);
  std::erase_if(close_fits_, is_of);
}

void World::EndAllPassing() {
  EndPassing([](const auto&) { return true; });
  close_fits_.clear();
}

void World::EndPassingApart() {
  EndPassing([this](const BodyPair& pair) {
    if (!IsAnyAwake(pair)) return false;
    const double depth = OverlapDepth(pair);
    if (depth > kCloseFitDepth) return false;
    if (depth > 0 && config_.eases_close_fits) InsertSorted(pair, &close_fits_);
    return true;
  });
}

void World::EndCloseFitsApart() {
  std::erase_if(close_fits_, [this](const BodyPair& pair) {
    return IsAnyAwake(pair) && OverlapDepth(pair) <= 0;
  });
}

bool World::IsAnyAwake(const BodyPair& pair) const {
  return body(pair.first).is_awake() || body(pair.second).is_awake();
}

double World::OverlapDepth(const BodyPair& pair) const {
  const Body& a = body(pair.first);
  return OverlapDepth(a, a.bullet_->getWorldTransform(), *body(pair.second).bullet_);
}

double World::OverlapDepth(const Body& a, const btTransform& X_WAcm,
                           const btCollisionObject& b) const {
  return engine_->overlap_probe.Depth(a.bullet_->getCollisionShape(), X_WAcm,
                                      const_cast<btCollisionShape*>(b.getCollisionShape()),
                                      b.getWorldTransform());
}

Overlaps World::OverlapsAt(BodyId id, const RigidTransform& X_WB, double depth) const {
  return OverlapsOf(body(id), X_WB, depth);
}

Overlaps World::OverlapsOf(const std::vector<scene::Solid>& solids, const RigidTransform& X_WB,
                           double depth) const {
  // Static, as no bodies are yet that are to be weighed; of no id, which nothing may pass.
  const Body imagined(BodyId(), std::make_shared<const BodySpec>(BodySpec{.solids = solids}));
  return OverlapsOf(imagined, X_WB, depth);
}

Overlaps World::OverlapsOf(const Body& moved, const RigidTransform& X_WB, double depth) const {
  const BodyId id = moved.id();
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
