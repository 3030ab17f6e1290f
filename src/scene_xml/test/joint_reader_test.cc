#include <gtest/gtest.h>

#include "scene_xml/scene_writer.h"
#include "scene_xml/test/scene_text.h"

namespace smile::scene_xml {
namespace {

const std::string kTwoBlocks = "<block location='(0,0,0)'/><block location='(0,0,1)'/>";

std::string Slider(const std::string& attributes, const std::string& content = kTwoBlocks) {
  return SceneText("<sliderJoint location='(1,2,3)' " + attributes + ">" + content +
                   "</sliderJoint>");
}

std::string Chain(const std::string& attributes) {
  return SceneText("<chain " + attributes + "/>");
}

TEST(SliderReader, PutsItsMembersWhereTheyStart) {
  const scene::SceneSpec scene =
      MustRead(Slider("id='rail' rotation='(0,0,90)' max='4' init='3' damping='1'"));
  ASSERT_EQ(scene.objects.size(), 2u);
  ASSERT_EQ(scene.sliders.size(), 1u);
  const scene::SliderSpec& slider = scene.sliders[0];
  EXPECT_EQ(slider.id, "rail");
  EXPECT_EQ(slider.first_object, 0u);
  EXPECT_EQ(slider.max_offset, 0.4);
  EXPECT_EQ(slider.damping, 1);
  EXPECT_EQ(slider.X_JB, RigidTransform(Vector3(0, 0, 0.1)));
  EXPECT_EQ(scene.objects[0].pose_in_world().translation(), Vector3(0.1, 0.2, 0.3));
  // Along -x of a joint that is turned by 90 degrees: along -y of the world.
  EXPECT_LT((scene.objects[1].pose_in_world().translation() - Vector3(0.1, -0.1, 0.4)).norm(),
            1e-15);
}

TEST(SliderReader, StartsAsNearToZeroAsItCan) {
  const auto start_of = [](const std::string& attributes) {
    return MustRead(Slider(attributes)).sliders.at(0).initial_offset;
  };
  EXPECT_EQ(start_of(""), 0);
  EXPECT_EQ(start_of("min='1' max='2'"), 0.1);
  EXPECT_EQ(start_of("min='-2' max='-1'"), -0.1);
}

TEST(SliderFaults, NameWhatDoesNotFit) {
  const std::string at = "test.xml:3: <sliderJoint>: found ";
  EXPECT_EQ(FaultOf(Slider("min='2'")), at + "min=\"2\", expected at most max");
  EXPECT_EQ(FaultOf(Slider("init='1.1'")), at + "init=\"1.1\", expected min to max");
  EXPECT_EQ(FaultOf(Slider("softness='2'")), at + "softness=\"2\", expected a number from 0 to 1");
  EXPECT_EQ(FaultOf(Slider("", "<block location='(0,0,0)'/>")),
            at + "1 object inside, expected two: one slides on the other");
  const std::string fixed = "<block mass='0' location='(0,0,0)'/>";
  EXPECT_EQ(FaultOf(Slider("", fixed + fixed)),
            at + "two objects of mass 0, expected one that can move");
  EXPECT_NE(FaultOf(Slider("", "<chain start='(0,0,0)' end='(0,0,1)'/>" + kTwoBlocks))
                .find("<chain>: found an element that does not belong"),
            std::string::npos);
}

TEST(ChainReader, MakesObjectsOfItsPieces) {
  const scene::SceneSpec scene = MustRead(
      SceneText("<chain color='red' start='(10,0,5)' end='(-10,-1,4)' linkCount='20'/>"
                "<block location='(0,0,0)'/>"
                "<chain start='(0,0,1)' end='(0,0.35,1)' linkYspan='0.1' linkMass='0.5'/>"));
  ASSERT_EQ(scene.chains.size(), 2u);
  ASSERT_EQ(scene.objects.size(), 22u + 1 + 2 + 4);
  EXPECT_EQ(scene.objects[0].id(), "obj-start");
  EXPECT_EQ(scene.objects[1].id(), "obj-end");
  EXPECT_EQ(scene.objects[21].id(), "obj-link19");
  EXPECT_EQ(scene.objects[22].id(), "obj#0");
  EXPECT_EQ(scene.chains[1].first_object, 23u);
  EXPECT_EQ(scene.chains[1].id, "obj#1");
  EXPECT_EQ(scene.objects.back().id(), "obj#1-link3") << "four links of 0.1 reach over 0.35";
  EXPECT_EQ(scene.objects.back().mass, 0.5);
  EXPECT_TRUE(scene.objects[23].is_static());
  EXPECT_TRUE(MustRead(WriteScene(scene)) == scene);
}

TEST(ChainReader, CountsTheLinksThatFit) {
  const auto links_of = [](const std::string& attributes) {
    return MustRead(Chain(attributes)).chains.at(0).link_ids.size();
  };
  EXPECT_EQ(links_of("start='(0,0,1)' end='(0,20,1)'"), 20u);
  EXPECT_EQ(links_of("start='(0,0,1)' end='(0,0.6,1)' linkYspan='0.1'"), 6u);
  EXPECT_EQ(links_of("start='(0,0,1)' end='(0,0.1,1)'"), 1u);
  EXPECT_EQ(links_of("start='(0,0,1)' end='(0,5.5,1)' linkCount='5'"), 5u) << "half a link short";
}

TEST(ChainFaults, NameWhatDoesNotReach) {
  const std::string at = "test.xml:3: <chain>: found ";
  EXPECT_EQ(FaultOf(Chain("start='(0,0,1)' end='(0,6,1)' linkCount='5'")),
            at + "linkCount=\"5\", expected 6 or more, to reach from start to end");
  EXPECT_EQ(FaultOf(Chain("start='(0,0,1)' end='(0,0,1)'")),
            at + "end=\"(0,0,1)\", expected a place at least 0.001 units from start");
  EXPECT_EQ(FaultOf(Chain("start='(0,0,1)' end='(0,2000,1)'")),
            at + "the default of linkYspan, expected links so long that 1000 of them reach from "
                 "start to end");
  EXPECT_EQ(FaultOf(Chain("start='(0,0,1)' end='(0,1,1)' linkCount='1001'")),
            at + "linkCount=\"1001\", expected a whole number from 0 to 1000");
  EXPECT_EQ(FaultOf(Chain("end='(0,1,1)'")), at + "no start, expected start=\"(x,y,z)\"");
}

TEST(ChainFaults, BoundTheObjectsOfAScene) {
  std::string chains;
  for (int i = 0; i < 4; ++i) {
    chains += "<chain start='(0,0,1)' end='(0,1,1)' linkCount='10'/>\n";
  }
  SceneReaderOptions options;
  options.limits.max_objects = 30;
  EXPECT_EQ(FaultOf(SceneText(chains), options),
            "test.xml:5: found more than 30 objects, links of chains among them, expected fewer");
}

TEST(JointWriter, WritesMechanismsAsTheyWereWritten) {
  const std::string text =
      WriteScene(MustRead(SceneText("<sliderJoint location='(1,0,0)' max='2'>" + kTwoBlocks +
                                    "</sliderJoint>" + "<chain start='(0,0,1)' end='(0,2,1)'/>")));
  EXPECT_NE(
      text.find("  <sliderJoint location=\"(1,0,0)\" rotation=\"(0,0,0)\" min=\"0\" max=\"2\" "
                "init=\"0\" collision=\"false\" damping=\"0\" restitution=\"0.7\" "
                "softness=\"1\">\n    <block id=\"obj\" location=\"(0,0,0)\""),
      std::string::npos)
      << text;
  EXPECT_NE(text.find("  <chain id=\"obj#1\" color=\"gray\" start=\"(0,0,1)\" end=\"(0,2,1)\" "
                      "linkXspan=\"0.1\" linkYspan=\"1\" linkZspan=\"0.1\" linkCount=\"2\" "
                      "linkPadding=\"0.05\" linkMass=\"1\"/>\n</tabletop>"),
            std::string::npos)
      << text;
}

}  // namespace
}  // namespace smile::scene_xml
