#include "world/tools.h"

#include "workshop.h"

namespace smile::world {
namespace {

scene::ObjectSpec Scissors(const Vector3& p_WB) {
  scene::ObjectSpec scissors = ObjectAt("Scissors", scene::Block{{0.02, 0.02, 0.02}}, p_WB);
  scissors.tool = scene::ToolSpec{
      .action = scene::ToolAction::kCut, .p_BT = {0, 0.02, 0}, .axis = {0, 2, 0}, .edge = 0.1};
  return scissors;
}

/// A driver upright, its tip 0.2 m below its origin.
scene::ObjectSpec Driver(const Vector3& p_WTip, const std::string& type = "phillips",
                         scene::ToolAction action = scene::ToolAction::kDrive) {
  scene::ObjectSpec driver =
      ObjectAt("Driver", scene::Block{{0.02, 0.02, 0.02}}, p_WTip + Vector3(0, 0, 0.2));
  driver.tool = scene::ToolSpec{.action = action, .type = type, .p_BT = {0, 0, -0.2}};
  return driver;
}

/// A screw of workshop.h whose head, 0.22 m above its tip, takes a screwdriver.
scene::ObjectSpec DrivenScrew(const Vector3& p_WB, int tightness) {
  scene::ObjectSpec screw = Screw("Screw", p_WB, tightness > 0 ? "Nut_hole" : "", tightness);
  GuestPointOf(screw).accepts = {{.type = "phillips", .p_GS = {0, 0, 0.22}}};
  GuestPointOf(screw).refuses_hands = true;
  return screw;
}

class ToolsTest : public WorkshopTest {
 protected:
  /// Returns what a tool did, or the refusal.
  std::string Use(std::string_view tool, bool loosens = false) {
    Refusal refusal;
    const auto use = tabletop_->PlanUse(*tabletop_->Find(tool), loosens, &refusal);
    if (!use) return refusal;
    tabletop_->Use(*use);
    return use->verb + " " + use->target;
  }
  /// Returns what a held tool could do.
  std::vector<std::string> PossibleUses(std::string_view tool) const {
    std::vector<std::string> uses;
    for (const ToolUse& use : tabletop_->PossibleUses({{.body = tabletop_->Find(tool)->body}})) {
      uses.push_back(use.verb + " " + use.target);
    }
    return uses;
  }
  /// Puts the driver's tip on the place of the screw, turned by an angle about the vertical.
  void PutDriver(double angle_deg, double tilt_deg = 0, double gap = 0) {
    const RigidTransform X_WScrew = PoseOf("Screw");
    const Matrix3 R = RotationFromFixedAxes({tilt_deg, 0, angle_deg});
    const Vector3 p_WTip = X_WScrew * Vector3(0, 0, 0.12) + Vector3(0, 0, gap);
    BodyOf("Driver").SetPose({R, p_WTip + R * Vector3(0, 0, 0.2)});
  }
  /// Ends a tick in which a hand or a gripper holds a tool.
  std::vector<std::string> EndTick(std::string_view tool, bool is_held = true,
                                   bool is_squeezing = false) {
    std::vector<Holder> holders;
    if (is_held) {
      holders.push_back(
          {.body = tabletop_->Find(tool)->body, .arm = 0, .is_squeezing = is_squeezing});
    }
    refusals_.clear();
    std::vector<std::string> done;
    for (const ToolUse& use : tabletop_->UseTools(holders, &refusals_)) {
      done.push_back(use.verb + " " + use.target);
    }
    return done;
  }
  std::vector<Refusal> refusals_;
};

/// A string of eight links along x, 1 m above the table.
scene::SceneSpec String() {
  scene::SceneSpec scene;
  scene::ChainSpec chain{.id = "Rope",
                         .start_id = "start",
                         .end_id = "end",
                         .p_WStart = {-0.4, 0, 1},
                         .p_WEnd = {0.4, 0, 1},
                         .link_mass = 0.05};
  for (int i = 0; i < 8; ++i) chain.link_ids.push_back("link" + std::to_string(i));
  scene.objects = PiecesOf(chain, scene.meters_per_unit);
  scene.chains = {chain};
  return scene;
}

TEST_F(ToolsTest, ScissorsPartAStringBetweenTheLinksAtTheirBlades) {
  scene::SceneSpec scene = String();
  scene.objects.push_back(Scissors({0.09, -0.08, 1}));
  Start(scene);
  const std::size_t joints = world_->joints().size();
  EXPECT_EQ(Use("Scissors"), "cut Rope between link 4 and 5");
  EXPECT_EQ(world_->joints().size(), joints - 1);
  // Both parts hang from their ends.
  StepSeconds(1.5);
  EXPECT_LT(PositionOf("link4").z(), 0.8);
  EXPECT_LT(PositionOf("link5").z(), 0.9);
  EXPECT_GT((PositionOf("link4") - PositionOf("link5")).norm(), 0.2);
}

TEST_F(ToolsTest, ScissorsRefuseWhatIsTooFarAndWhatCannotBeCut) {
  scene::SceneSpec scene = String();
  scene.objects.push_back(Scissors({0.09, -0.3, 1}));
  Start(scene);
  EXPECT_EQ(Use("Scissors"),
            "the blades of 'Scissors' are 1.8 units beside Rope between link 4 and 5, expected at "
            "most 0.2 units; move them by (0,1.8,0)");
  scene.chains[0].can_be_cut = false;
  Start(scene);
  EXPECT_EQ(Use("Scissors"), "there is nothing that 'Scissors' can cut");
  EXPECT_EQ(Use("link0"), "'link0' is no tool");
}

TEST_F(ToolsTest, TheNearestWorkIsWhereNothingImmovableStandsInTheWay) {
  scene::SceneSpec scene = String();
  scene.objects.push_back(Scissors({0.09, -0.3, 1}));
  const auto nearest = [this] { return tabletop_->NearestWork(*tabletop_->Find("Scissors")); };
  Start(scene);
  EXPECT_EQ(nearest()->target, "Rope between link 4 and 5");
  // Where the scissors would cut that, with the tip at the joint.
  const Vector3 there = Vector3(0.09, -0.3, 1) + nearest()->displacement;
  scene.objects.push_back(ObjectAt("Post", scene::Block{{0.03, 0.03, 0.03}}, there, 0));
  Start(scene);
  EXPECT_EQ(nearest()->target, "Rope between link 3 and 4");
  scene.objects.back().mass = 1;
  Start(scene);
  EXPECT_EQ(nearest()->target, "Rope between link 4 and 5") << "what is light gives way";
  scene.objects.back() = ObjectAt("Wall", scene::Block{{2, 0.03, 0.03}}, there, 0);
  Start(scene);
  EXPECT_EQ(nearest()->target, "Rope between link 4 and 5") << "no place is free";
}

TEST_F(ToolsTest, ScissorsEndABondThatCanBeCut) {
  scene::ObjectSpec screw = Screw("Screw", {0, 0, 0.2}, "Nut_hole", 1);
  GuestPointOf(screw).can_be_cut = true;
  Start({Nut("Nut", {0, 0, 0.06}), screw, Scissors({0, -0.1, 0.1})});
  EXPECT_EQ(Use("Scissors"), "cut Screw from Nut");
  EXPECT_EQ(TightnessOf("Nut_hole"), 0);
}

TEST_F(ToolsTest, ScissorsTriggerAPartThatCutTriggers) {
  scene::CustomControl wire;
  for (int state = 0; state < 2; ++state) {
    scene::Part part = BlockPart({0.2, 0.01, 0.01}, {0, 0, state * -0.05});
    part.id = "strand";
    if (state == 0) {
      part.next_state = 1;
      part.trigger = scene::TriggerRule{.cause = scene::TriggerCause::kCut};
    }
    wire.states.push_back({.name = state == 0 ? "whole" : "cut", .parts = {part}});
  }
  Start({ObjectAt("Wire", wire, {0, 0, 0.3}, 0), Scissors({0, -0.08, 0.3})});
  EXPECT_EQ(Trigger("Wire"), "'Wire' refuses bare hands; it takes a tool that cuts");
  EXPECT_EQ(Use("Scissors"), "cut strand");
  EXPECT_EQ(StateOf("Wire"), "cut");
}

TEST_F(ToolsTest, AScrewdriverTurnsTheScrewThatRefusesBareHands) {
  Start({Nut("Nut", {0, 0, 0.06}, 3, 0), DrivenScrew({0, 0, 0.3}, 1), Driver({0.5, 0, 0.5})});
  EXPECT_EQ(Fasten("Screw"), "'Screw' refuses bare hands; it takes a tool of type phillips");
  EXPECT_EQ(Loosen("Screw"), "'Screw' refuses bare hands; it takes a tool of type phillips");
  PutDriver(0);
  EXPECT_EQ(Use("Driver"), "fasten Screw");
  EXPECT_EQ(TightnessOf("Nut_hole"), 2);
  PutDriver(0);
  EXPECT_EQ(Use("Driver", /*loosens=*/true), "loosen Screw");
  EXPECT_EQ(TightnessOf("Nut_hole"), 1);
}

using Words = std::vector<std::string>;

TEST_F(ToolsTest, AHeldToolHasAPossibleUseOnlyWhereItIsInPlace) {
  scene::SceneSpec scene = String();
  scene.objects.push_back(Scissors({0.09, -0.08, 1}));
  Start(scene);
  EXPECT_EQ(PossibleUses("Scissors"), Words{"cut Rope between link 4 and 5"});
  EXPECT_EQ(PossibleUses("link0"), Words{}) << "no tool is held";
  BodyOf("Scissors").SetPose(RigidTransform(Vector3(0.09, -0.3, 1)));
  EXPECT_EQ(PossibleUses("Scissors"), Words{});
}

TEST_F(ToolsTest, PossibleUsesAreThoseThatAreNotRefusedAndChangeNothing) {
  Start({Nut("Nut", {0, 0, 0.06}, 3, 0), DrivenScrew({0, 0, 0.3}, 2), Driver({0.5, 0, 0.5})});
  EXPECT_EQ(PossibleUses("Driver"), Words{});
  PutDriver(0);
  const TabletopState before = tabletop_->state();
  EXPECT_EQ(PossibleUses("Driver"), (Words{"fasten Screw", "loosen Screw"}));
  EXPECT_EQ(tabletop_->state(), before);
  EXPECT_EQ(Use("Driver"), "fasten Screw");
  PutDriver(0);
  EXPECT_EQ(PossibleUses("Driver"), Words{"loosen Screw"});
  EXPECT_EQ(Use("Driver"), "'Screw' is already at its tightest stage");
}

TEST_F(ToolsTest, ReportsPlaceAxisAndTypeThatDoNotFit) {
  const std::vector<scene::ObjectSpec> screw_in_nut = {Nut("Nut", {0, 0, 0.06}, 3, 0),
                                                       DrivenScrew({0, 0, 0.3}, 1)};
  const auto start = [&](const std::string& type) {
    std::vector<scene::ObjectSpec> objects = screw_in_nut;
    objects.push_back(Driver({0.5, 0, 0.5}, type));
    Start(objects);
  };
  start("phillips");
  PutDriver(0, 0, 0.05);
  EXPECT_EQ(Use("Driver"),
            "the tip of 'Driver' is 0.5 units above its place on 'Screw', expected at most 0.2 "
            "units; move it by (0,0,-0.5)");
  PutDriver(0, 40);
  EXPECT_EQ(Use("Driver"), "'Driver' is tilted by 40 degrees against 'Screw', expected at most 15");
  start("hex");
  PutDriver(0);
  EXPECT_EQ(Use("Driver"), "'Screw' takes phillips, and 'Driver' is hex");
}

TEST_F(ToolsTest, AFullTurnInEitherDirectionIsAStageAndTheToolMayBeLiftedBetween) {
  Start({Nut("Nut", {0, 0, 0.06}, 3, 0), DrivenScrew({0, 0, 0.3}, 1), Driver({0.5, 0, 0.5})});
  const auto turn = [this](double from_deg, double to_deg) {
    std::vector<std::string> done;
    for (int i = 0; i <= 20; ++i) {
      PutDriver(from_deg + (to_deg - from_deg) * i / 20);
      for (std::string& one : EndTick("Driver")) done.push_back(std::move(one));
    }
    return done;
  };
  // Clockwise, seen from above, tightens; a wrist cannot make a full turn at once.
  EXPECT_TRUE(turn(0, -180).empty());
  PutDriver(-180, 0, 0.1);
  EXPECT_TRUE(EndTick("Driver").empty());
  PutDriver(0, 0, 0.1);
  EXPECT_TRUE(EndTick("Driver").empty());
  EXPECT_EQ(turn(0, -180), (std::vector<std::string>{"fasten Screw"}));
  EXPECT_EQ(TightnessOf("Nut_hole"), 2);
  PutDriver(0, 0, 0.1);
  EXPECT_TRUE(EndTick("Driver").empty());
  EXPECT_EQ(turn(0, 360), (std::vector<std::string>{"loosen Screw"}));
  EXPECT_EQ(TightnessOf("Nut_hole"), 1);
}

TEST_F(ToolsTest, AGripperUsesAToolByClosingOnItAgain) {
  scene::SceneSpec scene = String();
  scene.objects.push_back(Scissors({0.09, -0.08, 1}));
  Start(scene);
  // It closes to take the tool, and keeps closing.
  EXPECT_TRUE(EndTick("Scissors", true, /*is_squeezing=*/true).empty());
  EXPECT_TRUE(EndTick("Scissors", true, /*is_squeezing=*/true).empty());
  EXPECT_TRUE(EndTick("Scissors").empty());
  EXPECT_EQ(EndTick("Scissors", true, /*is_squeezing=*/true),
            (std::vector<std::string>{"cut Rope between link 4 and 5"}));
  EXPECT_TRUE(EndTick("Scissors", true, /*is_squeezing=*/true).empty()) << "once";
  BodyOf("Scissors").SetPose(RigidTransform(Vector3(0, 0, 0.1)));
  EXPECT_TRUE(EndTick("Scissors").empty());
  EXPECT_TRUE(EndTick("Scissors", true, /*is_squeezing=*/true).empty());
  EXPECT_EQ(refusals_.size(), 1u);
}

TEST_F(ToolsTest, AStickOfGlueFastensByTheSameMechanism) {
  scene::ObjectSpec screw = DrivenScrew({0, 0, 0.3}, 0);
  GuestPointOf(screw).accepts[0].type = "glue";
  Start({Nut("Nut", {0, 0, 0.06}, 3, 0), screw,
         Driver({0.5, 0, 0.5}, "glue", scene::ToolAction::kFasten)});
  PutDriver(0);
  EXPECT_EQ(Use("Driver"), "fasten Screw");
  EXPECT_EQ(TightnessOf("Nut_hole"), 1);
}

TEST_F(ToolsTest, TheStateOfATurnIsRestoredAndHashed) {
  Start({Nut("Nut", {0, 0, 0.06}, 3, 0), DrivenScrew({0, 0, 0.3}, 1), Driver({0.5, 0, 0.5})});
  const auto hash = [this] {
    StateHash now;
    tabletop_->AddToHash(&now);
    return now.value();
  };
  PutDriver(0);
  EndTick("Driver");
  const TabletopState before = tabletop_->state();
  const std::uint64_t hash_before = hash();
  PutDriver(-90);
  EndTick("Driver");
  EXPECT_NE(hash(), hash_before);
  tabletop_->Restore(before, std::make_shared<const model::Model>(tabletop_->model().scene()));
  EXPECT_EQ(hash(), hash_before);
}

}  // namespace
}  // namespace smile::world
