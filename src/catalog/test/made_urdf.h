#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "base/diagnostic.h"
#include "base/files.h"
#include "catalog/robot_guess.h"
#include "robot/urdf_reader.h"

namespace smile::catalog {

/// Text of a link with a mass and a box of this size, which stands on its origin.
inline std::string LinkText(const std::string& name, const std::string& size = "0.04 0.04 0.1",
                            const std::string& at = "0 0 0.07") {
  return "<link name=\"" + name +
         R"("><inertial><mass value="1"/><inertia ixx="0.01" iyy="0.01" izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial>)" +
         "<collision><origin xyz=\"" + at + "\"/><geometry><box size=\"" + size +
         "\"/></geometry></collision></link>\n";
}

/// Text of a joint.
/// @param more  of limits and mimics.
inline std::string JointText(const std::string& name, const std::string& type,
                             const std::string& parent, const std::string& child,
                             const std::string& xyz, const std::string& axis,
                             const std::string& range = R"(lower="-2" upper="2")",
                             const std::string& more = "") {
  return "<joint name=\"" + name + "\" type=\"" + type + "\"><parent link=\"" + parent +
         "\"/><child link=\"" + child + "\"/><origin xyz=\"" + xyz + "\"/><axis xyz=\"" + axis +
         "\"/><limit " + range + " velocity=\"2\" effort=\"50\"/>" + more + "</joint>\n";
}

/// Text of a chain of joints, NAME1 to NAMEn with links of the same names, that turn about z, y, y,
/// y, z, y and so on, 0.14 m apart.
inline std::string ChainText(const std::string& name, int count, const std::string& parent = "base",
                             const std::string& xyz = "0 0 0.1") {
  std::string text;
  for (int i = 1; i <= count; ++i) {
    const std::string link = name + std::to_string(i);
    text +=
        LinkText(link) + JointText(link, "revolute", i == 1 ? parent : name + std::to_string(i - 1),
                                   link, i == 1 ? xyz : "0 0 0.14", i % 4 == 1 ? "0 0 1" : "0 1 0");
  }
  return text;
}

/// Text of a robot on a foot.
inline std::string RobotText(const std::string& parts) {
  return "<robot name=\"made\">\n<link name=\"base\"><collision><origin xyz=\"0 0 "
         "0.03\"/><geometry>"
         "<box size=\"0.1 0.1 0.06\"/></geometry></collision></link>\n" +
         parts + "</robot>\n";
}

/// Folder per test, removed afterwards, for robots; also that of the user's data.
class MadeRobots : public testing::Test {
 protected:
  MadeRobots() {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(testing::TempDir()) /
              (std::string("smile_catalog_") + test->test_suite_name() + "_" + test->name());
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
    setenv("XDG_DATA_HOME", (folder_ / "data").c_str(), 1);
  }
  ~MadeRobots() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path WriteUrdf(const std::string& parts) {
    WriteFile(folder_ / "r.urdf", RobotText(parts));
    return folder_ / "r.urdf";
  }
  RobotGuess Guess(const std::string& parts) { return GuessRobot(WriteUrdf(parts), {}); }
  /// Returns the robot with the side file that was made for it.
  robot::RobotModel Read(const RobotGuess& guess) const {
    return robot::ReadRobot(folder_ / "r.urdf", {.side_file_text = guess.side_file});
  }
  /// Returns the message of the refusal without the folder's name.
  std::string Complaint(const std::string& parts) {
    try {
      Guess(parts);
    } catch (const InputError& error) {
      std::string message = error.what();
      const std::string start = folder_.string() + "/";
      return message.starts_with(start) ? message.substr(start.size()) : message;
    }
    return "";
  }

  std::filesystem::path folder_;
};

}  // namespace smile::catalog
