// Brains in Python, through the client in python/smile/brain.py.

#include <mutex>
#include <vector>

#include "brain_fixture.h"

namespace smile::brain {
namespace {

class PythonBrainTest : public BrainProcessTest {
 protected:
  fs::path Python(const std::string& text) {
    return Program("think.py", "import numpy as np\n" + text);
  }
  /// One whose step is this, from the third line on.
  fs::path Step(const std::string& lines) {
    return Python("def step(sensor, motor, aux):\n" + lines);
  }
};

TEST_F(PythonBrainTest, MovesJointsByWhatItSenses) {
  BrainProcess brain(
      Python("gain = 2\n"
             "def step(sensor, motor, aux):\n"
             "  motor.jointVelocities = gain * sensor.jointAngles\n"
             "  motor.gripperVelocities[:] = [1, -1]\n"
             "  if sensor.simTime > 0: motor.headVelocity = 0.25\n"
             "  if sensor.simTime > 1: motor.jointAngles = np.ones((2, 7)); aux.exit = True\n"));
  Started(brain);
  Sensor sensor = Classic(Sensor());
  sensor.arms[1].joints[2] = 0.5;
  const Motor first = Stepped(brain, sensor).motors.front();
  EXPECT_EQ(VelocitiesOf(first)(1, 2), 1);
  EXPECT_EQ(GrippersOf(first), Eigen::Vector2d(1, -1));
  EXPECT_FALSE(first.head_velocity || first.arms[0].joints);
  sensor.sim_time = 2;
  const StepReply last = Stepped(brain, sensor);
  EXPECT_EQ(last.motors.front().head_velocity, 0.25);
  EXPECT_EQ(JointsOf(last.motors.front()), LimbJoints::Ones());
  EXPECT_TRUE(last.exit);
  EXPECT_FALSE(brain.is_running());
}

TEST_F(PythonBrainTest, AnswersWithChunks) {
  BrainProcess brain(
      Step("  assert (aux.tickSeconds, aux.maxTicks) == (1 / 60, 600)\n"
           "  motor.jointVelocities = np.arange(42).reshape(2, 7, 3)\n"
           "  motor.gripperVelocities = [[0, 1], [2, 3]]\n"
           "  motor.headVelocity = [0.1, 0.2]\n"
           "  aux.imageSeconds = 5\n"
           "  if sensor.simTime > 0: motor.jointVelocities = np.ones((2, 7)); motor.ticks = 30\n"
           "  if sensor.simTime > 1: motor.ticks = [1, 2]\n"));
  Started(brain);
  const StepReply chunk = Stepped(brain);
  ASSERT_EQ(chunk.motors.size(), 3u);
  EXPECT_EQ(chunk.ticks, 3);
  EXPECT_EQ(VelocitiesOf(chunk.motors[2])(1, 0), 21 + 2);
  EXPECT_EQ(GrippersOf(chunk.motors[1]), Eigen::Vector2d(1, 3));
  EXPECT_EQ(chunk.motors[1].head_velocity, 0.2);
  EXPECT_EQ(chunk.image_seconds, 5.0);
  const StepReply held = Stepped(brain, {.sim_time = 1});
  EXPECT_EQ(held.ticks, 30);
  EXPECT_EQ(held.image_seconds, std::nullopt) << "sent when it changes";
  EXPECT_NE(ErrorIn(brain.Step(Classic(Sensor{.sim_time = 2})))
                .find("motor.ticks is 2, expected one number"),
            std::string::npos);
}

TEST_F(PythonBrainTest, ReceivesTheSameValuesAsScripts) {
  Aux aux = Classic(Aux());
  aux.arms[1].max_joints[6] = 3;
  aux.camera = CameraDescription{.width_px = 4, .height_px = 3};
  aux.camera_names = {"eye", "overhead"};
  aux.robot_files = {{"r.urdf", std::make_shared<const std::string>("<robot/>")}};
  aux.demonstration = "out/demo";
  aux.attention = {{"a", {"color", "size"}}, {"b", {}}};
  aux.plan = TaskPlan{
      .subtasks = {{"puts a", {"a", "tool"}, 1, 2, true}}, .sufficient = {0}, .goals = {"a", "b"}};
  BrainProcess brain(Python(
      "def init(aux):\n"
      "  assert aux.path == 'brain/' and (aux.numLimbs, aux.numJoints) == (2, 7)\n"
      "  assert aux.maxJointAngles[1, 6] == 3 and aux.minJointAngles.shape == (2, 7)\n"
      "  assert aux.cameraSize.tolist() == [[3, 4]] and (aux.cameraPose == np.eye(4)).all()\n"
      "  assert aux.demonstration == 'out/demo'\n"
      "  assert aux.attention == {'a': ['color', 'size'], 'b': []}\n"
      "  [subtask] = aux.plan.subtasks\n"
      "  assert (subtask.words, subtask.objects) == ('puts a', ['a', 'tool'])\n"
      "  assert (subtask.segments, subtask.isNecessary) == ((1, 2), True)\n"
      "  assert aux.plan.order.shape == (0, 2) and aux.plan.sufficient.tolist() == [0]\n"
      "  assert aux.plan.goals == ['a', 'b'] and 'planWords' not in aux\n"
      "  aux.initJointAngles = aux.maxJointAngles\n"
      "  aux.drawMarkers = [[1, 2, 3]]\n"
      "  aux.channels, aux.cameras, aux.imageSeconds = ['rgb', 'depth'], 'overhead', 2\n"
      "  aux.watch = 'demonstration' in aux\n"
      "  assert open(aux.robot).read() == '<robot/>' and aux.cameraNames == ['eye', 'overhead']\n"
      "def step(sensor, motor, aux):\n"
      "  assert (sensor.timeElapsed, sensor.simTime, sensor.demoCue) == (0.25, 2, True)\n"
      "  assert sensor.endEffPos.tolist() == [[1, 2, 3], [4, 5, 6]]\n"
      "  assert sensor.trackerLoc['r-S1'].tolist() == [7, 8, 9]\n"
      "  picture = sensor.rgbVision\n"
      "  assert picture.shape == (150, 200, 3) and picture.dtype == np.uint8\n"
      "  assert picture.flags.c_contiguous and picture[1, 2, 0] == 3 * 202 * 7 % 256\n"
      "  assert 'rgbVision' in sensor and 'depthVision' not in sensor\n"
      "  overhead = sensor.cameras.overhead\n"
      "  assert overhead.rgb.shape == (150, 200, 3) and overhead.intrinsics[0, 0] == 7\n"
      "  assert sensor.segmentNames == ['table', 'cube'] and sensor.heldObject == ['', 'cube']\n"
      "  assert sensor.isHolding.tolist() == [[False, True]]\n"
      "  if sensor.simTime == 2: del aux.drawMarkers\n"
      "  aux.cameras = []\n"));
  const InitReply reply = Started(brain, aux);
  EXPECT_EQ(reply.pictures, (PictureWishes{.channels = {.rgb = true, .depth = true},
                                           .cameras = {"overhead"},
                                           .image_seconds = 2}));
  EXPECT_TRUE(reply.watch);
  ASSERT_FALSE(reply.init_joints.empty());
  EXPECT_EQ(reply.init_joints[1], aux.arms[1].max_joints);
  EXPECT_EQ(reply.draw_markers, Eigen::RowVector3d(1, 2, 3));

  Sensor sensor = Classic(Sensor{.time_elapsed = 0.25, .sim_time = 2, .demo_cue = true});
  sensor.arms[0].X_WG.topRightCorner<3, 1>() << 1, 2, 3;
  sensor.arms[1].X_WG.topRightCorner<3, 1>() << 4, 5, 6;
  sensor.tracker_locations = {{"l-S1", {1, 1, 1}}, {"r-S1", {7, 8, 9}}};
  sensor.arms[1].held_object = "cube";
  const Image image = Gradient(200, 150);
  sensor.pictures = {{.image = image}, {.camera = {.fx = 7}, .image = image, .name = "overhead"}};
  sensor.segment_names = {"table", "cube"};
  const StepReply step = Stepped(brain, sensor);
  ASSERT_TRUE(step.draw_markers);
  EXPECT_EQ(step.draw_markers->rows(), 0);
  EXPECT_EQ(step.cameras, std::vector<std::string>());
}

TEST_F(PythonBrainTest, DrivesAnyArms) {
  BrainProcess brain(
      Python("def init(aux):\n"
             "  rail, arm = aux.arms\n"
             "  assert (rail.name, arm.name) == ('rail', 'arm') and arm.joints == ['a', 'b', 'c']\n"
             "  assert arm.minJoints.tolist() == [-1, -2, -3] and arm.maxVelocities[2] == 6\n"
             "  assert rail.gripper.tolist() == [0, 2] and arm.gripper is None\n"
             "  assert arm.toolPose[2, 3] == 0.7 and 'numLimbs' not in aux\n"
             "  arm.initJoints = [0.1, 0.2, 0.3]\n"
             "def step(sensor, motor, aux):\n"
             "  rail, arm = sensor.arms\n"
             "  assert 'arms' in sensor and 'jointAngles' not in sensor\n"
             "  assert rail.joints.tolist() == [1] and rail.velocities.tolist() == [0.1]\n"
             "  assert rail.gripper == 0.5 and arm.gripper is None\n"
             "  assert arm.endEffector[0, 3] == 9 and rail.heldObject == 'cube'\n"
             "  motor.arms[1].velocities = 2 * arm.joints\n"
             "  motor.arms[0].gripperVelocity = -1\n"
             "  if sensor.simTime > 0: motor.arms[1].velocities = np.arange(6).reshape(3, 2)\n"
             "  if sensor.simTime > 1: motor.arms[0].joints = 0.5\n"));
  const InitReply reply = Started(brain, {.arms = RailAndArm()});
  ASSERT_EQ(reply.init_joints.size(), 2u);
  EXPECT_EQ(reply.init_joints[0], std::nullopt);
  EXPECT_EQ(reply.init_joints[1], (std::vector{0.1, 0.2, 0.3}));
  Sensor sensor{.arms = RailAndArmSensed()};
  const StepReply first = Stepped(brain, sensor);
  EXPECT_EQ(first.motors.at(0).arms.at(1).velocities, (std::vector{4.0, 6.0, 8.0}));
  EXPECT_EQ(first.motors.at(0).arms.at(0).gripper_velocity, -1);
  EXPECT_EQ(first.motors.at(0).arms.at(0).velocities, std::vector{0.0});
  sensor.sim_time = 1;
  const StepReply chunk = Stepped(brain, sensor);
  ASSERT_EQ(chunk.motors.size(), 2u);
  EXPECT_EQ(chunk.motors[1].arms[1].velocities, (std::vector{1.0, 3.0, 5.0}));
  EXPECT_EQ(chunk.motors[1].arms[0].gripper_velocity, -1) << "the last value remains";
  sensor.sim_time = 2;
  const StepReply last = Stepped(brain, sensor);
  EXPECT_EQ(last.motors.at(0).arms[0].joints, std::vector{0.5});
  EXPECT_EQ(last.motors.at(0).arms[1].joints, std::nullopt);
}

TEST_F(PythonBrainTest, MayUseArmsOfTheClassicRobot) {
  BrainProcess brain(
      Step("  if sensor.simTime == 0: motor.jointVelocities[1] = sensor.arms[1].joints\n"
           "  if sensor.simTime == 1:\n"
           "    motor.jointVelocities[:] = 0\n"
           "    motor.arms[1].velocities = sensor.arms[1].joints\n"
           "  if sensor.simTime == 2: motor.jointVelocities[0, 0] = 1\n"));
  Started(brain);
  Sensor sensor = Classic(Sensor());
  sensor.arms[1].joints[6] = 0.7;
  const Motor classic = Stepped(brain, sensor).motors.front();
  EXPECT_EQ(VelocitiesOf(classic)(1, 6), 0.7);
  sensor.sim_time = 1;
  EXPECT_EQ(VelocitiesOf(Stepped(brain, sensor).motors.front()), VelocitiesOf(classic));
  sensor.sim_time = 2;
  EXPECT_EQ(ErrorIn(brain.Step(sensor)),
            "brain/think.py: motor.jointVelocities and motor.arms are both set, expected one of "
            "them");
}

TEST_F(PythonBrainTest, NamesTheGeneralFormOfAClassicVariable) {
  const auto error_of = [&](const char* line) {
    BrainProcess brain(Step(std::string("  ") + line + "\n"));
    Started(brain, {.arms = RailAndArm()});
    return ErrorIn(brain.Step({.arms = RailAndArmSensed()}));
  };
  EXPECT_TRUE(error_of("sensor.jointAngles")
                  .ends_with("; it is for two arms of seven joints, use sensor.arms[k].joints"));
  EXPECT_TRUE(error_of("motor.jointVelocities[:] = 0")
                  .ends_with("; it is for two arms of seven joints, use motor.arms[k].velocities"));
  EXPECT_EQ(error_of("motor.arms[1].velocities = [1, 2]"),
            "brain/think.py:3: ValueError: motor.arms[1].velocities is 2, expected 3");
  EXPECT_EQ(error_of("motor.arms[1].velocities[2] = np.nan"),
            "brain/think.py: ValueError: motor.arms[1].velocities[2] is nan, expected a finite "
            "number");
  EXPECT_EQ(error_of("motor.arms[1].gripperVelocity = 1"),
            "brain/think.py: motor.arms(2).gripperVelocity is set, but the arm \"arm\" has no "
            "gripper");
}

TEST_F(PythonBrainTest, DistinguishesValuesOfEqualLength) {
  // Messages of the same length, but not laid out alike; and arrays that are kept stay as they are.
  BrainProcess brain(
      Step("  held = [0, 'ab', 'cd', 'ab'][int(sensor.simTime)]\n"
           "  assert sensor.heldObject == [held, ''], sensor.heldObject\n"
           "  assert (sensor.isHolding == [[True, False]]).all()\n"
           "  if sensor.simTime == 1: aux.kept = sensor\n"
           "  assert aux.kept.simTime == 1 and (aux.kept.jointAngles == 1).all()\n"
           "  aux.kept.isHolding[0, 1] = False; sensor.jointAngles[:] += 0\n"
           "  if sensor.simTime > 1: motor.headVelocity = sensor.simTime\n"
           "  if sensor.simTime > 2: motor.headVelocity = None\n"));
  Started(brain);
  const char* held[] = {"", "ab", "cd", "ab"};
  for (const int time : {1, 2, 3}) {
    Sensor sensor = Classic(Sensor{.sim_time = static_cast<double>(time)});
    for (ArmSensor& arm : sensor.arms) arm.joints.assign(kJointCount, time);
    sensor.arms[0].held_object = held[time];
    const auto velocity = Stepped(brain, sensor).motors.front().head_velocity;
    EXPECT_EQ(velocity, time == 2 ? std::optional(2.0) : std::nullopt);
  }
}

TEST_F(PythonBrainTest, NamesTheLineOfItsOwnFiles) {
  EXPECT_EQ(ErrorOfStep(Step("  y = 1\n  return y + lost\n")),
            "brain/think.py:4: NameError: name 'lost' is not defined");
  EXPECT_EQ(ErrorOfInit(Python("def init(aux): raise ValueError('no luck')\ndef step(*_): pass")),
            "brain/think.py:2: ValueError: no luck");
  EXPECT_EQ(ErrorOfInit(Python("x = = 2")), "brain/think.py:2: SyntaxError: invalid syntax");
  EXPECT_EQ(ErrorOfInit(Python("x = 1")),
            "brain/think.py: NameError: function step(sensor, motor, aux) is missing");
  // The line that called numpy, not one inside it; and that of a module beside the program.
  EXPECT_EQ(ErrorOfStep(Step("  x = 1\n  np.linalg.inv(np.zeros((2, 2)))\n")),
            "brain/think.py:4: LinAlgError: Singular matrix");
  Program("helper.py", "def help():\n  return 1 / 0\n");
  EXPECT_EQ(ErrorOfStep(Step("  import helper\n  helper.help()\n")),
            "brain/helper.py:2: ZeroDivisionError: division by zero");
}

TEST_F(PythonBrainTest, RefusesWhatNoMotorTakes) {
  const std::pair<const char*, const char*> mistakes[] = {
      {"motor.jointVelocities = np.zeros((7, 2))",
       ":3: ValueError: motor.jointVelocities is 7x2, expected 2x7"},
      {"motor.jointVelocities[0, 1] = np.nan",
       ": ValueError: motor.jointVelocities[0, 1] is nan, expected a finite number"},
      {"motor.gripperVelocities = 'open'",
       ":3: TypeError: motor.gripperVelocities is str of <U4, expected real numbers"},
      {"motor.jointVelocity = 1",
       ":3: AttributeError: motor.jointVelocity is unknown, expected jointVelocities, "
       "gripperVelocities, jointAngles, headVelocity"},
      {"sensor.jointAngels", ":3: AttributeError: jointAngels is unknown, expected timeElapsed, "},
      {"aux.exit = motor.jointVelocities = None",
       ":3: ValueError: motor.jointVelocities is None, expected numbers"},
  };
  for (const auto& [line, message] : mistakes) {
    const std::string error = ErrorOfStep(Step(std::string("  ") + line + "\n"));
    EXPECT_TRUE(error.starts_with(std::string("brain/think.py") + message)) << error;
  }
}

TEST_F(PythonBrainTest, StopsEndlessLoopsAndNamesTheirLine) {
  const BrainOptions hasty{.callback_seconds = 0.3};
  const std::string late = ": the callback took longer than 0.3 s and was stopped";
  EXPECT_EQ(ErrorOfStep(Step("  while True: pass\n"), hasty), "brain/think.py:3" + late);
  EXPECT_EQ(ErrorOfStep(Step("  import time\n  time.sleep(30)\n"), hasty),
            "brain/think.py:4" + late);
  // One that swallows what it can is ended all the same.
  const fs::path stubborn =
      Step("  while True:\n    try:\n      while True: pass\n    except BaseException: pass\n");
  EXPECT_NE(ErrorOfStep(stubborn, hasty).find(late), std::string::npos);
}

TEST_F(PythonBrainTest, ShowsWhatItPrintsAndItsTraceback) {
  BrainProcess brain(Step("  print('nearly there')\n  lost()\n"));
  Started(brain);
  const auto reply = brain.Step(Classic(Sensor{}));
  ASSERT_TRUE(std::holds_alternative<BrainError>(reply));
  const auto& output = std::get<BrainError>(reply).output;
  ASSERT_GE(output.size(), 4u);
  EXPECT_EQ(output[0], "nearly there");
  EXPECT_EQ(output[1], "Traceback (most recent call last):");
  EXPECT_NE(output[2].find("brain/think.py\", line 4, in step"), std::string::npos) << output[2];
}

TEST_F(PythonBrainTest, ReportsMissingPythonModules) {
  const std::string source = fs::path(SMILE_SOURCE_DIR) / "python";
  const std::pair<std::string, const char*> pythons[] = {
      {"exec /usr/bin/python3 -S", "has no numpy; install numpy, or set SMILE_PYTHON"},
      {"PYTHONPATH=" + source + " exec /usr/bin/python3", "cannot load smile_brain_native"}};
  for (const auto& [command, message] : pythons) {
    const fs::path bare = Program("bare", "#!/bin/sh\n" + command + " \"$@\"\n");
    ::setenv("SMILE_PYTHON", bare.c_str(), 1);
    BrainProcess brain(Step("  pass\n"));
    const auto reply = brain.Init(Classic(Aux()));
    ::unsetenv("SMILE_PYTHON");
    ASSERT_TRUE(std::holds_alternative<BrainError>(reply));
    std::string output;
    for (const std::string& line : std::get<BrainError>(reply).output) output += line + "\n";
    EXPECT_NE(output.find(message), std::string::npos) << output;
  }
}

TEST_F(PythonBrainTest, TheWaveExampleWaves) {
  BrainProcess brain(fs::path(SMILE_SOURCE_DIR) / "python/examples/wave.py");
  EXPECT_FALSE(Started(brain).init_joints.empty());
  const StepReply reply = Stepped(brain);
  EXPECT_EQ(VelocitiesOf(reply.motors.front())(0, 0), 0.4);
  EXPECT_EQ(VelocitiesOf(reply.motors.front())(1, 0), -0.4);
}

}  // namespace
}  // namespace smile::brain
