#include "experiment/evaluation.h"

#include <cstdlib>
#include <vector>

#include "base/diagnostic.h"
#include "experiment/folder_lock.h"
#include "experiment/merge.h"
#include "experiment_fixture.h"

namespace smile::experiment {
namespace {

/// Evaluations whose runs are done by a shell script, which notes each start in `started.txt`.
class EvaluationTest : public ExperimentTest {
 protected:
  EvaluationTest() {
    demonstration_ = RecordStacking();
    Imitator("");
    Write("one", "#!/bin/sh\n");
    Write("two", "#!/bin/sh\n");
  }

  /// Does this for the layout $seed and then reports success, with a recording.
  void Imitator(const std::string& lines) const {
    Write("imitate", "#!/bin/sh\nseed=$1 out=$2\necho \"$3 $seed\" >>" +
                         (root_ / "started.txt").string() + "\nmkdir $out/imitation\n" + lines +
                         "\necho '{\"format\":2,\"success\":true,\"score\":1,\"seconds\":'$seed'}' "
                         ">$out/result.json\n");
  }
  EvaluationPlan PlanOf(std::size_t num_scenes, std::size_t jobs = 2) const {
    return {.demonstration = demonstration_,
            .scene_name = "pair.xml",
            .scene = Pair(),
            .brains = {(root_ / "one").string(), (root_ / "two").string()},
            .num_scenes = num_scenes,
            .jobs = jobs,
            .out = root_ / "out",
            .program = root_ / "imitate",
            .arguments = [](const ImitationJob& job) -> std::vector<std::string> {
              return {std::to_string(job.seed), job.out.string(), job.brain.filename().string()};
            }};
  }
  std::string Started() const {
    std::string text = Exists("started.txt") ? Read("started.txt") : "";
    fs::remove(root_ / "started.txt");
    return text;
  }

  fs::path demonstration_;
};

TEST_F(EvaluationTest, RunsEachBrainInEachLayout) {
  const report::Evaluation evaluation = Evaluate(PlanOf(2, 1));
  EXPECT_EQ(Started(), "one 1\ntwo 1\none 2\ntwo 2\n");
  ASSERT_EQ(evaluation.brains.size(), 2u);
  EXPECT_EQ(evaluation.brains[1].name, "two");
  ASSERT_EQ(evaluation.brains[1].runs.size(), 2u);
  EXPECT_TRUE(evaluation.brains[1].runs[1].has_succeeded);
  EXPECT_EQ(evaluation.brains[1].runs[1].seconds, 2);
  EXPECT_EQ(Read("out/evaluation.json"), ToText(ToJson(evaluation), 2) + "\n");
  EXPECT_TRUE(Exists("out/report.html"));
}

TEST_F(EvaluationTest, LeavesOutImpossibleLayouts) {
  EvaluationPlan plan = PlanOf(4, 1);
  plan.layout = [&plan](std::uint64_t seed) {
    if (seed % 2 == 0) throw std::invalid_argument("layout: there is no room for 'a'");
    return plan.scene;
  };
  std::string said;
  const report::Evaluation evaluation = Evaluate(
      plan, {.common = {.on_message = [&](std::string_view message) { said += message; }}});
  EXPECT_EQ(Started(), "one 1\ntwo 1\none 3\ntwo 3\n");
  EXPECT_EQ(evaluation.brains[0].runs.size(), 2u);
  EXPECT_EQ(ToJson(evaluation)["impossible_layouts"][1],
            Json({{"seed", 4}, {"reason", "layout: there is no room for 'a'"}}));
  EXPECT_NE(said.find("seed 2 is left out: layout: there is no room for 'a'"), std::string::npos);

  plan.layout = [](std::uint64_t) -> scene::SceneSpec { throw std::invalid_argument("no room"); };
  EXPECT_THROW(Evaluate(plan), InputError);
  EXPECT_EQ(Started(), "");
}

TEST_F(EvaluationTest, SkipsFinishedRuns) {
  Evaluate(PlanOf(2));
  Started();
  Evaluate(PlanOf(2));
  EXPECT_EQ(Started(), "");
  Evaluate(PlanOf(3, 1));
  EXPECT_EQ(Started(), "one 3\ntwo 3\n");
}

TEST_F(EvaluationTest, RunsOfAnEarlierVersionMoveAside) {
  Evaluate(PlanOf(1));
  Started();
  fs::rename(root_ / "out/one/brain.json", root_ / "out/one/agent.json");
  Write("out/one/seed-0001/result.json", R"({"rebuilt":true,"score":1})");
  EXPECT_TRUE(Evaluate(PlanOf(1)).brains[0].runs[0].has_succeeded);
  EXPECT_EQ(Started(), "one 1\n");
  EXPECT_TRUE(Exists("out/one.1/agent.json"));
}

TEST_F(EvaluationTest, RepeatsADamagedRun) {
  Evaluate(PlanOf(2));
  Started();
  Write("out/two/seed-0002/result.json", "{\"rebuilt\":tr");
  Evaluate(PlanOf(2));
  EXPECT_EQ(Started(), "two 2\n");
}

TEST_F(EvaluationTest, ResultsDoNotDependOnJobs) {
  Imitator("[ $seed = 3 ] && exit 3");
  EvaluationPlan one = PlanOf(4, 1), many = PlanOf(4, 8);
  many.out = root_ / "many";
  EXPECT_EQ(ToJson(Evaluate(one)), ToJson(Evaluate(many)));
}

TEST_F(EvaluationTest, ShardsMergeToTheSameBytes) {
  Imitator("[ $seed = 4 ] && exit 3");
  const auto possible = [this](std::uint64_t seed) {
    if (seed == 2) throw std::invalid_argument("no room");
    return Pair();
  };
  EvaluationPlan whole = PlanOf(5);
  whole.layout = possible;
  Evaluate(whole);
  std::vector<fs::path> shards;
  for (std::size_t index = 1; index <= 3; ++index) {
    EvaluationPlan plan = PlanOf(5);
    plan.layout = possible;
    plan.shard = {.index = index, .count = 3};
    plan.out = root_ / std::to_string(index);
    Evaluate(plan);
    shards.push_back(plan.out);
  }
  Merge(shards, root_ / "merged");
  for (const char* name : {"evaluation.json", "report.html", "one/brain.json",
                           "two/seed-0005/result.json", "two/seed-0005/run.json"}) {
    EXPECT_EQ(Read(std::string("merged/") + name), Read(std::string("out/") + name)) << name;
  }

  Write("2/two/seed-0003/result.json", R"({"format":2,"success":true,"score":0.5,"seconds":3})");
  try {
    Merge(shards, root_ / "again");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("2/two/seed-0003: was changed"), std::string::npos)
        << error.what();
  }
  EXPECT_FALSE(Exists("again"));
}

TEST_F(EvaluationTest, ASecondOneInTheFolderIsRefused) {
  const FolderLock first(root_ / "out");
  try {
    Evaluate(PlanOf(1));
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(error.what(),
              (root_ / "out").string() + ": another evaluation is writing its results there");
  }
  EXPECT_EQ(Started(), "");
}

TEST_F(EvaluationTest, ACancelledOneContinuesWhereItWas) {
  Imitator("while [ $seed -gt 1 ] && [ ! -e " + (root_ / "go").string() +
           " ]; do sleep 0.01; done");
  EvaluationPlan plan = PlanOf(3, 1);
  plan.brains.pop_back();
  // A new round begins after the first run: the second has started by then.
  std::size_t rounds = 0;
  EvaluationCallbacks callbacks{
      .common = {.is_cancelled = [&] { return rounds > 1; }},
      .on_status = [&](const EvaluationStatus& status) { rounds += status.done; }};
  try {
    Evaluate(plan, callbacks);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("1 of 3 runs are done and kept"), std::string::npos)
        << error.what();
  }
  EXPECT_EQ(Started(), "one 1\none 2\n");
  Write("go", "");
  EXPECT_EQ(Evaluate(plan).brains[0].runs.size(), 3u);
  EXPECT_EQ(Started(), "one 2\none 3\n");
}

TEST_F(EvaluationTest, AFailedRunHasACause) {
  Imitator(
      "[ $seed = 1 ] && exit 3\n[ $seed = 2 ] && kill -9 $$\n[ $seed = 3 ] && sleep 60\n"
      "[ $seed = 4 ] && { echo no room; exit 1; }");
  EvaluationPlan plan = PlanOf(4);
  plan.brains.pop_back();
  plan.wall_seconds = 0.5;
  std::vector<std::uint64_t> failed;
  const auto runs =
      Evaluate(plan, {.on_failed_run =
                          [&](const std::string& brain, const report::EvaluatedRun& run) {
                            EXPECT_EQ(brain, "one");
                            failed.push_back(run.seed);
                          }})
          .brains[0]
          .runs;
  EXPECT_EQ(failed.size(), 4u);
  const std::pair<const char*, const char*> causes[] = {{"no_result", "exit code 3"},
                                                        {"crashed", "signal 9"},
                                                        {"hung", "no end after 0.5 s"},
                                                        {"no_result", "no room"}};
  for (std::size_t i = 0; i < 4; ++i) {
    ASSERT_TRUE(runs[i].failure_reason);
    EXPECT_EQ(runs[i].failure_reason->code, causes[i].first);
    EXPECT_NE(runs[i].failure_reason->text.find(causes[i].second), std::string::npos)
        << runs[i].failure_reason->text;
  }
}

TEST_F(EvaluationTest, KeepsTheRecordingsOfFailures) {
  Imitator("[ $seed = 2 ] && exit 3");
  EvaluationPlan plan = PlanOf(2);
  plan.brains.pop_back();
  const auto runs = Evaluate(plan).brains[0].runs;
  EXPECT_FALSE(Exists("out/one/seed-0001/imitation"));
  EXPECT_EQ(runs[1].recording, "one/seed-0002/imitation");
  plan.keep = Keep::kNone;
  Evaluate(plan);
  EXPECT_FALSE(Exists("out/one/seed-0002/imitation"));
}

TEST_F(EvaluationTest, AChangedBrainStartsAgainBesideTheOld) {
  Evaluate(PlanOf(1));
  Started();
  Write("two", "#!/bin/sh\n# improved\n");
  std::string message;
  Evaluate(PlanOf(1), {.common = {.on_message = [&](std::string_view text) { message = text; }}});
  EXPECT_EQ(Started(), "two 1\n");
  EXPECT_TRUE(Exists("out/two.1/seed-0001/result.json"));
  EXPECT_EQ(message, (root_ / "out/two").string() + ": the earlier result is now " +
                         (root_ / "out/two.1").string());
}

TEST_F(EvaluationTest, BrainsOfOneNameHaveDifferentFolders) {
  Write("other/one", "#!/bin/sh\n");
  EvaluationPlan plan = PlanOf(1);
  plan.brains = {(root_ / "one").string(), (root_ / "other/one").string()};
  const report::Evaluation evaluation = Evaluate(plan);
  EXPECT_EQ(evaluation.brains[0].name, "one");
  EXPECT_EQ(evaluation.brains[1].name, "one-2");
}

TEST_F(EvaluationTest, ErrorsOfThePlanAreFoundBeforeAnyRun) {
  EvaluationPlan plan = PlanOf(1);
  plan.brains.push_back((root_ / "nowhere").string());
  EXPECT_THROW(Evaluate(plan), InputError);
  plan = PlanOf(1);
  plan.scene = SceneOf("<block id=\"b\" color=\"blue\" location=\"(2, -3, 0.5)\"/>");
  EXPECT_THROW(Evaluate(plan), InputError);
  EXPECT_FALSE(Exists("out"));
  EXPECT_EQ(Started(), "");
}

}  // namespace
}  // namespace smile::experiment
