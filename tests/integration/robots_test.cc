#include "program.h"

namespace smile {
namespace {

/// The robots that the program knows by name, and one that a user adds.
class Robots : public ProgramTest {
 protected:
  Robots() {
    // Tern, without its side file.
    Write("ws/bird.urdf", ReadFile(Shipped("robots/tern.urdf"), 1 << 20));
    Write("empty.xml", SceneOf(""));
  }
};

TEST_F(Robots, AreListed) {
  const Answer answer = Smile("robots");
  EXPECT_EQ(answer.exit_code, 0);
  EXPECT_EQ(
      answer.out,
      "baxter        2 arms: left of 7 joints with two fingers, 0 to 0.2 m; right of 7 joints "
      "with two fingers, 0 to 0.2 m (shipped)\n"
      "tern          1 arm: arm of 6 joints with two fingers, 0 to 0.13 m (shipped)\n");
}

TEST_F(Robots, AreAddedWithWhatIsFoundInThem) {
  const Answer added = Smile("robots add bird ws/bird.urdf");
  ASSERT_EQ(added.exit_code, 0) << added.err;
  for (const std::string found :
       {"found: arm: 6 joints, shoulder_turn, shoulder_lift, elbow, forearm_turn, wrist_bend, "
        "wrist_turn\n",
        "found: arm: tool tool\n",
        "found: arm: gripper: two fingers that slide apart, left_finger_slide and "
        "right_finger_slide\n",
        "found: ready pose: each tool over the table, pointing down, free of overlaps\n"}) {
    EXPECT_NE(added.out.find(found), std::string::npos) << added.out;
  }
  EXPECT_TRUE(Exists("data/smile/robots/bird/bird.png"));
  std::filesystem::remove_all(directory_ / "ws");
  const Answer check = Smile("robots check bird");
  EXPECT_EQ(check.exit_code, 0) << check.err;
  EXPECT_NE(check.out.find("description: not known; content hash "), std::string::npos)
      << check.out;
  EXPECT_NE(Smile("robots").out.find("\nbird "), std::string::npos);

  Write("down.jsonl",
        "{\"do\": \"turn\", \"joint\": \"elbow\", \"velocity\": 0.2}\n"
        "{\"do\": \"gripper\", \"arm\": \"left\", \"velocity\": -0.5}\n"
        "{\"do\": \"wait\", \"seconds\": 1}\n");
  const Answer run = Smile(
      "run empty.xml --robot bird --commands down.jsonl --record demo "
      "--no-pictures --json");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NEAR(run.json()["robot"]["arm"]["gripper"].get<double>(), 0.8, 0.02);
  std::filesystem::remove_all(directory_ / "data");
  EXPECT_EQ(Smile("replay demo --verify").exit_code, 0) << "the recording has its robot";
}

TEST_F(Robots, AreRefusedWithTheReason) {
  const auto refusal = [&](const std::string& arguments, int exit_code) {
    const Answer answer = Smile(arguments);
    EXPECT_EQ(answer.exit_code, exit_code) << arguments;
    return answer.err;
  };
  EXPECT_EQ(refusal("robots add tern ws/bird.urdf", 2), "smile: there is a robot \"tern\", " +
                                                            Shipped("robots/tern.urdf") +
                                                            ", expected another name\n");
  EXPECT_EQ(refusal("robots check birt", 2),
            "smile: no robot is called \"birt\", expected baxter or tern, or the path of a URDF\n");
  Write("ws/none.urdf", "<robot name=\"none\">\n<link name=\"base\"/></robot>");
  EXPECT_EQ(refusal("robots add none ws/none.urdf", 1),
            "ws/none.urdf: found no arm among its 0 joints, expected a chain of two joints or "
            "more\n");
  EXPECT_FALSE(Exists("data/smile/robots/none"));
  Write("ws/bird.robot.json",
        R"({"format": 2, "arms": {"arm": {"joints": ["wing"], "tool": "tool"}}})");
  EXPECT_EQ(
      refusal("robots add bird ws/bird.urdf", 1),
      "ws/bird.robot.json: <arms/arm/joints/0>: found \"wing\", expected a joint that moves\n");
}

}  // namespace
}  // namespace smile
