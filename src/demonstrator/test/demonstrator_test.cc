#include "demonstrator/demonstrator.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace smile::demonstrator {
namespace {

class DemonstratorTest : public ::testing::Test {
 protected:
  DemonstratorTest() {
    Start({BlockAt("a", {0, 0, 0.05}), BlockAt("b", {0.3, 0, 0.05}),
           BlockAt("shelf", {-0.5, 0, 0.25}, {0.008, 0.6, 0.5}, /*mass=*/0)});
  }

  static scene::ObjectSpec BlockAt(std::string id, const Vector3& p_WB,
                                   const Vector3& size = {0.1, 0.1, 0.1}, double mass = 1) {
    return {
        .whole = {.id = std::move(id), .X_PE = RigidTransform(p_WB), .shape = scene::Block{size}},
        .mass = mass};
  }
  void Start(std::vector<scene::ObjectSpec> objects) {
    world_ = std::make_unique<physics::World>();
    tabletop_ = std::make_unique<world::Tabletop>(
        world_.get(), scene::SceneSpec{.name = "test", .objects = std::move(objects)});
    hands_ = std::make_unique<Demonstrator>(world_.get(), tabletop_.get());
  }
  void StepSeconds(double seconds) {
    for (int i = 0; i < seconds * 480; ++i) {
      hands_->BeforeStep();
      world_->Step();
    }
  }
  Vector3 PositionOf(std::string_view id) const {
    return world_->body(tabletop_->Find(id)->body).pose_in_world().translation();
  }
  void Grasp(std::string_view id) {
    ASSERT_EQ(hands_->Grasp(HandName::kAny, id, std::nullopt), std::nullopt);
  }
  void MoveTo(const Vector3& p_WH) {
    ASSERT_EQ(hands_->MoveTo(HandName::kAny, p_WH, std::nullopt), std::nullopt);
  }
  void Release() { ASSERT_EQ(hands_->Release(HandName::kAny), std::nullopt); }

  std::unique_ptr<physics::World> world_;
  std::unique_ptr<world::Tabletop> tabletop_;
  std::unique_ptr<Demonstrator> hands_;
};

TEST_F(DemonstratorTest, StacksABlockWithinAMillimeter) {
  Grasp("a");
  MoveTo({0, 0, 0.3});
  StepSeconds(1);
  MoveTo({0.3, 0, 0.3});
  StepSeconds(1);
  EXPECT_TRUE(hands_->has_arrived());
  MoveTo({0.3, 0, 0.151});
  StepSeconds(1);
  Release();
  StepSeconds(2);
  EXPECT_LT((PositionOf("a") - Vector3(0.3, 0, 0.15)).norm(), 0.001);
  EXPECT_LT((PositionOf("b") - Vector3(0.3, 0, 0.05)).norm(), 0.001);
}

TEST_F(DemonstratorTest, StopsAtTheTableAndAtAThinWallAtAnySpeed) {
  Grasp("a");
  MoveTo({0, 0, -2});
  double lowest = 1;
  for (int i = 0; i < 60; ++i) {
    StepSeconds(1.0 / 60);
    lowest = std::min(lowest, PositionOf("a").z());
  }
  EXPECT_GT(lowest, 0.048);
  MoveTo({0, 0, 0.25});
  StepSeconds(1);
  MoveTo({-1.5, 0, 0.25});
  StepSeconds(3);
  EXPECT_GT(PositionOf("a").x(), -0.5);
}

TEST_F(DemonstratorTest, RammingAStackDoesNotExplodeIt) {
  Start({BlockAt("a", {-0.4, 0, 0.15}), BlockAt("b", {0, 0, 0.05}), BlockAt("c", {0, 0, 0.15}),
         BlockAt("d", {0, 0, 0.25})});
  Grasp("a");
  MoveTo({0.4, 0, 0.15});
  double fastest = 0;
  for (int i = 0; i < 480; ++i) {
    StepSeconds(1.0 / 480);
    for (const char* id : {"b", "c", "d"}) {
      fastest = std::max(fastest, world_->body(tabletop_->Find(id)->body).linear_velocity().norm());
    }
  }
  EXPECT_LT(fastest, 3.0);  // [m/s]
}

TEST_F(DemonstratorTest, TurnsAboutTheWorldsAxesByWhatIsAsked) {
  Grasp("a");
  MoveTo({0, 0, 0.3});
  ASSERT_EQ(hands_->Rotate(HandName::kAny, {0, 0, 90}), std::nullopt);
  ASSERT_EQ(hands_->Rotate(HandName::kAny, {90, 0, 0}), std::nullopt);
  StepSeconds(2);
  EXPECT_TRUE(hands_->has_arrived());
  const Matrix3 R = world_->body(tabletop_->Find("a")->body).pose_in_world().rotation();
  // Its x axis went to world y, then on to world z.
  EXPECT_GT(R.col(0).z(), 0.999);
}

TEST_F(DemonstratorTest, CarriesTheGraspedPointNotTheOrigin) {
  ASSERT_EQ(hands_->Grasp(HandName::kAny, "a", Vector3(0.05, 0, 0.1)), std::nullopt);
  MoveTo({0.05, 0, 0.4});
  StepSeconds(1);
  EXPECT_LT((PositionOf("a") - Vector3(0, 0, 0.35)).norm(), 0.0005);
}

TEST_F(DemonstratorTest, AReleasedObjectDoesNotJump) {
  Grasp("a");
  MoveTo({0, 0, 0.3});
  StepSeconds(0.2);  // still on its way, at full speed
  Release();
  const double height = PositionOf("a").z();
  StepSeconds(1.0 / 60);
  EXPECT_LE(PositionOf("a").z(), height);
}

TEST_F(DemonstratorTest, RefusesWithAReason) {
  EXPECT_EQ(hands_->Grasp(HandName::kAny, "nothing", std::nullopt), "there is no object 'nothing'");
  EXPECT_EQ(hands_->Grasp(HandName::kAny, "shelf", std::nullopt),
            "'shelf' is fixed (its mass is 0)");
  EXPECT_EQ(hands_->Release(HandName::kLeft), "the left hand holds nothing");
  Grasp("a");
  EXPECT_EQ(hands_->Grasp(HandName::kLeft, "a", std::nullopt),
            "the any hand holds 'a'; it must let go first");
  EXPECT_EQ(hands_->Grasp(HandName::kAny, "b", std::nullopt),
            "the any hand already holds 'a'; release it first");
}

TEST_F(DemonstratorTest, HandsWorkInterleaved) {
  ASSERT_EQ(hands_->Grasp(HandName::kLeft, "a", std::nullopt), std::nullopt);
  ASSERT_EQ(hands_->Grasp(HandName::kRight, "b", std::nullopt), std::nullopt);
  ASSERT_EQ(hands_->MoveTo(HandName::kLeft, {0, 0, 0.4}, std::nullopt), std::nullopt);
  ASSERT_EQ(hands_->MoveTo(HandName::kRight, {0.3, 0, 0.2}, 0.05), std::nullopt);
  StepSeconds(1);
  EXPECT_NEAR(PositionOf("a").z(), 0.4, 0.001);
  EXPECT_NEAR(PositionOf("b").z(), 0.1, 0.002);  // 0.05 m in a second, as told
}

}  // namespace
}  // namespace smile::demonstrator
