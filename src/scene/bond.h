#pragma once

#include <optional>
#include <string>
#include <vector>

#include "math/rigid_transform.h"
#include "scene/tool.h"

namespace smile::scene {

// Two frames inside composites that fit together, as a screw fits a thread: a guest (plug) is
// fastened to a host (hole) of the same type, in stages of tightness. One host holds one guest.

struct GuestPoint {
  std::string id;    ///< unique among all ids of the scene
  std::string type;  ///< only equal types fit
  RigidTransform X_PG;
  std::string initial_host;   ///< id of the host to which it is fastened at the start; may be empty
  int initial_tightness = 0;  ///< 1 is the first stage; 0 = not fastened
  bool can_be_cut = false;    ///< tools that cut can end its bond
  bool refuses_hands = false;      ///< only tools fasten and loosen it
  std::vector<ToolPlace> accepts;  ///< where tools fasten and loosen it

  bool operator==(const GuestPoint&) const = default;
};

/// Pose of a guest at one stage of tightness: its frame coincides with this one.
struct TightnessStage {
  RigidTransform X_HS;                  ///< the stage's frame S in the host point H
  std::optional<int> downstream_state;  ///< forced upon the host's `downstream_override`
  bool locks_downstream = false;        ///< true if the host's `downstream_lock` is locked

  bool operator==(const TightnessStage&) const = default;
};

struct HostPoint {
  std::string id;    ///< unique among all ids of the scene
  std::string type;  ///< only equal types fit
  RigidTransform X_PH;
  std::string downstream;              ///< id of the control that is set to the tightness
  std::string downstream_override;     ///< id of the control on which stages force a state
  std::string downstream_lock;         ///< id of the host point that stages lock
  std::vector<TightnessStage> stages;  ///< 1, 2, …; at least one

  bool operator==(const HostPoint&) const = default;
};

}  // namespace smile::scene
