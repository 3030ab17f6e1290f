#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "base/files.h"
#include "recorder/recorder.h"
#include "recording/recording.h"
#include "robot/urdf_reader.h"
#include "scene_xml/scene_reader.h"
#include "sim/script.h"

namespace smile::recorder {

/// Makes recordings in the test's own directory.
class RecordingFixture : public ::testing::Test {
 protected:
  RecordingFixture() {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    std::string name = test->name();  // of one of several parameters: with a slash
    std::ranges::replace(name, '/', '_');
    root_ = std::filesystem::temp_directory_path() /
            ("smile_record_" + std::to_string(getpid()) + "_" + name);
    std::filesystem::create_directories(root_);
  }
  ~RecordingFixture() override { std::filesystem::remove_all(root_); }

  static constexpr const char* kScene =
      R"xml(<tabletop xmlns="http://synapse.cs.umd.edu/tabletop-xml">
  <block id="a" color="red" location="(0, -2, 0.5)"><description name="color" value="red"/></block>
  <block id="b" color="blue" location="(3, -2, 0.5)" rotation="(0, 0, 30)">
    <description name="label" value="tall, blue"/></block>
</tabletop>)xml";

  static constexpr const char* kStackAOnB =
      R"({"hand":"left","do":"grasp","object":"a"}
{"hand":"left","do":"move_to","position":[0,-2,3]}
{"do":"wait","until":"arrived"}
{"hand":"left","do":"move_to","position":[3,-2,3]}
{"do":"wait","until":"arrived"}
{"hand":"left","do":"move_to","position":[3,-2,1.51]}
{"do":"wait","until":"arrived"}
{"hand":"left","do":"release"}
{"do":"wait","seconds":2})";

  static std::unique_ptr<sim::Simulation> MakeSimulation(bool with_robot, const char* xml = kScene,
                                                         const model::RobotBodyOptions& body = {}) {
    auto scene = scene_xml::ReadSceneText(xml, "pair.xml").scene;
    if (!with_robot) return std::make_unique<sim::Simulation>(*scene);
    robot::RobotReading robot = robot::LoadRobot(DataFile("robots/baxter.urdf"));
    return std::make_unique<sim::Simulation>(
        *scene, sim::RobotPlacement{.model = std::move(robot.model),
                                    .gripper = std::move(robot.gripper),
                                    .files = std::move(robot.files),
                                    .body = body});
  }

  /// Plays the script to its end in front of a recorder; returns the recording's directory.
  std::filesystem::path Record(const char* script = kStackAOnB, bool with_robot = false,
                               sim::Eye* eye = nullptr, const char* xml = kScene,
                               const RecorderOptions& options = {}) {
    const auto directory = root_ / "demo";
    auto simulation = MakeSimulation(with_robot, xml);
    Recorder recorder(directory, options, eye, *simulation);
    simulation->AddListener(&recorder);
    sim::ScriptPlayer player(sim::ParseScript(script, "script", 0.1));
    for (player.Advance(simulation.get()); !player.is_finished();
         player.Advance(simulation.get())) {
      simulation->Tick();
    }
    final_hash_ = simulation->state_hash();
    return directory;
  }

  static std::vector<std::string> Lines(const std::filesystem::path& path) {
    std::istringstream text(ReadFile(path, 1 << 20));
    std::vector<std::string> lines;
    for (std::string line; std::getline(text, line);) lines.push_back(line);
    return lines;
  }

  std::filesystem::path root_;
  std::uint64_t final_hash_ = 0;
};

}  // namespace smile::recorder
