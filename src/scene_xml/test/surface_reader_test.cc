#include <gtest/gtest.h>

#include "scene_xml/scene_writer.h"
#include "scene_xml/test/scene_text.h"

namespace smile::scene_xml {
namespace {

TEST(SurfaceOfAnObject, IsTheDefaultUnlessTheFileSpecifiesIt) {
  EXPECT_TRUE(MustReadObject("<block location='(0,0,0)'/>").surface == scene::Surface{});
  EXPECT_TRUE(MustReadObject("<ring location='(0,0,0)' friction='0.2' restitution='0.5' "
                             "rollingFriction='0'/>")
                  .surface ==
              (scene::Surface{.friction = 0.2, .restitution = 0.5, .rolling_friction = 0}));
  EXPECT_EQ(
      MustReadObject("<sphere location='(0,0,0)' rollingFriction='0.3'/>").surface.rolling_friction,
      0.03)
      << "a length, in the units of the file";
}

TEST(SurfaceOfAnObject, RoundTrips) {
  const scene::SceneSpec scene =
      MustRead(SceneText("<block location='(0,0,0)' friction='0.1' restitution='0.3' "
                         "rollingFriction='0.07'/><ring location='(0,0,2)'/>"));
  EXPECT_TRUE(MustRead(WriteScene(scene)).objects == scene.objects);
  EXPECT_EQ(WriteScene(MustRead(SceneText("<block location='(0,0,0)'/>"))).find("iction"),
            std::string::npos)
      << "programs without these attributes can still read ordinary scenes";
}

TEST(CenterOfMass, IsTheOriginUnlessSpecifiedAndRoundTrips) {
  EXPECT_EQ(MustReadObject("<block location='(0,0,0)'/>").center_of_mass, Vector3(0, 0, 0));
  const scene::SceneSpec scene =
      MustRead(SceneText("<ring location='(0,0,1)' centerOfMass='(0.1,-2,0.3)'/>"));
  EXPECT_EQ(scene.objects.at(0).center_of_mass, Vector3(0.01, -0.2, 0.03));
  EXPECT_TRUE(MustRead(WriteScene(scene)).objects == scene.objects);
  EXPECT_EQ(FaultOf(SceneText("<block location='(0,0,0)' centerOfMass='low'/>")),
            "test.xml:3: <block>: found centerOfMass=\"low\", expected (x,y,z), three numbers from "
            "-1000000 to 1000000");
  EXPECT_EQ(FaultOf(SceneText("<composite location='(0,0,0)'><block location='(0,0,0)' "
                              "centerOfMass='(0,0,0)'/></composite>")),
            "test.xml:3: <block>: found centerOfMass=\"(0,0,0)\", expected centerOfMass only on "
            "the whole object");
}

TEST(SurfaceOfAnObject, IsRefusedOutOfRangeAndOnParts) {
  EXPECT_EQ(FaultOf(SceneText("<block location='(0,0,0)' friction='-1'/>")),
            "test.xml:3: <block>: found friction=\"-1\", expected a number from 0 to 10");
  EXPECT_EQ(FaultOf(SceneText("<block location='(0,0,0)' restitution='1.1'/>")),
            "test.xml:3: <block>: found restitution=\"1.1\", expected a number from 0 to 1");
  EXPECT_EQ(
      FaultOf(SceneText("<composite location='(0,0,0)'>"
                        "<block location='(0,0,0)' friction='1'/></composite>")),
      "test.xml:3: <block>: found friction=\"1\", expected friction only on the whole object");
}

}  // namespace
}  // namespace smile::scene_xml
