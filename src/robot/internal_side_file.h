#pragma once

#include <optional>
#include <string>
#include <vector>

#include "robot/internal_gripper_choice.h"
#include "robot/internal_model_builder.h"

namespace smile::robot::internal {

/// Where a part of a gripper hangs.
struct Mounting {
  std::string urdf;    ///< as the side file names it
  std::string prefix;  ///< before the names in it
  std::string to;      ///< the link its root is
  std::string place;   ///< in the side file
};

/// What a URDF cannot say: arms, grippers, head, links that may touch, poses, the pose to start
/// in, and a shipped look. docs/robot.md describes the file. All that is wrong is an
/// InputError naming the place inside the file, as `arms/left/joints`.
class SideFile {
 public:
  /// @param gripper  the wanted one; empty: the usual one.
  SideFile(const FoundFile& file, const std::string& gripper);

  /// The gripper with its choices; empty if there are none to choose from.
  std::string gripper() const { return gripper_ ? gripper_->name : ""; }
  /// Where the robot stands: `gap` or `height`; nullopt if it is not said [m].
  std::optional<double> Place(const std::string& member) const;
  /// The parts of the gripper, for each arm that has a flange.
  std::vector<Mounting> Mountings() const;
  [[noreturn]] void Fail(const std::string& place, const std::string& message) const;

  /// Adds all it says to a robot built with these mountings.
  /// @param has_look  false leaves out the shipped look.
  void Apply(BuiltModel* built, bool has_look) const;

 private:
  std::string file_;
  Json root_;
  std::optional<GripperChoice> gripper_;
};

}  // namespace smile::robot::internal
