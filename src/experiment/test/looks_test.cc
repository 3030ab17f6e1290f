#include "experiment/looks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "experiment/variation.h"
#include "experiment_fixture.h"
#include "math/color.h"
#include "scene_xml/scene_writer.h"

namespace smile::experiment {
namespace {

using scene_xml::WriteScene;

scene::SceneSpec TwoReds() {
  return *scene_xml::ReadSceneText(
              "<tabletop xmlns=\"http://synapse.cs.umd.edu/tabletop-xml\">"
              "<block id=\"a\" color=\"red\" location=\"(0,-3,0.5)\"/>"
              "<composite id=\"b\" location=\"(2,-3,0.5)\"><block color=\"red\" "
              "location=\"(0,0,0)\"/><block color=\"blue\" location=\"(0,0,1)\"/></composite>"
              "<indicatorLights id=\"c\" location=\"(4,0,0.5)\" numLights=\"1\"><state><light "
              "id=\"0\" color=\"green\"/></state></indicatorLights></tabletop>",
              "two.xml")
              .scene;
}

/// All that can be varied, in ranges that leave colors nameable.
LookChoices Moderate() {
  return {.brightness = {0.85, 1},
          .warmth = {-0.1, 0.1},
          .turn_deg = {-180, 180},
          .hue_deg = {-8, 8},
          .value = {0.85, 1},
          .table = {0.7, 1},
          .tint = {0, 0.1},
          .background = {0, 0.1},
          .patterns = {"plain", "stripes", "checks"},
          .cameras = {"eye", "head"},
          .shift = {-0.1, 0.1},
          .tilt_deg = {-1, 1},
          .view = {0.97, 1.03}};
}

TEST(Looks, ChangeNothingByDefault) {
  EXPECT_EQ(DrawLooks({}, ColorsOf(TwoReds()), 5), Looks());
  scene::SceneSpec scene = TwoReds();
  Apply(Looks(), &scene);
  EXPECT_TRUE(scene == TwoReds());
  EXPECT_EQ(ChangesText({}), "");
}

TEST(Looks, AreInTheSceneThatIsWrittenToTheLastBit) {
  std::set<std::string> patterns, texts;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const Looks looks = DrawLooks(Moderate(), ColorsOf(TwoReds()), seed);
    scene::SceneSpec scene = TwoReds();
    Apply(looks, &scene);
    const auto again = scene_xml::ReadSceneText(WriteScene(scene), "two.xml").scene;
    ASSERT_TRUE(again) << WriteScene(scene);
    ASSERT_TRUE(*again == scene) << WriteScene(scene);
    patterns.insert(looks.pattern);
    texts.insert(WriteScene(scene));
    // Recorded, they are the same again.
    EXPECT_EQ(ParseChanges(ChangesText({.looks = looks})).looks, looks);
  }
  EXPECT_EQ(patterns, (std::set<std::string>{"plain", "stripes", "checks"}));
  EXPECT_EQ(texts.size(), 50u);
}

TEST(Looks, OfEqualColorsStayEqualAndLampsKeepTheirs) {
  EXPECT_EQ(ColorsOf(TwoReds()), (std::vector<std::string>{"blue", "red"}));
  const Looks looks = DrawLooks({.hue_deg = {30, 30}, .value = {0.5, 0.5}}, {"blue", "red"}, 1);
  scene::SceneSpec scene = TwoReds();
  Apply(looks, &scene);
  // Red at hue 30 degrees: half of the way to yellow.
  EXPECT_EQ(looks.colors.at("red"), "#804000");
  EXPECT_EQ(looks.colors.at("blue"), "#400080");
  EXPECT_EQ(ColorsOf(scene), (std::vector<std::string>{"#400080", "#804000"}));
  EXPECT_NE(WriteScene(scene).find("color=\"green\""), std::string::npos);
}

TEST(Looks, DependOnTheSeedAndTheirOwnRange) {
  VariationChoices choices{.scenes = {"a"}, .levels = {"edges"}, .eyes = {"eye"}};
  choices.joints = {0, 1};
  choices.looks = {.brightness = {0, 2}};
  const Variation before = DrawVariation(choices, 7);
  choices.looks.turn_deg = {0, 90};
  choices.speed = Range{0.5, 1};
  choices.varies_order = choices.varies_grasp = true;
  choices.disturbance.fraction = 0.5;
  const Variation after = DrawVariation(choices, 7);
  EXPECT_EQ(after.looks.brightness, before.looks.brightness);
  EXPECT_EQ(after.noise, before.noise);
  EXPECT_NE(after.looks.turn_deg, 0);
  EXPECT_NE(after.behavior.order, after.behavior.grasp);
  EXPECT_EQ(after.behavior.path, std::nullopt);
  const Json json = ToJson(after);
  EXPECT_EQ(VariationIn(JsonNode(json, "", "")), after);
  int disturbed = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    disturbed += DrawVariation(choices, seed).disturbance.has_value();
  }
  EXPECT_NEAR(disturbed, 200, 40);
}

TEST(Looks, ThatAreDamagedAreRefusedByName) {
  const auto fault = [](const std::string& text) -> std::string {
    try {
      ParseChanges(text);
    } catch (const std::exception& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(fault("{\"look\":{}}").find("look"), std::string::npos) << fault("{\"look\":{}}");
  EXPECT_NE(fault("{\"looks\":{\"brightness\":9}}").find("looks/brightness"), std::string::npos);
  EXPECT_NE(fault("{").size(), 0u);
}

}  // namespace
}  // namespace smile::experiment
