#include "physics/internal_dormant_islands.h"

#include <algorithm>
#include <iterator>
#include <set>

#include "base/demand.h"
#include "base/state_hash.h"
#include "physics/internal_collision_object.h"
#include "physics/internal_exact_world.h"
#include "physics/internal_joint_constraint.h"
#include "physics/internal_stateless_broadphase.h"

// Bullet visits every object, pair and contact several times a step, awake or not. Leaving out
// sleeping islands rests on three facts:
//
// 1. A body that has been asleep for two steps no longer changes: its predicted pose and its box
//    have been computed with velocity zero, so computing them again gives the same bits.
// 2. Bullet wakes a body only through a pair of overlapping boxes, through a joint, or from
//    outside. Pairs and joints with what can move keep an island in the world; boxes are searched
//    in each step before pairs are made; and what acts from outside returns the island first
//    (Body::WakeUp) or all of them (World).
// 3. The order of work is that of the objects' creation, with or without others in between; that
//    of joints is OrderJoints().
//
// An island keeps all pairs of its bodies, also those with static bodies: whatever is near it was
// in the world when it was left out. A static body that is left out has therefore no pairs itself,
// and returns with an island that has a pair with it.

namespace smile::physics {
namespace {

/// Number of steps after which a sleeping body no longer changes.
constexpr int kSettled = 2;
/// Number of steps after which an island that had to stay is examined again. Any number would do.
constexpr int kRetryPeriod = 64;

// Two of the numbers that Bullet keeps with an object for its user; OrderOf() is the first.
int StepsAsleep(const btRigidBody& body) { return body.getUserIndex2(); }
void SetStepsAsleep(int steps, btRigidBody* body) { body->setUserIndex2(steps); }
/// The key of a body's island while it is left out; otherwise kPresent.
int KeyOf(const btCollisionObject& body) { return body.getUserIndex3(); }
void SetKey(int key, btRigidBody* body) { body->setUserIndex3(key); }
constexpr int kPresent = -1;
bool IsLeftOut(const btCollisionObject* object) { return KeyOf(*object) != kPresent; }

/// Returns true for a static body; links of kinematic robots that never move are none.
bool IsFixture(const btCollisionObject& object) {
  return object.isStaticObject() && BodyOf(&object) != nullptr;
}

std::uint64_t HashOf(const btRigidBody& body) {
  StateHash hash;
  hash.Add(static_cast<std::uint64_t>(OrderOf(&body)));
  AddMotion(body, &hash);
  return hash.value();
}

void SetPlace(int place, btTypedConstraint* joint) {
  static_cast<JointConstraint*>(joint)->place = place;
}

btManifoldArray ManifoldsOf(const btBroadphasePair& pair) {
  btManifoldArray manifolds;
  if (pair.m_algorithm != nullptr) pair.m_algorithm->getAllContactManifolds(manifolds);
  return manifolds;
}

btDbvtVolume BoxOf(const btBroadphaseProxy& proxy) {
  return btDbvtVolume::FromMM(proxy.m_aabbMin, proxy.m_aabbMax);
}

}  // namespace

DormantIslands::DormantIslands(ExactWorld& world, Dispatcher& dispatcher,
                               StatelessBroadphase& broadphase)
    : world_(world), dispatcher_(dispatcher), broadphase_(broadphase) {}

bool DormantIslands::AllSleep() {
  if (all_sleep_) return true;
  all_sleep_ = std::ranges::none_of(All(world_.getNonStaticRigidBodies()), &btRigidBody::isActive);
  return all_sleep_;
}

std::uint64_t DormantIslands::HashOfBodies() {
  if (AllSleep() && hash_of_bodies_) return *hash_of_bodies_;
  std::uint64_t sum = hash_;
  ForEachPresent([&sum](const btRigidBody& body) { sum += HashOf(body); });
  if (all_sleep_) hash_of_bodies_ = sum;
  return sum;
}

void DormantIslands::NoteChange() {
  all_sleep_ = false;
  hash_of_bodies_.reset();
  --period_in_world_;
}

void DormantIslands::LeaveOut() {
  NoteChange();
  if (!CountStepsAsleep()) return;
  Islands leaving = FindIslandsToLeave();
  if (leaving.empty()) return;
  // From here on the key tells which bodies leave.
  for (auto& [key, island] : leaving) {
    for (btRigidBody* body : island.bodies) {
      SetKey(key, body);
      island.hash += HashOf(*body);
      btBroadphaseProxy* proxy = body->getBroadphaseHandle();
      island.boxes.push_back(boxes_.insert(BoxOf(*proxy), body));
    }
    hash_ += island.hash;
  }
  TakePairs(&leaving);
  TakeJoints(&leaving);
  dispatcher_.TakeManifolds([](const btPersistentManifold& manifold) {
    return IsLeftOut(manifold.getBody0()) || IsLeftOut(manifold.getBody1());
  });
  world_.TakeObjects(IsLeftOut);
  broadphase_.TakeProxies([](const auto* proxy) { return IsLeftOut(ObjectOf(proxy)); });
  islands_.merge(leaving);
}

/// Counts for each body in the world how long it has been asleep. Returns true if there are bodies
/// whose islands should be examined now.
bool DormantIslands::CountStepsAsleep() {
  bool is_time = false;
  for (btCollisionObject* object : All(world_.getCollisionObjectArray())) {
    btRigidBody* body = btRigidBody::upcast(object);
    if (body == nullptr || BodyOf(body) == nullptr) continue;
    const bool is_active = body->isActive() && !body->isStaticObject();
    const int steps = is_active ? 0 : std::max(0, StepsAsleep(*body)) + 1;
    SetStepsAsleep(steps, body);
    is_time = is_time || (steps > 0 && steps % kRetryPeriod == kSettled);
  }
  return is_time;
}

/// Returns the islands that must be in the world, by Bullet's tags, which are those of the last
/// step.
std::set<int> DormantIslands::FindTagsThatStay() const {
  std::set<int> staying;
  const auto stay = [&staying](const btCollisionObject& object) {
    staying.insert(object.getIslandTag());
  };
  for (const btCollisionObject* object : All(world_.getCollisionObjectArray())) {
    const btRigidBody* body = btRigidBody::upcast(object);
    if (body == nullptr || StepsAsleep(*body) < kSettled) stay(*object);
  }
  // A kinematic object moves without being part of an island.
  const auto stay_beside_kinematic = [&stay](const auto& a, const auto& b) {
    if (a.isKinematicObject()) stay(b);
    if (b.isKinematicObject()) stay(a);
  };
  for (const btTypedConstraint* joint : world_.joints()) {
    stay_beside_kinematic(joint->getRigidBodyA(), joint->getRigidBodyB());
  }
  for (const btBroadphasePair& pair : All(broadphase_.pairs())) {
    stay_beside_kinematic(*ObjectOf(pair.m_pProxy0), *ObjectOf(pair.m_pProxy1));
  }
  return staying;
}

/// Returns the islands that need not be in the world, by keys that are not in use.
DormantIslands::Islands DormantIslands::FindIslandsToLeave() const {
  const std::set<int> staying = FindTagsThatStay();
  Islands leaving;
  std::map<int, int> key_of_tag;
  for (btRigidBody* body : All(world_.getNonStaticRigidBodies())) {
    const int tag = body->getIslandTag();
    if (body->isKinematicObject() || staying.contains(tag)) continue;
    const int next_key = next_key_ + static_cast<int>(key_of_tag.size());
    leaving[key_of_tag.emplace(tag, next_key).first->second].bodies.push_back(body);
  }
  std::set<const btCollisionObject*> near;
  for (const btBroadphasePair& pair : All(broadphase_.pairs())) {
    const btCollisionObject &a = *ObjectOf(pair.m_pProxy0), &b = *ObjectOf(pair.m_pProxy1);
    if (a.isStaticObject() && staying.contains(b.getIslandTag())) near.insert(&a);
    if (b.isStaticObject() && staying.contains(a.getIslandTag())) near.insert(&b);
  }
  int next_key = next_key_ + static_cast<int>(key_of_tag.size());
  for (btCollisionObject* object : All(world_.getCollisionObjectArray())) {
    if (!IsFixture(*object) || near.contains(object)) continue;
    leaving[next_key++].bodies.push_back(btRigidBody::upcast(object));
  }
  return leaving;
}

/// Moves the pairs of the leaving islands from the broadphase to the islands.
void DormantIslands::TakePairs(Islands* leaving) {
  next_key_ = leaving->rbegin()->first + 1;
  for (btBroadphasePair& pair : All(broadphase_.pairs())) {
    const btCollisionObject &a = *ObjectOf(pair.m_pProxy0), &b = *ObjectOf(pair.m_pProxy1);
    const int key = KeyOf(a.isStaticObject() ? b : a);
    if (key == kPresent) continue;
    leaving->at(key).pairs.push_back(pair);
    // The algorithm has the contacts; it must not end with the pair.
    pair.m_algorithm = nullptr;
  }
  for (const auto& [key, island] : *leaving) {
    for (const btBroadphasePair& pair : island.pairs) {
      broadphase_.getOverlappingPairCache()->removeOverlappingPair(pair.m_pProxy0, pair.m_pProxy1,
                                                                   &dispatcher_);
    }
  }
}

/// Moves the joints of the leaving islands from the world to the islands.
void DormantIslands::TakeJoints(Islands* leaving) {
  for (btTypedConstraint* joint : world_.joints()) {
    const btRigidBody &a = joint->getRigidBodyA(), &b = joint->getRigidBodyB();
    const int key = KeyOf(a.isStaticObject() ? b : a);
    if (key == kPresent) continue;
    Island& island = leaving->at(key);
    island.joints.push_back(joint);
    joint_order_.LeaveOut({joint->getUserConstraintId(), OrderOf(island.bodies.front())});
  }
  world_.TakeJoints([this](const btTypedConstraint* joint) {
    return joint_order_.IsLeftOut(joint->getUserConstraintId());
  });
}

void DormantIslands::OrderJoints() {
  const std::span<btTypedConstraint*> joints = world_.joints();
  for (btTypedConstraint* joint : joints) SetPlace(0, joint);
  if (joint_order_.is_complete() || joints.size() < 2) return;
  // The tag of an island is that of its first object, from before islands were found.
  std::vector<int> order_of_tag;
  for (const btCollisionObject* object : All(world_.getCollisionObjectArray())) {
    if (!object->isStaticOrKinematicObject()) order_of_tag.push_back(OrderOf(object));
  }
  std::vector<mechanics::JointOrder::Entry> present;
  for (const btTypedConstraint* joint : joints) {
    const int tag_a = joint->getRigidBodyA().getIslandTag();
    const int tag = tag_a >= 0 ? tag_a : joint->getRigidBodyB().getIslandTag();
    present.push_back({joint->getUserConstraintId(), tag >= 0 ? order_of_tag[tag] : -1});
  }
  const std::vector<int> places = joint_order_.PlacesOf(present);
  for (std::size_t i = 0; i < places.size(); ++i) SetPlace(places[i], joints[i]);
}

void DormantIslands::ReturnReached() {
  if (islands_.empty()) return;
  struct Reached : btDbvt::ICollide {
    void Process(const btDbvtNode* leaf) override {
      auto* body = static_cast<btRigidBody*>(leaf->data);
      if (filter->needBroadphaseCollision(mover, body->getBroadphaseHandle())) {
        bodies.push_back(body);
      }
    }
    const PairFilter* filter = nullptr;
    btBroadphaseProxy* mover = nullptr;
    std::vector<btRigidBody*> bodies;
  } reached;
  reached.filter = &broadphase_.filter();
  for (btCollisionObject* object : All(world_.getCollisionObjectArray())) {
    // Pairs with static objects are found when an island returns for another reason.
    if (object->isStaticObject()) continue;
    reached.mover = object->getBroadphaseHandle();
    boxes_.collideTV(boxes_.m_root, BoxOf(*reached.mover), reached);
  }
  if (reached.bodies.empty()) return;
  for (const btRigidBody* body : reached.bodies) {
    // An island may be reached twice.
    if (IsLeftOut(body)) Put(islands_.find(KeyOf(*body)));
  }
  world_.SortObjects();
}

void DormantIslands::Return(std::span<btRigidBody* const> bodies) {
  // Any of them may have had contact with a static body, or have it now.
  if (std::ranges::any_of(bodies, &btRigidBody::isStaticObject)) ReturnAll();
  NoteChange();
  bool is_sorted = true;
  for (btRigidBody* body : bodies) {
    // What it becomes has not been asleep for any step that was counted.
    SetStepsAsleep(0, body);
    if (!IsLeftOut(body)) continue;
    // With the island this body and others of the list are in the world.
    Put(islands_.find(KeyOf(*body)));
    is_sorted = false;
  }
  if (!is_sorted) world_.SortObjects();
}

void DormantIslands::ReturnAll() {
  NoteChange();
  while (!islands_.empty()) Put(islands_.begin());
  world_.SortObjects();
}

/// Puts an island back into the world; the objects must then be sorted.
void DormantIslands::Put(Islands::iterator place) {
  Island& island = place->second;
  hash_ -= island.hash;
  for (btDbvtNode* box : island.boxes) boxes_.remove(box);
  for (btRigidBody* body : island.bodies) {
    SetKey(kPresent, body);
    SetStepsAsleep(0, body);
    world_.PutObject(body);
    broadphase_.PutProxy(body->getBroadphaseHandle());
  }
  for (btTypedConstraint* joint : island.joints) {
    joint_order_.Return(joint->getUserConstraintId());
    world_.PutJoint(joint);
  }
  for (const btBroadphasePair& pair : island.pairs) {
    for (const btBroadphaseProxy* proxy : {pair.m_pProxy0, pair.m_pProxy1}) {
      // A static body, which has no pairs of its own.
      if (IsLeftOut(ObjectOf(proxy))) Put(islands_.find(KeyOf(*ObjectOf(proxy))));
    }
    btBroadphasePair* fresh =
        broadphase_.getOverlappingPairCache()->addOverlappingPair(pair.m_pProxy0, pair.m_pProxy1);
    // What may collide changes only when all islands are in the world.
    SMILE_DEMAND(fresh != nullptr);
    fresh->m_algorithm = pair.m_algorithm;
    btManifoldArray manifolds = ManifoldsOf(pair);
    for (btPersistentManifold* manifold : All(manifolds)) dispatcher_.PutManifold(manifold);
  }
  islands_.erase(place);
}

std::int64_t DormantIslands::PeriodOf(const btRigidBody& body) const {
  return IsLeftOut(&body) ? KeyOf(body) : period_in_world_;
}

std::vector<btPersistentManifold*> DormantIslands::AllManifolds() const {
  std::vector<btPersistentManifold*> all = dispatcher_.Manifolds();
  for (const auto& [key, island] : islands_) {
    for (const btBroadphasePair& pair : island.pairs) {
      btManifoldArray manifolds = ManifoldsOf(pair);
      std::ranges::copy(All(manifolds), std::back_inserter(all));
    }
  }
  return all;
}

}  // namespace smile::physics
