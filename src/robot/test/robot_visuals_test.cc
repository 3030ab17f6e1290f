#include "robot/robot_visuals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "robot/test/baxter.h"

namespace smile::robot {
namespace {

TEST(RobotVisuals, TakesOneFrameForTheBaseAndOneForEachLink) {
  scene::VisualModel visual_model{.object_names = {"", "table", "robot"}, .num_frames = 5};
  AppendVisuals(Baxter(), 5, 2, &visual_model);
  EXPECT_EQ(visual_model.num_frames, 5 + 1 + Baxter().num_joints());
  ASSERT_EQ(visual_model.visuals.size(), Baxter().visuals.size());
  std::vector<bool> is_shown(static_cast<std::size_t>(visual_model.num_frames), false);
  for (const scene::Visual& visual : visual_model.visuals) {
    EXPECT_EQ(visual.object_id, 2u);
    ASSERT_GE(visual.frame, 5);
    ASSERT_LT(visual.frame, visual_model.num_frames);
    is_shown[static_cast<std::size_t>(visual.frame)] = true;
  }
  EXPECT_EQ(std::count(is_shown.begin() + 5, is_shown.end(), false), 0) << "every link shows";
}

TEST(RobotVisuals, TheFaceExpressionIsAChoice) {
  scene::VisualModel visual_model{.object_names = {"", "robot"}, .num_choices = 3};
  AppendVisuals(Baxter(), 1, 1, &visual_model);
  EXPECT_EQ(visual_model.num_choices, 4);
  std::set<int> variants;
  for (const scene::Visual& visual : visual_model.visuals) {
    if (visual.choice >= 0) variants.insert(visual.variant);
    EXPECT_TRUE(visual.choice == -1 || visual.choice == 3);
  }
  EXPECT_EQ(variants.size(), kFaceExpressions.size());
  EXPECT_TRUE(variants.contains(VariantOf(FaceExpression::kPuzzled)));
}

TEST(RobotVisuals, PosesFollowTheOrderOfTheFrames) {
  const RigidTransform X_WBase(Vector3(1, 2, 3));
  const scene::FramePoses poses = FramePosesOf(Baxter(), X_WBase, Baxter().q_start);
  const std::vector<RigidTransform> X_WL = LinkPoses(Baxter(), X_WBase, Baxter().q_start);
  ASSERT_EQ(poses.size(), static_cast<std::size_t>(NumVisualFrames(Baxter())));
  EXPECT_TRUE(poses[0] == X_WBase);
  for (std::size_t i = 0; i < X_WL.size(); ++i) EXPECT_TRUE(poses[i + 1] == X_WL[i]);
}

TEST(RobotVisuals, RefusesTheWorldsFrameAndTheBackground) {
  scene::VisualModel visual_model{.object_names = {"", "robot"}};
  EXPECT_THROW(AppendVisuals(Baxter(), 0, 1, &visual_model), std::invalid_argument);
  EXPECT_THROW(AppendVisuals(Baxter(), 1, 0, &visual_model), std::invalid_argument);
  EXPECT_THROW(AppendVisuals(Baxter(), 1, 2, &visual_model), std::invalid_argument);
  EXPECT_TRUE(visual_model.visuals.empty());
}

}  // namespace
}  // namespace smile::robot
