#include "robot_input.h"

#include <cmath>
#include <filesystem>
#include <optional>

#include "base/diagnostic.h"
#include "mesh/import_mesh.h"

namespace smile::fuzz {
namespace {

constexpr const char* kUrdf = "fuzzed.urdf";
constexpr const char* kSideFile = "fuzzed.robot.json";

std::string SmallStl() {
  return mesh::StlOf({.vertices = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}},
                      .triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}});
}

constexpr const char* kGripper = R"(<robot name="g"><link name="flange"/>
<joint name="slide" type="prismatic"><parent link="flange"/><child link="finger"/>
<limit lower="-0.1" upper="0" velocity="1" effort="1"/></joint>
<link name="finger"><inertial><mass value="1"/>
<inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link></robot>)";

robot::RobotReading ReadFrom(const robot::OpenRobotFile& open, const std::string& gripper) {
  return robot::LoadKeptRobot(kUrdf, gripper, open);
}

bool IsSomewhere(const RigidTransform& X) {
  return X.translation().allFinite() && X.rotation().allFinite();
}

std::string FaultOf(const robot::Gripper& gripper, const robot::RobotModel& model) {
  const auto is_joint = [&](int joint) { return joint >= 0 && joint < model.num_joints(); };
  if (gripper.kind == robot::GripperKind::kSuction) {
    return gripper.cup_radius > 0 && gripper.cup_capacity >= 0 ? "" : "a cup that is none";
  }
  if (!is_joint(gripper.left_finger) || !is_joint(gripper.right_finger)) {
    return "a finger that does not exist";
  }
  if (gripper.kind == robot::GripperKind::kJaws) {
    if (!is_joint(gripper.drive)) return "a drive that does not exist";
    const bool rises = gripper.openings.back() > gripper.openings.front();
    for (std::size_t i = 1; i < gripper.openings.size(); ++i) {
      const double change = gripper.openings[i] - gripper.openings[i - 1];
      if (!(rises ? change > 0 : change < 0)) return "an opening that does not change";
    }
    return std::isfinite(gripper.openings.front()) ? "" : "an opening that is none";
  }
  for (int finger : {gripper.left_finger, gripper.right_finger}) {
    if (model.links[static_cast<std::size_t>(finger)].lower != 0) {
      return "a finger that does not slide from 0 on";
    }
  }
  return std::isfinite(gripper.closed_opening) ? "" : "an opening that is none";
}

std::string FaultOf(const robot::RobotModel& model) {
  const int num_frames = static_cast<int>(model.frames.size());
  const auto is_joint = [&](int joint) { return joint >= 0 && joint < model.num_joints(); };
  for (int i = 0; i < model.num_joints(); ++i) {
    const scene::LinkSpec& link = model.links[static_cast<std::size_t>(i)];
    if (link.parent < -1 || link.parent >= i) return link.name + ": a parent that comes later";
    if (!IsSomewhere(link.X_PJ) || std::abs(link.axis.norm() - 1) > 1e-9) {
      return link.name + ": a joint that is nowhere";
    }
    if (!(link.lower < link.upper) || !(link.max_velocity > 0) || !(link.max_effort > 0)) {
      return link.name + ": a joint that cannot move";
    }
    if (!(link.mass > 0) || !std::isfinite(link.mass) || !link.inertia.allFinite()) {
      return link.name + ": a mass that is none";
    }
    if (link.mimic && (!is_joint(link.mimic->leader) || link.mimic->leader == i ||
                       model.links[static_cast<std::size_t>(link.mimic->leader)].mimic)) {
      return link.name + ": a leader that is none";
    }
    for (const scene::Solid& solid : link.solids) {
      if (!IsSomewhere(solid.X_BS)) return link.name + ": a solid that is nowhere";
    }
  }
  for (const robot::Frame& frame : model.frames) {
    if (!IsSomewhere(frame.X_LF)) return frame.name + ": a frame that is nowhere";
  }
  for (const robot::Arm& arm : model.arms) {
    for (int joint : arm.joints) {
      if (!is_joint(joint)) return arm.name + ": a joint that does not exist";
    }
    if (arm.tool < 0 || arm.tool >= num_frames) return arm.name + ": a tool that does not exist";
    if (!arm.gripper) continue;
    if (std::string fault = FaultOf(*arm.gripper, model); !fault.empty()) {
      return arm.name + ": " + fault;
    }
  }
  if (!robot::IsWithinLimits(model, model.q_start)) return "a start outside the limits";
  for (const robot::NamedPose& pose : model.poses) {
    if (!robot::IsWithinLimits(model, pose.q)) return pose.name + ": a pose outside the limits";
  }
  return {};
}

/// Meshes are different ones each time.
bool AreAlike(const robot::RobotModel& a, const robot::RobotModel& b) {
  return a.links == b.links && a.base_solids == b.base_solids && a.frames == b.frames &&
         a.arms == b.arms && a.never_collide == b.never_collide && a.poses == b.poses &&
         a.q_start == b.q_start && a.visuals.size() == b.visuals.size();
}

}  // namespace

robot::RobotReading ReadHostileRobot(std::string_view text) {
  constexpr std::string_view kSeparator = "\n=====\n";
  const std::size_t end = text.find(kSeparator);
  const auto open = [&](const std::string& name, std::size_t) -> std::optional<std::string> {
    if (name == kUrdf) return std::string(text.substr(0, end));
    if (name == kSideFile) {
      if (end == std::string_view::npos) return std::nullopt;
      return std::string(text.substr(end + kSeparator.size()));
    }
    const std::filesystem::path extension = std::filesystem::path(name).extension();
    if (extension == ".stl") return SmallStl();
    if (extension == ".urdf") return kGripper;
    return std::nullopt;
  };
  return ReadFrom(open, "");
}

std::string FaultWithRobot(std::string_view text) {
  robot::RobotReading reading;
  try {
    reading = ReadHostileRobot(text);
  } catch (const InputError& error) {
    const Diagnostic& found = error.diagnostics().front();
    return found.file.empty() || found.message.empty() ? "refused without a reason" : "";
  }
  if (std::string fault = FaultOf(reading.model); !fault.empty()) return fault;
  const auto kept = [&](const std::string& name, std::size_t) -> std::optional<std::string> {
    for (const robot::RobotFile& file : reading.files) {
      if (file.name == name) return *file.bytes;
    }
    return std::nullopt;
  };
  try {
    if (!AreAlike(ReadFrom(kept, reading.gripper).model, reading.model)) {
      return "from its kept files it reads differently";
    }
  } catch (const InputError& error) {
    return "from its kept files it is refused: " + std::string(error.what());
  }
  return {};
}

}  // namespace smile::fuzz
