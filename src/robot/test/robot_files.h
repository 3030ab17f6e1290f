#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "base/diagnostic.h"
#include "base/files.h"
#include "robot/urdf_reader.h"

namespace smile::robot {

/// Folder per test, removed afterwards, in which robots are written and read.
class RobotFiles : public testing::Test {
 protected:
  RobotFiles() {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(testing::TempDir()) /
              (std::string("smile_robot_") + test->test_suite_name() + "_" + test->name());
    std::filesystem::create_directories(folder_);
  }
  ~RobotFiles() override { std::filesystem::remove_all(folder_); }

  RobotModel Read(const std::string& urdf, const std::string& side_file = "") {
    WriteFile(folder_ / "r.urdf", urdf);
    if (!side_file.empty()) WriteFile(folder_ / "r.robot.json", side_file);
    return ReadRobot(folder_ / "r.urdf");
  }

  /// Returns the reader's message without the folder's name; empty if it succeeds.
  std::string Complaint(const std::string& urdf, const std::string& side_file = "") {
    try {
      Read(urdf, side_file);
    } catch (const InputError& error) {
      std::string message = error.what();
      const std::string folder = folder_.string() + "/";
      if (message.starts_with(folder)) message.erase(0, folder.size());
      return message;
    }
    return "";
  }

  std::filesystem::path folder_;
};

/// Robot of a base and an arm with one revolute and one prismatic joint; each piece can be replaced
/// by a broken one.
struct SmallRobot {
  std::string inertial = R"(<inertial><mass value="2"/>
      <inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>)";
  std::string shape = R"(<geometry><box size="1 2 3"/></geometry>)";
  std::string limit = R"(<limit lower="-1" upper="2" velocity="3" effort="4"/>)";
  std::string type = "revolute";
  std::string axis = R"(<axis xyz="0 0 2"/>)";
  std::string extra;

  /// `shape` stands on line 5, the joint `turn` on line 7.
  std::string Text() const {
    return R"(<?xml version="1.0"?>
<robot name="small">
  <link name="base"/>
  <link name="arm">)" +
           OnOneLine(inertial) + R"(
    <collision>)" +
           shape + R"(</collision>
  </link>
  <joint name="turn" type=")" +
           type + R"("><parent link="base"/><child link="arm"/>
    <origin xyz="0 0 1"/>)" +
           axis + limit + R"(
  </joint>)" +
           extra + R"(
</robot>
)";
  }

 private:
  static std::string OnOneLine(std::string text) {
    for (char& letter : text) {
      if (letter == '\n') letter = ' ';
    }
    return text;
  }
};

}  // namespace smile::robot
