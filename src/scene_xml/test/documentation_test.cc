#include <gtest/gtest.h>

#include "base/files.h"
#include "scene_xml/test/scene_text.h"

namespace smile::scene_xml {
namespace {

/// The blocks of code in docs/scene-format.md that begin with ``` and `kind`.
std::vector<std::string> ExamplesOf(const std::string& kind) {
  const std::string page = ReadFile(DataFile("docs/scene-format.md"), 1 << 20);
  const std::string begin_mark = "\n```" + kind + "\n";
  std::vector<std::string> examples;
  for (std::size_t at = 0; (at = page.find(begin_mark, at)) != std::string::npos;) {
    at += begin_mark.size();
    const std::size_t end = page.find("\n```", at);
    if (end == std::string::npos) break;
    examples.push_back(page.substr(at, end + 1 - at));
    at = end + 4;
  }
  return examples;
}

std::string ShippedScene(const std::string& name) {
  return ReadFile(DataFile("scenes/" + name), 1 << 20);
}

TEST(SceneFormatPage, ShowsTheTowerAsItShips) {
  EXPECT_EQ(ExamplesOf("xml")[0], ShippedScene("tower.xml"));
}

TEST(SceneFormatPage, ShowsTheMalletAsItShips) {
  const scene::ObjectSpec shown = MustReadObject(ExamplesOf("xml")[1]);
  bool is_shipped = false;
  for (const scene::ObjectSpec& object : MustRead(ShippedScene("shapes.xml")).objects) {
    is_shipped |= object == shown;
  }
  EXPECT_TRUE(is_shipped);
}

TEST(SceneFormatPage, ShowsOnlyScenesThatWork) {
  EXPECT_GE(ExamplesOf("xml").size(), 8u);
  for (const std::string& example : ExamplesOf("xml")) {
    const bool is_whole = example.find("<tabletop") != std::string::npos;
    EXPECT_GE(MustRead(is_whole ? example : SceneText(example)).objects.size(), 1u) << example;
  }
}

TEST(SceneFormatPage, ShowsATemplateThatWorks) {
  std::string shown;
  for (const std::string& example : ExamplesOf("xml")) {
    if (example.starts_with("<def")) shown = example;
  }
  const scene::SceneSpec scene = MustRead(SceneText(shown));
  ASSERT_EQ(scene.objects.size(), 2u);
  EXPECT_EQ(scene.objects[1].id(), "Step2");
  EXPECT_EQ(scene.objects[1].whole.color, (Color{1, 0, 0}));
  EXPECT_EQ(scene.objects[1].pose_in_world().translation().z(), 0.025);
}

TEST(SceneFormatPage, ShowsErrorsAsTheyAre) {
  const SceneReading reading =
      ReadSceneText(SceneText("<blok id='B1' location='(0,0,0)'/>\n<block id='B2'/>\n"
                              "<block id='B3' location='(0,0,0)' mass='-1'/>"),
                    "table.xml");
  std::string said;
  for (const Diagnostic& diagnostic : reading.diagnostics) said += ToString(diagnostic) + "\n";
  EXPECT_EQ(ExamplesOf("text").at(0), said);
}

}  // namespace
}  // namespace smile::scene_xml
