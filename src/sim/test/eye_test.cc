#include "sim/eye.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "base/files.h"
#include "math/angles.h"
#include "robot/urdf_reader.h"

namespace smile::sim {
namespace {

constexpr double kTolerance = 1e-5;  // [m]: the robot's data have five digits

scene::SceneSpec SceneWithCamera() {
  scene::SceneSpec scene{.name = "watched"};
  scene.cameras = {{.id = "overhead", .p_WC = {0.1, 0, 30}, .p_WQ = {0.1, 0, 0}}};
  return scene;
}

RobotPlacement Baxter() { return {.model = robot::ReadRobot(DataFile("robots/baxter.urdf"))}; }

/// A pose in the base of the simulation's robot.
RigidTransform InBase(const Simulation& simulation, const CameraView& view) {
  return simulation.robot()->base_pose().inverse() * view.X_WC;
}

TEST(Cameras, AreTheRobotsAndTheScenes) {
  EXPECT_EQ(CameraNames(model::Model(SceneWithCamera(), Baxter())),
            (std::vector<std::string>{"eye", "head", "left_hand", "right_hand", "overhead"}));
  EXPECT_EQ(CameraNames(model::Model(SceneWithCamera())),
            (std::vector<std::string>{"eye", "overhead"}));
}

TEST(Cameras, OfARobotPrecedeThoseOfTheScene) {
  scene::SceneSpec scene = SceneWithCamera();
  scene.cameras.front().id = "left_hand";  // no reader lets Baxter's pass, but those of others
  const Simulation simulation(std::move(scene), Baxter());
  EXPECT_EQ(CameraNames(simulation.model()),
            (std::vector<std::string>{"eye", "head", "left_hand", "right_hand"}));
  EXPECT_EQ(EyeView(simulation, {.camera = "left_hand"}).X_WC,
            EyeView(Simulation(SceneWithCamera(), Baxter()), {.camera = "left_hand"}).X_WC);
}

TEST(Cameras, MayBeDisplaced) {
  scene::SceneSpec scene = SceneWithCamera();
  scene.camera_offsets = {
      {.camera = "eye", .X_CD = RigidTransform(Vector3(0.01, 0, 0)), .view_angle_scale = 1.1},
      {.camera = "overhead", .X_CD = RigidTransform(RotationFromFixedAxes({0, 0, 90}), {0, 0, 1})},
      {.camera = "missing"}};
  const Simulation displaced(std::move(scene), Baxter()), usual(SceneWithCamera(), Baxter());
  const CameraView eye = EyeView(displaced, {}), before = EyeView(usual, {});
  EXPECT_TRUE((before.X_WC.inverse() * eye.X_WC).translation().isApprox(Vector3(0.01, 0, 0)));
  EXPECT_NEAR(std::atan(eye.intrinsics.cy / eye.intrinsics.fy) /
                  std::atan(before.intrinsics.cy / before.intrinsics.fy),
              1.1, 1e-9);
  EXPECT_NEAR(EyeView(displaced, {.camera = "overhead"}).X_WC.translation().z(), 29, 1e-9);
  EXPECT_EQ(EyeView(displaced, {.camera = "head"}).X_WC, EyeView(usual, {.camera = "head"}).X_WC);
}

TEST(Cameras, AreNamedWhenAnUnknownOneIsRequested) {
  const Simulation simulation(SceneWithCamera());
  try {
    EyeView(simulation, {.camera = "overhed"});
    FAIL() << "there is no such camera";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(),
                 "camera is \"overhed\", expected eye or overhead; did you mean \"overhead\"?");
  }
}

TEST(Cameras, OfTheHeadHaveTheRealViewDirection) {
  const Simulation simulation(SceneWithCamera(), Baxter());
  const CameraView view =
      EyeView(simulation, {.width_px = 640, .height_px = 400, .camera = kHeadCamera});
  const RigidTransform X_BaseC = InBase(simulation, view);
  EXPECT_LT((X_BaseC.translation() - Vector3(0.18839, 0, 0.74968)).norm(), kTolerance);
  EXPECT_LT((X_BaseC.rotation().col(2) - Vector3(0.98388, 0, -0.17881)).norm(), kTolerance);
  EXPECT_LT((X_BaseC.rotation().col(0) + Vector3::UnitY()).norm(), kTolerance) << "x is right";
  EXPECT_NEAR(view.intrinsics.fx, 381.36, 0.01);
  EXPECT_EQ(view.intrinsics.fy, view.intrinsics.fx);
}

TEST(Cameras, MoveWithTheirLinks) {
  Simulation simulation(SceneWithCamera(), Baxter());
  const auto pose = [&](const char* camera) {
    return InBase(simulation, EyeView(simulation, {.camera = camera}));
  };
  const RigidTransform eye = pose("eye"), head = pose("head"), left = pose("left_hand"),
                       right = pose("right_hand"), overhead = pose("overhead");
  const std::vector<double> there{0.1, 0.2, 0, 0.3, 0, 0, 0.5};
  ASSERT_FALSE(simulation.Apply(JointAngles{.arms = {{"left", there}}, .head = 0.5}));
  const Matrix3 R_turn = Eigen::AngleAxisd(0.5, Vector3::UnitZ()).toRotationMatrix();
  EXPECT_LT((pose("eye").rotation() - R_turn * eye.rotation()).norm(), 1e-9);
  EXPECT_LT((pose("head").rotation() - R_turn * head.rotation()).norm(), 1e-9);
  EXPECT_GT((pose("left_hand").translation() - left.translation()).norm(), 0.01);
  EXPECT_EQ(pose("right_hand"), right);
  EXPECT_EQ(pose("overhead"), overhead);
}

TEST(Cameras, DoNotSeeTheLinkTheyAreFixedTo) {
  const Simulation simulation(SceneWithCamera(), Baxter());
  const auto hidden = [&](const char* camera) {
    return FramesHiddenFromEye(simulation.model(), /*is_robot_shown=*/true, camera);
  };
  EXPECT_EQ(hidden("eye").size(), 1u);
  EXPECT_EQ(hidden("head"), hidden("eye"));
  EXPECT_EQ(hidden("left_hand").size(), 1u);
  EXPECT_NE(hidden("left_hand"), hidden("right_hand"));
  EXPECT_TRUE(hidden("overhead").empty());
  EXPECT_GT(FramesHiddenFromEye(simulation.model(), /*is_robot_shown=*/false, "overhead").size(),
            10u);
}

TEST(Cameras, OfASceneSeeFar) {
  const CameraView view = EyeView(Simulation(SceneWithCamera()), {.camera = "overhead"});
  EXPECT_EQ(view.X_WC, LookAt({0.1, 0, 30}, {0.1, 0, 0}));
  EXPECT_EQ(view.intrinsics.far, 60);
}

}  // namespace
}  // namespace smile::sim
