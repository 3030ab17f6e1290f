// Descriptions of real robots, as tools/get_real_robots.sh installs them; skipped without.

#include <regex>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "program.h"

namespace smile {
namespace {

struct RealRobot {
  std::string name, urdf;
  std::size_t num_arms, num_joints;  ///< joints of each arm
  std::string gripper;               ///< member of the side file; empty: none
};

void PrintTo(const RealRobot& robot, std::ostream* out) { *out << robot.name; }

class RealRobots : public ProgramTest, public ::testing::WithParamInterface<RealRobot> {
 protected:
  void SetUp() override {
    packages_ = Shipped("build/real_robots/cmeel.prefix/share");
    urdf_ = Shipped("build/real_robots/" + GetParam().urdf);
    if (!std::filesystem::exists(urdf_)) {
      GTEST_SKIP() << "tools/get_real_robots.sh installs the robots";
    }
  }
  Answer Add(const std::string& name, const std::filesystem::path& urdf) {
    return Smile("robots add " + name + " '" + urdf.string() + "' --package '" +
                 packages_.string() + "'");
  }
  /// Returns a description with a link below its root.
  static std::string OnAFoot(std::string text) {
    const std::regex link("<link\\s+name=\"([^\"]+)\""), child("<child\\s+link=\"([^\"]+)\"");
    std::set<std::string> roots;
    for (std::sregex_iterator it(text.begin(), text.end(), link), end; it != end; ++it) {
      roots.insert((*it)[1]);
    }
    for (std::sregex_iterator it(text.begin(), text.end(), child), end; it != end; ++it) {
      roots.erase((*it)[1]);
    }
    EXPECT_EQ(roots.size(), 1u);
    return text.insert(text.rfind("</robot>"),
                       "<link name=\"foot\"/><joint name=\"foot\" type=\"fixed\"><parent "
                       "link=\"foot\"/><child link=\"" +
                           *roots.begin() + "\"/><origin xyz=\"0 0 0.001\"/></joint>\n");
  }
  /// Writes another text of the description, beside copies of the files that are beside it.
  std::filesystem::path Changed(const std::string& text) {
    std::filesystem::copy(urdf_.parent_path(), directory_ / "changed",
                          std::filesystem::copy_options::recursive);
    Write("changed/changed.urdf", text);
    return directory_ / "changed/changed.urdf";
  }
  Json SideFileOf(const std::string& name) const {
    return Json::parse(Read("data/smile/robots/" + name + "/" + name + ".robot.json"));
  }
  static void ExpectArms(const Json& side_file) {
    EXPECT_EQ(side_file["arms"].size(), GetParam().num_arms);
    for (const Json& arm : side_file["arms"]) {
      EXPECT_EQ(arm["joints"].size(), GetParam().num_joints);
      for (const std::string kind : {"fingers", "jaws", "suction"}) {
        EXPECT_EQ(arm.contains(kind), kind == GetParam().gripper) << kind;
      }
    }
  }

  std::filesystem::path packages_, urdf_;
};

TEST_P(RealRobots, AreKnownByTheirContent) {
  const Answer added = Add("mine", urdf_);
  ASSERT_EQ(added.exit_code, 0) << added.err;
  EXPECT_NE(added.out.find("which ships for this description, known by its content"),
            std::string::npos)
      << added.out;
  ExpectArms(SideFileOf("mine"));
  const Answer check = Smile("robots check mine");
  EXPECT_EQ(check.exit_code, 0) << check.err;
}

TEST_P(RealRobots, AreKnownByTheirKinematics) {
  const Answer added = Add("mine", Changed(ReadFile(urdf_, 1 << 22) + "<!-- changed -->\n"));
  ASSERT_EQ(added.exit_code, 0) << added.err;
  EXPECT_NE(added.out.find("which ships for this description, known by its kinematics"),
            std::string::npos)
      << added.out;
  ExpectArms(SideFileOf("mine"));
  const Answer check = Smile("robots check mine");
  EXPECT_EQ(check.exit_code, 0) << check.err;
  EXPECT_NE(check.out.find("description: known by its kinematics: " + GetParam().name),
            std::string::npos)
      << check.out;
}

TEST_P(RealRobots, AreUnderstoodWithoutASideFile) {
  // On a foot of 1 mm it is another robot.
  const Answer added = Add("mine", Changed(OnAFoot(ReadFile(urdf_, 1 << 22))));
  ASSERT_EQ(added.exit_code, 0) << added.err;
  EXPECT_NE(added.out.find("ready pose: each tool over the table, pointing down, free of overlaps"),
            std::string::npos)
      << added.out;
  ExpectArms(SideFileOf("mine"));
}

TEST_P(RealRobots, MoveAndReplay) {
  ASSERT_EQ(Add("mine", urdf_).exit_code, 0);
  const Json arms = SideFileOf("mine")["arms"];
  const std::string joint = arms.begin().value()["joints"][1];
  Write("empty.xml", SceneOf(""));
  Write("move.jsonl", "{\"do\": \"turn\", \"joint\": \"" + joint +
                          "\", \"velocity\": -0.2}\n{\"do\": \"wait\", \"seconds\": 0.5}\n" +
                          (GetParam().gripper.empty()
                               ? ""
                               : "{\"do\": \"gripper\", \"arm\": \"left\", \"velocity\": -0.2}\n") +
                          "{\"do\": \"wait\", \"seconds\": 0.5}\n");
  const Answer run =
      Smile("run empty.xml --robot mine --commands move.jsonl --record demo --no-pictures --json");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Json start = SideFileOf("mine")["poses"]["ready"][arms.begin().key()];
  const Json joints = run.json()["robot"][arms.begin().key()]["joints"];
  for (std::size_t i = 0; i < joints.size(); ++i) {
    EXPECT_NEAR(joints[i].get<double>(), start[i].get<double>() - (i == 1 ? 0.2 : 0.0), 0.01) << i;
  }
  EXPECT_EQ(Smile("replay demo --verify").exit_code, 0);
}

const std::string kRobots = "cmeel.prefix/share/example-robot-data/robots/";

INSTANTIATE_TEST_SUITE_P(
    Each, RealRobots,
    testing::Values(
        RealRobot{"panda", kRobots + "panda_description/urdf/panda.urdf", 1, 7, "fingers"},
        RealRobot{"ur5", kRobots + "ur_description/urdf/ur5_robot.urdf", 1, 6, ""},
        RealRobot{"ur5e", "airo_models/arms/ur5e/ur5e.urdf", 1, 6, ""},
        RealRobot{"xarm7", kRobots + "xarm_description/urdf/xarm7.urdf", 1, 7, ""},
        RealRobot{"so101", kRobots + "so_arm_description/urdf/so101.urdf", 1, 5, "jaws"},
        RealRobot{"baxter", kRobots + "baxter_description/urdf/baxter.urdf", 2, 7, "fingers"}),
    [](const auto& robot) { return robot.param.name; });

/// Its fingers are short, and wherever its arm waits, it hides a part of the table from the eye.
class RealPanda : public ProgramTest, public ::testing::WithParamInterface<const char*> {};

TEST_P(RealPanda, BuildsATowerWithTheLearner) {
  const std::string urdf =
      Shipped("build/real_robots/" + kRobots + "panda_description/urdf/panda.urdf");
  if (!std::filesystem::exists(urdf)) GTEST_SKIP() << "tools/get_real_robots.sh installs it";
  const std::string cube = R"(" xspan="0.6" yspan="0.6" zspan="0.6" location=")";
  Write("cubes.xml", SceneOf("<block color=\"red\" id=\"A" + cube + "(-2,0,0.3)\"/>" +
                             "<block color=\"green\" id=\"B" + cube + "(0,0,0.3)\"/>" +
                             "<block color=\"blue\" id=\"C" + cube + "(2,0,0.3)\"/>"));
  std::string script;
  for (const auto& [object, x, top] : {std::tuple("A", -2, 0.91), std::tuple("C", 2, 1.51)}) {
    script += std::string(R"({"hand":"left","do":"grasp","object":")") + object + "\"}\n";
    for (const auto& [at, height] : {std::pair(x, 4.0), std::pair(0, 4.0), std::pair(0, top)}) {
      script += R"({"hand":"left","do":"move_to","position":[)" + std::to_string(at) + ",0," +
                std::to_string(height) + "]}\n{\"do\":\"wait\",\"until\":\"arrived\"}\n";
    }
    script += R"({"hand":"left","do":"release"}
{"do":"wait","until":"still"}
)";
  }
  Write("tower.jsonl", script);
  ASSERT_EQ(Smile("run cubes.xml --no-robot --commands tower.jsonl --record shown").exit_code, 0);
  const Answer answer = Smile("imitate shown cubes.xml --robot '" + urdf + "' --path '" +
                              Shipped("build/real_robots/cmeel.prefix/share") + "' --brain '" +
                              Shipped(GetParam()) + "' --seed 1 --no-pictures --json --out built");
  ASSERT_EQ(answer.exit_code, 0) << answer.err;
  EXPECT_TRUE(answer.json()["success"]);
  EXPECT_EQ(answer.json()["claim_right"], true);
}

INSTANTIATE_TEST_SUITE_P(Twins, RealPanda,
                         ::testing::Values("python/learner/learner.py", "matlab/learner"),
                         [](const auto& brain) {
                           return brain.index == 0 ? std::string("python") : std::string("octave");
                         });

}  // namespace
}  // namespace smile
