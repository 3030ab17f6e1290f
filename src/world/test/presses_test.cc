#include "workshop.h"

namespace smile::world {
namespace {

/// A fixed panel with a switch of 0.12 x 0.06 m, whose right button is raised.
scene::ObjectSpec SwitchPanel(const scene::TriggerRule& rule = scene::ToggleSwitch().trigger) {
  scene::Composite panel;
  panel.parts = {BlockPart({0.2, 0.2, 0.04}),
                 {.id = "power",
                  .X_PE = RigidTransform(Vector3(0, 0, 0.02)),
                  .shape = scene::ToggleSwitch{.size = {0.12, 0.06, 0.02},
                                               .angle = DegreesToRadians(12),
                                               .num_states = 4,
                                               .trigger = rule}}};
  return ObjectAt("panel", panel, {0, 0, 0.02}, /*mass=*/0);
}

/// A door bell: a button that stands out of a fixed wall, along -y, and goes in when it is pushed.
scene::ObjectSpec Bell() {
  scene::CustomControl bell;
  for (int state = 0; state < 2; ++state) {
    bell.states.push_back(
        {.name = state == 0 ? "out" : "in",
         .parts = {{.X_PE = {RotationFromFixedAxes({180, 0, 0}), Vector3(0, -0.02, 0)},
                    .next_state = 1 - state,
                    .trigger = scene::TriggerRule{.cause = scene::TriggerCause::kPress},
                    .shape = scene::Cylinder{.radius = 0.02, .length = 0.04}}}});
  }
  scene::ObjectSpec object = ObjectAt("bell", bell, {0, 0, 0.05}, /*mass=*/0);
  return object;
}

class PressesTest : public WorkshopTest {
 protected:
  /// Advances and counts the presses.
  int TickSeconds(double seconds) {
    int count = 0;
    for (int tick = 0; tick < seconds * 60; ++tick) {
      for (int step = 0; step < 8; ++step) {
        world_->Step();
        tabletop_->NoticePushes();
      }
      count += static_cast<int>(tabletop_->PressControls(1.0 / 60).size());
    }
    return count;
  }
  /// A cube of 4 cm above the raised button, whose upper side is at z = 0.06.
  static scene::ObjectSpec Cube(double mass, double z = 0.1, double x = 0.03) {
    return ObjectAt("cube", scene::Block{{0.04, 0.04, 0.04}}, {x, 0, z}, mass);
  }
};

TEST_F(PressesTest, AFallingBlockPressesTheRaisedButtonOnce) {
  Start({SwitchPanel(), Cube(1)});
  EXPECT_EQ(TickSeconds(3), 1);
  EXPECT_EQ(StateOf("power"), "1");
}

TEST_F(PressesTest, ALightBlockIsBelowTheThreshold) {
  Start({SwitchPanel(), Cube(0.02)});
  EXPECT_EQ(TickSeconds(2), 0);
  Start({SwitchPanel({.cause = scene::TriggerCause::kPress, .press_force = 0.1}), Cube(0.02)});
  EXPECT_EQ(TickSeconds(2), 1);
}

TEST_F(PressesTest, ASleepingWeightKeepsItPressedAndTheNextOnePressesAgain) {
  Start({SwitchPanel(), Cube(1)});
  ASSERT_EQ(TickSeconds(3), 1);
  ASSERT_FALSE(BodyOf("cube").is_awake());
  BodyOf("cube").WakeUp();
  EXPECT_EQ(TickSeconds(2), 0) << "it pressed again when it woke";
  // The left button is the raised one now.
  BodyOf("cube").SetPose(RigidTransform(Vector3(0.3, 0, 0.3)));
  EXPECT_EQ(TickSeconds(0.5), 0);
  BodyOf("cube").SetPose(RigidTransform(Vector3(-0.03, 0, 0.1)));
  EXPECT_EQ(TickSeconds(1), 1);
  EXPECT_EQ(StateOf("power"), "0");
}

TEST_F(PressesTest, APushFromTheSideIsBeyondTheAngle) {
  for (const bool is_straight : {true, false}) {
    Start({Bell(), ObjectAt("cube", scene::Block{{0.03, 0.03, 0.03}}, {0, 0, 0.5})});
    physics::Body& cube = BodyOf("cube");
    cube.SetCarried(true);
    cube.SetPose(
        RigidTransform(is_straight ? Vector3(0, -0.08, 0.05) : Vector3(0.06, -0.02, 0.05)));
    int count = 0;
    for (int i = 0; i < 30; ++i) {
      cube.SetVelocity(is_straight ? Vector3(0, 0.2, 0) : Vector3(-0.2, 0, 0), Vector3::Zero());
      count += TickSeconds(1.0 / 60);
    }
    EXPECT_EQ(count, is_straight ? 1 : 0);
  }
}

TEST_F(PressesTest, HandsOnlyMeansThatContactDoesNothing) {
  Start({SwitchPanel({.cause = scene::TriggerCause::kHand}), Cube(1)});
  EXPECT_FALSE(tabletop_->has_pressable_controls());
  EXPECT_EQ(TickSeconds(1), 0);
  EXPECT_EQ(Trigger("power"), "");
}

TEST_F(PressesTest, ScenesOfAnOlderVersionOfThePhysicsAreNotPressed) {
  Start(scene::SceneSpec{.objects = {SwitchPanel(), Cube(1)}, .physics_version = 3});
  EXPECT_EQ(TickSeconds(1), 0);
}

}  // namespace
}  // namespace smile::world
