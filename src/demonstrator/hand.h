#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "math/rigid_transform.h"
#include "physics/ids.h"

namespace smile::demonstrator {

/// The four logical hands of the invisible demonstrator. Each may hold one object.
enum class HandName { kLeft, kRight, kBoth, kAny };
inline constexpr std::array kHandNames = {HandName::kLeft, HandName::kRight, HandName::kBoth,
                                          HandName::kAny};

/// `left`, `right`, `both`, `any`, as commands say it.
std::string_view ToString(HandName hand);
std::optional<HandName> ParseHandName(std::string_view text);

/// One hand: what it holds, and where it wants that to be.
struct Hand {
  physics::BodyId held;            ///< none when the hand is empty
  RigidTransform X_WB_goal;        ///< where the held body B shall be
  Vector3 p_BH = Vector3::Zero();  ///< the point at which the hand took hold of it
  double speed = 0;                ///< at most this fast on the way [m/s]

  bool is_holding() const { return static_cast<bool>(held); }
  bool operator==(const Hand&) const = default;
};

}  // namespace smile::demonstrator
