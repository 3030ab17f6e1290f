// Brains in Python and C++, and in the style of the original's Matlab scripts.

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

TEST_F(BrainLanguages, AChunkGivesTheRecordingOfTheSameCommandsOneByOne) {
  // All velocities are planned at the start: sent for one tick at a time, or for seven.
  constexpr const char* kBrain =
      "import numpy as np\n"
      "VELOCITIES = np.sin(np.arange(2 * 7 * 70)).reshape(2, 7, 70)\n"
      "def step(sensor, motor, aux):\n"
      "  assert sensor.timeElapsed == (TICKS if sensor.simTime else 1) / 60\n"
      "  done = round(60 * sensor.simTime)\n"
      "  motor.jointVelocities = VELOCITIES[:, :, done:done + TICKS]\n"
      "  motor.ticks = TICKS\n"
      "  aux.exit = done == 63\n";
  Write("single.py", std::string("TICKS = 1\n") + kBrain);
  Write("chunk.py", std::string("TICKS = 7\n") + kBrain);
  Json hashes;
  for (const std::string name : {"single", "chunk"}) {
    const Answer answer = Smile("run pair.xml --seconds 1.2 --json --no-pictures --brain " + name +
                                ".py --record " + name);
    ASSERT_EQ(answer.exit_code, 0) << answer.err;
    hashes.push_back(answer.json()["hash"]);
    EXPECT_EQ(answer.json()["brain"]["status"], "exited") << answer.json()["brain"];
    EXPECT_EQ(Smile("replay " + name + " --verify").exit_code, 0);
  }
  EXPECT_EQ(hashes[0], hashes[1]);
  EXPECT_EQ(Read("single/commands.jsonl"), Read("chunk/commands.jsonl"));
}

TEST_F(BrainLanguages, ExamplesInCppBuildOutsideTheTree) {
  const Answer built = Shell("cmake --install '" SMILE_BUILD_DIR
                             "' --prefix there --component brain_client &&"
                             "cmake -S '" +
                             Shipped("examples/cpp_brain") +
                             "' -B build -G Ninja -DCMAKE_PREFIX_PATH=\"$PWD/there\" &&"
                             "cmake --build build");
  ASSERT_EQ(built.exit_code, 0) << built.out << built.err;
  const Answer answer = Smile("run pair.xml --seconds 1 --brain build/my_brain --json");
  EXPECT_EQ(answer.exit_code, 0) << answer.err;
  EXPECT_NE(answer.err.find("brain:   0.0 s: left gripper at"), std::string::npos) << answer.err;

  // The same example as older brains wrote it.
  const Answer older =
      Shell("cp -r '" + Shipped("examples/cpp_brain") +
            "' older && cd older &&"
            "sed -i 's/brain_client/agent/' CMakeLists.txt &&"
            "sed -i 's:brain_client/brain.h:agent/agent.h:;"
            "s/brain_client::Brain/agent::Program/;s/brain_client/agent/g' wave.cc &&"
            "cmake -B build -G Ninja -DCMAKE_PREFIX_PATH=\"$PWD/../there\" &&"
            "cmake --build build");
  EXPECT_EQ(older.exit_code, 0) << older.out << older.err;
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
        "aux.cameras = {'left_hand'};\n"
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
        "aux.claim = 'done: as shown';\n"
        "aux.notes = {'saw: a block', 'plan: none'};\n"
        "aux.noteTops = [1, 1, 0, 2, 1, 4, 1, 0.5, 0];\n"
        "aux.noteCameras = {'left_hand'};\n"
        "aux.exit = 1;\n");
  const Answer answer = Smile("run pair.xml --brain matlab --size 64x48 --record noted --json");
  ASSERT_EQ(answer.exit_code, 0) << answer.err;
  EXPECT_EQ(answer.json()["brain"]["status"], "exited");
  const std::string notes = Read("noted/notes.jsonl");
  EXPECT_NE(notes.find("\"saw\",\"text\":\"a block\",\"found\""), std::string::npos);
  EXPECT_NE(notes.find("\"camera\":\"left_hand\""), std::string::npos);
  EXPECT_EQ(answer.json()["brain"]["claim"], Json({{"done", true}, {"reason", "as shown"}}));
  EXPECT_GE(answer.json()["ticks"], 35);
  for (const char* file : {"matlab/frames/0.png", "matlab/frames/2.png", "matlab/result.mat"}) {
    EXPECT_TRUE(Exists(file)) << file;
  }
  EXPECT_NE(answer.err.find("brain: numJoints: 7"), std::string::npos) << answer.err;
  EXPECT_NE(Read("matlab/result.mat").find("# name: elbow"), std::string::npos);
}

/// A demonstration is watched before anything moves, picture by picture.
class BrainWatches : public BrainLanguages {
 protected:
  BrainWatches() {
    Write("stack.jsonl", StackPair());
    const Answer made =
        Smile("run pair.xml --commands stack.jsonl --no-robot --size 64x48 --record demo");
    EXPECT_EQ(made.exit_code, 0);
    const std::string index = Read("demo/frames.csv");
    num_frames_ = static_cast<int>(std::ranges::count(index, '\n')) - 1;
  }
  Json Imitate(const std::string& brain) const {
    const Answer answer =
        Smile("imitate demo pair.xml --size 64x48 --out out --json --brain " + brain);
    EXPECT_EQ(answer.exit_code, 0) << answer.err;
    const Answer again = Smile("replay out/imitation --verify");
    EXPECT_EQ(again.exit_code, 0) << again.out << again.err;
    return answer.exit_code == 0 ? answer.json() : Json::object();
  }

  int num_frames_ = 0;
};

TEST_F(BrainWatches, InTheStyleOfTheOriginalsScripts) {
  Write("matlab/agentBehavior.m",
        "function [init, callback] = agentBehavior()\n"
        "init = @keepInit;\ncallback = @keepCallback;\n");
  Write("matlab/keepInit.m",
        "aux.watch = true;\nfolder = [aux.path 'kept'];\nmkdir(folder);\ncount = 0;\n");
  Write("matlab/keepCallback.m",
        "if sensor.demoCue\n"
        "  imwrite(sensor.rgbVision, sprintf('%s/%d.png', folder, count));\n"
        "  count = count + 1;\n"
        "  return\n"
        "end\n"
        "same = 0; image = '';\n"
        "lines = regexp(fileread([aux.demonstration '/frames.csv']), '[^\\n]+', 'match');\n"
        "for k = 1:numel(lines) - 1\n"
        "  words = regexp(lines{k + 1}, ',', 'split');\n"
        "  if ~isempty(words{3}), image = words{3}; end\n"
        "  shown = uint16(imread([aux.demonstration '/' image])) * 257;  % kept with 16 bits\n"
        "  same = same + isequal(imread(sprintf('%s/%d.png', folder, k - 1)), shown);\n"
        "end\n"
        "fprintf('%d kept, %d same\\n', count, same);\n"
        "aux.exit = true;\n");
  const Json result = Imitate("matlab");
  const std::string count = std::to_string(num_frames_);
  EXPECT_EQ(Read("out/imitation/brain.log"), count + " kept, " + count + " same\n");
  EXPECT_GT(result["watched_seconds"], 0.5);
  EXPECT_LT(result["seconds"], 0.5) << "from the end of watching";
}

TEST_F(BrainWatches, InPython) {
  Write("watcher.py",
        "import numpy as np\n"
        "def init(aux):\n"
        "    aux.watch, aux.shown = True, []\n"
        "def step(sensor, motor, aux):\n"
        "    motor.jointVelocities[:] = 0.2\n"
        "    if sensor.demoCue:\n"
        "        assert sensor.rgbVision.shape == (48, 64, 3)\n"
        "        assert sensor.cameraPose.shape == (4, 4)\n"
        "        aux.shown.append(sensor.rgbVision.copy())\n"
        "        aux.last = sensor.jointAngles\n"
        "        return\n"
        "    assert (sensor.jointAngles == aux.last).all()\n"
        "    print(len(aux.shown), 'shown,', round(sensor.timeElapsed * 60), 'tick ago')\n"
        "    aux.exit = (aux.shown[0] != aux.shown[-1]).any()\n");
  EXPECT_EQ(Imitate("watcher.py")["brain"]["status"], "exited");
  EXPECT_EQ(Read("out/imitation/brain.log"), std::to_string(num_frames_) + " shown, 1 tick ago\n");
}

TEST_F(BrainLanguages, MatlabIsStartedAsItsManualDescribes) {
  // No Matlab: a placeholder object that takes the same arguments and lets Octave do the work.
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
