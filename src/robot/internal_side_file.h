#pragma once

#include <optional>
#include <string>
#include <vector>

#include "robot/internal_gripper_choice.h"
#include "robot/internal_model_builder.h"

namespace smile::robot::internal {

/// Attachment of a part of a gripper.
struct Mounting {
  std::string urdf;    ///< file, as written in the side file
  std::string prefix;  ///< put before its names
  std::string to;      ///< link that its root merges with
  std::string place;   ///< path in the side file, for messages
};

/// Side file of a URDF: arms, grippers, head, links that may touch, poses, the start pose, and a
/// shipped appearance, none of which URDF can express. docs/robot.md describes the file. Each error
/// is an InputError with the path inside the file, such as `arms/left/joints`.
class SideFile {
 public:
  /// Parses a file.
  /// @param gripper  name of the wanted gripper; empty: the default one.
  SideFile(const FoundFile& file, const std::string& gripper);

  /// Returns the gripper with its choices; empty if the file offers none.
  std::string gripper() const { return gripper_ ? gripper_->name : ""; }
  /// Returns the place of the robot [m]: `gap` or `height`; nullopt if it is not specified.
  std::optional<double> Place(const std::string& member) const;
  /// Returns the parts of the gripper for each arm that has a flange.
  std::vector<Mounting> Mountings() const;
  [[noreturn]] void Fail(const std::string& place, const std::string& message) const;

  /// Applies the file to a robot built with these mountings.
  /// @param has_appearance  false leaves out the shipped appearance.
  void Apply(BuiltModel* built, bool has_appearance) const;

 private:
  std::string file_;
  Json root_;
  std::optional<GripperChoice> gripper_;
};

}  // namespace smile::robot::internal
