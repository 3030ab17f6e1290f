#include "physics/internal_contact_cache.h"

#include <algorithm>
#include <stdexcept>

#include "base/sparse_fields.h"
#include "physics/internal_compound_pairs.h"

// Contact points in snapshots. Impulses of the last step are the solver's starting point in the
// next one, so points must be restored field by field. Layout: number of manifolds u32; each: key
// (three i32), number of points i32, and each point as PutSparse() writes it. Each list belongs to
// a body, or to all links.

namespace smile::physics {
namespace {

/// The numbers of a contact point that persist between steps. Not byte by byte, since Bullet's
/// struct has padding.
struct PointFields {
  template <class Point, class Field>
  static void Visit(Point& point, Field field) {
    for (auto* v : {&point.m_localPointA, &point.m_localPointB, &point.m_positionWorldOnA,
                    &point.m_positionWorldOnB, &point.m_normalWorldOnB,
                    &point.m_lateralFrictionDir1, &point.m_lateralFrictionDir2}) {
      for (int i = 0; i < 3; ++i) field((*v)[i]);
    }
    for (auto* number :
         {&point.m_distance1, &point.m_combinedFriction, &point.m_combinedRollingFriction,
          &point.m_combinedSpinningFriction, &point.m_combinedRestitution, &point.m_appliedImpulse,
          &point.m_prevRHS, &point.m_appliedImpulseLateral1, &point.m_appliedImpulseLateral2,
          &point.m_contactMotion1, &point.m_contactMotion2, &point.m_contactCFM,
          &point.m_contactERP, &point.m_frictionCFM}) {
      field(*number);
    }
    for (auto* number : {&point.m_partId0, &point.m_partId1, &point.m_index0, &point.m_index1,
                         &point.m_contactPointFlags, &point.m_lifeTime}) {
      field(*number);
    }
  }
};

}  // namespace

ManifoldKey KeyOfManifold(const btPersistentManifold* manifold) {
  return {OrderOf(manifold->getBody0()), OrderOf(manifold->getBody1()), PartPairOf(manifold)};
}

void ReadContacts(int owner, ByteReader* in, std::vector<SavedManifold>* contacts) {
  const auto num_manifolds = in->Get<std::uint32_t>();
  // Counts are checked before they are used.
  for (std::uint32_t i = 0; i < num_manifolds && in->ok(); ++i) {
    SavedManifold& manifold = contacts->emplace_back();
    manifold.owner = owner;
    manifold.key = ManifoldKey{in->Get<int>(), in->Get<int>(), in->Get<int>()};
    manifold.count = in->Get<int>();
    if (manifold.count < 1 || manifold.count > MANIFOLD_CACHE_SIZE) {
      throw std::invalid_argument("snapshot: a contact manifold has " +
                                  std::to_string(manifold.count) + " points, expected 1 to 4");
    }
    for (int k = 0; k < manifold.count; ++k) {
      manifold.points[k] =
          btManifoldPoint(btVector3(0, 0, 0), btVector3(0, 0, 0), btVector3(0, 0, 0), 0);
      // Fields that are not saved have the values of a new point.
      GetSparse<PointFields>(in, &manifold.points[k]);
    }
  }
  if (!in->ok()) throw std::invalid_argument("snapshot: its contacts are truncated");
}

namespace {

/// Contact manifolds of two objects, those that have a pair and those that it still needs.
class PairManifolds {
 public:
  PairManifolds(btCollisionObject& a, btCollisionObject& b, ExactWorld& world,
                StatelessBroadphase& broadphase)
      : a_(a), b_(b), world_(world), broadphase_(broadphase) {}

  /// Returns the manifold with this key; null if there is none.
  btPersistentManifold* Find(const ManifoldKey& key) const {
    const btBroadphasePair* pair = broadphase_.getOverlappingPairCache()->findPair(
        a_.getBroadphaseHandle(), b_.getBroadphaseHandle());
    if (pair == nullptr || pair->m_algorithm == nullptr) return nullptr;
    btManifoldArray manifolds;
    pair->m_algorithm->getAllContactManifolds(manifolds);
    for (btPersistentManifold* manifold : All(manifolds)) {
      if (KeyOfManifold(manifold) == key) return manifold;
    }
    return nullptr;
  }

  /// Makes the manifolds of all their parts by colliding the two, asleep or not. Does nothing if
  /// they never collide.
  void Make() {
    if (!a_.checkCollideWith(&b_) || !b_.checkCollideWith(&a_)) return;
    btBroadphasePair* pair = broadphase_.getOverlappingPairCache()->addOverlappingPair(
        a_.getBroadphaseHandle(), b_.getBroadphaseHandle());
    if (pair == nullptr) return;
    // Bullet makes no manifold for two that sleep.
    const int activation = a_.getActivationState();
    a_.forceActivationState(ACTIVE_TAG);
    const btCollisionObjectWrapper first = Wrap(*ObjectOf(pair->m_pProxy0)),
                                   second = Wrap(*ObjectOf(pair->m_pProxy1));
    if (pair->m_algorithm == nullptr) {
      pair->m_algorithm = world_.getDispatcher()->findAlgorithm(&first, &second, nullptr,
                                                                BT_CONTACT_POINT_ALGORITHMS);
    }
    btManifoldResult result(&first, &second);
    const CompoundPairAlgorithm::AllPartPairsScope all_part_pairs_scope;
    pair->m_algorithm->processCollision(&first, &second, world_.getDispatchInfo(), &result);
    a_.forceActivationState(activation);
  }

 private:
  static btCollisionObjectWrapper Wrap(const btCollisionObject& object) {
    return {nullptr, object.getCollisionShape(), &object, object.getWorldTransform(), -1, -1};
  }

  btCollisionObject &a_, &b_;
  ExactWorld& world_;
  StatelessBroadphase& broadphase_;
};

}  // namespace

void SaveContacts(std::span<const OwnedManifold> touching, ByteWriter* out) {
  out->Put(static_cast<std::uint32_t>(touching.size()));
  for (const auto& [owner, manifold] : touching) {
    const auto [a, b, parts] = KeyOfManifold(manifold);
    out->Put(a);
    out->Put(b);
    out->Put(parts);
    out->Put(manifold->getNumContacts());
    for (int k = 0; k < manifold->getNumContacts(); ++k) {
      PutSparse<PointFields>(manifold->getContactPoint(k), out);
    }
  }
}

void RestoreContacts(std::span<const SavedManifold> saved, const ContactOwners& owners,
                     ExactWorld& world, StatelessBroadphase& broadphase) {
  std::vector<btPersistentManifold*> restored;
  for (const SavedManifold& from : saved) {
    btCollisionObject* a = owners.object_of(std::get<0>(from.key));
    btCollisionObject* b = owners.object_of(std::get<1>(from.key));
    if (a == nullptr || b == nullptr) {
      throw std::invalid_argument("snapshot: a contact belongs to an unknown object");
    }
    if (owners.owner_of(a, b) != from.owner) {
      throw std::invalid_argument("snapshot: a contact is listed with another object");
    }
    PairManifolds manifolds(*a, *b, world, broadphase);
    if (manifolds.Find(from.key) == nullptr) manifolds.Make();
    restored.push_back(manifolds.Find(from.key));
    if (restored.back() == nullptr) {
      throw std::invalid_argument("snapshot: a contact fits no pair of shapes in this world");
    }
  }
  // Those that the snapshot does not have, or that arose just now, become empty. The next step
  // finds nothing in them, as if they were new.
  for (btPersistentManifold* manifold : world.manifolds()) {
    const int owner = owners.owner_of(manifold->getBody0(), manifold->getBody1());
    if (owners.is_replaced(owner)) manifold->clearManifold();
  }
  for (std::size_t i = 0; i < saved.size(); ++i) {
    restored[i]->setNumContacts(saved[i].count);
    for (int k = 0; k < saved[i].count; ++k) restored[i]->getContactPoint(k) = saved[i].points[k];
  }
}

}  // namespace smile::physics
