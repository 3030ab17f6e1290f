// What a robot did, out of a recording and back into a simulation.

#include <cmath>
#include <sstream>
#include <vector>

#include "program.h"

namespace smile {
namespace {

/// Arms, grippers and head: smoothly to a pose, then abruptly by speeds.
constexpr const char* kDrive = R"({"do":"pose","name":"ready","speed":0.4}
{"do":"wait","until":"arrived"}
{"do":"gripper","arm":"right","velocity":-1}
{"do":"turn","joint":"left_w2","velocity":1}
{"do":"turn","joint":"head_pan","velocity":-0.5}
{"do":"wait","seconds":1}
{"do":"joint_velocities","left":[0.3,-0.3,0.2,0.3,0.5,-0.4,-1],"grippers":[0,0.5],"head":0}
{"do":"wait","seconds":1}
{"do":"joint_velocities","left":[0,0,0,0,0,0,0],"grippers":[0,0]}
{"do":"wait","seconds":0.5}
)";

class Exports : public ProgramTest {
 protected:
  void Record(const std::string& script) const {
    Write("pair.xml", PairOfBlocks());
    Write("drive.jsonl", script);
    const Answer run = Smile("run pair.xml --commands drive.jsonl --record demo --no-pictures");
    ASSERT_EQ(run.exit_code, 0) << run.err;
  }
  std::vector<std::vector<double>> Table(const std::string& name) const {
    std::vector<std::vector<double>> rows;
    std::istringstream lines(Read(name));
    std::string line;
    for (std::getline(lines, line); std::getline(lines, line);) {
      std::istringstream cells(line);
      rows.emplace_back();
      for (std::string cell; std::getline(cells, cell, ',');)
        rows.back().push_back(std::stod(cell));
    }
    return rows;
  }
};

TEST_F(Exports, RoundTripInBothFormats) {
  constexpr double kTolerance = 0.003;  // [rad and m], where joints start and stop abruptly
  Record(kDrive);
  for (const auto& [format, file] :
       {std::pair("trajectory-csv", "motion.csv"), std::pair("ros-trajectory", "motion.json")}) {
    const std::string again = std::string("again_") + format;
    const Answer exported = Smile(std::string("export demo --to ") + format + " --out " + file);
    ASSERT_EQ(exported.exit_code, 0) << exported.err;
    const Answer played = Smile(std::string("run pair.xml --no-pictures --trajectory ") + file +
                                " --record " + again);
    ASSERT_EQ(played.exit_code, 0) << played.err;
    EXPECT_EQ(Smile("replay --verify " + again).exit_code, 0);
    ASSERT_EQ(Smile("export demo --to trajectory-csv --out before.csv").exit_code, 0);
    ASSERT_EQ(Smile("export " + again + " --to trajectory-csv --out after.csv").exit_code, 0);
    const auto before = Table("before.csv"), after = Table("after.csv");
    ASSERT_GE(after.size(), before.size());
    double farthest = 0;
    for (std::size_t row = 0; row < before.size(); ++row) {
      for (std::size_t i = 1; i < before[row].size(); ++i) {
        farthest = std::max(farthest, std::abs(after[row][i] - before[row][i]));
      }
    }
    EXPECT_LT(farthest, kTolerance) << format;
  }
}

TEST_F(Exports, AGraspIsExportedWithTheMotion) {
  // A block on a pillar between the fingers, as the robot stands at the start.
  Write("held.xml",
        SceneOf("<block id=\"pillar\" xspan=\"0.6\" yspan=\"0.6\" zspan=\"2.188\" mass=\"0\" "
                "location=\"(-2.0775, -4.8585, 1.094)\"/>\n"
                "<block id=\"held\" location=\"(-2.0775, -4.8585, 2.698)\"/>"));
  Write("lift.jsonl", R"({"do":"gripper","arm":"left","velocity":-1}
{"do":"wait","seconds":1.5}
{"do":"turn","joint":"left_s1","velocity":-0.3}
{"do":"wait","seconds":1}
{"do":"turn","joint":"left_s1","velocity":0}
{"do":"wait","seconds":0.5}
)");
  const Answer first =
      Smile("run held.xml --commands lift.jsonl --record demo --no-pictures --json");
  ASSERT_EQ(Smile("export demo --to ros-trajectory --rate 10 --out lift.json").exit_code, 0);
  const Answer again = Smile("run held.xml --trajectory lift.json --json");
  ASSERT_EQ(again.exit_code, 0) << again.err;
  const Json before = first.json()["objects"]["held"]["position"];
  const Json after = again.json()["objects"]["held"]["position"];
  EXPECT_GT(before[2].get<double>(), 2.8) << "it was never lifted";
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(after[axis].get<double>(), before[axis].get<double>(), 0.02) << axis;  // [units]
  }
}

TEST_F(Exports, ContainTheRequestedNamesTimesAndParts) {
  Record(kDrive);
  ASSERT_EQ(Smile("export demo --to trajectory-csv --arm left --no-grippers --from 1 --to-time 2 "
                  "--rate 10 --out left.csv")
                .exit_code,
            0);
  EXPECT_EQ(Read("left.csv").substr(0, 63),
            "time,left_s0,left_s1,left_e0,left_e1,left_w0,left_w1,left_w2\n0,");
  const auto rows = Table("left.csv");
  ASSERT_EQ(rows.size(), 11u);
  EXPECT_DOUBLE_EQ(rows[1][0], 0.1);
  EXPECT_DOUBLE_EQ(rows[10][0], 1);

  ASSERT_EQ(Smile("export demo --to ros-trajectory --arm head --out head.json").exit_code, 0);
  const Json message = Json::parse(Read("head.json"));
  EXPECT_EQ(message["header"]["frame_id"], "base");
  EXPECT_EQ(message["joint_names"], Json{"head_pan"});
  EXPECT_EQ(message["points"][60]["time_from_start"], (Json{{"secs", 1}, {"nsecs", 0}}));
}

TEST_F(Exports, LimitViolationsAreReportedAndCanBeSlowedDown) {
  Record(R"({"do":"joint_velocities","left":[-2,0,0,0,0,0,0]}
{"do":"wait","seconds":0.6}
{"do":"joint_velocities","left":[0,0,0,0,0,0,0]}
{"do":"wait","seconds":0.5}
)");
  const std::string command = "export demo --to trajectory-csv --arm left --out fast.csv ";
  const Answer refused = Smile(command);
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_NE(refused.err.find(" s, left_s0: velocity is -1."), std::string::npos) << refused.err;
  EXPECT_NE(refused.err.find(" rad/s, expected at least -1.5 rad/s"), std::string::npos)
      << refused.err;
  EXPECT_FALSE(Exists("fast.csv"));
  EXPECT_EQ(Smile(command + "--allow-breaches").exit_code, 0);
  const double whole = Table("fast.csv").back()[0];
  const Answer slower = Smile(command + "--slow-down");
  EXPECT_EQ(slower.exit_code, 0) << slower.err;
  EXPECT_EQ(slower.err.find("velocity"), std::string::npos) << slower.err;
  EXPECT_GT(Table("fast.csv").back()[0], whole);
  EXPECT_EQ(Smile("run pair.xml --trajectory fast.csv").exit_code, 0);
}

TEST_F(Exports, RefuseMotionsThatAreTooLong) {
  Write("pair.xml", PairOfBlocks());
  ASSERT_EQ(Smile("run pair.xml --seconds 170 --record demo --no-pictures").exit_code, 0);
  const Answer refused = Smile("export demo --to trajectory-csv --out long.csv");
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_EQ(refused.err,
            "demo: there are more than 10000 points; choose a smaller --rate or a part\n");
  EXPECT_FALSE(Exists("long.csv"));
  EXPECT_EQ(Smile("export demo --to trajectory-csv --out long.csv --rate 50").exit_code, 0);
}

TEST_F(Exports, ReportErrors) {
  Write("pair.xml", PairOfBlocks());
  ASSERT_EQ(Smile("run pair.xml --no-robot --seconds 0 --record demo --no-pictures").exit_code, 0);
  EXPECT_EQ(Smile("export demo --to trajectory-csv --out x.csv").err,
            "demo: was made without a robot\n");
  const Answer unknown = Smile("export demo --to cvs --out x.csv");
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_EQ(unknown.err,
            "smile: --to is \"cvs\", expected trajectory-csv, ros-trajectory, lerobot-v3.0, "
            "lerobot-v2.1, robomimic, zarr, mcap, rrd, csv, mjcf, sdf, urdf, gltf or usd\n");
  EXPECT_EQ(Smile("export demo --to trajectory-csv --fps 10 --out x.csv").err,
            "smile: --fps is for datasets, and --to is \"trajectory-csv\"\n");
  EXPECT_EQ(Smile("export demo --to sdf --out x.sdf").err,
            "smile: sdf is of a scene file, found the recording \"demo\"\n");
  EXPECT_EQ(Smile("export demo --to gltf --after 1 --out x.glb").err,
            "smile: --after, --path and options of the robot are for scene files, found the "
            "recording \"demo\"\n");
  for (const std::string option : {"--from 1", "--to-time 1", "--rate 60"}) {
    EXPECT_EQ(Smile("export pair.xml --to gltf " + option + " --out x.glb").err,
              "smile: --from, --to-time and --rate are for recordings, found the scene file "
              "\"pair.xml\"\n");
  }
  for (const std::string option : {"--arm", "--no-grippers", "--slow-down", "--allow-breaches"}) {
    for (const std::string format : {"usd", "csv"}) {
      const std::string value = option == "--arm" ? " all" : "";
      EXPECT_EQ(Smile("export pair.xml --to " + format + " " + option + value + " --out x.out").err,
                "smile: " + option + " is for trajectories, and --to is \"" + format + "\"\n");
    }
  }
  for (const std::string option : {"--from 1", "--to-time 1", "--rate 60"}) {
    EXPECT_EQ(Smile("export demo --to csv " + option + " --out x").err,
              "smile: --from, --to-time and --rate are for one recording, and --to is \"csv\"\n");
  }
  for (const auto& [option, format] :
       {std::pair{"--after 1", "trajectory-csv"}, std::pair{"--no-robot", "ros-trajectory"},
        std::pair{"--path .", "zarr"}}) {
    EXPECT_EQ(Smile("export demo --to " + std::string(format) + " " + option + " --out x").err,
              "smile: --after, --path and options of the robot are for other simulators, and "
              "--to is \"" +
                  std::string(format) + "\"\n");
  }
  EXPECT_EQ(Smile("export demo --to usd --out demo/x.usda").exit_code, 1);
  Write("broken.csv", "time,left_s0\n0,0.25\n1,half\n");
  EXPECT_EQ(Smile("run pair.xml --trajectory broken.csv").err,
            "broken.csv:3: found \"half\", expected a number of at most 1e6\n");
  Write("fast.csv", "time,left_s0\n0,0.25\n0.1,-0.25\n");
  const Answer fast = Smile("run pair.xml --trajectory fast.csv");
  EXPECT_EQ(fast.exit_code, 1);
  EXPECT_EQ(fast.err,
            "fast.csv: at 0 s, left_s0: velocity is -5 rad/s, expected at least -1.5 rad/s\n");
}

TEST_F(Exports, AreImportedAgain) {
  Write("pair.xml", PairOfBlocks());
  ASSERT_EQ(Smile("export pair.xml --no-robot --to mjcf --out pair.mjcf").exit_code, 0);
  const Answer imported = Smile("import pair.mjcf --from mjcf --out again.xml");
  EXPECT_EQ(imported.exit_code, 0) << imported.err;
  EXPECT_NE(imported.err.find("pair.mjcf:"), std::string::npos) << imported.err;
  EXPECT_EQ(Smile("check again.xml").exit_code, 0);
  EXPECT_EQ(Smile("import pair.mjcf --from mjfc --out x.xml").err,
            "smile: --from is \"mjfc\", expected mjcf, sdf or urdf\n");
  EXPECT_EQ(Smile("import pair.mjcf --from mjcf --title t --out x.xml").exit_code, 2);
  EXPECT_EQ(Smile("import pair.mjcf --from mjcf --table t --out x.xml").err,
            "smile: --table is \"t\", expected the name of a level, fixed box or plane\n");
  EXPECT_EQ(Smile("import pair.xml --from sdf --out x.xml").exit_code, 1);
}

// Python makes the datasets, with packages that may be missing.
TEST_F(Exports, DatasetsSayWhichPackageIsMissing) {
  Write("missing/pyarrow.py", "raise ImportError(\"No module named 'pyarrow'\")");
  for (const char* command : {"export demo --to lerobot-v3.0 --out dataset", "doctor dataset"}) {
    const Answer answer = Shell("PYTHONPATH=$PWD/missing smile " + std::string(command));
    EXPECT_EQ(answer.exit_code, 3) << command;
    EXPECT_NE(answer.err.find("datasets need a Python package: No module named 'pyarrow'"),
              std::string::npos)
        << answer.err;
    EXPECT_NE(answer.err.find("-m pip install pyarrow"), std::string::npos) << answer.err;
  }
  EXPECT_FALSE(Exists("dataset"));
}

}  // namespace
}  // namespace smile
