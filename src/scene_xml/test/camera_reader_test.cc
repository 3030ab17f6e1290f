#include <gtest/gtest.h>

#include "math/angles.h"
#include "scene_xml/scene_writer.h"
#include "scene_xml/test/scene_text.h"

namespace smile::scene_xml {
namespace {

std::string Camera(const std::string& attributes) {
  return SceneText("<camera " + attributes + "/>");
}

TEST(CameraReader, ReadsThePoseAndTheFieldOfViewOfACamera) {
  const scene::SceneSpec scene = MustRead(
      Camera("id='side' location='(-9,0,3)' target='(0,1,0.5)'/>"
             "<camera id='overhead' location='(0,0,12)' target='(0,0,0)' up='(0,2,0)' fov='30'"));
  ASSERT_EQ(scene.cameras.size(), 2u);
  EXPECT_EQ(scene.cameras[0],
            (scene::CameraSpec{.id = "side", .p_WC = {-0.9, 0, 0.3}, .p_WQ = {0, 0.1, 0.05}}));
  EXPECT_EQ(scene.cameras[0].vertical_field_of_view, DegreesToRadians(60.0));
  EXPECT_EQ(scene.cameras[1].up_in_world, Vector3(0, 2, 0));
  EXPECT_EQ(scene.cameras[1].vertical_field_of_view, DegreesToRadians(30.0));
  EXPECT_TRUE(scene.objects.empty());
}

TEST(CameraReader, MayLookStraightDownWithoutSayingWhatIsUp) {
  EXPECT_EQ(MustRead(Camera("id='a' location='(0,0,9)' target='(0,0,0)'")).cameras.size(), 1u);
}

TEST(CameraFaults, NameWhatDoesNotFit) {
  const std::string place = " location='(0,0,9)' target='(0,0,0)'";
  const auto found = [](const std::string& id, const std::string& fault) {
    return "test.xml:3: <camera id=\"" + id + "\">: found " + fault;
  };
  EXPECT_EQ(FaultOf(Camera("location='(0,0,9)' target='(0,0,0)'")),
            "test.xml:3: <camera>: found no id, expected id=\"…\"");
  EXPECT_EQ(FaultOf(Camera("id='a' target='(0,0,0)'")),
            found("a", "no location, expected location=\"(x,y,z)\""));
  EXPECT_EQ(FaultOf(Camera("id='a' location='(1,2,3)' target='(1,2,3)'")),
            found("a", "target=\"(1,2,3)\", expected another place than location"));
  EXPECT_EQ(FaultOf(Camera("id='a' up='(0,0,-3)'" + place)),
            found("a",
                  "up=\"(0,0,-3)\", expected another direction than that from location to "
                  "target"));
  EXPECT_EQ(FaultOf(Camera("id='a' up='(0,0,0)'" + place)),
            found("a",
                  "up=\"(0,0,0)\", expected (x,y,z), three numbers, the largest of which is "
                  "from 0.000001 to 1000000"));
  for (const std::string fov : {"0", "171", "nan", "-1e999"}) {
    EXPECT_EQ(FaultOf(Camera("id='a' fov='" + fov + "'" + place)),
              found("a", "fov=\"" + fov + "\", expected a number from 1 to 170"));
  }
  EXPECT_EQ(FaultOf(Camera("id='eye'" + place)),
            found("eye",
                  "id=\"eye\", expected none of close, eye, front, head, left, left_hand, nice, "
                  "right, right_hand or top, which are predefined"));
  EXPECT_EQ(FaultOf(Camera("id='3d'" + place)),
            found("3d", "id=\"3d\", expected a letter first, and at most 40 characters"));
  EXPECT_EQ(FaultOf(Camera("id='a'" + place + "/><camera id='a'" + place)),
            found("a", "id=\"a\", expected one that no other camera has"));
  EXPECT_NE(
      FaultOf(SceneText("<composite location='(0,0,0)'><camera id='a'" + place + "/></composite>"))
          .find("found an element that does not belong here"),
      std::string::npos);
}

TEST(CameraFaults, AreManyCameras) {
  std::string cameras;
  for (int i = 0; i <= scene::kMaxCameras; ++i) {
    cameras += "<camera id='c" + std::to_string(i) + "' location='(0,0,9)' target='(0,0,0)'/>";
  }
  EXPECT_EQ(FaultOf(SceneText(cameras)),
            "test.xml:3: <camera id=\"c64\">: found one camera more than 64");
}

}  // namespace
}  // namespace smile::scene_xml
