// Collision solids change with the state of controls.

#include "workshop.h"

namespace smile::world {
namespace {

class FormsTest : public WorkshopTest {
 protected:
  /// A gate across the table at x = 0: down when closed, up or nowhere when open.
  static scene::CustomControl GateThat(const std::string& opens) {
    const auto beam = [](double height) {
      scene::Part part = BlockPart({0.05, 0.5, 0.1}, {0, 0, height});
      part.next_state = 1;
      return part;
    };
    scene::CustomControl gate{.name = "gate"};
    gate.states = {{.name = "closed", .parts = {beam(0)}}, {.name = "open", .parts = {}}};
    if (opens == "upwards") gate.states[1].parts = {beam(0.3)};
    return gate;
  }
  void RollABall() {
    physics::Body& ball = BodyOf("ball");
    ball.SetPose(RigidTransform(Vector3(-0.3, 0, 0.04)));
    ball.SetVelocity({0.6, 0, 0}, {0, 15, 0});
    StepSeconds(1);
  }
  static scene::ObjectSpec Ball() { return ObjectAt("ball", scene::Sphere{0.04}, {-0.3, 0, 0.04}); }
};

TEST_F(FormsTest, ABallPassesAnOpenGate) {
  for (const char* opens : {"upwards", "away"}) {
    Start({ObjectAt("gate", GateThat(opens), {0, 0, 0.06}, /*mass=*/0), Ball()});
    RollABall();
    EXPECT_LT(PositionOf("ball").x(), -0.06) << opens;
    EXPECT_EQ(Trigger("gate"), "") << opens;
    EXPECT_EQ(StateOf("gate"), "open");
    RollABall();
    EXPECT_GT(PositionOf("ball").x(), 0.1) << opens;
  }
}

TEST_F(FormsTest, AGateThatIsPartOfAHeavyObjectOpens) {
  scene::Composite bridge;
  bridge.parts = {
      BlockPart({0.1, 0.1, 0.4}, {0, -0.4, 0}),
      BlockPart({0.1, 0.1, 0.4}, {0, 0.4, 0}),
      {.id = "gate", .X_PE = RigidTransform(Vector3(0, 0, -0.14)), .shape = GateThat("upwards")}};
  Start({ObjectAt("bridge", bridge, {0, 0, 0.2}, /*mass=*/5), Ball()});
  StepSeconds(0.2);
  RollABall();
  EXPECT_LT(PositionOf("ball").x(), -0.06);
  EXPECT_EQ(Trigger("gate"), "");
  EXPECT_LT((PositionOf("bridge") - Vector3(0, 0, 0.2)).norm(), 0.002) << "it stays";
  RollABall();
  EXPECT_GT(PositionOf("ball").x(), 0.1);
  EXPECT_LT((PositionOf("bridge") - Vector3(0, 0, 0.2)).norm(), 0.002) << "it still stands";
}

TEST_F(FormsTest, ASwitchCollidesInItsPosition) {
  scene::ToggleSwitch toggle{.size = {0.2, 0.1, 0.02}, .angle = DegreesToRadians(30)};
  Start({ObjectAt("switch", toggle, {0, 0, 0.1}, /*mass=*/0),
         ObjectAt("probe", scene::Sphere{0.005}, {0.5, 0, 0.5})});
  const physics::BodyId probe = tabletop_->Find("probe")->body;
  const auto is_felt_at = [&](double x) {
    // The outer end of a raised button is some 5 cm higher than that of a pressed one.
    const RigidTransform X_WProbe(Vector3(x, 0, 0.1 + 0.05));
    return !world_->OverlapsAt(probe, X_WProbe, 0.001).bodies.empty();
  };
  EXPECT_FALSE(is_felt_at(-0.08)) << "left lies flat";
  EXPECT_TRUE(is_felt_at(0.08)) << "right is raised";
  EXPECT_EQ(Trigger("switch", "switch-b2"), "");
  EXPECT_EQ(StateOf("switch"), "1");
  EXPECT_TRUE(is_felt_at(-0.08));
  EXPECT_FALSE(is_felt_at(0.08));
}

TEST_F(FormsTest, AnObjectOnAControlWakesAndFalls) {
  scene::CustomControl lift{.name = "lift"};
  for (double height : {0.2, 0.1}) {
    scene::Part platform = BlockPart({0.2, 0.2, height}, {0, 0, height / 2});
    platform.next_state = height > 0.15 ? 1 : 0;
    lift.states.push_back({.name = height > 0.15 ? "up" : "down", .parts = {platform}});
  }
  Start({ObjectAt("lift", lift, {0, 0, 0}, /*mass=*/0),
         ObjectAt("block", scene::Block{}, {0, 0, 0.251}),
         ObjectAt("elsewhere", scene::Block{}, {0.7, 0, 0.05})});
  StepSeconds(3);
  ASSERT_FALSE(BodyOf("block").is_awake());
  ASSERT_NEAR(PositionOf("block").z(), 0.25, 0.001);
  EXPECT_EQ(Trigger("lift"), "");
  EXPECT_TRUE(BodyOf("block").is_awake());
  EXPECT_FALSE(BodyOf("elsewhere").is_awake());
  StepSeconds(1);
  EXPECT_NEAR(PositionOf("block").z(), 0.15, 0.001);
}

TEST_F(FormsTest, ABondFlipsWhatItSetsFromTheStartAndLater) {
  scene::ObjectSpec nut = Nut("nut", {-0.5, 0, 0.055}, 1);
  HostPointOf(nut).downstream = "gate";
  Start({nut, Screw("screw", {-0.5, 0, 0.5}, "nut_hole"),
         ObjectAt("gate", GateThat("upwards"), {0, 0, 0.06}, /*mass=*/0), Ball()});
  ASSERT_EQ(StateOf("gate"), "open");
  RollABall();
  EXPECT_GT(PositionOf("ball").x(), 0.1);
  EXPECT_EQ(Loosen("screw"), "");
  RollABall();
  EXPECT_LT(PositionOf("ball").x(), -0.06);
}

TEST_F(FormsTest, DestroyedObjectsCanNeitherBeTriggeredNorTouched) {
  Start({ObjectAt("gate", GateThat("upwards"), {0, 0, 0.06}, /*mass=*/0), Ball()});
  tabletop_->Destroy(*tabletop_->Find("gate"));
  EXPECT_EQ(Trigger("gate"), "there is no control 'gate'");
  RollABall();
  EXPECT_GT(PositionOf("ball").x(), 0.1);
}

}  // namespace
}  // namespace smile::world
