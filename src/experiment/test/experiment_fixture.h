#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "base/files.h"
#include "experiment/run.h"
#include "robot/urdf_reader.h"
#include "scene_xml/scene_reader.h"

namespace smile::experiment {

namespace fs = std::filesystem;

/// A directory for each test, and small scenes, scripts and brains in it.
class ExperimentTest : public ::testing::Test {
 protected:
  ExperimentTest() {
    std::string name = (fs::temp_directory_path() / "smile_experiment_XXXXXX").string();
    EXPECT_NE(::mkdtemp(name.data()), nullptr);
    root_ = name;
  }
  ~ExperimentTest() override { fs::remove_all(root_); }

  fs::path Write(const std::string& name, const std::string& text) const {
    const fs::path path = root_ / name;
    MakeDirectories(path.parent_path());
    WriteFile(path, text);
    if (text.starts_with("#!")) fs::permissions(path, fs::perms::owner_all);
    return path;
  }
  std::string Read(const std::string& name) const { return ReadFile(root_ / name, 1 << 20); }
  bool Exists(const std::string& name) const { return fs::exists(root_ / name); }
  int CountLines(const std::string& name) const {
    return Exists(name) ? static_cast<int>(std::ranges::count(Read(name), '\n')) : 0;
  }

  static scene::SceneSpec SceneOf(const std::string& elements) {
    return *scene_xml::ReadSceneText("<tabletop xmlns=\"http://synapse.cs.umd.edu/tabletop-xml\">" +
                                         elements + "</tabletop>",
                                     "test.xml")
                .scene;
  }
  /// Two blocks, `a` and `b`.
  static scene::SceneSpec Pair() {
    return SceneOf(
        "<block id=\"a\" color=\"red\" location=\"(0, -3, 0.5)\"/>"
        "<block id=\"b\" color=\"blue\" location=\"(2, -3, 0.5)\"/>");
  }
  sim::Script ScriptOf(const std::string& lines) const {
    return sim::ReadScript(Write("script.jsonl", lines), scene::kMetersPerUnit);
  }
  /// Puts `a` on `b`.
  sim::Script Stacking() const {
    return ScriptOf(
        "{\"hand\":\"right\",\"do\":\"grasp\",\"object\":\"a\"}\n"
        "{\"hand\":\"right\",\"do\":\"move_to\",\"position\":[0,-3,2.5]}\n"
        "{\"do\":\"wait\",\"until\":\"arrived\"}\n"
        "{\"hand\":\"right\",\"do\":\"move_to\",\"position\":[2,-3,2.5]}\n"
        "{\"do\":\"wait\",\"until\":\"arrived\"}\n"
        "{\"hand\":\"right\",\"do\":\"move_to\",\"position\":[2,-3,1.51]}\n"
        "{\"do\":\"wait\",\"until\":\"arrived\"}\n"
        "{\"hand\":\"right\",\"do\":\"release\"}\n"
        "{\"do\":\"wait\",\"until\":\"still\"}\n");
  }
  /// A demonstration of that, without robot and pictures.
  fs::path RecordStacking() const {
    experiment::Run({.scene = Pair(),
                     .script = Stacking(),
                     .record = root_ / "stacked",
                     .has_pictures = false});
    return root_ / "stacked";
  }

  static sim::RobotPlacement Baxter() {
    static const robot::RobotReading kBaxter = robot::LoadRobot(DataFile("robots/baxter.urdf"));
    return {.model = kBaxter.model, .gripper = kBaxter.gripper, .files = kBaxter.files};
  }
  /// A brain in Python with these lines in its callback.
  fs::path Python(const std::string& lines) const {
    return Write("brain/brain.py", "def step(sensor, motor, aux):\n" + lines);
  }

  fs::path root_;
};

}  // namespace smile::experiment
