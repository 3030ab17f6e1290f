#include "demonstrator/demonstrator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

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

TEST_F(DemonstratorTest, NoDragPutsAnObjectIntoTheTableOrThroughAThinWall) {
  std::vector<scene::ObjectSpec> objects = {
      BlockAt("a", {-0.3, 0, 0.05}),
      BlockAt("wall", {0.2, 0, 0.5}, {0.02, 4, 1}, /*mass=*/0),
  };
  for (int i = 0; i < 5; ++i) {
    objects.push_back(BlockAt("s" + std::to_string(i), {-0.6, 0, 0.05 + 0.1 * i}));
  }
  Start(std::move(objects));
  Grasp("a");
  std::mt19937 random(3);
  const auto uniform = [&random](double low, double high) {
    return low + (high - low) * (random() / 4294967296.0);
  };
  double lowest = 1, farthest = -1, fastest = 0;
  for (int i = 0; i < 1000; ++i) {
    // Into the table, through the wall, through the stack; turned or not.
    const Vector3 goals[] = {{uniform(-0.8, 0.1), uniform(-0.4, 0.4), uniform(-1, 0)},
                             {uniform(0.3, 3), uniform(-0.4, 0.4), uniform(0, 0.6)},
                             {-0.6, 0, uniform(0, 0.5)},
                             {uniform(-0.9, 0.1), uniform(-0.4, 0.4), uniform(0.05, 0.5)}};
    MoveTo(goals[i % 4]);
    if (i % 5 == 0) {
      const Vector3 angles(uniform(-90, 90), uniform(-90, 90), uniform(-90, 90));
      ASSERT_EQ(hands_->Rotate(HandName::kAny, angles), std::nullopt);
    }
    const int num_steps = 24 + static_cast<int>(random() % 192);
    for (int step = 0; step < num_steps; ++step) {
      StepSeconds(1.0 / 480);
      const RigidTransform X_WB = world_->body(tabletop_->Find("a")->body).pose_in_world();
      for (int corner = 0; corner < 8; ++corner) {
        const Vector3 p_BQ(corner & 1 ? 0.05 : -0.05, corner & 2 ? 0.05 : -0.05,
                           corner & 4 ? 0.05 : -0.05);
        const Vector3 p_WQ = X_WB * p_BQ;
        lowest = std::min(lowest, p_WQ.z());
        farthest = std::max(farthest, p_WQ.x());
      }
      for (const world::Object& object : tabletop_->objects()) {
        fastest = std::max(fastest, world_->body(object.body).linear_velocity().norm());
      }
    }
  }
  EXPECT_GT(lowest, -0.005) << "m, of a corner: hardly into the table";
  EXPECT_LT(farthest, 0.195) << "m, of a corner: hardly into the wall";
  EXPECT_LT(fastest, 5.0) << "m/s, of anything: nothing explodes";
}

TEST_F(DemonstratorTest, HandsThatPushAgainstEachOtherDoNotExplode) {
  ASSERT_EQ(hands_->Grasp(HandName::kLeft, "a", std::nullopt), std::nullopt);
  ASSERT_EQ(hands_->Grasp(HandName::kRight, "b", std::nullopt), std::nullopt);
  // Each wants to be where the other is; then both at the same place.
  const std::pair<Vector3, Vector3> goals[] = {{{0.3, 0, 0.3}, {0, 0, 0.3}},
                                               {{0.15, 0, 0.3}, {0.15, 0, 0.3}},
                                               {{0.15, 0.01, 0.3}, {0.15, 0, 0.3}}};
  double fastest = 0, nearest = 1;
  for (const auto& [left, right] : goals) {
    ASSERT_EQ(hands_->MoveTo(HandName::kLeft, left, std::nullopt), std::nullopt);
    ASSERT_EQ(hands_->MoveTo(HandName::kRight, right, std::nullopt), std::nullopt);
    for (int step = 0; step < 960; ++step) {
      StepSeconds(1.0 / 480);
      for (const char* id : {"a", "b"}) {
        const physics::Body& body = world_->body(tabletop_->Find(id)->body);
        fastest = std::max(fastest, body.linear_velocity().norm());
      }
      nearest = std::min(nearest, (PositionOf("a") - PositionOf("b")).norm());
    }
  }
  EXPECT_LT(fastest, 1.5) << "m/s";
  EXPECT_GT(nearest, 0.095) << "m: hardly into each other";
  const Vector3 p_WA = PositionOf("a"), p_WB = PositionOf("b");
  StepSeconds(1);
  EXPECT_LT((PositionOf("a") - p_WA).norm() + (PositionOf("b") - p_WB).norm(), 0.001) << "at rest";
  ASSERT_EQ(hands_->Release(HandName::kLeft), std::nullopt);
  StepSeconds(1.0 / 60);
  EXPECT_LT((PositionOf("a") - p_WA).norm(), 0.005) << "no jump";
}

TEST_F(DemonstratorTest, TurnsAboutTheWorldsAxesByTheRequestedAngles) {
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

TEST_F(DemonstratorTest, AnObjectPressedOnTheTableSettlesWithoutAJump) {
  Grasp("a");
  MoveTo({0, 0, -1});
  StepSeconds(1);
  const Vector3 pressed = PositionOf("a");
  Release();
  double farthest = 0;
  for (int step = 0; step < 480; ++step) {
    StepSeconds(1.0 / 480);
    farthest = std::max(farthest, (PositionOf("a") - pressed).norm());
  }
  EXPECT_LT(farthest, 0.003);
  EXPECT_NEAR(PositionOf("a").z(), 0.05, 0.0005);
}

TEST_F(DemonstratorTest, RefusesWithAReason) {
  EXPECT_EQ(hands_->Grasp(HandName::kAny, "nothing", std::nullopt), "there is no object 'nothing'");
  EXPECT_EQ(hands_->Grasp(HandName::kAny, "shelf", std::nullopt),
            "'shelf' is fixed (its mass is 0)");
  EXPECT_EQ(hands_->Release(HandName::kLeft), "the left hand holds nothing");
  Grasp("a");
  EXPECT_EQ(hands_->Grasp(HandName::kLeft, "a", std::nullopt),
            "the hand 'any' holds 'a'; release it first");
  EXPECT_EQ(hands_->Grasp(HandName::kAny, "b", std::nullopt),
            "the hand 'any' already holds 'a'; release it first");
}

TEST_F(DemonstratorTest, HandsWorkInterleaved) {
  ASSERT_EQ(hands_->Grasp(HandName::kLeft, "a", std::nullopt), std::nullopt);
  ASSERT_EQ(hands_->Grasp(HandName::kRight, "b", std::nullopt), std::nullopt);
  ASSERT_EQ(hands_->MoveTo(HandName::kLeft, {0, 0, 0.4}, std::nullopt), std::nullopt);
  ASSERT_EQ(hands_->MoveTo(HandName::kRight, {0.3, 0, 0.2}, 0.05), std::nullopt);
  StepSeconds(1);
  EXPECT_NEAR(PositionOf("a").z(), 0.4, 0.001);
  EXPECT_NEAR(PositionOf("b").z(), 0.1, 0.002);  // 0.05 m in a second, as commanded
}

}  // namespace
}  // namespace smile::demonstrator
