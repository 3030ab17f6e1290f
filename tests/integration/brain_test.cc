#include "program.h"

namespace smile {
namespace {

class BrainAsUsed : public ProgramTest {
 protected:
  BrainAsUsed() { Write("pair.xml", PairOfBlocks()); }

  /// A folder `brain` whose callback is this.
  void WriteBrain(const std::string& callback, const std::string& init = "") const {
    Write("brain/agentBehavior.m",
          "function [init, callback] = agentBehavior()\n"
          "  init = @myInit;\n  callback = @myCallback;\nend\n");
    Write("brain/myInit.m", init + "\n");
    Write("brain/myCallback.m", callback + "\n");
  }
};

TEST_F(BrainAsUsed, MovesTheRobotAndItsRunReplaysWithoutIt) {
  WriteBrain(
      "motor.jointVelocities = [0.2 * ones(1, 7); zeros(1, 7)];\n"
      "motor.gripperVelocities = [-0.5; 0];\n"
      "if sensor.simTime >= 1, aux.exit = true; end",
      "aux.initJointAngles = [0.3 -0.4 0 0.9 0 1 0; -0.3 -0.4 0 0.9 0 1 0];");
  const Answer answer = Smile("run pair.xml --brain brain --record demo --json");
  ASSERT_EQ(answer.exit_code, 0) << answer.err;
  const Json result = answer.json();
  EXPECT_EQ(result["brain"]["status"], "exited");
  EXPECT_EQ(result["ticks"], 60 + 15);
  EXPECT_NEAR(result["robot"]["left"]["joints"][0].get<double>(), 0.5, 0.01);
  EXPECT_NEAR(result["robot"]["right"]["joints"][0].get<double>(), -0.3, 1e-4);
  EXPECT_NEAR(result["robot"]["left"]["gripper"].get<double>(), 1.5, 0.02);
  std::filesystem::remove_all(directory_ / "brain");
  EXPECT_EQ(Smile("replay demo --verify").exit_code, 0);
}

TEST_F(BrainAsUsed, ReceivesAFreshPictureFourTimesASecond) {
  WriteBrain(
      "if isfield(sensor, 'rgbVision'), seen = seen + 1; size_seen = size(sensor.rgbVision); end\n"
      "if sensor.simTime >= 1.9, printf('%d %d %d %d\\n', seen, size_seen); aux.exit = 1; end",
      "seen = 0;");
  const Answer answer = Smile("run pair.xml --brain brain --size 64x48");
  EXPECT_NE(answer.err.find("8 48 64 3"), std::string::npos) << answer.err;
}

/// Checks in Octave that a picture shows block `a`, one unit large at (0, 12, 0.5), where pose and
/// intrinsics say; `bounds` are of its pixels, as (u, v) of their edges.
constexpr const char* kCheckCorners =
    "function check(name, segments, names, K, pose)\n"
    "  [x, y, z] = ndgrid([-0.5 0.5], [11.5 12.5], [0 1]);\n"
    "  corners = pose \\ [x(:) y(:) z(:) ones(8, 1)].';\n"
    "  pixels = K * corners(1:3, :); pixels = pixels(1:2, :) ./ pixels(3, :);\n"
    "  [rows, columns] = find(segments == find(strcmp(names, 'a')));\n"
    "  bounds = [min(columns) - 1, max(columns); min(rows) - 1, max(rows)];\n"
    "  errors = bounds - [min(pixels, [], 2), max(pixels, [], 2)];\n"
    "  if max(abs(errors(:))) < 1.01 && max(corners(3, :)) > 0, printf('%s is right\\n', name);\n"
    "  else, name, bounds, pixels, errors, end\n"
    "end\n";

TEST_F(BrainAsUsed, ReceivesPicturesFromTheViewpointsOfItsCameras) {
  Write("pair.xml",
        SceneOf("<block id='b' color='blue' location='(7,3,0.5)'/>"
                "<block id='a' color='red' location='(0,12,0.5)' mass='0'/>"
                "<camera id='overhead' location='(0.5,12,12)' target='(0.5,12,0)' fov='40'/>"
                "<camera id='side' location='(-9,9,3)' target='(0,12,1)' up='(0,0.5,1)'/>"));
  Write("brain/check.m", kCheckCorners);
  WriteBrain(
      "motor.headVelocity = 0.2;\n"
      "if isfield(sensor, 'cameraPose')\n"
      "  names = sensor.segmentNames;\n"
      "  check('eye', sensor.segmentVision, names, aux.cameraIntrinsics, sensor.cameraPose);\n"
      "  for k = 1:2\n"
      "    c = sensor.cameras.(aux.cameras{k});\n"
      "    check(aux.cameras{k}, c.segments, names, c.intrinsics, c.pose);\n"
      "  end\n"
      "  printf('turned by %.3f, depth %.4f\\n', sensor.headAngle, ...\n"
      "         sensor.cameras.overhead.depth(120, 150));\n"
      "  if sensor.simTime > 0.9, aux.exit = true; end\n"
      "end",
      "aux.channels = {'segmentation', 'depth'};\n"
      "aux.cameras = {'overhead', 'side'}; aux.imageSeconds = 1;");
  for (const std::string eye : {"eye", "head"}) {
    const Answer answer = Smile("run pair.xml --brain brain --size 320x240 --eye " + eye);
    EXPECT_EQ(answer.exit_code, 0) << answer.err;
    for (const std::string seen : {"eye is right", "overhead is right", "side is right"}) {
      const auto first = answer.err.find(seen);
      EXPECT_NE(first, std::string::npos) << answer.err;
      EXPECT_NE(answer.err.find(seen, first + 1), std::string::npos) << "a second later";
    }
    // Along the axis, wherever in the picture: the top of the block lies 11 units below.
    EXPECT_NE(answer.err.find("turned by 0.000, depth 11.0000"), std::string::npos) << answer.err;
    EXPECT_NE(answer.err.find("turned by 0.2"), std::string::npos) << answer.err;
  }
}

TEST_F(BrainAsUsed, ReceivesTheListOfCameras) {
  WriteBrain("", "aux.cameras = 'left_hnd';");
  const Answer answer = Smile("run pair.xml --brain brain --seconds 1");
  EXPECT_EQ(answer.exit_code, 1);
  EXPECT_NE(answer.err.find("brain/myInit.m: aux.cameras names \"left_hnd\", expected eye, head, "
                            "left_hand or right_hand; did you mean \"left_hand\"?"),
            std::string::npos)
      << answer.err;
}

TEST_F(BrainAsUsed, ReceivesTheSameNoiseFromTheSameSeed) {
  WriteBrain(
      "if isfield(sensor, 'rgbVision'), total = total + sum(sensor.rgbVision(:)); end\n"
      "total = total + sum(sensor.jointAngles(:));\n"
      "if sensor.simTime > 0.5, printf('total %.15g\\n', total); aux.exit = true; end",
      "total = 0;");
  const auto total = [this](const std::string& options) {
    const Answer answer = Smile("run pair.xml --brain brain --size 32x24 " + options);
    EXPECT_EQ(answer.exit_code, 0) << answer.err;
    return answer.err.substr(answer.err.find("total"));
  };
  const std::string noisy = total("--noise joints=0.01,image=0.1,seed=3 --record noisy");
  EXPECT_EQ(total("--noise joints=0.01,image=0.1,seed=3"), noisy);
  EXPECT_NE(total("--noise joints=0.01,image=0.1,seed=4"), noisy);
  EXPECT_NE(total(""), noisy);
  EXPECT_EQ(Smile("replay noisy --verify").exit_code, 0);
  EXPECT_EQ(Smile("run pair.xml --brain brain --noise joint=1").err,
            "smile: noise: found \"joint\", expected depth, image, joints or seed; did you mean "
            "\"joints\"?\n");
}

TEST_F(BrainAsUsed, MarksPointsForPeopleOnly) {
  WriteBrain(
      "if sensor.simTime >= 0.5, aux.drawMarkers = []; end\n"
      "if sensor.simTime >= 1, aux.exit = true; end",
      "aux.drawMarkers = [0 -3 2; 1 -3 2];");
  ASSERT_EQ(Smile("run pair.xml --brain brain --record demo").exit_code, 0);
  for (const std::string camera : {"front", "eye"}) {
    for (const std::string at : {"0.4", "0.9"}) {
      ASSERT_EQ(Smile("render demo --size 160x120 --camera " + camera + " --at " + at + " --out " +
                      camera + at + ".png")
                    .exit_code,
                0);
    }
  }
  EXPECT_NE(Read("front0.4.png"), Read("front0.9.png"));
  EXPECT_EQ(Read("eye0.4.png"), Read("eye0.9.png"));
}

TEST_F(BrainAsUsed, AnErrorNamesFileAndLineAndKeepsTheRecording) {
  WriteBrain("x = 1;\nif sensor.simTime > 0.5\n  y = undefined_thing + 1;\nend");
  const Answer answer = Smile("run pair.xml --brain brain --record demo --json");
  EXPECT_EQ(answer.exit_code, 1);
  EXPECT_NE(answer.err.find("brain/myCallback.m:3: "), std::string::npos) << answer.err;
  EXPECT_EQ(answer.json()["brain"]["status"], "failed");
  const Answer replay = Smile("replay demo --verify --json");
  EXPECT_EQ(replay.exit_code, 0) << replay.err;
  EXPECT_GE(replay.json()["ticks"], 30);
  const std::string log = Read("demo/commands.jsonl");
  EXPECT_NE(log.find("working"), std::string::npos) << "the face while it ran";
  EXPECT_NE(log.find("puzzled"), std::string::npos) << "the face when it failed";
}

TEST_F(BrainAsUsed, CrashesLoopsAndInvalidRepliesDoNoHarm) {
  WriteBrain("kill(getpid(), 9);");
  EXPECT_EQ(Smile("run pair.xml --brain brain --seconds 1 --record crash").exit_code, 1);
  EXPECT_EQ(Smile("replay crash --verify").exit_code, 0);

  WriteBrain("while true, end");
  const Answer loop = Smile("run pair.xml --brain brain --seconds 1 --timeout 1 --record loop");
  EXPECT_EQ(loop.exit_code, 1);
  EXPECT_NE(loop.err.find("myCallback.m:1"), std::string::npos) << loop.err;

  WriteBrain("motor.jointVelocities = zeros(3, 3);");
  const Answer nonsense = Smile("run pair.xml --brain brain --seconds 1");
  EXPECT_EQ(nonsense.exit_code, 1);
  EXPECT_NE(nonsense.err.find("jointVelocities"), std::string::npos) << nonsense.err;
}

TEST_F(BrainAsUsed, AMissingBrainIsReported) {
  const Answer answer = Smile("run pair.xml --brain absent --seconds 1");
  EXPECT_EQ(answer.exit_code, 1);
  EXPECT_NE(answer.err.find("absent"), std::string::npos) << answer.err;
}

}  // namespace
}  // namespace smile
