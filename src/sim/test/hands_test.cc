// Commands of hands: implied commands and reported events.

#include <algorithm>

#include "sim/command_json.h"
#include "sim/drag.h"
#include "simulation_fixture.h"

namespace smile::sim {
namespace {

using enum HandName;

/// Blocks a, b and c, and the events of the simulation.
class HandsTest : public SimulationFixture {
 protected:
  HandsTest() {
    scene::ObjectSpec a = BlockAt("a", {0, 0, 0.05});
    a.descriptions = {{"shape", "block"}, {"maker", "Ann"}};
    simulation_ = MakeSimulation({a, BlockAt("b", {0.3, 0, 0.05}), BlockAt("c", {-0.3, 0, 0.05})},
                                 /*with_robot=*/false);
    simulation_->AddListener(&ear_);
  }
  struct Ear : Listener {
    void OnCommand(const Simulation& simulation, const Command& command) override {
      log.push_back(command);
      std::string line;
      const Json json = ToJson(command, simulation.scene().meters_per_unit);
      for (const char* key : {"hand", "do", "object"}) {
        if (json.contains(key)) line += (line.empty() ? "" : " ") + json.at(key).get<std::string>();
      }
      lines.push_back(line);
    }
    void OnEvent(const Simulation&, const Event& event) override { events.push_back(event); }
    std::vector<Command> log;
    std::vector<std::string> lines;
    std::vector<Event> events;
  };
  /// Returns the refusal; empty if it was executed.
  std::string Do(const Command& command) { return simulation_->Apply(command).value_or(""); }
  std::string DoDrag(const Drag& drag) {
    Refusal refusal;
    const auto move = MoveOf(drag, *simulation_, &refusal);
    return move ? Do(*move) : refusal;
  }
  std::string Grab(HandName hand, const char* object) {
    return Do(Grasp{.hand = hand, .object = object});
  }
  /// `left: a, any: c`
  std::string Holding() const {
    std::string text;
    for (HandName name : demonstrator::kHandNames) {
      const demonstrator::Hand& hand = simulation_->demonstrator().hand(name);
      if (!hand.is_holding()) continue;
      text += (text.empty() ? "" : ", ") + std::string(ToString(name)) + ": " +
              simulation_->tabletop().Find(hand.held)->id();
    }
    return text;
  }
  RigidTransform PoseOf(const char* id) const {
    return simulation_->physics().body(simulation_->tabletop().Find(id)->body).pose_in_world();
  }

  Ear ear_;
  std::unique_ptr<Simulation> simulation_;
};

TEST_F(HandsTest, HandsReleaseForAnotherCommand) {
  const auto after = [this](std::vector<std::pair<HandName, const char*>> grasps) {
    const SimulationState start = simulation_->Save();
    for (const auto& [hand, object] : grasps) EXPECT_EQ(Grab(hand, object), "");
    std::string holding = Holding();
    simulation_->Restore(start);
    return holding;
  };
  EXPECT_EQ(after({{kBoth, "a"}, {kLeft, "b"}}), "left: b");
  EXPECT_EQ(after({{kBoth, "a"}, {kRight, "b"}}), "right: b");
  EXPECT_EQ(after({{kAny, "a"}, {kLeft, "b"}}), "left: b, any: a");
  EXPECT_EQ(after({{kAny, "a"}, {kLeft, "b"}, {kRight, "c"}}), "left: b, right: c");
  EXPECT_EQ(after({{kAny, "a"}, {kRight, "b"}, {kLeft, "c"}}), "left: c, right: b");
  EXPECT_EQ(after({{kLeft, "a"}, {kRight, "b"}, {kBoth, "c"}}), "both: c");
  EXPECT_EQ(after({{kRight, "a"}, {kAny, "b"}, {kBoth, "c"}}), "both: c");
  EXPECT_EQ(after({{kLeft, "a"}, {kAny, "b"}}), "left: a, any: b");
  // After the handover, the object blocks no hand.
  EXPECT_EQ(after({{kLeft, "a"}, {kRight, "b"}, {kAny, "a"}}), "right: b, any: a");
  EXPECT_EQ(after({{kRight, "a"}, {kAny, "b"}, {kLeft, "b"}}), "left: b, right: a");
  EXPECT_EQ(after({{kBoth, "a"}, {kAny, "a"}}), "any: a");
}

TEST_F(HandsTest, EachImpliedReleaseIsACommandOfItsOwnHand) {
  ASSERT_EQ(Grab(kAny, "a"), "");
  ASSERT_EQ(Grab(kRight, "b"), "");
  ear_ = {};
  ASSERT_EQ(Grab(kBoth, "b"), "");
  EXPECT_EQ(ear_.lines, (std::vector<std::string>{"right release", "any release", "both grasp b"}));
  ASSERT_EQ(ear_.events.size(), 3u);
  EXPECT_EQ(ear_.events[0], (Event{.kind = EventKind::kReleased, .hand = kRight, .object = "b"}));
  EXPECT_EQ(ear_.events[1], (Event{.kind = EventKind::kReleased, .hand = kAny, .object = "a"}));
  EXPECT_EQ(ear_.events[2], (Event{.kind = EventKind::kGrasped, .hand = kBoth, .object = "b"}));
}

TEST_F(HandsTest, ALogOfImpliedReleasesReplaysToTheSameBits) {
  const SimulationState start = simulation_->Save();
  const std::vector<Command> wanted = {
      Grasp{.hand = kLeft, .object = "a"}, Plane{.hand = kLeft, .angle_deg = 30},
      MoveTo{.hand = kLeft, .p_WH = {0.1, 1.0 / 3, 0.3}}, Grasp{.hand = kRight, .object = "a"},
      Grasp{.hand = kBoth, .object = "c"}};
  for (const Command& command : wanted) {
    ASSERT_EQ(Do(command), "");
  }
  TickSeconds(*simulation_, 1);
  const std::uint64_t hash = simulation_->state_hash();
  simulation_->Restore(start);
  const std::vector<Command> log = std::exchange(ear_.log, {});
  EXPECT_EQ(log.size(), wanted.size() + 2);
  for (const Command& command : log) {
    ASSERT_EQ(Do(command), "");
  }
  EXPECT_EQ(ear_.log, log);
  TickSeconds(*simulation_, 1);
  EXPECT_EQ(simulation_->state_hash(), hash);
}

TEST_F(HandsTest, ARefusedGraspReleasesNothing) {
  ASSERT_EQ(Grab(kBoth, "a"), "");
  const std::uint64_t hash = simulation_->state_hash();
  EXPECT_EQ(Grab(kAny, "b"), "both hands are occupied: the pair of hands holds 'a'");
  EXPECT_EQ(Grab(kLeft, "nothing"), "there is no object 'nothing'");
  EXPECT_EQ(simulation_->state_hash(), hash);
  ASSERT_EQ(Grab(kLeft, "a"), "");
  ASSERT_EQ(Grab(kRight, "b"), "");
  EXPECT_EQ(Grab(kAny, "c"),
            "both hands are occupied: the left hand holds 'a', the right hand holds 'b'");
  EXPECT_EQ(Grab(kLeft, "b"), "the left hand already holds 'a'; release it first");
  EXPECT_EQ(Holding(), "left: a, right: b");
}

TEST_F(HandsTest, AHandOverDoesNotMoveTheObject) {
  ASSERT_EQ(Grab(kLeft, "a"), "");
  ASSERT_EQ(Do(MoveTo{.hand = kLeft, .p_WH = {0, 0, 0.4}}), "");
  ASSERT_EQ(Do(Rotate{.hand = kLeft, .angles_deg = {30, 20, 10}}), "");
  TickSeconds(*simulation_, 1);
  for (HandName hand : {kRight, kAny, kBoth, kLeft}) {
    const RigidTransform X_WB = PoseOf("a");
    ASSERT_EQ(Grab(hand, "a"), "");
    EXPECT_EQ(PoseOf("a"), X_WB);
    TickSeconds(*simulation_, 0.5);
    EXPECT_LT((PoseOf("a").translation() - X_WB.translation()).norm(), 1e-5);
  }
}

TEST_F(HandsTest, TwoHandsInterleavedCarryAsEachAlone) {
  const auto carry = [this](std::vector<HandName> hands) {
    const SimulationState start = simulation_->Save();
    const auto object_of = [](HandName hand) { return hand == kLeft ? "c" : "b"; };
    for (HandName hand : hands) EXPECT_EQ(Grab(hand, object_of(hand)), "");
    for (int i = 0; i < 40; ++i) {
      for (HandName hand : {kLeft, kRight}) {
        const double side = hand == kLeft ? -1 : 1;
        const Vector3 p_WH(side * (0.3 + 0.01 * i), 0.1 * side * (i % 3), 0.05 + 0.01 * i);
        if (std::ranges::count(hands, hand) > 0) {
          EXPECT_EQ(Do(MoveTo{.hand = hand, .p_WH = p_WH, .speed = 0.2 + 0.1 * (i % 4)}), "");
        }
        simulation_->Tick();
      }
    }
    std::pair<Vector3, Vector3> places = {PoseOf("c").translation(), PoseOf("b").translation()};
    simulation_->Restore(start);
    return places;
  };
  const auto both = carry({kLeft, kRight});
  EXPECT_LT((both.first - carry({kLeft}).first).norm(), 1e-9);
  EXPECT_LT((both.second - carry({kRight}).second).norm(), 1e-9);
  EXPECT_GT(both.first.z(), 0.3);
  EXPECT_GT(both.second.z(), 0.3);
}

TEST_F(HandsTest, ADragFollowsTheRayInThePlane) {
  ASSERT_EQ(Do(Grasp{.hand = kLeft, .object = "a", .p_WQ = Vector3(0, 0, 0.1)}), "");
  const auto drag = [this](const Vector3& origin, const Vector3& direction) {
    return DoDrag(Drag{.hand = kLeft, .p_WOrigin = origin, .direction_in_world = direction});
  };
  const auto goal = [this]() -> Vector3 {
    const demonstrator::Hand& hand = simulation_->demonstrator().hand(kLeft);
    return hand.X_WB_goal * hand.p_BH;
  };
  // Along the x axis unless turned, through the grasped point.
  EXPECT_EQ(drag({0.2, -2, 0.5}, {0, 1e6, 0}), "");
  EXPECT_LT((goal() - Vector3(0.2, 0, 0.5)).norm(), 1e-12);
  EXPECT_EQ(drag({0.1, -1, 0.3}, {0, 1e-300, 1e-301}), "") << "of any length";
  EXPECT_LT((goal() - Vector3(0.1, 0, 0.4)).norm(), 1e-12);

  ASSERT_EQ(Do(Plane{.hand = kLeft, .angle_deg = 45}), "");
  EXPECT_EQ(drag({0.3, -2, 0.2}, {0, 1, 0}), "");
  EXPECT_LT((goal() - Vector3(0.3, 0.2, 0.2)).norm(), 1e-12) << "counterclockwise from above";
  // It stays in that plane however often it is dragged.
  for (int i = 0; i < 1000; ++i) ASSERT_EQ(drag({0.1 * (i % 7), -2, 0.2}, {0.1, 1, 0}), "");
  EXPECT_NEAR(goal().y(), goal().x() - 0.1, 1e-12);

  // Level it keeps its height, wherever its plane stands.
  const auto drag_level = [this](const Vector3& origin, const Vector3& direction) {
    return DoDrag(Drag{
        .hand = kLeft, .p_WOrigin = origin, .direction_in_world = direction, .is_level = true});
  };
  EXPECT_EQ(drag_level({-0.1, -2, 1.2}, {0.1, 1, -0.5}), "");
  EXPECT_LT((goal() - Vector3(0.1, 0, 0.2)).norm(), 1e-12);

  const std::uint64_t hash = simulation_->state_hash();
  EXPECT_EQ(drag_level({0, -2, 0.2}, {0, 1, 0}),
            "the ray is parallel to the horizontal plane of the left hand");
  const std::string plane = "the motion plane of the left hand";
  EXPECT_EQ(drag({0, -2, 0.2}, {1, 1, 3}), "the ray is parallel to " + plane);
  EXPECT_EQ(drag({0, -2, 0.2}, {0, -1, 0}), "the ray points away from " + plane);
  EXPECT_EQ(drag({0, -2, 0.2}, {1, 1.01, 0}), "the ray meets " + plane + " more than 100 m away");
  EXPECT_EQ(drag({0, -2, 0.2}, {0, 0, 0}), "the ray has no direction");
  EXPECT_EQ(drag({0, -2, 0.2}, {0, std::nan(""), 0}), "the ray has no direction");
  EXPECT_EQ(DoDrag(Drag{.hand = kRight}), "the right hand holds nothing");
  EXPECT_EQ(simulation_->state_hash(), hash);
}

TEST_F(HandsTest, ADragStaysWithinTheRangeOfTheLog) {
  scene::SceneSpec scene{.name = "tiny", .meters_per_unit = 1e-6};
  scene.objects = {BlockAt("a", {0, 0, 0.05})};
  Simulation tiny(scene);
  ASSERT_EQ(tiny.Apply(Grasp{.hand = kLeft, .object = "a"}), std::nullopt);
  const Drag drag{.hand = kLeft, .p_WOrigin = {0, -1, 0.2}, .direction_in_world = {1, 1, 0}};
  Refusal refusal;
  EXPECT_NE(MoveOf(drag, tiny, &refusal), std::nullopt) << "just a million units to the right";
  Drag farther = drag;
  farther.p_WOrigin.x() = 0.1;
  EXPECT_EQ(MoveOf(farther, tiny, &refusal), std::nullopt);
  EXPECT_EQ(refusal, "the ray meets the motion plane more than 1e6 units away");
}

TEST_F(HandsTest, AHandOverIsUndoneInTwoSteps) {
  ASSERT_EQ(Grab(kLeft, "a"), "");
  const std::uint64_t hash = simulation_->state_hash();
  ASSERT_EQ(Grab(kRight, "a"), "");
  ASSERT_EQ(Do(Undo()), "");
  EXPECT_EQ(Holding(), "");
  ASSERT_EQ(Do(Undo()), "");
  EXPECT_EQ(simulation_->state_hash(), hash);
}

TEST_F(HandsTest, EachHandKeepsItsPlaneFromGraspToGrasp) {
  const std::uint64_t hash = simulation_->state_hash();
  ASSERT_EQ(Do(Plane{.hand = kRight, .angle_deg = 90}), "");
  EXPECT_NE(simulation_->state_hash(), hash);
  ASSERT_EQ(Grab(kRight, "a"), "");
  ASSERT_EQ(Do(Release{.hand = kRight}), "");
  ASSERT_EQ(Grab(kRight, "b"), "");
  ASSERT_EQ(Grab(kLeft, "a"), "");
  EXPECT_EQ(simulation_->demonstrator().plane_angle_deg(kRight), 90);
  EXPECT_EQ(simulation_->demonstrator().plane_angle_deg(kLeft), 0);
}

TEST_F(HandsTest, HandsMarkPropertiesOfHeldObjects) {
  const auto attend = [this](std::vector<std::string> properties) {
    return Do(Attend{.hand = kLeft, .properties = std::move(properties)});
  };
  const auto attended_of = [this](const char* id) {
    return simulation_->demonstrator().PropertiesThatMatter(*simulation_->tabletop().Find(id));
  };
  using Words = std::vector<std::string>;
  EXPECT_EQ(attend({"size"}), "the left hand holds nothing");
  ASSERT_EQ(Grab(kLeft, "a"), "");
  const std::uint64_t silent = simulation_->state_hash();
  EXPECT_EQ(attend({"size", "colour", "maker", "color", "size"}), "");
  EXPECT_EQ(attended_of("a"), (Words{"size", "color", "maker"}));
  EXPECT_EQ(ear_.events.back(), (Event{.kind = EventKind::kAttended,
                                       .hand = kLeft,
                                       .object = "a",
                                       .properties = {"size", "color", "maker"}}));
  EXPECT_EQ(attend({"size", "sise"}),
            "'a' has no property \"sise\", expected color, shape, size, position, orientation, "
            "order, support or maker; did you mean \"size\"?");
  EXPECT_EQ(attend(Words(33, "size")), "found 33 properties, expected at most 32");
  EXPECT_EQ(attended_of("a"), (Words{"size", "color", "maker"})) << "a refusal changes nothing";
  const SimulationState saved = simulation_->Save();
  EXPECT_EQ(attend({}), "");
  EXPECT_EQ(attended_of("a"), Words());
  EXPECT_EQ(ear_.events.back().properties, Words());
  EXPECT_EQ(simulation_->state_hash(), silent);
  simulation_->Restore(saved);
  EXPECT_NE(simulation_->state_hash(), silent);

  ASSERT_EQ(Grab(kRight, "a"), "");
  ASSERT_EQ(Do(Release{.hand = kRight}), "");
  ASSERT_EQ(Grab(kLeft, "b"), "");
  EXPECT_EQ(attend({"maker"}),
            "'b' has no property \"maker\", expected color, shape, size, position, orientation, "
            "order or support");
  EXPECT_EQ(attend({"order"}), "");
  EXPECT_EQ(attended_of("a"), (Words{"size", "color", "maker"})) << "it stays after release";
  EXPECT_EQ(attended_of("b"), Words{"order"});
}

}  // namespace
}  // namespace smile::sim
