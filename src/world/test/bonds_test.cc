// Bonds: poses of fastened objects, and refusals.

#include "world/bonds.h"

#include <algorithm>
#include <numeric>

#include "workshop.h"

namespace smile::world {
namespace {

class BondsTest : public WorkshopTest {};

TEST_F(BondsTest, EachStagePutsTheGuestAtItsPose) {
  scene::ObjectSpec nut = Nut("nut", {0.2, 0.1, 0.055});
  nut.whole.X_PE = {RotationFromFixedAxes({0, 0, 30}), Vector3(0.2, 0.1, 0.055)};
  Start({nut, Screw("screw", {-0.5, 0, 0.5}, "nut_hole")});
  ExpectPose("screw", {0.2, 0.1, 0.21 - 1 / 30.0}, {0, 0, 30 + 45});
  EXPECT_EQ(Fasten("screw"), "");
  ExpectPose("screw", {0.2, 0.1, 0.21 - 2 / 30.0}, {0, 0, 30 + 90});
  EXPECT_EQ(Fasten("screw"), "");
  ExpectPose("screw", {0.2, 0.1, 0.21 - 3 / 30.0}, {0, 0, 30 + 135});
  EXPECT_EQ(Fasten("screw"), "'screw' is already at its tightest stage");
  EXPECT_EQ(TightnessOf("nut_hole"), 3);
  for (int k : {2, 1}) {
    EXPECT_EQ(Loosen("screw"), "");
    ExpectPose("screw", {0.2, 0.1, 0.21 - k / 30.0}, {0, 0, 30 + 45.0 * k});
  }
  EXPECT_EQ(Loosen("screw"), "");
  ExpectPose("screw", {0.2, 0.1, 0.21}, {0, 0, 30});
  EXPECT_TRUE(world_->joints().empty());
  EXPECT_EQ(Loosen("screw"), "'screw' is not fastened there");
  ExpectPose("nut", {0.2, 0.1, 0.055}, {0, 0, 30});
}

TEST_F(BondsTest, PointsMayLieAndPointAnywhere) {
  scene::Composite wall, peg;
  wall.parts = {BlockPart({0.1, 0.4, 0.4})};
  // The hole looks along the wall's x; its only stage is 5 cm before it, a quarter turn about x.
  wall.hosts = {{.id = "hole",
                 .type = "peg",
                 .X_PH = {RotationFromFixedAxes({0, 90, 0}), Vector3(0.05, 0.1, 0)},
                 .stages = {{.X_HS = {RotationFromFixedAxes({0, 0, 90}), Vector3(0, 0, 0.05)}}}}};
  peg.parts = {BlockPart({0.02, 0.02, 0.2})};
  peg.guests = {{.id = "tip", .type = "peg", .X_PG = RigidTransform(Vector3(0, 0, -0.1))}};
  Start({ObjectAt("wall", wall, {0, 0, 0.5}, /*mass=*/0), ObjectAt("peg", peg, {0.1, 0.1, 0.6})});
  EXPECT_EQ(Fasten("peg"), "");
  EXPECT_LT((PositionOf("peg") - Vector3(0.2, 0.1, 0.5)).norm(), 1e-6);
  Matrix3 R_WPeg;  // its z is the world's x, its x the world's y
  R_WPeg << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  EXPECT_TRUE(PoseOf("peg").rotation().isApprox(R_WPeg, 1e-6)) << PoseOf("peg").rotation();
  StepSeconds(1);
  EXPECT_LT((PositionOf("peg") - Vector3(0.2, 0.1, 0.5)).norm(), 1e-4) << "it is held";
}

TEST_F(BondsTest, ReleasingAScrewDoesNotPushTheNut) {
  // The thread: a shaft wider than the hole, and a host point in the middle of the nut.
  scene::ObjectSpec nut = Nut("nut", {0, 0, 0.055});
  HostPointOf(nut).X_PH = {};
  scene::ObjectSpec screw = Screw("screw", {0, 0, 0.5}, "nut_hole");
  std::get<scene::Composite>(screw.whole.shape).parts[0] = BlockPart({0.05, 0.05, 0.2});
  for (scene::TightnessStage& stage : HostPointOf(nut).stages) {
    stage.X_HS = {stage.X_HS.rotation(), stage.X_HS.translation() / 4};
  }
  Start({nut, screw});
  StepSeconds(0.5);
  const Vector3 p_WNut = PositionOf("nut");
  EXPECT_EQ(Loosen("screw"), "");
  EXPECT_NEAR(PositionOf("screw").z(), p_WNut.z() + 0.1, 1e-6) << "halfway in its hole";
  double farthest = 0, fastest = 0;
  for (int step = 0; step < 480; ++step) {
    world_->Step();
    farthest = std::max(farthest, (PositionOf("nut") - p_WNut).norm());
    fastest = std::max(fastest, BodyOf("screw").linear_velocity().norm());
  }
  EXPECT_LT(farthest, 0.001) << "m";
  EXPECT_LT(fastest, 1.1) << "m/s; it falls 5 cm at most";
  EXPECT_LT(PositionOf("screw").z(), 0.14) << "nothing holds it";
}

TEST_F(BondsTest, AGuestReachesLessThanTwoUnits) {
  const auto fasten_from = [this](double distance, double meters_per_unit) {
    // The hole ends at z = 0.11, the tip is that far above and aside of it.
    const Vector3 p_WTip = Vector3(0, 0, 0.11) + distance * Vector3(0.6, 0, 0.8);
    Start({Nut("nut", {0, 0, 0.055}), Screw("screw", p_WTip + Vector3(0, 0, 0.1))},
          meters_per_unit);
    return Fasten("screw");
  };
  const char* too_far = "no free point that fits 'screw_tip' is within two units";
  EXPECT_EQ(fasten_from(0.126, 0.1), "");
  ExpectPose("screw", {0, 0, 0.21 - 1 / 30.0}, {0, 0, 45});
  EXPECT_EQ(fasten_from(0.199, 0.1), "");
  EXPECT_EQ(fasten_from(0.201, 0.1), too_far);
  ExpectPose("screw", Vector3(0, 0, 0.21) + 0.201 * Vector3(0.6, 0, 0.8), {0, 0, 0});
  EXPECT_EQ(fasten_from(0.099, 0.05), "");
  EXPECT_EQ(fasten_from(0.101, 0.05), too_far);
}

TEST_F(BondsTest, AGuestGoesToTheNearestFreeHostThatFits) {
  scene::ObjectSpec nearest = Nut("m6", {0, 0, 0.055});
  HostPointOf(nearest).type = "m6";
  Start({nearest, Nut("far", {0.15, 0, 0.055}), Nut("near", {0, 0.13, 0.055}),
         Screw("screw", {0.01, 0, 0.25}), Screw("second", {0.01, 0.02, 0.5})});
  EXPECT_EQ(Fasten("screw"), "");
  EXPECT_EQ(TightnessOf("near_hole"), 1);
  BodyOf("second").SetPose(RigidTransform(Vector3(0.01, 0, 0.25)));
  EXPECT_EQ(Fasten("second"), "");
  EXPECT_EQ(TightnessOf("far_hole"), 1) << "the near one is taken";
  EXPECT_EQ(TightnessOf("m6_hole"), 0);
}

TEST_F(BondsTest, TheGuestPointNearestToTheHandIsMeant) {
  scene::ObjectSpec rod = Screw("rod", {0, 0, 0.24});
  auto& guests = std::get<scene::Composite>(rod.whole.shape).guests;
  guests.push_back({.id = "rod_end", .type = "m8", .X_PG = RigidTransform(Vector3(0, 0, 0.1))});
  Start({Nut("nut", {0, 0, 0.055}), rod});
  const Object& object = *tabletop_->Find("rod");
  EXPECT_EQ(tabletop_->Fasten(object, {0, 0, 0.4}),
            "no free point that fits 'rod_end' is within two units");
  EXPECT_EQ(tabletop_->Fasten(object, {0, 0, 0.2}), std::nullopt);
  EXPECT_EQ(tabletop_->Loosen(object, {0, 0, 0.4}), "'rod' is not fastened there");
  EXPECT_EQ(TightnessOf("nut_hole"), 1);
}

/// A block with a hole in its upper side and a plug in its lower.
scene::ObjectSpec Brick(const std::string& id, const Vector3& p_WB,
                        const std::string& initial_host = "") {
  scene::Composite brick;
  brick.parts = {BlockPart({0.1, 0.1, 0.1})};
  brick.hosts = {{.id = id + "_top",
                  .type = "brick",
                  .X_PH = RigidTransform(Vector3(0, 0, 0.05)),
                  .stages = {{.X_HS = {RotationFromFixedAxes({0, 0, 10}), {0.01, 0, 0.001}}}}}};
  brick.guests = {{.id = id + "_bottom",
                   .type = "brick",
                   .X_PG = RigidTransform(Vector3(0, 0, -0.05)),
                   .initial_host = initial_host,
                   .initial_tightness = initial_host.empty() ? 0 : 1}};
  return ObjectAt(id, brick, p_WB);
}

TEST_F(BondsTest, NothingIsFastenedToItselfOrInALoop) {
  const char* nothing = "no free point that fits 'a_bottom' is within two units";
  Start({Brick("a", {0, 0, 0.051}), Brick("b", {0, 0, 0.5})});
  EXPECT_EQ(Fasten("a"), nothing) << "its own hole is not meant";
  BodyOf("b").SetPose(RigidTransform(Vector3(0, 0, 0.16)));
  EXPECT_EQ(Fasten("b"), "");
  EXPECT_EQ(TightnessOf("a_top"), 1);
  // As if the bond had been torn: b's hole is free and near a's plug.
  const RigidTransform X_WB_beside(Vector3(0.12, 0, 0.051));
  BodyOf("b").SetPose(X_WB_beside);
  EXPECT_EQ(Fasten("a"), nothing) << "they would hold each other";
  EXPECT_EQ(Loosen("b"), "");
  BodyOf("b").SetPose(X_WB_beside);
  EXPECT_EQ(Fasten("a"), "");
}

TEST_F(BondsTest, HoldFromTheStartInAnyOrderOfObjects) {
  const std::vector<scene::ObjectSpec> bricks = {
      Brick("a", {0.3, 0.2, 0.05}), Brick("b", {-0.5, 0, 0.05}, "a_top"),
      Brick("c", {-0.3, 0, 0.05}, "b_top"), Brick("d", {0, 0, 0.5}, "c_top")};
  RigidTransform X_WD(Vector3(0.3, 0.2, 0.05));
  for (int i = 0; i < 3; ++i) {
    X_WD = X_WD * RigidTransform(RotationFromFixedAxes({0, 0, 10}), Vector3(0.01, 0, 0.101));
  }
  std::vector<std::size_t> order(bricks.size());
  std::iota(order.begin(), order.end(), 0u);
  do {
    std::vector<scene::ObjectSpec> objects;
    for (std::size_t i : order) objects.push_back(bricks[i]);
    Start(std::move(objects));
    ExpectPose("a", {0.3, 0.2, 0.05}, {0, 0, 0});
    ExpectPose("b", {0.31, 0.2, 0.151}, {0, 0, 10});
    ExpectPose("d", X_WD.translation(), {0, 0, 30});
    EXPECT_EQ(world_->joints().size(), 3u);
  } while (std::ranges::next_permutation(order).found && !HasFailure());
}

class NoRoomTest : public WorkshopTest {
 protected:
  /// Expects that fastening is refused for this reason and changes nothing.
  void ExpectRefusal(std::string_view id, const std::string& reason) {
    const TabletopState before = tabletop_->state();
    const std::uint64_t hash = world_->state_hash();
    const std::string refusal = Fasten(id);
    EXPECT_NE(refusal.find(reason), std::string::npos) << refusal;
    EXPECT_TRUE(tabletop_->state() == before);
    EXPECT_EQ(world_->state_hash(), hash);
  }
};

TEST_F(NoRoomTest, NothingIsPutIntoAnother) {
  Start({Nut("nut", {0, 0, 0.055}), Screw("screw", {0.1, 0, 0.25}),
         ObjectAt("shelf", scene::Block{{0.1, 0.1, 0.02}}, {0, 0.06, 0.28}, /*mass=*/0)});
  ExpectRefusal("screw", "there is no room for 'screw': 'shelf' is in the way");
  tabletop_->Destroy(*tabletop_->Find("shelf"));
  EXPECT_EQ(Fasten("screw"), "");
}

TEST_F(NoRoomTest, NothingIsPutIntoTheTable) {
  scene::ObjectSpec nut = Nut("nut", {0, 0, 0.055}, 4);
  HostPointOf(nut).stages[3].X_HS = RigidTransform(Vector3(0, 0, -0.12));
  Start({nut, Screw("screw", {0, 0, 0.5}, "nut_hole", 3)});
  ExpectRefusal("screw", "is in the way");
}

TEST_F(NoRoomTest, ObjectsAttachedToTheGuestNeedSpace) {
  // A brick hangs low on the side of the screw's head.
  scene::ObjectSpec screw = Screw("screw", {0, 0, 0.3});
  auto& parts = std::get<scene::Composite>(screw.whole.shape);
  parts.hosts = {{.id = "hook",
                  .type = "brick",
                  .X_PH = RigidTransform(Vector3(0.12, 0, -0.1)),
                  .stages = {{.X_HS = {}}}}};
  Start({Nut("nut", {0, 0, 0.055}), screw, Brick("weight", {0.5, 0, 0.2}, "hook"),
         ObjectAt("stop", scene::Block{{0.04, 0.04, 0.04}}, {0.085, 0.085, 0.15}, /*mass=*/0)});
  // At 45 degrees the weight would stand where the stop is; the screw itself has room.
  ExpectRefusal("screw", "'stop' is in the way");
}

TEST_F(NoRoomTest, NorIsItPutIntoWhatHangsOnTheSameHost) {
  scene::Composite plate;
  plate.parts = {BlockPart({0.3, 0.1, 0.02})};
  for (int i = 0; i < 2; ++i) {
    plate.hosts.push_back({.id = "hole" + std::to_string(i),
                           .type = "m8",
                           .X_PH = RigidTransform(Vector3(-0.05 + 0.1 * i, 0, 0.03)),
                           .stages = {{.X_HS = {}}, {.X_HS = {}}}});
  }
  // The second stage of the first screw is where the second one stands.
  plate.hosts[0].stages[1].X_HS = RigidTransform(Vector3(0.1, 0.01, 0));
  Start({ObjectAt("plate", plate, {0, 0, 0.01}), Screw("one", {0, 0, 0.4}, "hole0"),
         Screw("two", {0.3, 0, 0.4}, "hole1")});
  ExpectRefusal("one", "there is no room for 'one': 'two' is in the way");
}

TEST_F(NoRoomTest, FixedObjectsDoNotMove) {
  scene::ObjectSpec screw = Screw("screw", {0, 0, 0.24});
  screw.mass = 0;
  Start({Nut("nut", {0, 0, 0.055}), screw, ObjectAt("b", scene::Block{}, {0.5, 0, 0.05})});
  ExpectRefusal("screw", "'screw' is fixed (its mass is 0)");
  ExpectRefusal("b", "'b' has nothing to fasten it by");
}

TEST_F(NoRoomTest, ASliderOnAFixedRailStaysOnIt) {
  scene::SceneSpec scene{.name = "rail"};
  scene.objects = {ObjectAt("rail", scene::Block{{0.5, 0.02, 0.02}}, {0, 0, 0.5}, /*mass=*/0),
                   Screw("cart", {0, 0, 0.24}), Nut("nut", {0.05, 0, 0.055})};
  scene.sliders = {{.X_WJ = RigidTransform(Vector3(0, 0, 0.5)),
                    .X_JB = RigidTransform(Vector3(0, 0, -0.26)),
                    .min_offset = -0.2,
                    .max_offset = 0.2,
                    .initial_offset = 0}};
  Start(scene);
  ExpectRefusal("cart", "'cart' is connected to a fixed object and cannot move there");
}

TEST_F(BondsTest, ObjectsAttachedToTheGuestMoveAlong) {
  Start({Brick("a", {0, 0, 0.051}), Brick("b", {0.1, 0.1, 0.2}),
         Brick("c", {0.1, 0.1, 0.5}, "b_top")});
  ExpectPose("c", {0.11, 0.1, 0.301}, {0, 0, 10});
  EXPECT_EQ(Fasten("b"), "");
  ExpectPose("b", {0.01, 0, 0.152}, {0, 0, 10});
  const RigidTransform X_BC(RotationFromFixedAxes({0, 0, 10}), Vector3(0.01, 0, 0.101));
  ExpectPose("c", PoseOf("b") * X_BC.translation(), {0, 0, 20});
}

}  // namespace
}  // namespace smile::world
