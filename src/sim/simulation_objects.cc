// How objects come into a simulation and go out of it without a hand.

#include <algorithm>

#include "sim/simulation.h"
#include "sim/spawning.h"

namespace smile::sim {

std::optional<Refusal> Simulation::Carry(const Spawn& spawn) {
  Refusal refusal;
  auto grown = GrownModel(*model_, spawn, &refusal);
  if (grown == nullptr) return refusal;
  if (auto overlap = RefuseOverlap(*grown, tabletop_, physics_)) return overlap;
  model_ = std::move(grown);
  tabletop_.Grow(model_);
  return std::nullopt;
}

std::optional<Refusal> Simulation::Carry(const Remove& remove) {
  const world::Object* object = tabletop_.Find(remove.object);
  if (object == nullptr) return tabletop_.RefuseToReach(remove.object);
  return demonstrator_.Remove(*object);
}

std::optional<Refusal> Simulation::Carry(const Clear&) {
  std::vector<physics::BodyId> kept;
  std::vector<const world::Object*> taken;
  for (const world::Object& object : tabletop_.objects()) {
    if (!tabletop_.IsPresent(object) || !physics_.body(object.body).is_carried()) continue;
    for (physics::BodyId member : physics_.Assembly(object.body)) kept.push_back(member);
  }
  for (const world::Object& object : tabletop_.objects()) {
    const bool is_kept = std::ranges::find(kept, object.body) != kept.end();
    if (tabletop_.IsPresent(object) && !is_kept) taken.push_back(&object);
  }
  if (taken.empty()) return "there is nothing to clear away";
  for (const world::Object* object : taken) {
    if (auto refusal = demonstrator_.Remove(*object)) return refusal;
  }
  return std::nullopt;
}

}  // namespace smile::sim
