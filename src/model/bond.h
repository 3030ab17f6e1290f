#pragma once

#include <optional>

#include "model/indices.h"
#include "scene/bond_points.h"

namespace smile::model {

/// Guest point of the scene: a plug.
struct Guest {
  const scene::GuestPoint* point = nullptr;  ///< in the scene; never null in a Model
  ObjectIndex object{0};                     ///< the object it belongs to
  RigidTransform X_BG{};                     ///< in the object's body B
};

/// Host point of the scene: a hole.
struct Host {
  const scene::HostPoint* point = nullptr;  ///< in the scene; never null in a Model
  ObjectIndex object{0};                    ///< the object it belongs to
  RigidTransform X_BH{};                    ///< in the object's body B
  std::optional<ControlIndex> downstream{}, downstream_override{};
  std::optional<HostIndex> downstream_lock{};
};

/// State of a host: its guest, and whether that can change.
struct HostState {
  std::optional<GuestIndex> guest{};  ///< nullopt: none
  int tightness = 0;
  bool is_locked = false;  ///< can be neither fastened nor loosened

  bool operator==(const HostState&) const = default;
};

/// Returns the stage of a host at a tightness; nullptr at 0.
const scene::TightnessStage* StageAt(const Host& host, int tightness);
/// Returns the state that a host forces on its `downstream_override` at a tightness; -1: none.
int OverrideAt(const Host& host, int tightness);
/// Returns true if a host locks its `downstream_lock` at a tightness.
bool LocksDownstreamAt(const Host& host, int tightness);
/// Returns the pose X_AB of the guest's body B in the host's body A at a tightness.
RigidTransform GuestBodyInHostBody(const Host& host, const Guest& guest, int tightness);

}  // namespace smile::model
