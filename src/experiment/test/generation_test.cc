#include "experiment/generation.h"

#include <gtest/gtest.h>

#include <map>
#include <vector>

#include "base/diagnostic.h"
#include "experiment/folder_lock.h"
#include "experiment/merge.h"
#include "experiment_fixture.h"

namespace smile::experiment {
namespace {

/// Generations whose runs are done by a shell script, which notes each start in `started.txt`.
class GenerationTest : public ExperimentTest {
 protected:
  GenerationTest() {
    demonstration_ = RecordStacking();
    Imitator("");
    Write("brain", "#!/bin/sh\n");
  }

  /// Does this for the layout $seed and then reports success, with a recording; after `failed` it
  /// reports a failure.
  void Imitator(const std::string& lines) const {
    Write("imitate",
          "#!/bin/sh\nseed=$1 out=$2 success=true cause=null\nfailed() { success=false; "
          "cause='{\"word\":\"toppled\",\"text\":\"a lies\"}'; }\necho $seed >>" +
              (root_ / "started.txt").string() +
              "\nmkdir $out/imitation; echo trace of $seed >$out/imitation/trace.bin\n" + lines +
              "\necho '{\"format\":2,\"success\":'$success',\"score\":0.5,\"seconds\":'$seed',"
              "\"cause\":'$cause',\"realtime_factor\":'$$'}' >$out/result.json\n");
  }
  GenerationPlan PlanOf(std::size_t count, const std::string& out = "out") const {
    return {
        .demonstration = demonstration_,
        .scenes = {{"pair.xml", Pair()}},
        .brain = (root_ / "brain").string(),
        .choices = {.scenes = {"pair.xml"},
                    .levels = {"scattered", "edges"},
                    .eyes = {"eye"},
                    .joints = {0, 0.01}},
        .count = count,
        .jobs = 2,
        .out = root_ / out,
        .program = root_ / "imitate",
        .arguments = [](const Attempt& attempt, const fs::path& to) -> std::vector<std::string> {
          return {std::to_string(attempt.seed), to.string()};
        }};
  }
  /// Makes all shards of a generation, in folders `1`, `2`, …
  std::vector<fs::path> MakeShards(std::size_t count, std::size_t num_shards) const {
    std::vector<fs::path> folders;
    for (std::size_t index = 1; index <= num_shards; ++index) {
      GenerationPlan plan = PlanOf(count, std::to_string(index));
      plan.shard = {.index = index, .count = num_shards};
      Generate(plan);
      folders.push_back(plan.out);
    }
    return folders;
  }
  std::string Started() const {
    std::string text = Exists("started.txt") ? Read("started.txt") : "";
    fs::remove(root_ / "started.txt");
    return text;
  }
  /// Returns all files of a folder, by their path in it.
  std::map<std::string, std::string> FilesIn(const std::string& folder) const {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(root_ / folder)) {
      if (!entry.is_regular_file()) continue;
      files[entry.path().lexically_relative(root_ / folder)] = ReadFile(entry.path(), 1 << 20);
    }
    return files;
  }
  /// Returns the message of an error; empty if there is none.
  template <class Function>
  static std::string MessageOf(const Function& function) {
    try {
      function();
    } catch (const std::exception& error) {
      return error.what();
    }
    return "";
  }
  std::string MessageOfMerge(const std::vector<fs::path>& shards) const {
    return MessageOf([&] { Merge(shards, root_ / "merged"); });
  }

  fs::path demonstration_;
};

TEST_F(GenerationTest, KeepsSuccessesAndFailuresApart) {
  Imitator("[ $seed = 2 ] && failed");
  const GenerationSummary summary = Generate(PlanOf(3));
  EXPECT_EQ(summary.yield, (Yield{.attempts = 4, .successes = 3}));
  EXPECT_EQ(summary.causes, (std::map<std::string, std::size_t>{{"toppled", 1}}));
  EXPECT_EQ(Read("out/episodes/seed-1000002/imitation/trace.bin"), "trace of 1000002\n");
  EXPECT_TRUE(Exists("out/failures/seed-0002/imitation/trace.bin"));
  EXPECT_FALSE(Exists("out/running"));
  const std::vector<EndedAttempt> attempts = ReadManifest(root_ / "out");
  ASSERT_EQ(attempts.size(), 4u);
  EXPECT_EQ(attempts[1].attempt.seed, 2u);
  EXPECT_EQ(attempts[1].cause, (task::FailureReason{"toppled", "a lies"}));
  EXPECT_EQ(attempts[2].attempt.seed, 1'000'002u);
  EXPECT_EQ(attempts[2].attempt.number, 2u);
  EXPECT_EQ(attempts[2].attempt.variation, DrawVariation(PlanOf(3).choices, 1'000'002));
  EXPECT_EQ(Read("out/failures/seed-0002/attempt.json"), ToText(ToJson(attempts[1])) + "\n");
}

TEST_F(GenerationTest, GivesUpAnEpisodeAfterItsTries) {
  Imitator("[ $(expr $seed % 1000000) = 2 ] && failed");
  GenerationPlan plan = PlanOf(2);
  plan.tries = 3;
  const GenerationSummary summary = Generate(plan);
  EXPECT_EQ(summary.yield, (Yield{.attempts = 4, .successes = 1}));
  EXPECT_EQ(Started(), "1\n2\n1000002\n2000002\n");
}

TEST_F(GenerationTest, ImpossibleLayoutsAreAttemptsWithoutARun) {
  GenerationPlan plan = PlanOf(2);
  plan.layout = [](const Attempt& attempt) {
    if (attempt.seed == 1) throw std::invalid_argument("there is no room for 'a'");
    return Pair();
  };
  const GenerationSummary summary = Generate(plan);
  EXPECT_EQ(summary.yield, (Yield{.attempts = 2, .successes = 2}));
  EXPECT_EQ(summary.impossible, 1u);
  EXPECT_EQ(Started(), "2\n1000001\n");
  EXPECT_EQ(ReadManifest(root_ / "out")[0].cause->text, "there is no room for 'a'");
}

TEST_F(GenerationTest, HasTheSameBytesWithAnyNumberOfJobsAndShards) {
  Imitator("[ $(expr $seed % 3) = 2 ] && failed");
  GenerationPlan one = PlanOf(6), many = PlanOf(6, "many");
  one.jobs = 1;
  many.jobs = 8;
  Generate(one);
  Generate(many);
  EXPECT_EQ(FilesIn("out"), FilesIn("many"));
  std::vector<fs::path> shards = MakeShards(6, 4);
  std::swap(shards[0], shards[2]);
  Merge(shards, root_ / "merged");
  EXPECT_EQ(FilesIn("merged"), FilesIn("out"));
  EXPECT_FALSE(Exists("merged.partial"));
}

TEST_F(GenerationTest, ACancelledOneContinuesWhereItWas) {
  Generate(PlanOf(3, "whole"));
  Started();
  Imitator("while [ $seed -gt 1 ] && [ ! -e " + (root_ / "go").string() +
           " ]; do sleep 0.01; done");
  GenerationPlan plan = PlanOf(3);
  plan.jobs = 1;
  std::size_t episodes = 0;
  const std::string message = MessageOf([&] {
    Generate(plan,
             {.common = {.is_cancelled = [&] { return episodes > 0; }},
              .on_status = [&](const GenerationStatus& status) { episodes = status.episodes; }});
  });
  EXPECT_NE(message.find("1 of 3 episodes are made and kept"), std::string::npos) << message;
  EXPECT_FALSE(Exists("out/summary.json"));
  Write("go", "");
  Started();
  Generate(plan);
  EXPECT_EQ(Started(), "2\n3\n");
  const auto files = FilesIn("out"), whole = FilesIn("whole");
  for (const char* name : {"manifest.jsonl", "summary.json", "episodes/seed-0003/attempt.json"}) {
    EXPECT_EQ(files.at(name), whole.at(name));
  }
}

TEST_F(GenerationTest, ContinuesToMoreEpisodesAndRepairsDamage) {
  Generate(PlanOf(1));
  Started();
  Generate(PlanOf(2));
  EXPECT_EQ(Started(), "2\n");
  Write("out/episodes/seed-0001/imitation/trace.bin", "edited");
  Generate(PlanOf(2));
  EXPECT_EQ(Started(), "1\n");
  EXPECT_EQ(Read("out/episodes/seed-0001/imitation/trace.bin"), "trace of 1\n");
  for (const char* text :
       {"", "{", R"({"episode":0,"try":1,"seed":1,"variation":{"scene":"a"}})"}) {
    Write("out/episodes/seed-0001/attempt.json", text);
    Generate(PlanOf(2));
    EXPECT_EQ(Started(), "1\n") << text;
  }
  EXPECT_NE(MessageOf([&] { Generate(PlanOf(1)); }).find("belongs to none of the 1 episodes"),
            std::string::npos);
}

TEST_F(GenerationTest, NeverMixesDifferentGenerations) {
  Generate(PlanOf(1));
  GenerationPlan other = PlanOf(1);
  other.first_seed = 5;
  EXPECT_EQ(MessageOf([&] { Generate(other); }),
            (root_ / "out").string() +
                ": contains a generation that differs in first_seed, expected the same or a new "
                "folder");
  Write("else/notes.txt", "");
  EXPECT_NE(MessageOf([&] { Generate(PlanOf(1, "else")); }).find("is not empty"),
            std::string::npos);
  const FolderLock lock(root_ / "out", "generation");
  EXPECT_NE(MessageOf([&] { Generate(PlanOf(1)); }).find("another generation is writing"),
            std::string::npos);
}

TEST_F(GenerationTest, MergeNamesWhatIsWrongAndWritesNothing) {
  const std::vector<fs::path> shards = MakeShards(4, 2);
  EXPECT_EQ(MessageOfMerge({shards[0]}),
            shards[0].string() + ": shard 2/2 is missing, expected all of them");
  EXPECT_NE(MessageOfMerge({shards[0], shards[0]}).find("is shard 1/2 again"), std::string::npos);
  EXPECT_NE(MessageOfMerge({shards[0], demonstration_}).find("is no complete shard"),
            std::string::npos);

  const std::string trace = "2/episodes/seed-0002/imitation/trace.bin", kept = Read(trace);
  Write(trace, "edited");
  EXPECT_NE(MessageOfMerge(shards).find("seed-0002/imitation was changed"), std::string::npos);
  Write(trace, kept);
  const std::string manifest = Read("2/manifest.jsonl");
  Write("2/manifest.jsonl", manifest.substr(manifest.find('\n') + 1));
  EXPECT_NE(MessageOfMerge(shards).find("episode 1 is missing"), std::string::npos);
  Write("2/manifest.jsonl", manifest);
  std::string key = Read("2/generation.json");
  key.replace(key.find("smile 0"), 7, "smile 9");
  Write("2/generation.json", key);
  EXPECT_NE(MessageOfMerge(shards).find("differs in program: \"smile 9"), std::string::npos);
  EXPECT_FALSE(Exists("merged") || Exists("merged.partial"));
}

TEST(Variation, IsDrawnFromTheSeedAlone) {
  VariationChoices choices{.scenes = {"a", "b"},
                           .levels = {"scattered", "edges"},
                           .eyes = {"eye"},
                           .joints = {0.1, 0.2}};
  std::map<std::string, int> levels;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const Variation variation = DrawVariation(choices, seed);
    EXPECT_EQ(variation, DrawVariation(choices, seed));
    EXPECT_TRUE(variation.noise.joints >= 0.1 && variation.noise.joints < 0.2);
    EXPECT_EQ(variation.noise.image, 0);
    ++levels[variation.scene + " " + variation.level];
  }
  EXPECT_EQ(levels.size(), 4u);
  for (const auto& [level, count] : levels) EXPECT_GT(count, 25) << level;
  const Variation before = DrawVariation(choices, 7);
  choices.levels.emplace_back("mixed");
  EXPECT_EQ(DrawVariation(choices, 7).noise, before.noise);
}

TEST(Shard, IsParsed) {
  EXPECT_EQ(ParseShard("2/8"), (Shard{.index = 2, .count = 8}));
  for (const char* text : {"", "2", "0/8", "9/8", "2/8/", "-1/8", "a/b", "/"}) {
    EXPECT_THROW(ParseShard(text), std::invalid_argument) << text;
  }
}

}  // namespace
}  // namespace smile::experiment
