// One demonstration, many recordings of a robot: the same bytes, whatever happens meanwhile.

#include "program.h"

namespace smile {
namespace {

class Generate : public ProgramTest {
 protected:
  Generate() {
    EXPECT_EQ(Smile("run " + Shipped("scenes/tower.xml") + " --commands " +
                    Shipped("examples/tower.jsonl") + " --record shown --size 320x240")
                  .exit_code,
              0);
  }

  /// Returns the command that generates towers.
  static std::string Towers(const std::string& arguments) {
    return "generate shown --scene " + Shipped("scenes/tower_robot.xml") + " --brain " +
           Shipped("python/learner/learner.py") + " --noise joints=0..0.002 " +
           "--level scattered,edges " + arguments;
  }
  /// Returns the files that differ between two folders.
  std::string Differences(const std::string& a, const std::string& b) const {
    return Shell("diff -r " + a + " " + b + " || true").out;
  }
};

TEST_F(Generate, TowersAreTheSameAfterAKillAndInShards) {
  const Answer whole = Smile(Towers("--count 3 --jobs 2 --out whole"));
  ASSERT_EQ(whole.exit_code, 0) << whole.err;
  EXPECT_NE(whole.out.find("3 of 3 episodes\nyield: 3 of 3 attempts"), std::string::npos)
      << whole.out;
  EXPECT_EQ(Smile("replay whole/episodes/seed-0002/imitation --verify").exit_code, 0);
  const std::string line = Shell("head -1 whole/manifest.jsonl").out;
  const Json first = Json::parse(line);
  EXPECT_EQ(first["outcome"], "success");
  EXPECT_EQ(first["state_hash"].get<std::string>().size(), 16u) << line;
  EXPECT_LT(first["variation"]["noise"]["joints"], 0.002);

  // Killed without warning after its first episode; what was begun is begun again.
  const Answer killed =
      Shell(SMILE_PROGRAM " " + Towers("--count 3 --jobs 1 --out killed") +
            " & generation=$!\n"
            "for k in $(seq 3000); do [ -e killed/running/seed-0002 ] && break; sleep 0.02; done\n"
            "kill -KILL $generation\nwait $generation");
  EXPECT_EQ(killed.exit_code, 128 + 9);
  EXPECT_FALSE(Exists("killed/manifest.jsonl"));
  ASSERT_TRUE(Exists("killed/episodes/seed-0001/attempt.json"));
  const Answer resumed = Smile(Towers("--count 3 --jobs 1 --out killed"));
  ASSERT_EQ(resumed.exit_code, 0) << resumed.err;
  EXPECT_EQ(Differences("whole", "killed"), "");

  for (const char* shard : {"1", "2"}) {
    ASSERT_EQ(Smile(Towers(std::string("--count 3 --shard ") + shard + "/2 --out part" + shard))
                  .exit_code,
              0);
  }
  EXPECT_EQ(Smile("merge part1 --out merged").exit_code, 1);
  ASSERT_EQ(Smile("merge part2 part1 --out merged").exit_code, 0);
  EXPECT_EQ(Differences("whole", "merged"), "");
}

TEST_F(Generate, VariesLooksAndDisturbsWithTheSameBytesForAnyJobs) {
  const std::string arguments =
      "--count 2 --looks brightness=0.98..1,turn=-90..90,hue=-1..1,table=0.9..1 --pattern checks "
      "--jitter shift=-0.05..0.05,tilt=-0.5..0.5 --speed 0.7..0.9 --choices order "
      "--disturb fraction=1,seconds=1..2,distance=0.2 --size 320x240 ";
  const Answer one = Smile(Towers(arguments + "--jobs 1 --out one"));
  ASSERT_EQ(one.exit_code, 0) << one.err;
  ASSERT_EQ(Smile(Towers(arguments + "--jobs 2 --out two")).exit_code, 0);
  EXPECT_EQ(Differences("one", "two"), "");
  const Json first = Json::parse(Shell("head -1 one/manifest.jsonl").out);
  const Json& variation = first["variation"];
  EXPECT_LT(variation["behavior"]["speed"], 0.9);
  EXPECT_EQ(variation["looks"]["pattern"], "checks");
  EXPECT_EQ(variation["looks"]["cameras"][0]["camera"], "eye");
  EXPECT_EQ(variation["disturbance"]["distance"], 0.2);
  // All of it is in the recording, which shows who took the block.
  const std::string episode = "one/" + first["recording"].get<std::string>();
  const std::string scene = Read(episode + "/scene.xml");
  for (const char* word : {"<lighting", "<cameraOffset camera=\"eye\"", "pattern=\"checks\""}) {
    EXPECT_NE(scene.find(word), std::string::npos) << word;
  }
  const Json result = Json::parse(Read(episode + "/../result.json"));
  EXPECT_TRUE(result["disturbance"]["object"].is_string()) << result["disturbance"];
}

TEST_F(Generate, ReportsWhatFailsAndWhatIsWrong) {
  Write("idle.py", "def step(sensor, motor, aux):\n  aux.exit = 1\n");
  const std::string tower = "generate shown --scene " + Shipped("scenes/tower_robot.xml");
  const Answer answer = Smile(tower + " --brain idle.py --count 1 --tries 2 --json --out idle");
  EXPECT_EQ(answer.exit_code, 1);
  EXPECT_EQ(answer.json()["causes"]["never_taken"], 2);
  EXPECT_EQ(answer.json()["episodes"], 0);
  EXPECT_NE(answer.err.find("1 episodes are missing"), std::string::npos) << answer.err;
  EXPECT_TRUE(Exists("idle/failures/seed-1000001/imitation/demo.json"));

  const std::pair<const char*, int> wrong[] = {{" --brain nowhere", 1},
                                               {" --brain idle.py --noise joints=2..1", 2},
                                               {" --brain idle.py --noise seed=3", 2},
                                               {" --brain idle.py --shard 3/2", 2},
                                               {" --brain idle.py --level easy", 2},
                                               {" --brain idle.py --looks bright=1", 2},
                                               {" --brain idle.py --looks hue=3..1", 2},
                                               {" --brain idle.py --disturb fraction=2", 2},
                                               {" --brain idle.py --jitter shift=1 "
                                                "--jitter-camera ey",
                                                2},
                                               {" --brain idle.py --count 0", 2}};
  for (const auto& [arguments, exit_code] : wrong) {
    EXPECT_EQ(Smile(tower + arguments + " --out wrong").exit_code, exit_code) << arguments;
  }
  EXPECT_FALSE(Exists("wrong"));
}

}  // namespace
}  // namespace smile
