#include "brain/brain_driver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "base/files.h"
#include "classic_arms.h"
#include "robot/test/generated_robot.h"
#include "robot/urdf_reader.h"

namespace smile::brain {
namespace {

/// An eye whose pictures are all alike.
class GrayEye : public sim::Eye {
 public:
  const Image& Draw(const scene::VisualModel&, const sim::ViewSample&) override { return image_; }
  const sim::EyeSpec& spec() const override { return spec_; }

 private:
  sim::EyeSpec spec_{.width_px = 2, .height_px = 1};
  Image image_{.width_px = 2, .height_px = 1, .color = std::vector<std::uint8_t>(6, 128)};
};

/// A driver whose brain is the test.
class BrainDriverTest : public ::testing::Test {
 protected:
  static sim::RobotPlacement Baxter() {
    static const robot::RobotModel kBaxter = robot::ReadRobot(DataFile("robots/baxter.urdf"));
    return {.model = kBaxter};
  }

  void TickSeconds(double seconds) {
    for (int i = 0; i < seconds * sim::kTicksPerSecond; ++i) simulation_.Tick();
  }
  void Start(const InitReply& reply = {}) {
    EXPECT_TRUE(std::holds_alternative<Aux>(driver_.NextQuestion(&simulation_).value()));
    driver_.Take(reply, &simulation_);
  }
  /// Runs a tick. Returns the sensor data sent to the brain before it; nullopt if it was not asked.
  std::optional<Sensor> Step(const StepReply& reply = {}) {
    const std::optional<BrainQuestion> question = driver_.NextQuestion(&simulation_);
    if (question) driver_.Take(reply, &simulation_);
    simulation_.Tick();
    return question ? std::optional(std::get<Sensor>(*question)) : std::nullopt;
  }
  /// A brain that is given a demonstration with frames at these ticks, and asks to watch it. The
  /// picture of frame k is of the color k + 1.
  void StartToWatch(std::vector<std::uint64_t> ticks) {
    const auto frames = [ticks, next = std::size_t{0}]() mutable {
      const std::size_t frame = next++;
      return frame < ticks.size() ? FrameAt(ticks[frame], frame + 1) : std::nullopt;
    };
    driver_ = BrainDriver({.eye = &eye_, .demonstration = "demo", .frames = frames});
    Start({.watch = true});
  }
  static std::optional<DemonstrationFrame> FrameAt(std::uint64_t tick, std::size_t color) {
    const auto byte = static_cast<std::uint8_t>(color);
    return DemonstrationFrame{.tick = tick,
                              .view = {.intrinsics = {.width_px = 1, .height_px = 1},
                                       .X_WC = RigidTransform(Vector3(0.1, 0, 0))},
                              .image = {.width_px = 1, .height_px = 1, .color = {byte, 0, 0}}};
  }
  /// A chunk whose commands turn joints ever faster, all in another way.
  static StepReply Chunk(int num_motors, int ticks) {
    StepReply reply{.motors = std::vector<Motor>(static_cast<std::size_t>(num_motors)),
                    .ticks = ticks};
    for (int k = 0; k < num_motors; ++k) {
      Motor& motor = reply.motors[static_cast<std::size_t>(k)];
      motor = MotorOf(LimbJoints::Constant(0.01 * (k + 1)), {0.1 * k, -0.1});
      motor.head_velocity = 0.02 * k;
    }
    return reply;
  }
  /// An answer that turns all joints.
  static StepReply Turning() {
    StepReply reply;
    reply.motors.front() = MotorOf(LimbJoints::Constant(0.5));
    return reply;
  }

  GrayEye eye_;
  sim::Simulation simulation_{scene::SceneSpec{.name = "test"}, Baxter()};
  BrainDriver driver_{{.eye = &eye_}};
};

TEST_F(BrainDriverTest, PicturesKeepTheirRateInAnOldSimulation) {
  TickSeconds(2);
  Start();
  std::vector<int> steps_with_picture;
  for (int step = 0; step < 40; ++step) {
    if (!Step().value().pictures.empty()) steps_with_picture.push_back(step);
  }
  EXPECT_EQ(steps_with_picture, (std::vector<int>{0, 15, 30}));
}

/// Commands with their ticks, and the state after each tick.
struct CommandWitness : sim::Listener {
  void OnCommand(const sim::Simulation& simulation, const sim::Command& command) override {
    commands.emplace_back(simulation.tick(), command);
  }
  void OnTick(const sim::Simulation& simulation) override {
    hashes.push_back(simulation.state_hash());
  }
  std::vector<std::pair<std::uint64_t, sim::Command>> commands;
  std::vector<std::uint64_t> hashes;
};

TEST_F(BrainDriverTest, AChunkIsRecordedLikeItsCommandsOneByOne) {
  CommandWitness of_chunk, of_single;
  Start();
  simulation_.AddListener(&of_chunk);
  EXPECT_TRUE(Step(Chunk(5, 8)));
  for (int tick = 1; tick < 8; ++tick) EXPECT_FALSE(Step()) << tick;
  const Sensor next = Step().value();
  EXPECT_EQ(next.time_elapsed, 8 / 60.);

  sim::Simulation single(scene::SceneSpec{.name = "test"}, Baxter());
  BrainDriver driver({.eye = &eye_});
  driver.NextQuestion(&single);
  driver.Take(InitReply(), &single);
  single.AddListener(&of_single);
  const StepReply chunk = Chunk(5, 8);
  for (std::size_t tick = 0; tick < 9; ++tick) {
    EXPECT_TRUE(driver.NextQuestion(&single));
    StepReply reply;
    if (tick < 8) reply.motors = {chunk.motors[std::min(tick, chunk.motors.size() - 1)]};
    driver.Take(reply, &single);
    single.Tick();
  }
  EXPECT_EQ(of_chunk.commands, of_single.commands);
  EXPECT_EQ(of_chunk.hashes, of_single.hashes);
  EXPECT_GT(VelocitiesOf(next).norm(), 0.01);
}

/// One motor command for three arms: of each, the first joint turns; the gripper of the last one
/// closes.
Motor TurningArms(const std::vector<ArmDescription>& arms) {
  Motor motor;
  for (const ArmDescription& arm : arms) {
    ArmMotor& one = motor.arms.emplace_back();
    one.velocities.assign(arm.joint_names.size(), 0);
    one.velocities[0] = 0.3;
  }
  motor.arms.back().gripper_velocity = 1;
  return motor;
}

TEST_F(BrainDriverTest, DrivesAnyArms) {
  sim::Simulation simulation(
      scene::SceneSpec{.name = "test", .table = {.x_span = 1.6, .y_span = 2.4}},
      sim::RobotPlacement{.model = robot::ThreeArms().Model()});
  BrainDriver driver({.may_read = {.trackers = true, .arms = false}});
  const Aux aux = std::get<Aux>(driver.NextQuestion(&simulation).value());
  EXPECT_TRUE(aux.table_size.isApprox(Eigen::RowVector2d(16, 24))) << "in units";
  ASSERT_EQ(aux.arms.size(), 3u);
  EXPECT_TRUE(aux.sends_arms) << "there are no classic variables";
  EXPECT_EQ(aux.arms[0].name, "front");
  EXPECT_EQ(aux.arms[2].joint_names.size(), 7u);
  EXPECT_EQ(aux.arms[0].max_velocities, std::vector<double>(4, 2.0));
  EXPECT_NEAR(aux.arms[0].gripper.value()[1], 1, 1e-12) << "in units";
  EXPECT_FALSE(aux.arms[1].gripper);
  EXPECT_NEAR(aux.arms[1].X_LG(2, 3), 1, 1e-12) << "in units";

  driver.Take(InitReply{.init_joints = {std::nullopt, std::vector<double>(6, 0.1), std::nullopt}},
              &simulation);
  const Sensor first = std::get<Sensor>(driver.NextQuestion(&simulation).value());
  EXPECT_EQ(first.arms[1].joints, std::vector<double>(6, 0.1));
  EXPECT_EQ(first.arms[0].joints, (std::vector{0.0, 0.5, 0.5, 0.5}));
  EXPECT_TRUE(first.tracker_locations.empty()) << "these are points of the classic robot";
  EXPECT_EQ(first.arms[0].gripper, 0.0);
  const RigidTransform X_WG = simulation.robot()->ToolPose(2);
  EXPECT_NEAR(first.arms[2].X_WG(2, 3), 10 * X_WG.translation().z(), 1e-9);

  driver.Take(StepReply{.motors = {TurningArms(aux.arms)}, .ticks = 30}, &simulation);
  simulation.Tick();
  for (int tick = 1; tick < 30; ++tick) {
    EXPECT_FALSE(driver.NextQuestion(&simulation));
    simulation.Tick();
  }
  const Sensor last = std::get<Sensor>(driver.NextQuestion(&simulation).value());
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(last.arms[k].joints[0] - first.arms[k].joints[0], 0.15, 0.01) << k;
  }
  EXPECT_NEAR(last.arms[2].gripper.value(), 0.5, 0.05);
  EXPECT_NEAR(last.arms[0].gripper.value(), 0, 0.01);
}

TEST_F(BrainDriverTest, SendsArmsOfTheClassicRobotToThoseThatMayReadThem) {
  for (const bool may_read : {true, false}) {
    BrainDriver driver({.may_read = {.trackers = false, .arms = may_read}});
    EXPECT_EQ(std::get<Aux>(driver.NextQuestion(&simulation_).value()).sends_arms, may_read);
    driver.Take(InitReply(), &simulation_);
    EXPECT_EQ(std::get<Sensor>(driver.NextQuestion(&simulation_).value()).sends_arms, may_read);
  }
}

TEST_F(BrainDriverTest, NeedsARobotWithArms) {
  sim::Simulation simulation(scene::SceneSpec{.name = "test"});
  BrainDriver driver({});
  EXPECT_THROW(driver.NextQuestion(&simulation), std::invalid_argument);
}

TEST_F(BrainDriverTest, AChunkEndsWhenTheClockJumps) {
  Start();
  const sim::Spawn spawn{.xml =
                             "<tabletop xmlns=\"http://synapse.cs.umd.edu/tabletop-xml\">"
                             "<block id=\"a\" location=\"(0,0,0.5)\"/></tabletop>"};
  ASSERT_EQ(simulation_.Apply(spawn), std::nullopt);
  Step(Chunk(30, 30));
  EXPECT_FALSE(Step());
  ASSERT_EQ(simulation_.Apply(sim::Undo{}), std::nullopt);
  const Sensor sensor = Step().value();
  EXPECT_EQ(sensor.sim_time, 0);
  EXPECT_EQ(sensor.time_elapsed, 1 / 60.);
}

TEST_F(BrainDriverTest, AChunkEndsWithItsBrain) {
  Start();
  StepReply last = Chunk(30, 30);
  last.exit = true;
  Step(last);
  EXPECT_EQ(driver_.status(), BrainStatus::kExited);
  TickSeconds(0.5);
  EXPECT_LT(simulation_.robot()->ArmVelocities(0)[0], 1e-6);
}

TEST_F(BrainDriverTest, AStepGetsOnePictureHoweverManyWereDue) {
  Start();
  std::vector<std::uint64_t> ticks;
  for (int tick = 0; tick < 90; ++tick) {
    const std::optional<Sensor> sensor = Step(Chunk(1, tick < 40 ? 40 : 1));
    if (sensor && !sensor->pictures.empty()) ticks.push_back(simulation_.tick() - 1);
  }
  EXPECT_EQ(ticks, (std::vector<std::uint64_t>{0, 40, 45, 60, 75}));
}

TEST_F(BrainDriverTest, AStepMayChangeTheTimeBetweenPictures) {
  Start({.pictures = {.image_seconds = 3600}});
  std::vector<int> steps_with_picture;
  for (int step = 0; step < 30; ++step) {
    StepReply reply;
    if (step == 5) reply.image_seconds = 0;
    if (step >= 7) reply.image_seconds = 0.1;  // again and again, which changes nothing
    if (!Step(reply).value().pictures.empty()) steps_with_picture.push_back(step);
  }
  EXPECT_EQ(steps_with_picture, (std::vector<int>{0, 6, 7, 13, 19, 25}));
}

TEST_F(BrainDriverTest, ShowsTheDemonstrationFrameByFrameOnRequest) {
  TickSeconds(1);
  StartToWatch({0, 15, 18});
  std::vector<int> ticks;
  for (int tick = 0; tick <= 18; ++tick) {
    const std::optional<Sensor> sensor = Step(Turning());
    EXPECT_EQ(simulation_.face_expression(), robot::FaceExpression::kWatching);
    if (!sensor) continue;
    ticks.push_back(tick);
    EXPECT_TRUE(sensor->demo_cue);
    ASSERT_EQ(sensor->pictures.size(), 1u);
    EXPECT_EQ(sensor->pictures[0].image.color[0], ticks.size()) << "a picture of another frame";
    EXPECT_EQ(sensor->pictures[0].camera.width_px, 1);
    EXPECT_NEAR(sensor->pictures[0].camera.X_WC(0, 3), 1, 1e-12) << "in units";
    EXPECT_EQ(sensor->time_elapsed, (std::array{1., 15., 3.}[ticks.size() - 1] / 60));
    EXPECT_EQ(sensor->sim_time, 1 + tick / 60.);
    EXPECT_TRUE(VelocitiesOf(*sensor).isZero(0)) << "the robot rests";
  }
  EXPECT_EQ(ticks, (std::vector<int>{0, 15, 18}));
  const Sensor first = Step(Turning()).value();
  EXPECT_FALSE(first.demo_cue);
  EXPECT_EQ(first.time_elapsed, 1 / 60.);
  ASSERT_EQ(first.pictures.size(), 1u);
  EXPECT_EQ(first.pictures[0].image.color[0], 128) << "of its own eye";
  EXPECT_EQ(driver_.watched_ticks(), 19u);
  EXPECT_TRUE(Step(Turning()).value().pictures.empty()) << "its own come at their rate";
  EXPECT_GT(VelocitiesOf(Step().value()).norm(), 0.01) << "now it moves";
  EXPECT_EQ(driver_.watched_ticks(), 19u);
}

TEST_F(BrainDriverTest, ShowsThePicturesAsRecordedWhenSensorsAreNoisy) {
  driver_ = BrainDriver({.demonstration = "demo",
                         .frames = [] { return FrameAt(0, 100); },
                         .noise = {.joints = 0.1, .image = 0.5}});
  Start({.watch = true});
  const Sensor sensor = Step().value();
  EXPECT_EQ(sensor.pictures.at(0).image.color, (std::vector<std::uint8_t>{100, 0, 0}));
  EXPECT_GT(JointsOf(sensor).norm(), 0.01);
}

TEST_F(BrainDriverTest, ADemonstrationIsShownOnlyOnRequest) {
  driver_ = BrainDriver({.demonstration = "demo", .frames = [] { return FrameAt(0, 1); }});
  Start();
  EXPECT_FALSE(Step().value().demo_cue);
  EXPECT_EQ(driver_.watched_ticks(), 0u);
}

TEST_F(BrainDriverTest, ABrainMayExitWhileItWatches) {
  StartToWatch({0, 15, 30});
  Step({.exit = true});
  EXPECT_EQ(driver_.status(), BrainStatus::kExited);
  EXPECT_EQ(simulation_.face_expression(), robot::FaceExpression::kDone);
}

TEST_F(BrainDriverTest, AnUnreadableDemonstrationEndsTheBrain) {
  driver_ =
      BrainDriver({.demonstration = "demo", .frames = []() -> std::optional<DemonstrationFrame> {
                     throw std::runtime_error("demo/0/0.png: no such file");
                   }});
  Start({.watch = true});
  EXPECT_EQ(driver_.status(), BrainStatus::kFailed);
  EXPECT_EQ(driver_.error().value().message,
            "the demonstration cannot be shown: demo/0/0.png: no such file");

  driver_ = BrainDriver({.demonstration = "demo", .frames = [] {
                           DemonstrationFrame frame;
                           frame.image.color.resize(std::size_t{53} << 20);
                           return std::optional(std::move(frame));
                         }});
  Start({.watch = true});
  EXPECT_EQ(driver_.error().value().message,
            "the demonstration cannot be shown: its pictures are too large for a message, expected "
            "at most 52 MiB");
}

}  // namespace
}  // namespace smile::brain
