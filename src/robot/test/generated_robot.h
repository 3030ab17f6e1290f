#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/wording.h"
#include "robot/urdf_reader.h"

namespace smile::robot {

/// Arm of a generated robot.
struct GeneratedArm {
  std::string name;
  int num_joints = 6;  ///< 1 to 7
  bool has_gripper = true;
};

/// Text of a robot with arms side by side, all of their links upright at 0: a turn about z, then
/// bends about y with rolls about z, as many as there are joints. An arm of four or five joints has
/// three bends in one plane, so it reaches each direction of the tool in that plane only.
class GeneratedRobot {
 public:
  explicit GeneratedRobot(std::vector<GeneratedArm> arms) : arms_(std::move(arms)) {}

  std::string Urdf() const {
    std::string text =
        "<robot name=\"generated\">\n<link name=\"base\">" + Shape(0.1, 0.05) + "</link>\n";
    for (std::size_t k = 0; k < arms_.size(); ++k) text += ArmText(k);
    return text + "</robot>\n";
  }

  std::string SideFile() const {
    std::string arms, start;
    for (const GeneratedArm& arm : arms_) {
      std::string joints, angles;
      for (int i = 0; i < arm.num_joints; ++i) {
        joints += (i > 0 ? ", \"" : "\"") + arm.name + "_j" + std::to_string(i) + "\"";
        // The first bend forward and the others back, so that no joint is at a limit.
        angles += (i > 0 ? ", " : "") + NumberText(IsBend(arm, i) ? 0.5 : 0.0);
      }
      arms += (arms.empty() ? "\"" : ",\n  \"") + arm.name + "\": {\"joints\": [" + joints +
              "], \"tool\": \"" + arm.name + "_tool\"" +
              (arm.has_gripper
                   ? ", \"fingers\": [\"" + arm.name + "_finger_l\", \"" + arm.name + "_finger_r\"]"
                   : "") +
              "}";
      start += (start.empty() ? "\"" : ", \"") + arm.name + "\": [" + angles + "]";
    }
    return "{\"format\": 1,\n \"arms\": {\n  " + arms + "},\n \"poses\": {\"bent\": {" + start +
           "}}, \"start\": \"bent\"}\n";
  }

  RobotModel Model() const {
    const std::string urdf = Urdf(), side_file = SideFile();
    return LoadKeptRobot("generated.urdf", "",
                         [&](const std::string& name, std::size_t) -> std::optional<std::string> {
                           if (name == "generated.urdf") return urdf;
                           if (name == "generated.robot.json") return side_file;
                           return std::nullopt;
                         })
        .model;
  }

 private:
  static constexpr const char* kAxes[] = {"",     "z",     "zy",     "zyy",
                                          "zyyy", "zyyyz", "zyyzyz", "zyzyzyz"};

  static bool IsBend(const GeneratedArm& arm, int joint) {
    return kAxes[arm.num_joints][joint] == 'y';
  }
  /// A cylinder along z with its lower end at 0.01.
  static std::string Shape(double length, double radius) {
    return "<collision><origin xyz=\"0 0 " + NumberText(0.01 + length / 2) +
           "\"/><geometry><cylinder radius=\"" + NumberText(radius) + "\" length=\"" +
           NumberText(length) + "\"/></geometry></collision>";
  }
  static std::string Inertial() {
    return "<inertial><origin xyz=\"0 0 0.05\"/><mass value=\"1\"/><inertia ixx=\"0.01\" "
           "iyy=\"0.01\" izz=\"0.01\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial>";
  }
  static std::string Joint(const std::string& name, const std::string& type,
                           const std::string& parent, const std::string& child,
                           const std::string& xyz, const std::string& rest) {
    return "<joint name=\"" + name + "\" type=\"" + type + "\"><parent link=\"" + parent +
           "\"/><child link=\"" + child + "\"/><origin xyz=\"" + xyz + "\"/>" + rest + "</joint>\n";
  }

  std::string ArmText(std::size_t index) const {
    const GeneratedArm& arm = arms_[index];
    const double y =
        0.4 * ((static_cast<double>(arms_.size()) - 1) / 2 - static_cast<double>(index));
    std::string text, parent = "base", xyz = "0 " + NumberText(y) + " 0.1";
    int num_bends = 0;
    for (int i = 0; i < arm.num_joints; ++i) {
      const std::string joint = arm.name + "_j" + std::to_string(i);
      const bool is_bend = IsBend(arm, i);
      // Upper arm and forearm are longer than the rest.
      const double length = is_bend && ++num_bends <= 2 ? 0.35 : 0.1;
      text += Joint(joint, "revolute", parent, joint + "_link", xyz,
                    std::string("<axis xyz=\"") + (is_bend ? "0 1 0" : "0 0 1") +
                        "\"/><limit lower=\"-2.8\" upper=\"2.8\" velocity=\"2\" effort=\"200\"/>");
      text += "<link name=\"" + joint + "_link\">" + Inertial() + Shape(length - 0.05, 0.02) +
              "</link>\n";
      parent = joint + "_link";
      xyz = "0 0 " + NumberText(length);
    }
    text += Joint(arm.name + "_mount", "fixed", parent, arm.name + "_tool", xyz, "") +
            "<link name=\"" + arm.name + "_tool\"/>\n";
    if (!arm.has_gripper) return text;
    for (const char side : {'l', 'r'}) {
      const std::string finger = arm.name + "_finger_" + side;
      text += Joint(finger, "prismatic", parent, finger + "_link", xyz,
                    std::string("<axis xyz=\"0 ") + (side == 'l' ? "1" : "-1") +
                        " 0\"/><limit lower=\"0\" upper=\"0.05\" velocity=\"0.2\" effort=\"50\"/>");
      text += "<link name=\"" + finger + "_link\">" + Inertial() + "<collision><origin xyz=\"0 " +
              (side == 'l' ? "0.005" : "-0.005") +
              " 0\"/><geometry><box size=\"0.02 0.01 0.04\"/></geometry></collision></link>\n";
    }
    return text;
  }

  std::vector<GeneratedArm> arms_;
};

/// Three arms of four, six and seven joints; the one in the middle has no gripper.
inline GeneratedRobot ThreeArms() {
  return GeneratedRobot({{"front", 4}, {"middle", 6, /*has_gripper=*/false}, {"rear", 7}});
}

}  // namespace smile::robot
