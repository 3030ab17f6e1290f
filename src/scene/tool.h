#pragma once

#include <array>
#include <numbers>
#include <string>
#include <string_view>

#include "math/angles.h"
#include "math/rigid_transform.h"

namespace smile::scene {

/// Effect of a tool on what its working point is at.
enum class ToolAction {
  kCut,     ///< parts a chain, a bond, or a part of a control at its blades
  kDrive,   ///< turned about its axis, it tightens or loosens a bond by one stage
  kFasten,  ///< tightens a bond by one stage
  kLoosen,  ///< loosens a bond by one stage
};
/// Names of the actions in scene files.
inline constexpr std::array<std::string_view, 4> kToolActions{"cut", "drive", "fasten", "loosen"};

/// Working point of an object that is a tool. All actions are decided at once, by place and axis.
struct ToolSpec {
  ToolAction action = ToolAction::kCut;
  std::string type;                       ///< fits places of this type; empty for kCut
  Vector3 p_BT = Vector3::Zero();         ///< working point, in the object's frame B [m]
  Vector3 axis{0, 0, -1};                 ///< from it towards the work, in B; of any length
  double edge = 0;                        ///< kCut: length of the blades along the axis [m]
  double turn = 2 * std::numbers::pi;     ///< kDrive: rotation for one stage [rad]
  double reach = 0.02;                    ///< greatest distance from the work [m]
  double angle = DegreesToRadians(15.0);  ///< greatest angle between both axes [rad]

  bool operator==(const ToolSpec&) const = default;
};

/// Place of a guest point at which tools of a type work on its bond, such as the head of a screw.
struct ToolPlace {
  std::string type;
  Vector3 p_GS = Vector3::Zero();  ///< in the frame of the guest point G [m]
  Vector3 axis{0, 0, 1};           ///< from it towards the tool, in G; of any length

  bool operator==(const ToolPlace&) const = default;
};

}  // namespace smile::scene
