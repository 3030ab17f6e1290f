#include "interchange/urdf.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

namespace smile::interchange {
namespace {

/// A robot of two links, the second of which follows the first one.
ExportedWorld Geared() {
  auto spec = std::make_shared<scene::ArticulationSpec>();
  for (const char* name : {"lead", "follow"}) {
    spec->links.push_back({.name = name,
                           .joint_name = name,
                           .lower = -1,
                           .upper = 2,
                           .max_velocity = 3,
                           .max_effort = 4,
                           .mass = 1,
                           .inertia = Matrix3::Identity()});
  }
  spec->links[1].mimic = scene::Mimic{.leader = 0, .multiplier = -2, .offset = 0.5};
  return {.robot = ExportedRobot{.spec = spec,
                                 .q = {0.25, 0},
                                 .base = {.name = "base"},
                                 .links = {{.name = "lead"}, {.name = "follow"}}}};
}

TEST(Urdf, FollowersFollowFromTheirPresentPositions) {
  const std::string text = ToUrdf(Geared(), "meshes").text;
  // At position 0 both are where they are now, so that the offset of 0.5 is in that.
  EXPECT_NE(text.find(R"(<mimic joint="lead" multiplier="-2"/>)"), std::string::npos) << text;
  EXPECT_NE(text.find(R"(<limit lower="-1.25" upper="1.75" effort="4" velocity="3"/>)"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find(R"(<limit lower="-1" upper="2" effort="4" velocity="3"/>)"),
            std::string::npos)
      << text;
}

TEST(Urdf, TurnsUpRightWithoutLoss) {
  ExportedWorld world;
  world.bodies.resize(1);
  world.bodies[0].name = "</link>";
  // A pitch of a quarter turn leaves only the difference of roll and yaw.
  const Quaternion q = Eigen::AngleAxisd(0.3, Vector3::UnitZ()) *
                       Eigen::AngleAxisd(M_PI / 2, Vector3::UnitY()) *
                       Eigen::AngleAxisd(0.1, Vector3::UnitX());
  world.bodies[0].spec.X_WB = RigidTransform(q, Vector3::Zero());
  const std::string text = ToUrdf(world, "meshes").text;
  EXPECT_NE(text.find(R"(<link name="&lt;/link&gt;"/>)"), std::string::npos) << text;
  double roll = 0, pitch = 0, yaw = 0;
  const std::size_t at = text.find("rpy=\"");
  ASSERT_NE(at, std::string::npos);
  ASSERT_EQ(std::sscanf(text.c_str() + at, "rpy=\"%lf %lf %lf", &roll, &pitch, &yaw), 3);
  const Quaternion read = Eigen::AngleAxisd(yaw, Vector3::UnitZ()) *
                          Eigen::AngleAxisd(pitch, Vector3::UnitY()) *
                          Eigen::AngleAxisd(roll, Vector3::UnitX());
  EXPECT_LT(read.angularDistance(q), 1e-7);
}

}  // namespace
}  // namespace smile::interchange
