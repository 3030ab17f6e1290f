#include "mechanics/collision_exemptions.h"

#include <stdexcept>

// Pairs of bodies with exceptions from contact. An ignored pair (after a joint has ended inside a
// hole, for example) does not collide until it has separated, or nearly so: a body that only
// touches another must not fall through it. A close fit collides, but with the same play. A pair
// goes from the first list to the second and then out of both. Both lists are sorted and part of
// snapshots.

namespace smile::mechanics {

CollisionExemptions::CollisionExemptions(CollidingPairs* pairs, double play, bool eases_close_fits)
    : world_(pairs), play_(play), eases_close_fits_(eases_close_fits) {}

void CollisionExemptions::IgnoreUntilSeparated(BodyId a, BodyId b) {
  if (a == b) throw std::invalid_argument("world: a body cannot pass through itself");
  const BodyPair pair = PairOf(a, b);
  if (!world_->CanMove(pair) || ignored_.Contains(pair)) return;
  // A pair is in one of the two lists at most.
  close_fits_.Remove(pair);
  ignored_.Add(pair);
  world_->Exclude({a, b});
}

template <class IsOver>
void CollisionExemptions::EndIgnoring(IsOver is_over) {
  ignored_.RemoveIf([this, &is_over](const BodyPair& pair) {
    if (!is_over(pair)) return false;
    world_->Include(pair);
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
  close_fits_.RemoveIf([this](const BodyPair& pair) {
    return world_->IsAnyAwake(pair) && world_->OverlapDepth(pair) <= 0;
  });
  EndIgnoring([this](const BodyPair& pair) {
    if (!world_->IsAnyAwake(pair)) return false;
    const double depth = world_->OverlapDepth(pair);
    if (depth > play_) return false;
    if (depth > 0 && eases_close_fits_) close_fits_.Add(pair);
    return true;
  });
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
  close_fits_ = BodyPairs(snapshot.close_fits);
}

void CollisionExemptions::AddTo(StateHash* hash) const {
  ignored_.AddTo(hash);
  // Added only if present, so that hashes of worlds without close fits stay unchanged.
  if (!close_fits_.empty()) hash->Add("close fits");
  close_fits_.AddTo(hash);
}

}  // namespace smile::mechanics
