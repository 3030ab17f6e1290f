#include "physics/internal_collision_exemptions.h"

#include <algorithm>
#include <stdexcept>

#include "base/state_hash.h"
#include "physics/internal_body_dynamics.h"

// Pairs of bodies with exceptions from contact. An ignored pair (after a joint has ended inside a
// hole, for example) does not collide until it has separated, or nearly so; a close fit collides,
// but with some play. A pair goes from the first list to the second and then out of both. Both
// lists are sorted and part of snapshots.

namespace smile::physics {
namespace {

/// An ignored pair that overlaps by at most this collides again: a body that only touches another
/// must not fall through it. A close fit has the same play [m].
constexpr double kCloseFitDepth = ExactWorld::kCloseFitPlay;

}  // namespace

CollisionExemptions::CollisionExemptions(const WorldConfig& config, const WorldObjects& objects,
                                         Engine& engine)
    : config_(config), objects_(objects), engine_(engine) {}

void CollisionExemptions::IgnoreUntilSeparated(BodyId a, BodyId b) {
  if (a == b) throw std::invalid_argument("world: a body cannot pass through itself");
  const BodyPair pair = mechanics::PairOf(a, b);
  Body &body_a = objects_.body(a), &body_b = objects_.body(b);
  if (body_a.is_static() && body_b.is_static()) return;
  if (ignored_.Contains(pair)) return;
  // A pair is in one of the two lists at most.
  close_fits_.Remove(pair);
  ignored_.Add(pair);
  engine_.broadphase.Exclude(body_a.dynamics().bullet(), body_b.dynamics().bullet(),
                             &engine_.dispatcher);
}

template <class IsOver>
void CollisionExemptions::EndIgnoring(IsOver is_over) {
  ignored_.RemoveIf([this, &is_over](const BodyPair& pair) {
    if (!is_over(pair)) return false;
    // The two are a pair again, which only those in the world become.
    objects_.body(pair.first).dynamics().ReturnToWorld();
    objects_.body(pair.second).dynamics().ReturnToWorld();
    engine_.broadphase.filter().Include(static_cast<int>(pair.first.value),
                                        static_cast<int>(pair.second.value));
    return true;
  });
}

void CollisionExemptions::EndAllOf(BodyId id) {
  const auto is_of = [id](const BodyPair& pair) { return pair.first == id || pair.second == id; };
  EndIgnoring(is_of);
  close_fits_.RemoveIf(is_of);
}

void CollisionExemptions::EndAll() {
  EndIgnoring([](const BodyPair&) { return true; });
  close_fits_.clear();
}

void CollisionExemptions::Update() {
  // The depth of a pair of sleeping bodies cannot change, so only awake ones are measured.
  close_fits_.RemoveIf(
      [this](const BodyPair& pair) { return IsAnyAwake(pair) && OverlapDepth(pair) <= 0; });
  EndIgnoring([this](const BodyPair& pair) {
    if (!IsAnyAwake(pair)) return false;
    const double depth = OverlapDepth(pair);
    if (depth > kCloseFitDepth) return false;
    if (depth > 0 && config_.eases_close_fits) close_fits_.Add(pair);
    return true;
  });
  // The solver's world applies the play in each step.
  engine_.world.SetCloseFits(close_fits_);
}

bool CollisionExemptions::IsAnyAwake(const BodyPair& pair) const {
  return objects_.body(pair.first).is_awake() || objects_.body(pair.second).is_awake();
}

/// Returns the overlap of a pair [m], measured without creating contacts.
double CollisionExemptions::OverlapDepth(const BodyPair& pair) const {
  const btRigidBody& a = objects_.body(pair.first).dynamics().bullet();
  const btRigidBody& b = objects_.body(pair.second).dynamics().bullet();
  return engine_.overlap_probe.Depth(a, a.getWorldTransform(), b);
}

void CollisionExemptions::Save(Snapshot* snapshot) const {
  snapshot->passing = ignored_.sorted();
  snapshot->close_fits = close_fits_.sorted();
}

bool CollisionExemptions::AreThoseOf(const Snapshot& snapshot) const {
  return ignored_.sorted() == snapshot.passing && close_fits_.sorted() == snapshot.close_fits;
}

void CollisionExemptions::Restore(const Snapshot& snapshot) {
  for (const auto& [a, b] : snapshot.passing) IgnoreUntilSeparated(a, b);
  close_fits_ = mechanics::BodyPairs(snapshot.close_fits);
}

void CollisionExemptions::AddTo(StateHash* hash) const {
  ignored_.AddTo(hash);
  // Added only if present, so that hashes of worlds without close fits stay unchanged.
  if (!close_fits_.empty()) hash->Add("close fits");
  close_fits_.AddTo(hash);
}

}  // namespace smile::physics
