#include "motion/trajectory_files.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/diagnostic.h"
#include "motion/trajectory_shape.h"

namespace smile::motion {
namespace {

JointTrajectory RandomTrajectory(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> anywhere(-3, 3), later(0.01, 0.3);
  JointTrajectory trajectory{.joint_names = {"left_s0", "left_gripper"}};
  for (double seconds = 0; trajectory.points.size() < 50; seconds += later(random)) {
    trajectory.points.push_back({seconds, {anywhere(random), anywhere(random)}});
  }
  SetVelocitiesFromPositions(&trajectory);
  return trajectory;
}

std::string FaultOfCsv(const std::string& text) {
  try {
    ParseTrajectoryCsv(text, "wave.csv");
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

std::string FaultOfJson(const std::string& text) {
  try {
    ParseTrajectoryRosJson(text, "wave.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(TrajectoryFiles, ReadWhatTheyWrite) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const JointTrajectory trajectory = RandomTrajectory(seed);
    EXPECT_EQ(ParseTrajectoryCsv(ToCsv(trajectory), "f"), trajectory);
    const JointTrajectory read = ParseTrajectoryRosJson(ToRosJson(trajectory), "f");
    EXPECT_EQ(read.joint_names, trajectory.joint_names);
    for (std::size_t i = 0; i < trajectory.points.size(); ++i) {
      EXPECT_NEAR(read.points[i].seconds, trajectory.points[i].seconds, 0.5001e-9);
      EXPECT_EQ(read.points[i].positions, trajectory.points[i].positions);
      EXPECT_EQ(read.points[i].velocities, trajectory.points[i].velocities);
    }
  }
}

TEST(TrajectoryFiles, VelocitiesFromPositionsNeverLeadBeyondThePoints) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const JointTrajectory trajectory = RandomTrajectory(seed);
    for (std::size_t i = 1; i < trajectory.points.size(); ++i) {
      const TrajectoryPoint &from = trajectory.points[i - 1], &to = trajectory.points[i];
      for (double u = 0; u < 1; u += 0.1) {
        const double at =
            SampleAt(trajectory, from.seconds + u * (to.seconds - from.seconds)).positions[0];
        EXPECT_GE(at, std::min(from.positions[0], to.positions[0]) - 1e-12);
        EXPECT_LE(at, std::max(from.positions[0], to.positions[0]) + 1e-12);
      }
    }
  }
}

TEST(TrajectoryFiles, VelocitiesFromPositionsAreTheSlopesOfASmoothMotion) {
  JointTrajectory wave{.joint_names = {"a"}};
  for (int i = 0; i <= 120; ++i) wave.points.push_back({i / 60.0, {std::sin(i / 60.0)}});
  SetVelocitiesFromPositions(&wave);
  for (int i = 1; i < 120; ++i) {
    if (i == 94) continue;  // where the sine turns, no slope may be but 0
    // Central differences of a sine are off by a share of h^2 / 6.
    EXPECT_NEAR(wave.points[i].velocities[0], std::cos(i / 60.0), 5e-5) << i;
  }
}

TEST(TrajectoryFiles, NameTheLineThatIsWrong) {
  EXPECT_EQ(FaultOfCsv(""), "wave.csv: the file is empty, expected a header like time,left_s0");
  EXPECT_EQ(FaultOfCsv("time,a\n"), "wave.csv: no line follows the header, expected points");
  EXPECT_EQ(
      FaultOfCsv("left_s0\n0\n"),
      "wave.csv:1: the header begins with \"left_s0\", expected time and the names of joints: "
      "time,left_s0");
  EXPECT_EQ(FaultOfCsv("time,a,a\n"), "wave.csv:1: joint \"a\" appears twice");
  EXPECT_EQ(FaultOfCsv("time,a\n\n0,1\r\n1,x\n2,3,4\n0,5\n-1,5\n"),
            "wave.csv:4: found \"x\", expected a number of at most 1e6\n"
            "wave.csv:5: there are 3 cells, expected 2, as in the header\n"
            "wave.csv:6: the time is 0 s, expected more than the 0 s before\n"
            "wave.csv:7: the time is -1 s, expected 0 to 86400");
  std::string endless = "time,a\n";
  for (int i = 0; i < 20'000; ++i) endless += std::to_string(i) + ",0\n";
  EXPECT_EQ(FaultOfCsv(endless), "wave.csv:10002: there are more than 10000 points");
}

TEST(TrajectoryFiles, NameTheFieldThatIsWrong) {
  const auto with_points = [](const std::string& points) {
    return FaultOfJson(R"({"joint_names":["a","b"],"points":[)" + points + "]}");
  };
  EXPECT_EQ(FaultOfJson("{}"), "wave.json: the trajectory lacks \"joint_names\"");
  EXPECT_EQ(with_points(""), "wave.json: there are no points");
  EXPECT_EQ(with_points(R"({"positions":[1,2]})"),
            "wave.json: points[0] lacks \"time_from_start\"");
  EXPECT_EQ(with_points(R"({"positions":[1],"time_from_start":{"secs":0,"nsecs":0}})"),
            "wave.json: points[0]: there are 1 positions, expected 2");
  EXPECT_EQ(with_points(R"({"positions":[1,2],"time_from_start":{"secs":0,"nsecs":1000000000}})"),
            "wave.json: points[0].time_from_start.nsecs is not a whole number from 0 to 999999999");
  EXPECT_EQ(with_points(R"({"positions":[1,"x"],"time_from_start":{"secs":0,"nsecs":0}})"),
            "wave.json: points[0].positions contains values other than numbers");
  EXPECT_EQ(FaultOfJson("[1,"), "wave.json: this is not JSON");
}

}  // namespace
}  // namespace smile::motion
