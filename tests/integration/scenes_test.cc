// What docs/scenes.md says of the scenes we ship, done by scripts. What their scripts in examples/
// do, examples_test.cc claims.

#include <algorithm>
#include <cmath>
#include <vector>

#include "program.h"

namespace smile {
namespace {

/// Slowly, so that what is dragged does not slide on.
std::string MoveTo(double x, double y, double z) {
  return "{\"hand\":\"right\",\"do\":\"move_to\",\"position\":" + Json({x, y, z}).dump() +
         ",\"speed\":1.5}\n{\"do\":\"wait\",\"until\":\"arrived\"}\n";
}
std::string Grasp(const std::string& object) {
  return "{\"hand\":\"right\",\"do\":\"grasp\",\"object\":\"" + object + "\"}\n";
}
std::string Do(const std::string& what, const std::string& object) {
  const std::string key = what == "trigger" ? "control" : "object";
  return "{\"hand\":\"right\",\"do\":\"" + what + "\",\"" + key + "\":\"" + object + "\"}\n";
}
std::string Wait(double seconds) {
  return "{\"do\":\"wait\",\"seconds\":" + Json(seconds).dump() + "}\n";
}
std::string Times(int count, const std::string& lines) {
  std::string all;
  for (int i = 0; i < count; ++i) all += lines;
  return all;
}

class Scenes : public ProgramTest {
 protected:
  Answer Play(const std::string& scene, const std::string& script) const {
    Write("script.jsonl", script + Wait(0.1));
    return Smile("run '" + Shipped("scenes/" + scene + ".xml") +
                 "' --commands script.jsonl --no-robot --json");
  }
  /// What there is at the end of a script; empty, with a failure, when it fails.
  Json After(const std::string& scene, const std::string& script) const {
    const Answer answer = Play(scene, script);
    EXPECT_EQ(answer.exit_code, 0) << answer.err;
    return answer.exit_code == 0 ? answer.json() : Json();
  }
  static double At(const Json& json, const std::string& object, int axis) {
    return json.at("objects").at(object).at("position").at(axis).get<double>();
  }
};

TEST_F(Scenes, StayOnTheTable) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(Shipped("scenes"))) {
    if (entry.path().extension() == ".xml") files.push_back(entry.path());
  }
  ASSERT_GT(files.size(), 20u);
  for (const auto& file : files) {
    const Answer answer = Smile("run '" + file.string() + "' --seconds 2 --no-robot --json");
    ASSERT_EQ(answer.exit_code, 0) << answer.err;
    const Json objects = answer.json()["objects"];
    EXPECT_FALSE(objects.empty()) << file;
    for (const auto& [id, object] : objects.items()) {
      const Json& p = object["position"];
      const bool is_on_table = std::abs(p[0].get<double>()) <= 10 &&
                               std::abs(p[1].get<double>()) <= 6 && p[2].get<double>() >= 0 &&
                               p[2].get<double>() < 8;
      EXPECT_TRUE(is_on_table) << file << " " << id << " " << p.dump();
    }
  }
}

TEST_F(Scenes, TheLidTakesTheBoxAlongAtItsLimits) {
  // The lid is 2.2 open; the box stands at x = 1.
  const std::string open = Grasp("ChestLid") + MoveTo(-3.7, -0.5, 2.125);
  const Json opened = After("lidbox", open);
  EXPECT_NEAR(At(opened, "ChestLid", 0), -3.7, 0.02);
  EXPECT_NEAR(At(opened, "Chest", 0), 1, 0.02);
  const std::string pull = open + MoveTo(-5.75, -0.5, 2.125);
  EXPECT_NEAR(At(After("lidbox", pull), "Chest", 0), -1, 0.05);
  EXPECT_NEAR(At(After("lidbox", pull + MoveTo(0.5, -0.5, 2.125)), "Chest", 0), 0.5, 0.05);
}

TEST_F(Scenes, LiftingTheLidLiftsTheBox) {
  const Json lifted = After(
      "lidbox", Grasp("ChestLid") + MoveTo(1, -0.5, 2.125) + MoveTo(1, -0.5, 5.125) + Wait(1));
  EXPECT_NEAR(At(lifted, "Chest", 2), 4, 0.1);
}

TEST_F(Scenes, TheTrapDoorHoldsItsBlocksWhileItIsShut) {
  const Json shut = After("trapdoor", Wait(2));
  for (const char* block : {"Rust", "Sky", "Moss"}) EXPECT_NEAR(At(shut, block, 2), 3.8, 0.02);
}

TEST_F(Scenes, TheWeightHangsOnItsString) {
  EXPECT_GT(At(After("strings", Wait(2)), "Weight", 2), 1.5);
}

TEST_F(Scenes, TheDrawerMovesTheCaseOnlyAtItsLimit) {
  const std::string shut = Grasp("DockDrawer") + MoveTo(-5.9, 3.3, 0.5);
  const std::string open = shut + MoveTo(-5.9, -1.1, 0.5);
  EXPECT_NEAR(At(After("dock", shut), "DockCase", 1), 3.4, 0.02);
  const Json opened = After("dock", open);
  EXPECT_NEAR(At(opened, "DockCase", 1), 3.4, 0.02);
  EXPECT_NEAR(At(opened, "DockDrawer", 1), -1.1, 0.02);
  EXPECT_NEAR(At(opened, "Drive1", 1), -0.5, 0.2) << "drives ride in their slots";
  EXPECT_NEAR(At(After("dock", open + MoveTo(-5.9, -2.2, 0.5)), "DockCase", 1), 2.4, 0.05);
}

TEST_F(Scenes, ALampKeepsItsStateWhenItHasNoneOfThatNumber) {
  const char* const expected[][2] = {
      {"halt", "dark"}, {"ready", "blue"}, {"drive", "blue"}, {"halt", "dark"}};
  for (int presses = 0; presses < 4; ++presses) {
    const Json controls = After("controls", Times(presses, Do("trigger", "Switch")))["controls"];
    EXPECT_EQ(controls["Signal"], expected[presses][0]) << presses;
    EXPECT_EQ(controls["Lamp"], expected[presses][1]) << presses;
  }
}

TEST_F(Scenes, TheKnobTurnsTheDialAndTheDialTheDigit) {
  const std::string press = Do("trigger", "Knob");
  EXPECT_EQ(After("dial", Times(7, press))["controls"],
            Json({{"Knob", "seven"}, {"Dial", "seven"}, {"Digit", "seven"}}));
  EXPECT_EQ(After("dial", Times(10, press))["controls"]["Digit"], "zero");
  EXPECT_EQ(After("dial", Times(3, press) + Do("trigger", "Dial"))["controls"],
            Json({{"Knob", "three"}, {"Dial", "zero"}, {"Digit", "zero"}}));
}

TEST_F(Scenes, AScrewStandsAtThePoseOfItsStage) {
  const std::string tighter = Do("fasten", "BrassScrew");
  for (int stage = 1; stage <= 3; ++stage) {
    const Json json = After("screws", Times(stage - 1, tighter) + Wait(0.5));
    EXPECT_NEAR(At(json, "BrassScrew", 2), 2.6 - 0.4 * stage, 0.005);
    EXPECT_NEAR(json["objects"]["BrassScrew"]["rotation"][2].get<double>(), -45 * stage, 0.1);
  }
  EXPECT_EQ(Play("screws", Times(3, tighter)).exit_code, 1) << "there is no stage 4";
  // Loose, it drops back into the hole and carries no nut.
  const Json loose = After(
      "screws", Do("loosen", "BrassScrew") + Grasp("BrassScrew") + MoveTo(-4.5, -2, 5) + Wait(0.5));
  EXPECT_NEAR(At(loose, "Nut", 2), 0.6, 0.01);
}

TEST_F(Scenes, ValvesSetOverrideAndLock) {
  const auto gauge = [&](const std::string& script) {
    return After("valve", script)["controls"]["Gauge"];
  };
  const std::string red = Do("fasten", "Red"), blue = Do("fasten", "Blue");
  EXPECT_EQ(gauge(""), "low");
  EXPECT_EQ(gauge(red), "normal");
  EXPECT_EQ(gauge(red + blue), "bypassed");
  EXPECT_EQ(gauge(red + blue + red), "bypassed");
  EXPECT_EQ(gauge(red + blue + red + Do("loosen", "Blue")), "high");
  const std::string lock = Do("fasten", "Green");
  EXPECT_EQ(Play("valve", lock + red).exit_code, 1);
  EXPECT_EQ(Play("valve", lock + Do("loosen", "Red")).exit_code, 1);
  EXPECT_EQ(gauge(lock + Do("loosen", "Green") + red), "normal");
}

}  // namespace
}  // namespace smile
