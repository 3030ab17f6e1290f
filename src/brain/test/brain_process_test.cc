#include "brain/brain_process.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <mutex>
#include <string>

#include "base/diagnostic.h"
#include "brain/brain_driver.h"
#include "brain_fixture.h"
#include "wire/wire.h"

namespace smile::brain {
namespace {

using wire::kProtocolVersion;
using wire::MessageType;
using wire::MessageWriter;

// ---- the life of a good brain -------------------------------------------------------------------

TEST_F(BrainProcessTest, AnOctaveBrainFindsTheFunctionsForMoving) {
  const std::string urdf = DataFile("robots/baxter.urdf").string();
  const fs::path folder = Brain(
      "assert(~isempty(which('smileForward')));\n"
      "if exist('smilemotion') == 3\n"  // not with sanitizers
      "  pose = smileForward(smileRobot('" +
          urdf +
          "'), 'left', zeros(1, 7));\n"
          "  assert(abs(pose(3, 4) - 0.32098) < 1e-5);\n"
          "end\n",
      "");
  BrainProcess brain(folder);
  Started(brain);
}

TEST_F(BrainProcessTest, MovesJointsByWhatItSenses) {
  BrainProcess brain(Brain("gain = 2;",
                           "motor.jointVelocities = gain * sensor.jointAngles;\n"
                           "motor.gripperVelocities = [1; -1];"));
  Started(brain);
  Sensor sensor = Classic(Sensor());
  sensor.arms[1].joints[2] = 0.5;
  const StepReply reply = Stepped(brain, sensor);
  EXPECT_EQ(VelocitiesOf(reply.motors.front()), LimbJoints(2 * JointsOf(sensor)));
  EXPECT_EQ(GrippersOf(reply.motors.front()), Eigen::Vector2d(1, -1));
  EXPECT_FALSE(reply.exit);
}

TEST_F(BrainProcessTest, KeepsVariablesAndMotorBetweenSteps) {
  BrainProcess brain(Brain("count = 0;",
                           "count = count + 1;\n"
                           "if count == 1, motor.jointVelocities(1, 1) = 3; end\n"
                           "motor.gripperVelocities = [count; 0];"));
  Started(brain);
  Stepped(brain);
  const StepReply reply = Stepped(brain);
  EXPECT_EQ(GrippersOf(reply.motors.front())(0), 2);
  EXPECT_EQ(VelocitiesOf(reply.motors.front())(0, 0), 3);
}

TEST_F(BrainProcessTest, SendsAuxAndReadsTheReply) {
  Aux aux = Classic(Aux());
  for (ArmDescription& arm : aux.arms) arm.min_joints.assign(kJointCount, -1);
  aux.arms[1].max_joints[6] = 3;
  aux.camera = CameraDescription{.width_px = 200, .height_px = 150, .fx = 130};
  aux.demonstration = "out/demo";
  aux.attention = {{"a", {"color", "size"}}, {"b", {"shape"}}};
  BrainProcess brain(
      Brain("assert(aux.path, 'brain/'); assert(exist([aux.path 'begin.m'], 'file') == 2);\n"
            "assert([aux.numLimbs aux.numJoints], [2 7]);\n"
            "assert(aux.cameraSize, [150 200]); assert(aux.cameraIntrinsics(1, 1), 130);\n"
            "assert(aux.cameraPose, eye(4)); assert(aux.demonstration, 'out/demo');\n"
            "assert(numel(aux.attention), 2); assert(aux.attention(1).object, 'a');\n"
            "assert(aux.attention(1).properties, {'color', 'size'});\n"
            "aux.initJointAngles = aux.minJointAngles + aux.maxJointAngles;\n"
            "aux.drawMarkers = [1 2 3; 4 5 6];",
            "assert(isfield(aux, 'drawMarkers'));"));
  const InitReply reply = Started(brain, aux);
  ASSERT_FALSE(reply.init_joints.empty());
  EXPECT_EQ(JointsOf(reply)(1, 6), 2);
  EXPECT_EQ(JointsOf(reply)(0, 0), -1);
  EXPECT_EQ(reply.draw_markers, (Eigen::Matrix<double, 2, 3>() << 1, 2, 3, 4, 5, 6).finished());
  Stepped(brain);
}

TEST_F(BrainProcessTest, SendsThePlanOfADemonstration) {
  Aux aux = Classic(Aux());
  aux.plan = TaskPlan{.subtasks = {{"puts a", {"a", "tool"}, 1, 2, true}, {"presses", {}, 3, 3}},
                      .order = {{0, 1}},
                      .sufficient = {0},
                      .goals = {"a", "b"}};
  BrainProcess brain(Brain(
      "plan = aux.plan;\n"
      "assert(numel(plan.subtasks), 2); assert(plan.subtasks(1).words, 'puts a');\n"
      "assert(plan.subtasks(1).objects, {'a', 'tool'}); assert(plan.subtasks(2).objects, {});\n"
      "assert(plan.subtasks(1).segments, [1 2]);\n"
      "assert([plan.subtasks.isNecessary], [true false]);\n"
      "assert(plan.order, [1 2]); assert(plan.sufficient, 1);\n"
      "assert(plan.goals, {'a', 'b'}); assert(!isfield(aux, 'planWords'));",
      "aux.exit = true;"));
  Started(brain, aux);
  // The smallest one: nothing has an order.
  aux.plan = TaskPlan{.subtasks = {{"presses", {"s"}, 1, 1}}};
  BrainProcess smallest(
      Brain("assert(size(aux.plan.order), [0 2]); assert(size(aux.plan.goals, 2), 0);\n"
            "assert(isempty(aux.plan.sufficient));\n"
            "assert(aux.plan.subtasks.objects, {'s'});",
            ""));
  Started(smallest, aux);
  BrainProcess without(Brain("assert(!isfield(aux, 'plan'));", ""));
  Started(without);
}

TEST_F(BrainProcessTest, SensorHasTheShapesOfTheScripts) {
  BrainProcess brain(
      Brain("",
            "assert(size(sensor.timeElapsed), [1 1]); assert(sensor.simTime, 2);\n"
            "assert(size(sensor.jointAngles), [2 7]); assert(sensor.endEffPos, [1 2 3; 4 5 6]);\n"
            "assert(sensor.gripperOpening, [0.5 2]); assert(islogical(sensor.demoCue));\n"
            "assert(sensor.demoCue);\n"
            "assert(sensor.trackerLoc('r-S1'), [7 8 9]);\n"
            "assert(keys(sensor.trackerLoc), {'l-S1', 'r-S1'});\n"
            "assert(!isfield(sensor, 'rgbVision'));"));
  Started(brain);
  Sensor sensor = Classic(Sensor{.time_elapsed = 0.25, .sim_time = 2, .demo_cue = true});
  sensor.arms[0].X_WG.topRightCorner<3, 1>() << 1, 2, 3;
  sensor.arms[1].X_WG.topRightCorner<3, 1>() << 4, 5, 6;
  sensor.arms[0].gripper = 0.5;
  sensor.arms[1].gripper = 2;
  sensor.tracker_locations = {{"l-S1", {1, 1, 1}}, {"r-S1", {7, 8, 9}}};
  Stepped(brain, sensor);
}

TEST_F(BrainProcessTest, EndsOnRequestOfTheScript) {
  BrainProcess brain(Brain("aux.exit = false;",
                           "if sensor.simTime > 1, aux.exit = true; end\n"
                           "motor.gripperVelocities = [5; 5];"));
  Started(brain);
  EXPECT_FALSE(Stepped(brain, {.sim_time = 1}).exit);
  const StepReply last = Stepped(brain, {.sim_time = 2});
  EXPECT_TRUE(last.exit);
  EXPECT_EQ(GrippersOf(last.motors.front())(0), 5);
  EXPECT_FALSE(brain.is_running());
  EXPECT_THROW(static_cast<void>(brain.Step(Classic(Sensor{}))), std::logic_error);
}

TEST_F(BrainProcessTest, SurvivesAScriptThatClearsEverything) {
  BrainProcess brain(
      Brain("clear all; close all; k = 1;", "clear functions; motor.gripperVelocities = [k; k];"));
  Started(brain);
  EXPECT_EQ(GrippersOf(Stepped(brain).motors.front())(0), 1);
  EXPECT_EQ(GrippersOf(Stepped(brain).motors.front())(0), 1);
}

TEST_F(BrainProcessTest, TakesABreakOutsideALoopAsTheEndOfTheScript) {
  BrainProcess brain(Brain("",
                           "motor.gripperVelocities = [1; 1];\nif true, break; end\n"
                           "motor.gripperVelocities = [2; 2];"));
  Started(brain);
  EXPECT_EQ(GrippersOf(Stepped(brain).motors.front())(0), 1);
  EXPECT_EQ(GrippersOf(Stepped(brain).motors.front())(0), 1);
}

TEST_F(BrainProcessTest, BothTransportsGiveTheSameAnswer) {
  const fs::path folder =
      Brain("",
            "v = sensor.rgbVision;\n"
            "motor.jointVelocities(1, 1:4) = [size(v, 1) size(v, 2) v(2, 3, 1) v(20, 30, 3)];\n"
            "motor.jointVelocities(2, 1:3) = [sum(v(:)) std(v(:)) sensor.simTime / 3];\n"
            "motor.headVelocity = single(0.25); motor.gripperVelocities = sensor.gripperOpening;");
  Sensor sensor = Classic(Sensor{.sim_time = 1.0, .pictures = {{.image = Gradient(200, 150)}}});
  sensor.arms[0].gripper = 1.0 / 3;
  sensor.arms[1].gripper = 2;
  std::vector<Motor> motors;
  for (const auto transport : {BrainTransport::kMex, BrainTransport::kPlain}) {
    BrainProcess brain(folder, {.transport = transport});
    Started(brain);
    motors.push_back(Stepped(brain, sensor).motors.front());
  }
  EXPECT_EQ(VelocitiesOf(motors[0]), VelocitiesOf(motors[1]));
  EXPECT_EQ(GrippersOf(motors[0]), GrippersOf(motors[1]));
  EXPECT_EQ(motors[0].head_velocity, motors[1].head_velocity);
  EXPECT_EQ(VelocitiesOf(motors[0])(0, 0), 150);
  // Row 2, column 3, red: the 202nd pixel of the image.
  EXPECT_EQ(VelocitiesOf(motors[0])(0, 2), (3 * 202 * 7 % 256) / 255.0);
}

TEST_F(BrainProcessTest, BothTransportsDriveAnyArms) {
  const fs::path folder = Brain(
      "assert({aux.arms.name}, {'rail', 'arm'}); assert(aux.arms(2).joints, {'a', 'b', 'c'});\n"
      "assert(aux.arms(2).minJoints, [-1 -2 -3]); assert(aux.arms(2).maxVelocities, [4 5 6]);\n"
      "assert(aux.arms(1).gripper, [0 2]); assert(isempty(aux.arms(2).gripper));\n"
      "assert(aux.arms(2).toolPose(3, 4), 0.7); assert(!isfield(aux, 'numLimbs'));\n"
      "aux.arms(2).initJoints = [0.1 0.2 0.3];",
      "assert(sensor.arms(1).joints, 1); assert(sensor.arms(1).velocities, 0.1);\n"
      "assert(sensor.arms(1).gripper, 0.5); assert(isempty(sensor.arms(2).gripper));\n"
      "assert(sensor.arms(2).endEffector(1, 4), 9);\n"
      "assert({sensor.arms.heldObject}, {'cube', ''}); assert(!isfield(sensor, 'jointAngles'));\n"
      "motor.arms(2).velocities = 2 * sensor.arms(2).joints;\n"
      "motor.arms(1).gripperVelocity = -1;\n"
      "if sensor.simTime > 0, motor.arms(2).velocities = reshape(0:5, 3, 2); end\n"
      "if sensor.simTime > 1, motor.arms(1).joints = 0.5; end\n"
      "if sensor.simTime > 2, motor.arms(1).joints = []; end\n"
      "if sensor.simTime > 3, motor.arms(2).velocities = [1 2]; end\n");
  for (const auto transport : {BrainTransport::kMex, BrainTransport::kPlain}) {
    BrainProcess brain(folder, {.transport = transport});
    const InitReply reply = Started(brain, {.arms = RailAndArm()});
    ASSERT_EQ(reply.init_joints.size(), 2u);
    EXPECT_EQ(reply.init_joints[0], std::nullopt);
    EXPECT_EQ(reply.init_joints[1], (std::vector{0.1, 0.2, 0.3}));
    std::vector<StepReply> replies;
    Sensor sensor{.arms = RailAndArmSensed()};
    for (; sensor.sim_time < 4; ++sensor.sim_time) replies.push_back(Stepped(brain, sensor));
    ASSERT_EQ(replies[1].motors.size(), 2u);
    EXPECT_EQ(replies[0].motors.at(0).arms.at(1).velocities, (std::vector{4.0, 6.0, 8.0}));
    EXPECT_EQ(replies[0].motors.at(0).arms.at(0).gripper_velocity, -1);
    EXPECT_EQ(replies[1].motors[1].arms[1].velocities, (std::vector{3.0, 4.0, 5.0}));
    EXPECT_EQ(replies[1].motors[1].arms[0].gripper_velocity, -1) << "the last value remains";
    EXPECT_EQ(replies[2].motors.at(0).arms[0].joints, std::vector{0.5});
    EXPECT_EQ(replies[3].motors.at(0).arms[0].joints, std::nullopt);
    EXPECT_EQ(ErrorIn(brain.Step(sensor)),
              "brain/act.m: motor.arms(2).velocities is 1x2, expected 1x3 or 3xN");
  }
}

TEST_F(BrainProcessTest, SearchesScriptsForValuesThatTheyMayRead) {
  EXPECT_EQ(WhatMayBeRead(Brain("", "x = 1;")), (MayRead{.trackers = false, .arms = false}));
  EXPECT_EQ(WhatMayBeRead(Brain("", "keys(sensor.trackerLoc);")),
            (MayRead{.trackers = true, .arms = false}));
  EXPECT_EQ(WhatMayBeRead(Brain("numel(aux.arms)", "")),
            (MayRead{.trackers = false, .arms = true}));
  Program("parts/see.m", "keys(sensor.trackerLoc);");
  EXPECT_EQ(WhatMayBeRead(Brain("", "see();")), (MayRead{.trackers = true, .arms = false}));
  EXPECT_EQ(WhatMayBeRead(Program("think.py", "")), MayRead());
}

TEST_F(BrainProcessTest, ScriptsMayUseArmsOfTheClassicRobot) {
  BrainProcess brain(Brain("assert(numel(aux.arms), 2);",
                           "if sensor.simTime == 0, motor.jointVelocities(2, 7) = 0.7; end\n"
                           "if sensor.simTime == 1\n"
                           "  motor.jointVelocities(:) = 0;\n"
                           "  motor.arms(2).velocities(7) = 0.7;\n"
                           "end\n"
                           "if sensor.simTime == 2, motor.jointVelocities(1) = 1; end\n"));
  Started(brain);
  const LimbJoints classic = VelocitiesOf(Stepped(brain).motors.front());
  EXPECT_EQ(classic(1, 6), 0.7);
  EXPECT_EQ(VelocitiesOf(Stepped(brain, {.sim_time = 1}).motors.front()), classic);
  EXPECT_EQ(ErrorIn(brain.Step(Classic(Sensor{.sim_time = 2}))),
            "brain/act.m: motor.jointVelocities and motor.arms are both set, expected one of them");
}

TEST_F(BrainProcessTest, NamesTheGeneralFormOfAClassicVariable) {
  const auto error_of = [&](const char* line) {
    BrainProcess brain(Brain("", std::string("x = 1;\n") + line));
    Started(brain, {.arms = RailAndArm()});
    return ErrorIn(brain.Step({.arms = RailAndArmSensed()}));
  };
  const std::string sensed = error_of("y = sensor.jointAngles(1);");
  EXPECT_TRUE(sensed.starts_with("brain/act.m:2: ")) << sensed;
  EXPECT_TRUE(sensed.ends_with(
      "; sensor.jointAngles is for two arms of seven joints, use sensor.arms(k).joints"))
      << sensed;
  EXPECT_EQ(
      error_of("motor.jointVelocities = zeros(2, 7);"),
      "brain/act.m: motor.jointVelocities is for two arms of seven joints, but this robot has "
      "rail (1 joint), arm (3 joints): use motor.arms(k).velocities");
  EXPECT_EQ(error_of("motor.arms(2).velocity = 1;"),
            "brain/act.m: motor.arms(k).velocity is unknown, expected velocities, gripperVelocity "
            "or joints");
}

TEST_F(BrainProcessTest, BothTransportsBringChunks) {
  const fs::path folder = Brain(
      "assert(aux.tickSeconds, 1 / 60); assert(aux.maxTicks, 600);",
      "motor.jointVelocities = reshape(0:41, 2, 7, 3); motor.gripperVelocities = [0 1; 2 3];\n"
      "if sensor.simTime > 0, motor.jointVelocities = reshape(0:41, 2, 3, 7); end\n"
      "aux.imageSeconds = 5; motor.ticks = 2;");
  for (const auto transport : {BrainTransport::kMex, BrainTransport::kPlain}) {
    BrainProcess brain(folder, {.transport = transport});
    Started(brain);
    for (const bool is_first : {true, false}) {
      const StepReply chunk = Stepped(brain);
      ASSERT_EQ(chunk.motors.size(), 2u);
      EXPECT_EQ(VelocitiesOf(chunk.motors[1])(1, 0), 14 + 1);
      EXPECT_EQ(GrippersOf(chunk.motors[1]), Eigen::Vector2d(1, 3));
      EXPECT_EQ(chunk.image_seconds, is_first ? std::optional(5.0) : std::nullopt);
    }
    EXPECT_NE(
        ErrorIn(brain.Step(Classic(Sensor{.sim_time = 1}))).find("motor.jointVelocities is 2x3x7"),
        std::string::npos);
  }
}

TEST_F(BrainProcessTest, BothTransportsBringTheRequestedPictures) {
  const fs::path folder = Brain(
      "assert(aux.cameraNames, {'eye', 'overhead'}); assert(aux.unit, 0.5);\n"
      "assert(aux.tableSize, [20 12]); assert(aux.robotBase, eye(4)); assert(fileread(aux.robot), "
      "'<robot/>');\n"
      "assert(aux.maxJointVelocities, zeros(2, 7));\n"
      "aux.channels = {'depth', 'segmentation'}; aux.cameras = {'overhead'};\n"
      "aux.imageSeconds = 2; aux.watch = isfield(aux, 'demonstration');",
      "assert(sensor.jointVelocities(2, 7), 3); assert(sensor.headAngle, 0.25);\n"
      "assert(sensor.isHolding, [false true]); assert(islogical(sensor.isHolding));\n"
      "assert(isempty(sensor.heldObject{1})); assert(sensor.heldObject{2}, 'cube');\n"
      "assert(isempty(strfind([fieldnames(sensor){:}], 'cameras_')));\n"
      "if isfield(sensor, 'cameraPose')\n"
      "  assert(sensor.depthVision, [1 2; 3 4]); assert(sensor.segmentVision, [0 1; 2 1]);\n"
      "  assert(sensor.segmentNames, {'table', 'cube'}); assert(~isfield(sensor, 'rgbVision'));\n"
      "  assert(sensor.cameraPose, eye(4)); overhead = sensor.cameras.overhead;\n"
      "  assert(overhead.depth, [1 2; 3 4]); assert(overhead.intrinsics(1, 1), 7);\n"
      "  assert(overhead.pose, eye(4)); assert(overhead.segments(2, 1), 2);\n"
      "  aux.cameras = {};\n"
      "else\n"
      "  assert(~isfield(sensor, 'cameras'));\n"
      "  aux.cameras = {'overhead'};\n"
      "end");
  Aux aux{.camera = CameraDescription{.width_px = 2, .height_px = 2}};
  aux.camera_names = {"eye", "overhead"};
  aux.robot_files = {{"r.urdf", std::make_shared<const std::string>("<robot/>")}};
  aux.meters_per_unit = 0.5;
  aux.demonstration = "out/demo";
  const Image image{.width_px = 2, .height_px = 2, .depth = {1, 2, 3, 4}, .ids = {0, 1, 2, 1}};
  Sensor sensor = Classic(Sensor{.head_angle = 0.25});
  sensor.arms[1].velocities[6] = 3;
  sensor.arms[1].held_object = "cube";
  Sensor seeing = sensor;
  seeing.pictures = {{.image = image}, {.camera = {.fx = 7}, .image = image, .name = "overhead"}};
  seeing.segment_names = {"table", "cube"};
  for (const auto transport : {BrainTransport::kMex, BrainTransport::kPlain}) {
    BrainProcess brain(folder, {.transport = transport});
    const InitReply reply = Started(brain, aux);
    EXPECT_EQ(reply.pictures, (PictureWishes{.channels = {.rgb = false, .depth = true, .id = true},
                                             .cameras = {"overhead"},
                                             .image_seconds = 2}));
    EXPECT_TRUE(reply.watch);
    EXPECT_EQ(Stepped(brain, seeing).cameras, std::vector<std::string>());
    EXPECT_EQ(Stepped(brain, sensor).cameras, std::vector<std::string>{"overhead"});
    EXPECT_EQ(Stepped(brain, sensor).cameras, std::nullopt) << "they did not change";
  }
}

TEST_F(BrainProcessTest, BothTransportsDistinguishValuesOfEqualLength) {
  const fs::path folder =
      Brain("held = {'ab', 'cd', 'ab'};",
            "assert(sensor.heldObject, {held{sensor.simTime}, ''});\n"
            "assert(isfield(sensor, 'trackerLoc'), sensor.simTime == 2);\n"
            "motor.jointVelocities = sensor.jointAngles;\n"
            "if sensor.simTime == 1, clear aux; end\n"
            "if sensor.simTime == 2, aux.drawMarkers = [1 2 3]; motor.headVelocity = 2; end");
  for (const auto transport : {BrainTransport::kMex, BrainTransport::kPlain}) {
    BrainProcess brain(folder, {.transport = transport});
    Started(brain);
    const char* held[] = {"", "ab", "cd", "ab"};
    for (const int time : {1, 2, 3}) {
      Sensor sensor = Classic(Sensor{.sim_time = static_cast<double>(time)});
      for (ArmSensor& arm : sensor.arms) arm.joints.assign(kJointCount, time);
      sensor.arms[0].held_object = held[time];
      if (time == 2) sensor.tracker_locations = {{"l-S1", {1, 1, 1}}};
      const StepReply reply = Stepped(brain, sensor);
      EXPECT_EQ(VelocitiesOf(reply.motors.front()), JointsOf(sensor));
      EXPECT_EQ(reply.draw_markers.has_value(), time == 2);
      EXPECT_EQ(reply.motors.front().head_velocity, time == 1 ? std::nullopt : std::optional(2.0));
    }
  }
}

TEST_F(BrainProcessTest, ReportsMarkersWhenTheyChange) {
  BrainProcess brain(Brain("aux.drawMarkers = [1 2 3];",
                           "if sensor.simTime == 2, aux.drawMarkers = [4 5 6; 7 8 9]; end\n"
                           "if sensor.simTime == 4, aux = rmfield(aux, 'drawMarkers'); end"));
  EXPECT_EQ(Started(brain).draw_markers.rows(), 1);
  EXPECT_FALSE(Stepped(brain, {.sim_time = 1}).draw_markers);
  EXPECT_EQ(Stepped(brain, {.sim_time = 2}).draw_markers->rows(), 2);
  EXPECT_FALSE(Stepped(brain, {.sim_time = 3}).draw_markers);
  EXPECT_EQ(Stepped(brain, {.sim_time = 4}).draw_markers->rows(), 0);
}

// ---- mistakes in scripts ------------------------------------------------------------------------

TEST_F(BrainProcessTest, NamesTheLineOfAnUndefinedVariable) {
  EXPECT_EQ(ErrorOfStep(Brain("", "y = 1;\n\nz = y + lost;")), "brain/act.m:3: 'lost' undefined");
}

TEST_F(BrainProcessTest, PlainClientAlsoNamesTheLine) {
  EXPECT_EQ(
      ErrorOfStep(Brain("", "y = 1;\n\nz = y + lost;"), {.transport = BrainTransport::kPlain}),
      "brain/act.m:3: 'lost' undefined");
}

TEST_F(BrainProcessTest, NamesTheLineOfAMistakeInInit) {
  EXPECT_EQ(ErrorOfInit(Brain("x = 1;\nerror('no luck');", "")), "brain/begin.m:2: no luck");
}

TEST_F(BrainProcessTest, NamesTheLineOfAParseError) {
  EXPECT_EQ(ErrorOfInit(Brain("", "x = 1;\nx = = 2;")), "brain/act.m:2: syntax error: x = = 2;");
}

TEST_F(BrainProcessTest, BlamesTheScriptAndNotTheLibrary) {
  EXPECT_EQ(ErrorOfStep(Brain("", "x = 1;\nstrjoin(5);")).substr(0, 14), "brain/act.m:2:");
}

TEST_F(BrainProcessTest, NamesAScriptThatIsMissing) {
  const fs::path folder = Brain("", "");
  fs::remove(folder / "act.m");
  EXPECT_EQ(ErrorOfInit(folder),
            "brain/agentBehavior.m: agentBehavior names act, but act.m is missing");
}

TEST_F(BrainProcessTest, RefusesWrongShapesWithBothShapesNamed) {
  EXPECT_EQ(ErrorOfStep(Brain("", "motor.jointVelocities = zeros(7, 2);")),
            "brain/act.m: motor.jointVelocities is 7x2, expected 2x7");
  EXPECT_EQ(ErrorOfInit(Brain("aux.initJointAngles = 1;", "")),
            "brain/begin.m: aux.initJointAngles is 1x1, expected 2x7");
}

TEST_F(BrainProcessTest, RefusesWhatIsNotANumberByName) {
  for (const auto transport : {BrainTransport::kMex, BrainTransport::kPlain}) {
    const BrainOptions options{.transport = transport};
    EXPECT_EQ(ErrorOfStep(Brain("", "motor.jointVelocities = {1};"), options),
              "brain/act.m: motor.jointVelocities is a cell, expected real numbers");
    EXPECT_EQ(ErrorOfStep(Brain("", "motor = 7;"), options),
              "brain/act.m: motor is no longer a struct");
    EXPECT_EQ(ErrorOfStep(Brain("", "aux = 7;"), options),
              "brain/act.m: aux is no longer a struct");
  }
}

// ---- programs that misbehave --------------------------------------------------------------------

TEST_F(BrainProcessTest, StopsAnEndlessLoopAndNamesItsLine) {
  const fs::path folder = Brain("", "x = 1;\nwhile true\n  x = x + 1;\nend");
  std::string error;
  EXPECT_LT(SecondsOf([&] { error = ErrorOfStep(folder, {.callback_seconds = 0.5}); }), 3);
  EXPECT_TRUE(error == "brain/act.m:2: the callback took longer than 0.5 s and was stopped" ||
              error == "brain/act.m:3: the callback took longer than 0.5 s and was stopped")
      << error;
}

TEST_F(BrainProcessTest, StopsASleeperAndItsChildren) {
  const fs::path folder = Brain("", "system('sleep 30 & sleep 30');");
  std::string error;
  EXPECT_LT(SecondsOf([&] { error = ErrorOfStep(folder, {.callback_seconds = 0.3}); }), 3);
  EXPECT_EQ(error, "brain/act.m:1: the callback took longer than 0.3 s and was stopped");
}

TEST_F(BrainProcessTest, KillsWhatRefusesToListen) {
  const fs::path folder = Brain("", "while true\n  try\n    while true, end\n  catch\n  end\nend");
  std::string error;
  EXPECT_LT(SecondsOf([&] { error = ErrorOfStep(folder, {.callback_seconds = 0.3}); }), 4);
  EXPECT_NE(error.find("the callback took longer than 0.3 s"), std::string::npos) << error;
}

TEST_F(BrainProcessTest, StopsAnEndlessInit) {
  const fs::path folder = Brain("while true, end", "");
  EXPECT_EQ(ErrorOfInit(folder, {.start_seconds = 4}),
            "brain/begin.m:1: init took longer than 4 s and was stopped");
}

TEST_F(BrainProcessTest, ReportsHowACrashedProgramEnded) {
  for (const auto transport : {BrainTransport::kMex, BrainTransport::kPlain}) {
    EXPECT_EQ(ErrorOfStep(Brain("", "kill(getpid(), 9);"), {.transport = transport}),
              "brain/act.m: the brain ended during the callback: it was ended by signal 9 "
              "(Killed)");
  }
  EXPECT_EQ(ErrorOfStep(Brain("", "exit(3);")),
            "brain/act.m: the brain ended during the callback: it ended with exit code 3");
}

TEST_F(BrainProcessTest, ShowsTheLastLinesBesideAnError) {
  BrainProcess brain(Brain("", "disp('nearly there'); error('oh');"));
  Started(brain);
  const auto reply = brain.Step(Classic(Sensor{}));
  ASSERT_TRUE(std::holds_alternative<BrainError>(reply));
  const auto& output = std::get<BrainError>(reply).output;
  ASSERT_FALSE(output.empty());
  EXPECT_EQ(output.front(), "nearly there");
}

TEST_F(BrainProcessTest, AChattyProgramNeitherBlocksNorFloods) {
  std::mutex mutex;
  std::vector<std::string> lines;
  BrainOptions options;
  options.on_output = [&](std::string_view line) {
    const std::lock_guard lock(mutex);
    lines.emplace_back(line);
  };
  BrainProcess brain(Brain("text = repmat(sprintf('%s\\n', repmat('x', 1, 99)), 1, 30000);",
                           "fputs(stdout, text);"),
                     options);
  Started(brain);
  for (int k = 0; k < 3; ++k) Stepped(brain);
  brain.Stop();
  // 90 000 lines were printed; 200 a second are shown, and a note about the others.
  EXPECT_GE(lines.size(), 200u);
  EXPECT_LT(lines.size(), 5000u);
  EXPECT_EQ(lines.front(), std::string(99, 'x'));
  EXPECT_NE(lines.back().find("more lines were not shown"), std::string::npos) << lines.back();
}

TEST_F(BrainProcessTest, IsCanceledAtOnce) {
  BrainOptions options;
  options.is_cancelled = [] { return true; };
  const fs::path folder = Brain("", "");
  EXPECT_EQ(ErrorOfInit(folder, options),
            "brain/agentBehavior.m: the brain was stopped during the start");
}

// ---- hostile bytes ------------------------------------------------------------------------------

std::vector<std::byte> Hello() {
  MessageWriter writer(MessageType::kHello, 0);
  writer.AddScalar("version", kProtocolVersion);
  return writer.Finish();
}

std::vector<std::byte> Joined(std::vector<std::byte> first, const std::vector<std::byte>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

constexpr const char* kSendAll = "cat \"$SMILE_BRAIN_FOLDER/frames\" >&4; sleep 5";
const BrainOptions kOverPipes{.transport = BrainTransport::kPlain};

TEST_F(BrainProcessTest, RefusesNoise) {
  EXPECT_EQ(ErrorOfInit(Talker("head -c 100000 /dev/zero >&4; sleep 5", {}), kOverPipes),
            root_.filename().string() +
                "/talker: the brain sent an invalid message during the start: the received bytes "
                "are not a message");
}

TEST_F(BrainProcessTest, RefusesAGiantLength) {
  auto frame = Hello();
  frame[15] = std::byte{0x7f};
  EXPECT_NE(ErrorOfInit(Talker(kSendAll, frame), kOverPipes).find("expected at most 67108864"),
            std::string::npos);
}

TEST_F(BrainProcessTest, RefusesAnotherVersion) {
  MessageWriter writer(MessageType::kHello, 0);
  writer.AddScalar("version", 2);
  EXPECT_NE(ErrorOfInit(Talker(kSendAll, writer.Finish()), kOverPipes)
                .find("the brain does not speak version 1 of the protocol"),
            std::string::npos);
}

TEST_F(BrainProcessTest, RefusesUnrequestedAnswers) {
  const auto frames = Joined(Hello(), MessageWriter(MessageType::kInitDone, 77).Finish());
  EXPECT_NE(ErrorOfInit(Talker(kSendAll, frames), kOverPipes)
                .find("this is not an answer to the request"),
            std::string::npos);
}

TEST_F(BrainProcessTest, AnExecutableMayUseTheProtocol) {
  auto frames = Joined(Hello(), MessageWriter(MessageType::kInitDone, 1).Finish());
  MessageWriter motor(MessageType::kFinalMotor, 2);
  motor.AddDoubles("jointVelocities", std::array{2u, 7u}, std::array<double, 14>{1});
  motor.AddDoubles("gripperVelocities", std::array{2u, 1u}, std::array<double, 2>{});
  frames = Joined(std::move(frames), motor.Finish());
  BrainProcess brain(Talker("cat \"$SMILE_BRAIN_FOLDER/frames\" >&4; cat <&3 >/dev/null", frames),
                     kOverPipes);
  Started(brain);
  const StepReply reply = Stepped(brain);
  EXPECT_EQ(VelocitiesOf(reply.motors.front())(0, 0), 1);
  EXPECT_TRUE(reply.exit);
}

TEST_F(BrainProcessTest, NoticesASilentProgram) {
  BrainOptions options = kOverPipes;
  options.start_seconds = 0.3;
  EXPECT_NE(ErrorOfInit(Talker("sleep 30", {}), options).find("the start took longer than 0.3 s"),
            std::string::npos);
}

TEST_F(BrainProcessTest, NoticesAProgramThatEndsAtOnce) {
  EXPECT_NE(ErrorOfInit(Talker("exit 4", {}), kOverPipes)
                .find("the brain ended during the start: it ended with exit code 4"),
            std::string::npos);
}

// ---- brains that are none -----------------------------------------------------------------------

TEST_F(BrainProcessTest, RefusesWhatIsNoBrain) {
  const auto error_for = [&](const fs::path& path) -> std::string {
    try {
      BrainProcess brain(path);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  };
  const std::string root = root_.string();
  EXPECT_EQ(error_for(root_ / "nothing"),
            root +
                "/nothing: no such brain, expected a folder with agentBehavior.m, a Python file, a "
                "program, or an address, tcp://HOST:PORT or unix:PATH");
  EXPECT_EQ(error_for(root_), root + ": the folder has no agentBehavior.m");
  WriteFile(root_ / "notes.txt", "hello");
  EXPECT_EQ(error_for(root_ / "notes.txt"),
            root +
                "/notes.txt: not a program, expected a folder with agentBehavior.m, a Python "
                "file or an executable file (chmod +x makes it one)");
}

TEST_F(BrainProcessTest, ReportsAMissingOctave) {
  const fs::path folder = Brain("", "");
  ::setenv("SMILE_OCTAVE", "/nowhere/octave-cli", 1);
  EXPECT_THROW(
      {
        try {
          BrainProcess brain(folder);
        } catch (const std::runtime_error& error) {
          EXPECT_STREQ(error.what(), "SMILE_OCTAVE: /nowhere/octave-cli is not a program");
          throw;
        }
      },
      std::runtime_error);
  ::unsetenv("SMILE_OCTAVE");
}

TEST_F(BrainProcessTest, TheWaveExampleWaves) {
  BrainProcess brain(fs::path(SMILE_SOURCE_DIR) / "matlab/examples/wave/");
  EXPECT_FALSE(Started(brain).init_joints.empty());
  const StepReply reply = Stepped(brain);
  EXPECT_EQ(VelocitiesOf(reply.motors.front())(0, 0), 0.4);
  EXPECT_EQ(VelocitiesOf(reply.motors.front())(1, 0), -0.4);
}

}  // namespace
}  // namespace smile::brain
