#pragma once

#include <array>
#include <string_view>

#include "math/angles.h"

namespace smile::scene {

/// Cause that triggers a switch or a part of a control. The demonstrator's hands can trigger those
/// that are pressed, too.
enum class TriggerCause {
  kHand,   ///< a hand of the demonstrator only
  kPress,  ///< anything that pushes it in
  kCut,    ///< a tool that cuts it, and no hand
};
/// Names of the causes in scene files.
inline constexpr std::array<std::string_view, 3> kTriggerCauses{"hand", "press", "cut"};

/// Rule by which a switch or a part of a control is triggered.
struct TriggerRule {
  TriggerCause cause = TriggerCause::kHand;
  /// Force with which it must be pushed in, as the mean of a tick [N]. About that of a doorbell.
  double press_force = 5;
  double press_angle = DegreesToRadians(45.0);  ///< greatest angle between push and axis [rad]

  bool operator==(const TriggerRule&) const = default;
};

}  // namespace smile::scene
