// Robot programs in Python and C++, and in the style of the original's Matlab scripts.

#include "program.h"

namespace smile {
namespace {

class BrainLanguages : public ProgramTest {
 protected:
  BrainLanguages() { Write("pair.xml", PairOfBlocks()); }

  double LeftShoulder(const Answer& answer) const {
    return answer.json()["robot"]["left"]["joints"][0].get<double>();
  }
};

TEST_F(BrainLanguages, TheSameProgramMovesTheRobotTheSameWayInAllOfThem) {
  std::vector<Json> ends;
  for (const std::string& brain :
       {Shipped("matlab/examples/wave"), Shipped("python/examples/wave.py"),
        std::filesystem::path(SMILE_PROGRAM).replace_filename("smile_wave").string()}) {
    const Answer answer = Smile("run pair.xml --seconds 2 --json --brain '" + brain + "'");
    ASSERT_EQ(answer.exit_code, 0) << brain << answer.err;
    EXPECT_NE(answer.err.find("brain:   0.0 s: left gripper at"), std::string::npos) << answer.err;
    ends.push_back(answer.json()["robot"]);
  }
  for (const Json& end : ends) {
    EXPECT_NEAR(end["left"]["joints"][0].get<double>(), ends[0]["left"]["joints"][0], 1e-9);
    EXPECT_NEAR(end["right"]["gripper"].get<double>(), ends[0]["right"]["gripper"], 1e-9);
  }
}

TEST_F(BrainLanguages, ExamplesInCppBuildOutsideTheTree) {
  const Answer built = Shell("cmake --install '" SMILE_BUILD_DIR
                             "' --prefix there --component agent &&"
                             "cmake -S '" +
                             Shipped("examples/cpp_brain") +
                             "' -B build -G Ninja -DCMAKE_PREFIX_PATH=\"$PWD/there\" &&"
                             "cmake --build build");
  ASSERT_EQ(built.exit_code, 0) << built.out << built.err;
  const Answer answer = Smile("run pair.xml --seconds 1 --brain build/my_brain --json");
  EXPECT_EQ(answer.exit_code, 0) << answer.err;
  EXPECT_NE(answer.err.find("brain:   0.0 s: left gripper at"), std::string::npos) << answer.err;
}

TEST_F(BrainLanguages, ScriptsOfTheOriginalRunAsTheyAre) {
  // In the style of its recordDemo: images and data go to files beside the scripts, everything is
  // shown, a break outside any loop ends the script.
  Write("matlab/agentBehavior.m",
        "function [init, callback] = agentBehavior()\n"
        "init = @recordInit;\ncallback = @recordCallback;\n");
  Write("matlab/recordInit.m",
        "disp(aux)\n"
        "names = fieldnames(aux);\n"
        "for i = 1:length(names)\n  fprintf(1, '%s: ', names{i}); disp(aux.(names{i}));\nend\n"
        "seen = containers.Map();\n"
        "figure(1); plot([0 1], [0 1]);\n"
        "aux.drawMarkers = [0 0 1; 1 0 1];\n"
        "mkdir([aux.path 'frames']);\n"
        "frame = 0; total = 0;\n");
  Write("matlab/recordCallback.m",
        "total = total + sensor.timeElapsed;\n"
        "fields = fieldnames(sensor);\n"
        "for i = 1:numel(fields), seen(fields{i}) = size(sensor.(fields{i})); end\n"
        "if isfield(sensor, 'rgbVision')\n"
        "  imwrite(sensor.rgbVision, sprintf('%sframes/%d.png', aux.path, frame));\n"
        "  frame = frame + 1;\n"
        "  sensor = rmfield(sensor, 'rgbVision');\n"
        "end\n"
        "points = keys(sensor.trackerLoc);\n"
        "motor.jointVelocities = zeros(aux.numLimbs, aux.numJoints);\n"
        "motor.gripperVelocities = [1; -1];\n"
        "if total < 0.6, break; end\n"
        "disp(sensor); disp(seen.keys());\n"
        "elbow = sensor.trackerLoc('r-E1');\n"
        "save([aux.path 'result.mat'], 'elbow', 'total', 'points');\n"
        "close all\n"
        "aux.exit = 1;\n");
  const Answer answer = Smile("run pair.xml --brain matlab --size 64x48 --json");
  ASSERT_EQ(answer.exit_code, 0) << answer.err;
  EXPECT_EQ(answer.json()["brain"]["status"], "exited");
  EXPECT_GE(answer.json()["ticks"], 35);
  for (const char* file : {"matlab/frames/0.png", "matlab/frames/2.png", "matlab/result.mat"}) {
    EXPECT_TRUE(Exists(file)) << file;
  }
  EXPECT_NE(answer.err.find("brain: numJoints: 7"), std::string::npos) << answer.err;
  EXPECT_NE(Read("matlab/result.mat").find("# name: elbow"), std::string::npos);
}

TEST_F(BrainLanguages, MatlabIsStartedTheWayItsManualSays) {
  // No Matlab: a stand-in that takes the same arguments and lets Octave do the work.
  Write("matlab", "#!/bin/sh\n[ \"$1\" = -batch ] || exit 9\nexec octave-cli -q --eval \"$2\"\n");
  Write("brain/agentBehavior.m",
        "function [init, callback] = agentBehavior()\ninit = @begin;\ncallback = @act;\n");
  Write("brain/begin.m", "disp('begun')\n");
  Write("brain/act.m", "if sensor.simTime >= 0.1, aux.exit = true; end\n");
  const Answer answer =
      Shell("chmod +x matlab; SMILE_MATLAB=$PWD/matlab smile run pair.xml --brain brain --json");
  EXPECT_EQ(answer.exit_code, 0) << answer.err;
  EXPECT_EQ(answer.json()["ticks"], 6 + 15);
  EXPECT_NE(answer.err.find("brain: begun"), std::string::npos) << answer.err;
}

}  // namespace
}  // namespace smile
