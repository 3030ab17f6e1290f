// Hands and controls, bonds and whole objects, except carrying.

#include <gtest/gtest.h>

#include "demonstrator/demonstrator.h"
#include "math/angles.h"

namespace smile::demonstrator {
namespace {

scene::ObjectSpec ObjectAt(std::string id, scene::Shape shape, const Vector3& p_WB,
                           double mass = 1) {
  return {.whole = {.id = std::move(id), .X_PE = RigidTransform(p_WB), .shape = std::move(shape)},
          .mass = mass};
}

/// A nut and two pegs that fit it, a switch on a panel with a pointable plate, a block on a base.
class MechanismHandsTest : public ::testing::Test {
 protected:
  MechanismHandsTest() {
    scene::Composite nut, panel;
    nut.parts = {{.X_PE = {}, .shape = scene::Ring{0.06, 0.03, 0.1, 12}}};
    nut.hosts = {{.id = "hole", .type = "m8", .X_PH = {}}};
    for (int k = 1; k <= 2; ++k) {
      nut.hosts[0].stages.push_back(
          {.X_HS = {RotationFromFixedAxes({0, 0, 45.0 * k}), Vector3(0, 0, 0.06 - 0.03 * k)}});
    }
    panel.parts = {
        {.id = "plate", .is_pointable = true, .shape = scene::Block{}},
        {.id = "back", .X_PE = RigidTransform(Vector3(0.1, 0, 0)), .shape = scene::Block{}},
        {.id = "power",
         .X_PE = RigidTransform(Vector3(0, 0, 0.05)),
         .shape = scene::ToggleSwitch{}}};
    Start({.name = "test",
           .objects = {ObjectAt("nut", nut, {0, 0, 0.05}),
                       ObjectAt("peg", Peg("peg"), {0.1, 0, 0.15}, 0.2),
                       ObjectAt("panel", panel, {-0.5, 0.3, 0.05}, 0),
                       ObjectAt("base", scene::Block{}, {0.5, 0, 0.05}),
                       ObjectAt("top", scene::Block{}, {0.5, 0, 0.15})}});
  }
  void Start(const scene::SceneSpec& scene) {
    tabletop_.reset();
    world_ = std::make_unique<physics::World>();
    tabletop_ = std::make_unique<world::Tabletop>(world_.get(), scene);
    hands_ = std::make_unique<Demonstrator>(world_.get(), tabletop_.get());
  }
  static scene::Composite Peg(const std::string& id) {
    scene::Composite peg;
    peg.parts = {{.X_PE = {}, .shape = scene::Block{{0.03, 0.03, 0.2}}}};
    peg.guests = {{.id = id + "_tip", .type = "m8", .X_PG = RigidTransform(Vector3(0, 0, -0.1))}};
    return peg;
  }
  void StepSeconds(double seconds) {
    for (int i = 0; i < seconds * 480; ++i) {
      hands_->BeforeStep();
      world_->Step();
    }
  }
  RigidTransform PoseOf(std::string_view id) const {
    return world_->body(tabletop_->Find(id)->body).pose_in_world();
  }
  Vector3 PositionOf(std::string_view id) const { return PoseOf(id).translation(); }
  double YawOf(std::string_view id) const { return FixedAxesAngles(PoseOf(id).rotation()).z(); }
  void Grasp(HandName hand, std::string_view id) {
    ASSERT_EQ(hands_->Grasp(hand, id, std::nullopt), std::nullopt);
  }
  std::string Fasten(HandName hand, std::string_view id) {
    return hands_->Fasten(hand, id, std::nullopt).value_or("");
  }

  static constexpr HandName kLeft = HandName::kLeft, kRight = HandName::kRight;
  std::unique_ptr<physics::World> world_;
  std::unique_ptr<world::Tabletop> tabletop_;
  std::unique_ptr<Demonstrator> hands_;
};

TEST_F(MechanismHandsTest, ADestroyedObjectIsRemovedAndFreesTheHand) {
  EXPECT_EQ(hands_->Destroy(kLeft), "the left hand holds nothing");
  StepSeconds(2);
  Grasp(kLeft, "base");
  Grasp(kRight, "peg");
  EXPECT_EQ(hands_->Destroy(kLeft), std::nullopt);
  EXPECT_EQ(tabletop_->Find("base"), nullptr);
  EXPECT_FALSE(hands_->hand(kLeft).is_holding());
  EXPECT_TRUE(hands_->hand(kRight).is_holding());
  EXPECT_EQ(hands_->Grasp(kLeft, "base", std::nullopt),
            "'base' no longer exists: it was destroyed");
  EXPECT_EQ(hands_->PointAt(kLeft, "base"), "'base' no longer exists: it was destroyed");
  Grasp(kLeft, "nut");
  StepSeconds(1);
  EXPECT_NEAR(PositionOf("top").z(), 0.05, 0.001) << "nothing carries it";
}

TEST_F(MechanismHandsTest, AnEmptyHandPointsAtObjectsAndPointableParts) {
  EXPECT_EQ(hands_->PointAt(kLeft, "top"), std::nullopt);
  EXPECT_EQ(hands_->PointAt(kLeft, "plate"), std::nullopt);
  EXPECT_EQ(hands_->PointAt(kLeft, "back"),
            "there is no object 'back', and no pointable part with this id");
  Grasp(kLeft, "top");
  EXPECT_EQ(hands_->PointAt(kLeft, "plate"),
            "the left hand holds 'top'; it must be empty to point");
  EXPECT_EQ(hands_->PointAt(kRight, "plate"), std::nullopt);
}

TEST_F(MechanismHandsTest, OnlyAnEmptyHandTriggers) {
  Grasp(kLeft, "top");
  const auto position = [&] { return tabletop_->controls().states().at(0).position; };
  EXPECT_EQ(hands_->Trigger(kLeft, "power", ""),
            "the left hand holds 'top'; it must be empty to trigger a control");
  EXPECT_EQ(position(), 0);
  EXPECT_EQ(hands_->Trigger(kRight, "power", ""), std::nullopt);
  EXPECT_EQ(position(), 1);
  EXPECT_EQ(hands_->Trigger(kRight, "panel", ""), "there is no control 'panel'");
}

TEST_F(MechanismHandsTest, TheGoalOfAHandIsWhereItFastenedTheObject) {
  Grasp(kLeft, "peg");
  ASSERT_EQ(hands_->MoveTo(kLeft, {0.1, 0, 0.3}, std::nullopt), std::nullopt);
  StepSeconds(0.3);
  ASSERT_EQ(Fasten(kLeft, "peg"), "");
  StepSeconds(1);
  // With its old goal, it would drag the nut there.
  EXPECT_LT((PositionOf("nut") - Vector3(0, 0, 0.05)).norm(), 0.001);
  EXPECT_LT((PositionOf("peg") - Vector3(0, 0, 0.05 + 0.03 + 0.1)).norm(), 0.001);
  EXPECT_NEAR(YawOf("peg"), 45, 0.2);
  EXPECT_TRUE(hands_->has_arrived());

  ASSERT_EQ(Fasten(kLeft, "peg"), "");
  StepSeconds(1);
  EXPECT_LT((PositionOf("nut") - Vector3(0, 0, 0.05)).norm(), 0.001);
  EXPECT_NEAR(YawOf("peg"), 90, 0.2);

  ASSERT_EQ(hands_->MoveTo(kLeft, {0, 0, 0.45}, std::nullopt), std::nullopt);
  StepSeconds(1.5);
  EXPECT_LT((PositionOf("peg") - Vector3(0, 0, 0.45)).norm(), 0.001);
  EXPECT_LT((PositionOf("nut") - Vector3(0, 0, 0.35)).norm(), 0.002) << "it hangs on the peg";
}

TEST_F(MechanismHandsTest, AnotherHandMayTurnWhatAHandHolds) {
  Grasp(kLeft, "peg");
  StepSeconds(0.1);
  ASSERT_EQ(Fasten(kRight, "peg"), "");
  StepSeconds(1);
  EXPECT_TRUE(hands_->has_arrived());
  EXPECT_LT((PositionOf("nut") - Vector3(0, 0, 0.05)).norm(), 0.001);
  EXPECT_NEAR(YawOf("peg"), 45, 0.2);
}

TEST_F(MechanismHandsTest, AHandThatHoldsSomethingElseDoesNotFasten) {
  Grasp(kLeft, "top");
  EXPECT_EQ(Fasten(kLeft, "peg"),
            "the left hand holds 'top'; it must be empty to fasten or loosen anything else");
  EXPECT_EQ(tabletop_->bonds().states().at(0).tightness, 0);
  EXPECT_EQ(Fasten(kRight, "peg"), "");
  EXPECT_EQ(hands_->Loosen(kLeft, "peg", std::nullopt),
            "the left hand holds 'top'; it must be empty to fasten or loosen anything else");
  EXPECT_EQ(tabletop_->bonds().states().at(0).tightness, 1);
  EXPECT_EQ(hands_->Loosen(kRight, "gone", std::nullopt), "there is no object 'gone'");
}

TEST_F(MechanismHandsTest, LooseningSeparatesObjectsHeldByTwoHands) {
  ASSERT_EQ(Fasten(kLeft, "peg"), "");
  Grasp(kLeft, "peg");
  Grasp(kRight, "nut");
  ASSERT_EQ(hands_->MoveTo(kLeft, {0, 0, 0.48}, std::nullopt), std::nullopt);
  ASSERT_EQ(hands_->MoveTo(kRight, {0, 0, 0.35}, std::nullopt), std::nullopt);
  StepSeconds(1.5);
  EXPECT_TRUE(hands_->has_arrived());
  ASSERT_EQ(hands_->Loosen(kLeft, "peg", std::nullopt), std::nullopt);
  ASSERT_EQ(hands_->MoveTo(kLeft, {0.3, 0, 0.6}, std::nullopt), std::nullopt);
  StepSeconds(1.5);
  EXPECT_LT((PositionOf("peg") - Vector3(0.3, 0, 0.6)).norm(), 0.001);
  EXPECT_LT((PositionOf("nut") - Vector3(0, 0, 0.35)).norm(), 0.001) << "the other hand has it";
}

TEST_F(MechanismHandsTest, HandOverLeavesBondsAndPlaces) {
  ASSERT_EQ(Fasten(kLeft, "peg"), "");
  Grasp(kLeft, "peg");
  ASSERT_EQ(hands_->MoveTo(kLeft, {0, 0, 0.4}, std::nullopt), std::nullopt);
  StepSeconds(1.5);
  EXPECT_EQ(hands_->Grasp(kRight, "peg", std::nullopt),
            "the left hand holds 'peg'; release it first");
  EXPECT_TRUE(hands_->hand(kLeft).is_holding()) << "a refusal lets nothing fall";
  ASSERT_EQ(hands_->Release(kLeft), std::nullopt);
  Grasp(kRight, "peg");
  StepSeconds(1);
  EXPECT_LT((PositionOf("peg") - Vector3(0, 0, 0.4)).norm(), 0.001);
  EXPECT_LT((PositionOf("nut") - Vector3(0, 0, 0.27)).norm(), 0.002);
  EXPECT_EQ(tabletop_->bonds().states().at(0).tightness, 1);
}

TEST_F(MechanismHandsTest, TheHostOfABondMayBeDestroyedInTheHand) {
  ASSERT_EQ(Fasten(kLeft, "peg"), "");
  Grasp(kLeft, "nut");
  Grasp(kRight, "peg");
  ASSERT_EQ(hands_->Destroy(kLeft), std::nullopt);
  StepSeconds(0.5);
  EXPECT_LT((PositionOf("peg") - Vector3(0, 0, 0.18)).norm(), 0.001) << "the other hand has it";
  EXPECT_EQ(hands_->Loosen(kRight, "peg", std::nullopt), "'peg' is not fastened there");
}

TEST_F(MechanismHandsTest, ALidLiftedByAHandLiftsItsHeavyBox) {
  const scene::SliderSpec slider{.X_WJ = RigidTransform(Vector3(0, 0, 0.135)),
                                 .X_JB = RigidTransform(Vector3(0, 0, 0.15)),
                                 .max_offset = 0.6,
                                 .initial_offset = 0.37};
  scene::SceneSpec scene{.name = "lidbox"};
  scene.objects = {ObjectAt("box", scene::Box{{0.8, 0.6, 0.27}, 0.03}, {0, 0, 0.135}, 10),
                   ObjectAt("lid", scene::Block{{0.8, 0.6, 0.03}}, {-0.37, 0, 0.285}, 1)};
  scene.sliders = {slider};
  Start(scene);
  Grasp(kLeft, "lid");
  // Up to its limit, at which it drags the box along.
  ASSERT_EQ(hands_->MoveTo(kLeft, {0.05, 0, 0.285}, 0.3), std::nullopt);
  StepSeconds(2);
  // Near the goal the hand pulls less than friction holds the box.
  EXPECT_LT((PositionOf("box") - Vector3(0.05, 0, 0.135)).norm(), 0.008);
  ASSERT_EQ(hands_->MoveTo(kLeft, {0.05, 0, 0.5}, 0.3), std::nullopt);
  StepSeconds(2);
  EXPECT_LT((PositionOf("lid") - Vector3(0.05, 0, 0.5)).norm(), 0.002);
  EXPECT_LT((PositionOf("box") - Vector3(0.05, 0, 0.35)).norm(), 0.008) << "it hangs on its lid";
}

TEST_F(MechanismHandsTest, HandsCannotReachWhatFellToTheFloor) {
  const auto fall = [this](std::string_view id, double x) {
    world_->body(tabletop_->Find(id)->body).SetPose(RigidTransform(Vector3(x, 0, -0.7)));
    for (int i = 0; i < 480; ++i) {
      world_->Step();
      tabletop_->NoticeFallen();
    }
    ASSERT_TRUE(tabletop_->HasFallen(*tabletop_->Find(id)));
  };
  const std::string nut_fell = "'nut' fell to the floor; undo restores it";
  fall("nut", 1.5);
  EXPECT_EQ(hands_->Grasp(kLeft, "nut", std::nullopt), nut_fell);
  EXPECT_EQ(hands_->PointAt(kLeft, "nut"), nut_fell);
  EXPECT_EQ(hands_->Fasten(kLeft, "nut", std::nullopt), nut_fell);
  EXPECT_EQ(hands_->Loosen(kLeft, "nut", std::nullopt), nut_fell);
  // Nor fasten anything to it, however near.
  Grasp(kLeft, "peg");
  for (const Vector3& p_WH : {Vector3(0.1, 0, 0.6), Vector3(1.5, 0, 0.6), Vector3(1.5, 0, -0.65)}) {
    ASSERT_EQ(hands_->MoveTo(kLeft, p_WH, std::nullopt), std::nullopt);
    StepSeconds(2);
    ASSERT_TRUE(hands_->has_arrived());
  }
  EXPECT_EQ(hands_->Fasten(kLeft, "peg", std::nullopt),
            "no free point that fits 'peg_tip' is within two units");
}

TEST_F(MechanismHandsTest, AnObjectFastenedToAFixedOneCanBeGrasped) {
  scene::SceneSpec scene{.name = "test"};
  for (const world::Object& object : tabletop_->objects()) scene.objects.push_back(*object.spec);
  scene.objects[0].mass = 0;
  Start(scene);
  ASSERT_EQ(Fasten(kLeft, "peg"), "");
  EXPECT_EQ(hands_->Grasp(kLeft, "nut", std::nullopt), "'nut' is fixed (its mass is 0)");
  Grasp(kLeft, "peg");
  EXPECT_EQ(hands_->Loosen(kLeft, "peg", std::nullopt), std::nullopt);
  ASSERT_EQ(hands_->MoveTo(kLeft, {0, 0, 0.5}, std::nullopt), std::nullopt);
  StepSeconds(1);
  EXPECT_GT(PositionOf("peg").z(), 0.49);
}

}  // namespace
}  // namespace smile::demonstrator
