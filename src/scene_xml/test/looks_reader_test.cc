// Table, light and displaced cameras: what changes pictures and no physics.

#include <gtest/gtest.h>

#include "math/angles.h"
#include "scene_xml/scene_writer.h"
#include "scene_xml/test/scene_text.h"

namespace smile::scene_xml {
namespace {

std::string Table(const std::string& attributes) {
  return "<tabletop xmlns=\"http://synapse.cs.umd.edu/tabletop-xml\" " + attributes + "/>";
}

TEST(Looks, AreThoseOfTheFile) {
  const scene::TableSpec table =
      MustRead(Table("color='#e0d0c0' pattern='checks' patternColor='gray' patternSpan='2'")).table;
  EXPECT_EQ(table.color, (Color{224 / 255.0, 208 / 255.0, 192 / 255.0}));
  EXPECT_EQ(table.pattern, scene::TablePattern::kChecks);
  EXPECT_EQ(table.pattern_color, (Color{0.5, 0.5, 0.5}));
  EXPECT_EQ(table.pattern_span, 0.2);
  const scene::SceneSpec scene = MustRead(SceneText(
      "<lighting brightness='0.8' color='yellow' turn='90' background='black'/>"
      "<cameraOffset camera='eye' location='(0.1,0,0)' rotation='(0,0,90)' fovScale='1.1'/>"));
  EXPECT_EQ(scene.lighting, (scene::Lighting{.brightness = 0.8,
                                             .color = {1, 1, 0},
                                             .turn = DegreesToRadians(90.0),
                                             .background = Color{0, 0, 0}}));
  ASSERT_EQ(scene.camera_offsets.size(), 1u);
  EXPECT_EQ(scene.camera_offsets[0].camera, "eye");
  EXPECT_EQ(scene.camera_offsets[0].X_CD.translation(), Vector3(0.01, 0, 0));
  EXPECT_EQ(scene.camera_offsets[0].view_angle_scale, 1.1);
}

TEST(Looks, OfUsualScenesAreNotWritten) {
  const std::string text = WriteScene(MustRead(Table("xspan='20'")));
  for (const char* word : {"color", "pattern", "lighting", "cameraOffset"}) {
    EXPECT_EQ(text.find(word), std::string::npos) << text;
  }
}

TEST(LookFaults, NameWhatDoesNotFit) {
  EXPECT_EQ(FaultOf(Table("patternSpan='2'")),
            "test.xml:1: <tabletop>: found patternSpan=\"2\", expected patternSpan only with "
            "pattern=\"stripes\" or \"checks\"");
  EXPECT_EQ(FaultOf(Table("pattern='dots'")),
            "test.xml:1: <tabletop>: found pattern=\"dots\", expected plain, stripes or checks");
  EXPECT_EQ(FaultOf(SceneText("<lighting background='blac'/>")),
            "test.xml:3: <lighting>: found background=\"blac\", expected #RRGGBB, black, blue, "
            "brown, cyan, darkgray, gray, green, lightgray, magenta, orange, pink, red, white or "
            "yellow; did you mean \"black\"?");
  EXPECT_EQ(FaultOf(SceneText("<lighting/><lighting brightness='2'/>")),
            "test.xml:3: <lighting>: found a second lighting, expected one");
  EXPECT_EQ(FaultOf(SceneText("<cameraOffset camera='eye' fovScale='3'/>")),
            "test.xml:3: <cameraOffset>: found fovScale=\"3\", expected a number from 0.5 to 2");
  EXPECT_EQ(FaultOf(SceneText("<cameraOffset camera='eye'/><cameraOffset camera='eye'/>")),
            "test.xml:3: <cameraOffset>: found camera=\"eye\", expected one that no other offset "
            "displaces");
}

}  // namespace
}  // namespace smile::scene_xml
