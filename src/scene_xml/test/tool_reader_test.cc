#include <gtest/gtest.h>

#include "math/angles.h"
#include "scene_xml/scene_writer.h"
#include "scene_xml/test/scene_text.h"

namespace smile::scene_xml {
namespace {

/// A block with this content.
std::string Tool(const std::string& attributes) {
  return "<block location='(0,0,0)'><tool " + attributes + "/></block>";
}

std::string Guest(const std::string& attributes, const std::string& content) {
  return "<composite location='(0,0,0)'><guestBondPoint type='M4' " + attributes + ">" + content +
         "</guestBondPoint></composite>";
}

std::string FaultOfTool(const std::string& attributes) {
  return FaultOf(SceneText(Tool(attributes)));
}

TEST(ToolReader, ReadsToolsAndThePlacesWhereTheyWork) {
  const std::string places =
      "<accepts tool='phillips' at='(0,0,1)' axis='(0,1,1)'/><accepts tool='hex'/>";
  const scene::SceneSpec scene = MustRead(SceneText(
      Tool("action='cut' at='(0,1,0)' axis='(0,2,0)' edge='1.5' reach='0.3'") +
      Tool("action='drive' type='phillips' at='(0,0,-2)' axis='(0,0,-1)' turn='90' "
           "angle='10'") +
      Guest("cut='yes' by='tool'", places) + "<chain start='(0,0,1)' end='(0,3,1)' cut='no'/>"));
  EXPECT_EQ(scene.objects[0].tool, (scene::ToolSpec{.action = scene::ToolAction::kCut,
                                                    .p_BT = {0, 0.1, 0},
                                                    .axis = {0, 2, 0},
                                                    .edge = 0.15,
                                                    .reach = 0.03}));
  EXPECT_EQ(scene.objects[1].tool, (scene::ToolSpec{.action = scene::ToolAction::kDrive,
                                                    .type = "phillips",
                                                    .p_BT = {0, 0, -0.2},
                                                    .axis = {0, 0, -1},
                                                    .turn = DegreesToRadians(90.0),
                                                    .angle = DegreesToRadians(10.0)}));
  const auto& guest = std::get<scene::Composite>(scene.objects[2].whole.shape).guests.at(0);
  EXPECT_TRUE(guest.can_be_cut);
  EXPECT_TRUE(guest.refuses_hands);
  EXPECT_EQ(guest.accepts,
            (std::vector<scene::ToolPlace>{
                {.type = "phillips", .p_GS = {0, 0, 0.1}, .axis = {0, 1, 1}}, {.type = "hex"}}));
  EXPECT_FALSE(scene.chains[0].can_be_cut);
  EXPECT_TRUE(MustRead(WriteScene(scene)) == scene);
}

TEST(ToolReader, NamesWhatAToolLacks) {
  EXPECT_EQ(
      FaultOfTool("action='cut' at='(0,1,0)' axis='(0,1,0)'"),
      "test.xml:3: <tool>: found no edge, expected edge=\"…\": the length of the blades, from "
      "at along axis");
  EXPECT_EQ(FaultOfTool("action='drive' at='(0,1,0)' axis='(0,1,0)'"),
            "test.xml:3: <tool>: found no type, expected type=\"…\"");
  EXPECT_EQ(FaultOfTool("action='fasten' type='glue' axis='(0,1,0)'"),
            "test.xml:3: <tool>: found no at, expected at=\"(x,y,z)\"");
  EXPECT_EQ(FaultOfTool("action='cutt' at='(0,1,0)' axis='(0,1,0)'"),
            "test.xml:3: <tool>: found action=\"cutt\", expected cut, drive, fasten or loosen; did "
            "you mean \"cut\"?");
}

TEST(ToolReader, RefusesAttributesThatMeanNothing) {
  EXPECT_EQ(FaultOfTool("action='drive' type='hex' at='(0,1,0)' axis='(0,1,0)' edge='1'"),
            "test.xml:3: <tool>: found edge=\"1\", expected edge only with action=\"cut\"");
  EXPECT_EQ(FaultOf(SceneText(Guest("by='tool'", ""))),
            "test.xml:3: <guestBondPoint>: found by=\"tool\", expected an accepts element inside: "
            "otherwise nothing can turn it");
  EXPECT_EQ(FaultOf(SceneText("<block location='(0,0,0)'><tool action='fasten' type='a' "
                              "at='(0,0,0)' axis='(0,0,1)'/><tool action='fasten' type='a' "
                              "at='(0,0,0)' axis='(0,0,1)'/></block>")),
            "test.xml:3: <tool>: found a second tool, expected one in an object");
}

TEST(ToolReader, RefusesAScrewWithoutStagesAtItsHole) {
  EXPECT_EQ(FaultOf(SceneText("<composite location='(0,0,0)'>"
                              "<hostBondPoint id='H' type='M4'/></composite>")),
            "test.xml:3: <hostBondPoint id=\"H\">: found 0 tightness elements, expected 1 to 256");
  // A guest in it has no finding of its own.
  EXPECT_EQ(FaultOf(SceneText("<composite location='(0,0,0)'><hostBondPoint id='H' type='M4'/>"
                              "</composite><composite location='(0,0,2)'><guestBondPoint "
                              "type='M4' initBondHostId='H' initBondTightness='1'/></composite>")),
            "test.xml:3: <hostBondPoint id=\"H\">: found 0 tightness elements, expected 1 to 256");
}

}  // namespace
}  // namespace smile::scene_xml
