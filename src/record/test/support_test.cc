#include "sim/support.h"

#include <gtest/gtest.h>

#include "scene_xml/scene_reader.h"

namespace smile::sim {
namespace {

/// What object `a` would lie on, at this height above something.
std::optional<Support> SupportOfAAt(const std::string& place) {
  const auto scene =
      scene_xml::ReadSceneText(
          "<tabletop xmlns=\"http://synapse.cs.umd.edu/tabletop-xml\">\n"
          "<block id=\"a\" location=\"" +
              place +
              "\"/>\n"
              "<block id=\"b\" location=\"(3, 0, 0.5)\"/>\n"
              "<box id=\"crate\" xspan=\"4\" yspan=\"4\" zspan=\"3\" thickness=\"0.5\" "
              "location=\"(-4, 0, 1.5)\"/>\n</tabletop>",
          "some.xml")
          .scene;
  if (!scene) throw std::logic_error("this is no scene");
  std::vector<std::optional<RigidTransform>> X_WBs;
  for (const scene::ObjectSpec& object : scene->objects) X_WBs.push_back(object.pose_in_world());
  return SupportOf(*scene, X_WBs, 0);
}

TEST(Support, IsTheHighestThingStraightBeneath) {
  EXPECT_EQ(SupportOfAAt("(0, 0, 0.5)")->object, "");
  EXPECT_TRUE(SupportOfAAt("(0, 0, 0.5)")->is_near());
  EXPECT_EQ(SupportOfAAt("(3.5, 0.5, 1.6)")->object, "b");
  EXPECT_FALSE(SupportOfAAt("(3.5, 0.5, 1.75)")->is_near());
  const Support in_crate = *SupportOfAAt("(-4, 0, 1)");
  EXPECT_EQ(in_crate.object, "crate");
  EXPECT_TRUE(in_crate.is_container && in_crate.is_near());
  EXPECT_FALSE(SupportOfAAt("(-2.2, 0, 3.5)")->is_container) << "it lies on the crate's wall";
  EXPECT_EQ(SupportOfAAt("(12, 0, 0.5)"), std::nullopt);
}

}  // namespace
}  // namespace smile::sim
