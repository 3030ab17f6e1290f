// Effects of bonds on controls and on other bonds.

#include "workshop.h"

namespace smile::world {
namespace {

class BondEffectsTest : public WorkshopTest {};

TEST_F(BondEffectsTest, TheTightnessIsTheControlsStateAndStaysWithIt) {
  scene::ObjectSpec nut = Nut("nut", {0, 0, 0.055});
  HostPointOf(nut).downstream = "first";
  // The controls come later than the host, and are found all the same.
  Start({Screw("screw", {0, 0, 0.5}, "nut_hole"), nut, Lamps("first", 3, {"second"}),
         Lamps("second", 3)});
  EXPECT_EQ(StateOf("first"), "1");
  EXPECT_EQ(Fasten("screw"), "");
  EXPECT_EQ(StateOf("first"), "2");
  EXPECT_EQ(StateOf("second"), "0") << "what is behind it is not driven";
  EXPECT_EQ(Fasten("screw"), "");
  EXPECT_EQ(StateOf("first"), "2") << "it has no state 3";
  EXPECT_EQ(Loosen("screw"), "");
  EXPECT_EQ(StateOf("first"), "2");
  EXPECT_EQ(Loosen("screw"), "");
  EXPECT_EQ(Loosen("screw"), "");
  EXPECT_EQ(StateOf("first"), "0");
}

/// A valve, a ball and a stepper: the valve's tightness is the lamp's state, the ball's second
/// stage forces state 4 upon it, the stepper's third locks the valve.
class ValveTest : public WorkshopTest {
 protected:
  ValveTest() {
    scene::ObjectSpec ball_seat = Nut("seat", {0.3, 0, 0.055});
    HostPointOf(ball_seat).downstream_override = "lamp";
    HostPointOf(ball_seat).stages[1].downstream_state = 4;
    scene::ObjectSpec stepper_nut = Nut("guard", {0.6, 0, 0.055});
    HostPointOf(stepper_nut).downstream_lock = "pipe_hole";
    HostPointOf(stepper_nut).stages[2].locks_downstream = true;
    scene::ObjectSpec pipe = Nut("pipe", {0, 0, 0.055}, 4);
    HostPointOf(pipe).downstream = "lamp";
    for (int k = 0; k < 4; ++k) {
      HostPointOf(pipe).stages[static_cast<std::size_t>(k)].X_HS =
          RigidTransform(Vector3(0, 0, -0.02 * (k + 1)));
    }
    Start({ball_seat, stepper_nut, pipe, Screw("ball", {0, 0.4, 0.2}, "seat_hole"),
           Screw("stepper", {0.3, 0.4, 0.2}, "guard_hole"),
           Screw("valve", {0.6, 0.4, 0.2}, "pipe_hole"), Lamps("lamp", 5)});
  }
  ControlState Lamp() { return tabletop_->controls().states().at(0); }
};

TEST_F(ValveTest, AForcedStateIsShownUntilItsBondIsLooser) {
  EXPECT_EQ(StateOf("lamp"), "1");
  EXPECT_EQ(Fasten("valve"), "");
  EXPECT_EQ(StateOf("lamp"), "2");
  EXPECT_EQ(Fasten("ball"), "");
  EXPECT_EQ(StateOf("lamp"), "4");
  EXPECT_EQ(Fasten("valve"), "");
  EXPECT_EQ(StateOf("lamp"), "4") << "forced";
  EXPECT_EQ(Lamp(), (ControlState{.state = 3, .override_state = 4})) << "and continues beneath";
  EXPECT_EQ(Loosen("ball"), "");
  EXPECT_EQ(StateOf("lamp"), "3");
  EXPECT_EQ(Fasten("ball"), "");
  EXPECT_EQ(StateOf("lamp"), "4");
  EXPECT_EQ(Fasten("ball"), "");
  EXPECT_EQ(StateOf("lamp"), "3") << "the third stage forces nothing";
}

TEST_F(ValveTest, ALockedHostIsNeitherFastenedNorLoosened) {
  EXPECT_EQ(Fasten("stepper"), "");
  EXPECT_EQ(Fasten("valve"), "");
  EXPECT_EQ(Fasten("stepper"), "");
  EXPECT_EQ(Fasten("valve"), "'pipe_hole' is locked");
  EXPECT_EQ(Loosen("valve"), "'pipe_hole' is locked");
  EXPECT_EQ(TightnessOf("pipe_hole"), 2);
  EXPECT_EQ(StateOf("lamp"), "2");
  EXPECT_EQ(Loosen("stepper"), "");
  EXPECT_EQ(Fasten("valve"), "");
}

TEST_F(ValveTest, ADestroyedValveForcesAndLocksNothing) {
  EXPECT_EQ(Fasten("ball"), "");
  EXPECT_EQ(Fasten("stepper"), "");
  EXPECT_EQ(Fasten("stepper"), "");
  ASSERT_EQ(StateOf("lamp"), "4");
  tabletop_->Destroy(*tabletop_->Find("seat"));
  EXPECT_EQ(StateOf("lamp"), "1");
  tabletop_->Destroy(*tabletop_->Find("stepper"));
  EXPECT_EQ(TightnessOf("guard_hole"), 0);
  EXPECT_EQ(Loosen("valve"), "");
  EXPECT_EQ(StateOf("lamp"), "0");
}

TEST_F(BondEffectsTest, ALockedHostIsPassedOverForAnother) {
  scene::ObjectSpec key = Nut("key", {0.6, 0, 0.055});
  HostPointOf(key).downstream_lock = "near_hole";
  HostPointOf(key).stages[0].locks_downstream = true;
  Start({key, Screw("lock", {0, 0, 0.5}, "key_hole"), Nut("near", {0, 0, 0.055}),
         Nut("other", {0.14, 0, 0.055}), Screw("screw", {0.01, 0, 0.23})});
  EXPECT_EQ(Fasten("screw"), "");
  EXPECT_EQ(TightnessOf("other_hole"), 1);
  EXPECT_EQ(Loosen("screw"), "");
  tabletop_->Destroy(*tabletop_->Find("other"));
  EXPECT_EQ(Fasten("screw"), "the point that fits 'screw_tip' is locked");
}

TEST_F(BondEffectsTest, AGuestIsFreeWhenItsHostIsDestroyed) {
  Start({Nut("nut", {0, 0, 0.055}), Nut("other", {0.15, 0, 0.055}),
         Screw("screw", {0, 0, 0.5}, "nut_hole", 2)});
  StepSeconds(0.5);
  const double height = PositionOf("screw").z();
  tabletop_->Destroy(*tabletop_->Find("nut"));
  EXPECT_TRUE(world_->joints().empty());
  EXPECT_EQ(Loosen("screw"), "'screw' is not fastened there");
  EXPECT_NEAR(PositionOf("screw").z(), height, 1e-9) << "it is not put anywhere";
  EXPECT_EQ(Fasten("screw"), "");
  EXPECT_EQ(TightnessOf("other_hole"), 1) << "from the first stage on";
  EXPECT_EQ(TightnessOf("nut_hole"), 0);
  tabletop_->Destroy(*tabletop_->Find("other"));
  EXPECT_EQ(Fasten("screw"), "no free point that fits 'screw_tip' is within two units");
  StepSeconds(0.5);
  EXPECT_LT(PositionOf("screw").z(), 0.13) << "it falls";
}

}  // namespace
}  // namespace smile::world
