#pragma once

#include <optional>

#include "model/indices.h"
#include "scene/bond_points.h"

namespace smile::model {

/// A plug of the scene.
struct Guest {
  const scene::GuestPoint* point = nullptr;  ///< of the scene; never null in a Model
  ObjectIndex object{0};                     ///< the object it belongs to
  RigidTransform X_BG{};                     ///< in the object's body B
};

/// A hole of the scene.
struct Host {
  const scene::HostPoint* point = nullptr;  ///< of the scene; never null in a Model
  ObjectIndex object{0};                    ///< the object it belongs to
  RigidTransform X_BH{};                    ///< in the object's body B
  std::optional<ControlIndex> downstream{}, downstream_override{};
  std::optional<HostIndex> downstream_lock{};
};

/// What a host holds, and whether that can change.
struct HostState {
  std::optional<GuestIndex> guest{};  ///< nullopt: none
  int tightness = 0;
  bool is_locked = false;  ///< can be neither fastened nor loosened

  bool operator==(const HostState&) const = default;
};

/// The stage of a host at a tightness; nullptr at 0.
const scene::TightnessStage* StageAt(const Host& host, int tightness);
/// The state that a host forces on its `downstream_override` at a tightness; -1: none.
int OverrideAt(const Host& host, int tightness);
/// True where a host locks its `downstream_lock` at a tightness.
bool LocksDownstreamAt(const Host& host, int tightness);
/// Where the guest's body B is in that of the host, A, when it is fastened so far: X_AB.
RigidTransform GuestBodyInHostBody(const Host& host, const Guest& guest, int tightness);

}  // namespace smile::model
