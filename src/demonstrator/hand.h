#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "math/rigid_transform.h"
#include "physics/definitions.h"

namespace smile::demonstrator {

/// The four logical hands of the demonstrator. Each may hold one object.
enum class HandName { kLeft, kRight, kBoth, kAny };
inline constexpr std::array kHandNames = {HandName::kLeft, HandName::kRight, HandName::kBoth,
                                          HandName::kAny};

/// Returns `left`, `right`, `both` or `any`, as in commands.
std::string_view ToString(HandName hand);
std::optional<HandName> ParseHandName(std::string_view text);

/// State of one hand: the object it holds, and its goal.
struct Hand {
  physics::BodyId held;            ///< none if the hand is empty
  RigidTransform X_WB_goal;        ///< goal of the held body B
  Vector3 p_BH = Vector3::Zero();  ///< point at which the body was grasped
  double speed = 0;                ///< greatest speed on the way [m/s]

  bool is_holding() const { return static_cast<bool>(held); }
  bool operator==(const Hand&) const = default;
};

}  // namespace smile::demonstrator
