// Manual control of a robot: joints, grippers, poses and trajectories.

#include <cmath>

#include "event_counter.h"
#include "everything_scene.h"
#include "motion/trajectory_shape.h"
#include "random_hands.h"
#include "random_robot.h"
#include "robot/test/generated_robot.h"
#include "sim/script.h"
#include "simulation_fixture.h"
#include "undo_books.h"

namespace smile::sim {
namespace {

class RobotCommands : public SimulationFixture {
 protected:
  static double JointAt(const Simulation& simulation, const char* name) {
    return simulation.robot()->positions()[*FindJoint(Baxter(), name)];
  }
  static double FarthestFrom(const robot::NamedPose& pose, const Simulation& simulation) {
    double farthest = 0;
    for (int arm = 0; arm < 2; ++arm) {
      for (const int joint : Baxter().arms[arm].joints) {
        farthest =
            std::max(farthest, std::abs(simulation.robot()->positions()[joint] - pose.q[joint]));
      }
    }
    return farthest;
  }
  /// Both arms swing for some seconds, and rest at the end as at the start.
  static motion::JointTrajectory Wave(double seconds) {
    motion::JointTrajectory wave;
    std::vector<double> start;
    for (const robot::Arm& arm : Baxter().arms) {
      for (const int joint : arm.joints) {
        wave.joint_names.push_back(Baxter().links[joint].joint_name);
        start.push_back(Baxter().q_start[joint]);
      }
    }
    for (int i = 0; i <= 20 * seconds; ++i) {
      const double turn = i / (20 * seconds);
      motion::TrajectoryPoint point{.seconds = i / 20.0};
      for (std::size_t k = 0; k < start.size(); ++k) {
        // Elbows are at their limit at the start and can only be opened.
        point.positions.push_back(start[k] - 0.2 * (1 - std::cos(2 * M_PI * turn)));
      }
      wave.points.push_back(point);
    }
    motion::SetVelocitiesFromPositions(&wave);
    return wave;
  }

  std::unique_ptr<Simulation> simulation_ = MakeSimulation({}, true);
};

TEST_F(RobotCommands, OneJointTurnsUntilItIsStopped) {
  const std::vector<double> before = simulation_->robot()->positions();
  ASSERT_EQ(simulation_->Apply(TurnJoint{.joint = "left_e1", .velocity = -0.5}), std::nullopt);
  ASSERT_EQ(simulation_->Apply(TurnJoint{.joint = "head_pan", .velocity = 0.2}), std::nullopt);
  TickSeconds(*simulation_, 1);
  ASSERT_EQ(simulation_->Apply(TurnJoint{.joint = "left_e1"}), std::nullopt);
  TickSeconds(*simulation_, 1);
  std::vector<double> expected = before;
  expected[*FindJoint(Baxter(), "left_e1")] -= 0.5;
  expected[*FindJoint(Baxter(), "head_pan")] += 0.4;
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_NEAR(simulation_->robot()->positions()[i], expected[i], 5e-3) << i;
  }
}

TEST_F(RobotCommands, GrippersMoveOneByOneAndTogether) {
  simulation_->Apply(MoveGripper{.arm = "right", .velocity = -0.05});
  TickSeconds(*simulation_, 1);
  EXPECT_NEAR(simulation_->robot()->GripperOpening(0), 0.2, 1e-3);
  EXPECT_NEAR(simulation_->robot()->GripperOpening(1), 0.15, 1e-3);
  simulation_->Apply(MoveGripper{.velocity = -0.05});
  TickSeconds(*simulation_, 1);
  EXPECT_NEAR(simulation_->robot()->GripperOpening(0), 0.15, 1e-3);
  EXPECT_NEAR(simulation_->robot()->GripperOpening(1), 0.1, 1e-3);
}

TEST_F(RobotCommands, EveryPoseButTuckedIsReached) {
  for (const char* name : {"ready", "neutral", "untucked", "zero", "ready", "smile_start"}) {
    ASSERT_EQ(simulation_->Apply(TakePose{.name = name}), std::nullopt);
    int ticks = 0;
    for (; simulation_->is_robot_following() && ticks < 1200; ++ticks) simulation_->Tick();
    EXPECT_LT(ticks, 1200) << name;
    TickSeconds(*simulation_, 0.25);
    EXPECT_LT(FarthestFrom(*FindPose(Baxter(), name), *simulation_), 1e-3) << name;
  }
}

TEST_F(RobotCommands, JointsFollowATrajectoryWithinOneMilliradian) {
  const motion::JointTrajectory wave = Wave(4);
  ASSERT_EQ(simulation_->Apply(FollowTrajectory{wave}), std::nullopt);
  double farthest = 0;
  while (simulation_->is_robot_following()) {
    const motion::TrajectoryPoint wanted = SampleAt(wave, simulation_->seconds());
    for (std::size_t i = 0; i < wave.joint_names.size(); ++i) {
      farthest = std::max(farthest, std::abs(JointAt(*simulation_, wave.joint_names[i].c_str()) -
                                             wanted.positions[i]));
    }
    simulation_->Tick();
  }
  EXPECT_EQ(simulation_->tick(), 4 * kTicksPerSecond + 1u);
  EXPECT_LT(farthest, 1e-3);
}

TEST_F(RobotCommands, ADistantRobotFirstMovesToTheStartOfTheTrajectory) {
  const motion::JointTrajectory there{{"left_s0"}, {{0, {-0.5}, {0}}, {1, {-0.5}, {0}}}};
  const auto way = motion::MoveStraight(std::vector{0.25}, std::vector{-0.5},
                                        std::vector{motion::JointLimits{-2, 2, 1.5, 3}}, 0.5);
  ASSERT_EQ(simulation_->Apply(FollowTrajectory{there}), std::nullopt);
  TickSeconds(*simulation_, way.back().seconds + 0.5);
  EXPECT_TRUE(simulation_->is_robot_following());
  EXPECT_NEAR(JointAt(*simulation_, "left_s0"), -0.5, 2e-3);
  TickSeconds(*simulation_, 0.6);
  EXPECT_FALSE(simulation_->is_robot_following());
}

TEST_F(RobotCommands, AnEarlyRobotRestsUntilTheTrajectoryBegins) {
  // From rest to this speed in one cubic, it would swing back by more than 0.5 rad.
  const motion::JointTrajectory passing{{"left_s0"}, {{5, {-0.2}, {1}}, {6, {0.3}, {0}}}};
  ASSERT_EQ(simulation_->Apply(FollowTrajectory{passing}), std::nullopt);
  TickSeconds(*simulation_, 2);
  while (simulation_->seconds() < 5) {
    ASSERT_NEAR(JointAt(*simulation_, "left_s0"), -0.2, 2e-3) << simulation_->seconds() << " s";
    simulation_->Tick();
  }
  while (simulation_->is_robot_following()) simulation_->Tick();
  EXPECT_NEAR(simulation_->seconds(), 6, 0.1);
  EXPECT_NEAR(JointAt(*simulation_, "left_s0"), 0.3, 5e-3);
}

TEST_F(RobotCommands, ALaterCommandTakesOverItsJointsAndTheOthersContinue) {
  simulation_->Apply(TakePose{.name = "ready"});
  TickSeconds(*simulation_, 0.5);
  simulation_->Apply(TurnJoint{.joint = "left_s0", .velocity = 0});
  const double left_s0 = JointAt(*simulation_, "left_s0");
  simulation_->Apply(JointVelocities{.arms = {{"right", std::vector<double>(7, 0.0)}}});
  const std::vector<double> right = simulation_->robot()->ArmAngles(1);
  while (simulation_->is_robot_following()) simulation_->Tick();
  TickSeconds(*simulation_, 0.25);
  const robot::NamedPose& ready = *FindPose(Baxter(), "ready");
  EXPECT_NEAR(JointAt(*simulation_, "left_s0"), left_s0, 0.05);
  EXPECT_NEAR(JointAt(*simulation_, "left_e0"), ready.q[*FindJoint(Baxter(), "left_e0")], 1e-3);
  for (int i = 0; i < 7; ++i) {
    EXPECT_NEAR(simulation_->robot()->ArmAngles(1)[i], right[i], 0.06) << i;
  }
  // Teleporting is a command like any other.
  simulation_->Apply(TakePose{.name = "neutral"});
  simulation_->Apply(JointAngles{
      .arms = {{"left", std::vector<double>(7, 0.0)}, {"right", std::vector<double>(7, 0.0)}},
      .head = 0});
  EXPECT_FALSE(simulation_->is_robot_following());
}

TEST_F(RobotCommands, ABlockedArmStopsWhenItsTimeIsUp) {
  const Vector3 p_WG = simulation_->robot()->ToolPose(0).translation();
  auto blocked =
      MakeSimulation({BlockAt("wall", p_WG + Vector3(0, 0.15, 0), /*mass=*/0, {1, 0.1, 1})}, true);
  const motion::JointTrajectory reach{{"left_e1"}, {{0, {2.618}, {0}}, {2, {1.6}, {0}}}};
  ASSERT_EQ(blocked->Apply(FollowTrajectory{reach}), std::nullopt);
  TickSeconds(*blocked, 2);
  EXPECT_GT(JointAt(*blocked, "left_e1"), 1.8) << "the wall is no hindrance";
  const double stopped_at = JointAt(*blocked, "left_e1");
  blocked->Tick();
  EXPECT_FALSE(blocked->is_robot_following());
  TickSeconds(*blocked, 1);
  EXPECT_NEAR(JointAt(*blocked, "left_e1"), stopped_at, 1e-3);
}

TEST_F(RobotCommands, ImpossibleCommandsAreRefusedWithAReason) {
  const auto refusal = [this](const Command& command) {
    const std::uint64_t hash = simulation_->state_hash();
    const std::string words = simulation_->Apply(command).value_or("");
    EXPECT_EQ(simulation_->state_hash(), hash) << words;
    return words;
  };
  const auto through = [&](double position, double velocity) {
    return refusal(FollowTrajectory{
        {{"left_s0"}, {{0, {0.25}, {0}}, {2, {position}, {velocity}}, {4, {0}, {0}}}}});
  };
  EXPECT_EQ(refusal(TurnJoint{.joint = "left_s7"}),
            "the robot has no joint \"left_s7\" to turn; did you mean \"left_s0\"?");
  EXPECT_EQ(refusal(TurnJoint{.joint = "left_gripper_left_finger"}).substr(0, 61),
            "the robot has no joint \"left_gripper_left_finger\" to turn");
  EXPECT_EQ(refusal(TakePose{.name = "asleep"}),
            "the robot has no pose \"asleep\", expected zero, neutral, tucked, untucked, ready, "
            "parked or smile_start");
  EXPECT_EQ(refusal(FollowTrajectory{{{"knee"}, {{0, {0}, {0}}}}}),
            "the robot has no joint \"knee\"");
  EXPECT_EQ(refusal(FollowTrajectory{}), "there are no joints");
  EXPECT_EQ(through(1.8, 0),
            "at 2 s, left_s0: position is 1.8 rad, expected at most 1.70167993878 rad");
  EXPECT_EQ(through(0, 1.6), "at 2 s, left_s0: velocity is 1.6 rad/s, expected at most 1.5 rad/s");
  auto alone = MakeSimulation({}, false);
  EXPECT_EQ(alone->Apply(TakePose{.name = "ready"}), "there is no robot in this simulation");
  robot::RobotModel without_arms = Baxter();
  without_arms.arms.clear();
  without_arms.head.reset();
  Simulation still({}, RobotPlacement{.model = std::move(without_arms)});
  EXPECT_EQ(still.Apply(TakePose{.name = "ready"}), "the robot has no joints for poses");
}

/// A block on a pillar between the left fingers, as the robot stands at the start.
class DrivenGripper : public RobotCommands {
 protected:
  DrivenGripper() {
    const Vector3 p_WG = simulation_->robot()->ToolPose(0).translation();
    const double height = p_WG.z() - 0.05;
    simulation_ = MakeSimulation({BlockAt("pillar", {p_WG.x(), p_WG.y(), height / 2},
                                          /*mass=*/0, {0.06, 0.06, height}),
                                  BlockAt("block", p_WG + Vector3(0, 0, 0.001))},
                                 true);
  }
};

TEST_F(DrivenGripper, APoseKeepsWhatIsHeld) {
  simulation_->Apply(MoveGripper{.arm = "left", .velocity = -0.1});
  TickSeconds(*simulation_, 1.5);
  ASSERT_EQ(simulation_->robot()->HeldBodies(0).size(), 1u);
  simulation_->Apply(TakePose{.name = "ready"});
  while (simulation_->is_robot_following()) simulation_->Tick();
  EXPECT_EQ(simulation_->robot()->HeldBodies(0).size(), 1u);
}

TEST_F(DrivenGripper, ATrajectoryGraspsAndReleases) {
  const motion::JointTrajectory grip{
      {"left_gripper"}, {{0, {0.2}, {0}}, {1, {0.1}, {0}}, {3, {0.1}, {0}}, {4, {0.2}, {0}}}};
  ASSERT_EQ(simulation_->Apply(FollowTrajectory{grip}), std::nullopt);
  TickSeconds(*simulation_, 2);
  EXPECT_EQ(simulation_->robot()->HeldBodies(0).size(), 1u);
  TickSeconds(*simulation_, 0.9);
  EXPECT_EQ(simulation_->robot()->HeldBodies(0).size(), 1u);
  TickSeconds(*simulation_, 1.2);
  EXPECT_TRUE(simulation_->robot()->HeldBodies(0).empty());
  EXPECT_NEAR(simulation_->robot()->GripperOpening(0), 0.2, 2e-3);
}

class AnyArms : public SimulationFixture {
 protected:
  static std::unique_ptr<Simulation> With(const robot::GeneratedRobot& robot) {
    return std::make_unique<Simulation>(scene::SceneSpec{.name = "test"},
                                        RobotPlacement{.model = robot.Model()});
  }

  std::unique_ptr<Simulation> simulation_ = With(robot::ThreeArms());
};

TEST_F(AnyArms, MoveByTheirNames) {
  const std::vector<double> before = simulation_->robot()->positions();
  ASSERT_EQ(simulation_->Apply(JointVelocities{
                .arms = {{"front", {0.1, 0, 0, 0}}, {"rear", {0, 0, 0, 0, 0, 0, -0.3}}},
                .grippers = {{"rear", 0.05}}}),
            std::nullopt);
  TickSeconds(*simulation_, 1);
  ASSERT_EQ(simulation_->Apply(MoveGripper{.arm = "all", .velocity = 0.02}), std::nullopt);
  TickSeconds(*simulation_, 0.5);
  const world::RobotBody& robot = *simulation_->robot();
  EXPECT_NEAR(robot.ArmAngles(0)[0], 0.15, 2e-3);
  EXPECT_NEAR(robot.ArmAngles(1)[0], 0, 2e-3) << "not named";
  EXPECT_NEAR(robot.ArmAngles(2)[6], -0.45, 2e-3);
  EXPECT_NEAR(robot.GripperOpening(0), 0.01, 2e-3);
  EXPECT_NEAR(robot.GripperOpening(2), 0.06, 2e-3);
  ASSERT_EQ(simulation_->Apply(JointAngles{.arms = {{"middle", {0.1, 0.2, 0.3, 0, 0.1, 0}}}}),
            std::nullopt);
  EXPECT_EQ(robot.ArmAngles(1), (std::vector{0.1, 0.2, 0.3, 0.0, 0.1, 0.0}));
}

TEST_F(AnyArms, AreLeftAndRightInOldLogs) {
  const std::vector<double> four(4, 0.1), six(6, 0.1);
  ASSERT_EQ(simulation_->Apply(JointVelocities{.arms = {{"left", four}, {"right", six}},
                                               .grippers = {{"left", 0.05}, {"right", 0.05}}}),
            std::nullopt)
      << "the second arm has no gripper, which a pair does not need";
  TickSeconds(*simulation_, 0.5);
  EXPECT_NEAR(simulation_->robot()->ArmAngles(0)[0], 0.05, 2e-3);
  EXPECT_NEAR(simulation_->robot()->ArmAngles(1)[0], 0.05, 2e-3);
  EXPECT_NEAR(simulation_->robot()->GripperOpening(0), 0.025, 2e-3);
}

TEST_F(AnyArms, ThatDoNotExistOrFitAreRefused) {
  const auto refusal = [&](const Command& command) {
    const std::uint64_t before = simulation_->state_hash();
    const std::string words = simulation_->Apply(command).value_or("accepted");
    EXPECT_EQ(simulation_->state_hash(), before);
    return words;
  };
  const std::vector<double> four(4, 0.1);
  EXPECT_EQ(refusal(JointVelocities{.arms = {{"front", four}, {"fourth", four}}}),
            "the robot has no arm \"fourth\", expected front, middle or rear");
  EXPECT_EQ(refusal(JointAngles{.arms = {{"rear", four}}}),
            "the rear arm has 7 joints, found 4 numbers");
  EXPECT_EQ(refusal(JointVelocities{.arms = {{"front", four}, {"left", four}}}),
            "the arm \"front\" is named twice");
  EXPECT_EQ(refusal(JointVelocities{.grippers = {{"front", 1}, {"middle", 1}}}),
            "the arm \"middle\" has no gripper");
  EXPECT_EQ(refusal(MoveGripper{.arm = "both"}), "the arm \"right\" has no gripper");
  EXPECT_EQ(refusal(MoveGripper{.arm = "hind"}),
            "the robot has no arm \"hind\", expected front, middle or rear");
}

TEST_F(AnyArms, StandStillAtACommand) {
  simulation_->Apply(JointVelocities{.arms = {{"middle", std::vector<double>(6, 0.2)}}});
  TickSeconds(*simulation_, 0.2);
  ASSERT_EQ(simulation_->Apply(StillVelocities(simulation_->robot()->model())), std::nullopt);
  TickSeconds(*simulation_, 0.2);
  for (const double velocity : simulation_->robot()->ArmVelocities(1)) {
    EXPECT_NEAR(velocity, 0, 1e-3);
  }
}

class RobotCommandsProperty : public SimulationFixture,
                              public ::testing::WithParamInterface<unsigned> {
 protected:
  /// Returns Tern with fingers as jaws: one of them drives the other.
  static const robot::RobotModel& TernWithJaws() {
    static const robot::RobotModel kTern =
        robot::ReadRobot(DataFile("robots/tern.urdf"), {.side_file_text = R"({"format": 2,
"arms": {"arm": {"joints": ["shoulder_turn", "shoulder_lift", "elbow", "forearm_turn", "wrist_bend",
"wrist_turn"], "tool": "tool",
"jaws": {"drive": "left_finger_slide", "left": "left_finger", "right": "right_finger"},
"pads": ["left_finger", "right_finger"]}},
"never_collide": [["palm", "left_finger"], ["palm", "right_finger"], ["left_finger", "right_finger"]],
"poses": {"zero": {"opening": 0.05}, "ready": {"arm": [0, 0.54, 1.38, 0, 1.2216, 0]}},
"start": "ready"})"});
    return kTern;
  }
  static const robot::RobotModel& Tern() {
    static const robot::RobotModel kTern = robot::ReadRobot(DataFile("robots/tern.urdf"));
    return kTern;
  }
  /// Adds `snips`, which stand on the table between the fingers and cut the chain from there.
  static void AddToolBetweenFingers(const robot::RobotModel& model, scene::SceneSpec* scene) {
    const Simulation empty(*scene, RobotPlacement{.model = model});
    const RigidTransform X_WG = empty.robot()->ToolPose(0);
    const Vector3 p_WG = X_WG.translation(), across = X_WG.rotation().col(1);
    const Eigen::AngleAxisd turn(std::atan2(across.y(), across.x()), Vector3::UnitZ());
    scene::ObjectSpec snips = BlockAt("snips", Vector3::Zero(), 0.03);
    const double height = p_WG.z() + 0.005;
    snips.whole.shape = scene::Block{{0.03, 0.03, height}};
    snips.whole.X_PE = RigidTransform(Quaternion(turn), Vector3(p_WG.x(), p_WG.y(), height / 2));
    snips.tool = scene::ToolSpec{
        .action = scene::ToolAction::kCut, .axis = {1, 0, 0}, .edge = 0.05, .reach = 5};
    scene->objects.push_back(snips);
  }
  static Command CloseAtSpeed(double speed) {
    return MoveGripper{.arm = "all", .velocity = -speed};
  }
};

INSTANTIATE_TEST_SUITE_P(Seeds, RobotCommandsProperty, testing::Range(31u, 36u));

TEST_P(RobotCommandsProperty, EveryMotionCanBeUndoneAndRedone) {
  // The last three have three arms, a gripper of jaws with a coupling of joints, and two fingers
  // with a tool between them.
  const bool has_tool = GetParam() == 35;
  const robot::RobotModel model = GetParam() == 33   ? robot::ThreeArms().Model()
                                  : GetParam() == 34 ? TernWithJaws()
                                  : has_tool         ? Tern()
                                                     : Baxter();
  scene::SceneSpec scene = EverythingScene::MakeWithTools();
  if (has_tool) AddToolBetweenFingers(model, &scene);
  const auto make = [&] {
    return std::make_unique<Simulation>(scene, RobotPlacement{.model = model});
  };
  struct Moment {
    SimulationState state;
    std::uint64_t hash;
    Command command;
  };
  auto simulation = make();
  UndoBooks books(*simulation);
  simulation->AddListener(&books);
  RandomHands hands(GetParam());
  RandomRobot robot(GetParam());
  std::mt19937 random(GetParam());
  EventCounter counter;
  simulation->AddListener(&counter);
  std::vector<Moment> moments;
  int num_following = 0;
  // The grasp is no use of the tool; squeezing it again is one.
  std::vector<Command> script;
  if (has_tool) {
    script = {Grasp{.hand = HandName::kLeft, .object = "ball"},
              CloseAtSpeed(0.1),
              CloseAtSpeed(0),
              CloseAtSpeed(0.1),
              Undo(),
              Redo()};
  }
  for (std::size_t i = 0; i < 80; ++i) {
    const Command command = i < script.size()   ? script[i]
                            : random() % 5 == 0 ? Command(Undo())
                            : random() % 3 == 0 ? hands.Next(*simulation)
                                                : robot.Next(*simulation);
    if (!std::holds_alternative<Undo>(command) && !std::holds_alternative<Redo>(command)) {
      moments.push_back({simulation->Save(), simulation->state_hash(), command});
    }
    const std::uint64_t before = simulation->state_hash();
    if (simulation->Apply(command)) {
      EXPECT_EQ(simulation->state_hash(), before) << "a refused command changed something";
    }
    for (int tick = i < script.size() ? 120 : 4; tick > 0; --tick) simulation->Tick();
    num_following += simulation->is_robot_following() ? 1 : 0;
  }
  if (has_tool) {
    EXPECT_GT(counter.num_events[EventKind::kGripperHolds], 0);
    EXPECT_GT(counter.num_events[EventKind::kUsed], 0);
  }
  EXPECT_GT(books.num_undone(), 2);
  EXPECT_GT(num_following, 5);

  simulation->RemoveListener(&books);  // a restored simulation has no history to compare
  auto elsewhere = make();
  for (std::size_t i = moments.size() / 2; i < moments.size(); ++i) {
    std::array<std::uint64_t, 2> hashes{};
    for (std::size_t k = 0; k < 2; ++k) {
      Simulation& again = k == 0 ? *simulation : *elsewhere;
      again.Restore(moments[i].state);
      ASSERT_EQ(again.state_hash(), moments[i].hash);
      (void)again.Apply(moments[i].command);
      for (int tick = 0; tick < 8; ++tick) again.Tick();
      hashes[k] = again.state_hash();
    }
    ASSERT_EQ(hashes[0], hashes[1]) << "after command " << i;
  }
}

}  // namespace
}  // namespace smile::sim
