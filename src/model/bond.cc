#include "model/bond.h"

namespace smile::model {

const scene::TightnessStage* StageAt(const Host& host, int tightness) {
  // Tightness counts stages from 1.
  return tightness > 0 ? &host.point->stages[static_cast<std::size_t>(tightness) - 1] : nullptr;
}

int OverrideAt(const Host& host, int tightness) {
  const scene::TightnessStage* stage = StageAt(host, tightness);
  return stage != nullptr ? stage->downstream_state.value_or(-1) : -1;
}

bool LocksDownstreamAt(const Host& host, int tightness) {
  const scene::TightnessStage* stage = StageAt(host, tightness);
  return stage != nullptr && stage->locks_downstream;
}

RigidTransform GuestBodyInHostBody(const Host& host, const Guest& guest, int tightness) {
  const scene::TightnessStage* stage = StageAt(host, tightness);
  const RigidTransform X_HStage = stage != nullptr ? stage->X_HS : RigidTransform();
  // The guest point coincides with the stage's frame in the hole.
  return host.X_BH * (X_HStage * guest.X_BG.inverse());
}

}  // namespace smile::model
