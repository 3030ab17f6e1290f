#include "report/evaluation.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "base/diagnostic.h"
#include "base/files.h"
#include "report/evaluation_page.h"

namespace smile::report {
namespace {

EvaluatedRun Success(std::uint64_t seed, double error_mm, double seconds) {
  return {.seed = seed,
          .has_succeeded = true,
          .score = 1,
          .gain = 1,
          .claim = task::ClaimEnd{.is_done = true, .is_right = true},
          .error_mm = error_mm,
          .seconds = seconds,
          .retries = 1};
}
EvaluatedRun Failed(std::uint64_t seed, const std::string& word) {
  return {.seed = seed,
          .gain = 0.25,
          .claim = task::ClaimEnd{.is_done = true, .is_right = false},
          .seconds = 600,
          .failure_reason = task::FailureReason{.code = word, .text = "for some reason"},
          .recording = "runs/" + std::to_string(seed)};
}

/// Two brains, five layouts.
Evaluation Pair() {
  return {.program = "smile 1",
          .demo = "shown",
          .scene = "pair.xml",
          .brains = {{"old",
                      "brains/old",
                      {Success(1, 4, 30), Failed(2, "fell"), Success(3, 6, 34), Failed(4, "fell"),
                       Failed(5, "time up")}},
                     {"new",
                      "brains/new",
                      {Success(1, 3, 20), Success(2, 3, 20), Success(3, 3, 22), Success(4, 3, 20),
                       Failed(5, "time up")}}},
          .again = "smile imitate"};
}

TEST(Evaluation, SummarizesSuccessesAndCountsCauses) {
  const Summary summary = SummaryOf(Pair().brains[0]);
  EXPECT_EQ(summary.successes, 2u);
  EXPECT_EQ(summary.success_rate(), 0.4);
  EXPECT_EQ(summary.error_mm.value_or(Mean{}).value, 5);
  EXPECT_EQ(summary.seconds_p50, 32);
  EXPECT_EQ(summary.retries, 2u);
  EXPECT_EQ(summary.grasps, std::nullopt);
  EXPECT_EQ(summary.num_failures,
            (std::map<std::string, std::size_t>{{"fell", 2}, {"time up", 1}}));
}

TEST(Evaluation, ComparesSeedBySeed) {
  const Evaluation pair = Pair();
  const BrainComparison comparison = Compare(pair.brains[0], pair.brains[1]);
  EXPECT_EQ(comparison.both, 2u);
  EXPECT_EQ(comparison.only_first, 0u);
  EXPECT_EQ(comparison.only_second, 2u);
  EXPECT_EQ(comparison.neither, 1u);
  EXPECT_DOUBLE_EQ(comparison.success_difference, -0.4);
  EXPECT_EQ(comparison.p_value, 0.5);  // two coins that fall alike
  // Of seeds 1 and 3 only, with which both succeeded: 4 - 3 and 6 - 3; 30 - 20 and 34 - 22.
  EXPECT_EQ(comparison.error_mm.value_or(Mean{}).value, 2);
  EXPECT_EQ(comparison.seconds.value_or(Mean{}).value, 11);
}

TEST(Evaluation, JsonHoldsSummariesRunsAndComparisons) {
  const Json json = ToJson(Pair());
  EXPECT_EQ(json["brains"][0]["summary"]["successes"], 2);
  EXPECT_EQ(json["brains"][1]["runs"][4]["cause"]["word"], "time up");
  EXPECT_EQ(json["brains"][0]["runs"][0]["recording"], nullptr);
  EXPECT_EQ(json["comparisons"][0]["second"], "new");
  EXPECT_EQ(json["comparisons"][0]["p_value"], 0.5);
}

TEST(Evaluation, TheTableLinesUp) {
  EXPECT_EQ(ToText(Pair()).substr(0, ToText(Pair()).find("old failed")),
            "      success                      95 %         error mm (95 %)   error deg (95 %)   "
            "s p50   s p95   retries   gain   right claims\n"
            "old       2/5   40.0 %   11.8 to 76.9 %   5.00 (-7.71 to 17.71)                  –   "
            " 32.0    33.8         2   0.55         2 of 5\n"
            "new       4/5   80.0 %   37.6 to 96.4 %     3.00 (3.00 to 3.00)                  –   "
            " 20.0    21.7         4   0.85         4 of 5\n");
}

/// Writes it and reads it.
EvaluatedRun Read(const std::string& text) {
  const auto path =
      std::filesystem::temp_directory_path() / ("smile_" + std::to_string(getpid()) + "_run.json");
  WriteFile(path, text);
  struct Remover {
    std::filesystem::path path;
    ~Remover() { std::filesystem::remove(path); }
  } remover{path};
  return ReadRun(path, 7);
}

TEST(Evaluation, ReadsResultsOfBothFormats) {
  const EvaluatedRun old = Read(
      R"({"rebuilt": false, "score": 0.5, "mean_error_mm": 30, "seconds": 12,
          "realtime_factor": 9, "brain": {"status": "failed", "message": "oh"}})");
  EXPECT_EQ(old.failure_reason, (task::FailureReason{.code = "brain_failed", .text = "oh"}));
  EXPECT_EQ(old.error_mm, 30);
  EXPECT_EQ(old.seed, 7u);
  const EvaluatedRun now = Read(
      R"({"format": 2, "success": false, "score": 0.5, "mean_error_mm": 30, "mean_error_degrees": 2,
          "seconds": 12, "realtime_factor": 9, "work": {"grasps": 5, "retries": 2},
          "brain": {"status": "exited", "message": ""},
          "cause": {"word": "fell", "text": "b1 fell to the floor"}})");
  EXPECT_EQ(now.failure_reason,
            (task::FailureReason{.code = "fell", .text = "b1 fell to the floor"}));
  EXPECT_EQ(now.retries, 2u);
  EXPECT_EQ(now.error_degrees, 2);
  EXPECT_TRUE(Read(R"({"rebuilt": true, "score": 1})").has_succeeded);
  EXPECT_TRUE(Read(R"({"format": 2, "success": true, "score": 1})").has_succeeded);
}

TEST(Evaluation, RefusesResultsThatAreNone) {
  for (const char* text :
       {"", "[]", "{}", R"({"rebuilt": true, "score": 2})",
        R"({"format": 2, "rebuilt": true, "score": 1})",
        R"({"format": 3, "success": true, "score": 1})", R"({"success": true, "score": 1})",
        R"({"rebuilt": true, "score": 1, "mean_error_mm": "near"})",
        R"({"rebuilt": true, "score": 1, "work": {"retries": -1}})",
        R"({"rebuilt": false, "score": 0, "cause": {"word": 3, "text": ""}})"}) {
    EXPECT_THROW(Read(text), InputError) << text;
  }
}

TEST(EvaluationPage, ShowsEachBrainAndLinksToEveryFailure) {
  const std::string page = PageOf(Pair());
  for (const char* text : {"Of 2 brains, new succeeded from most layouts: 4 of 5 starting layouts",
                           "40.0 % (11.8 to 76.9 %)", "href=\"./runs/2\"", "−40.0 points",
                           "p = 0.500", "smile imitate", "seed 5: time up", "for some reason"}) {
    EXPECT_NE(page.find(text), std::string::npos) << text;
  }
}

TEST(EvaluationPage, HostileNamesAndMessagesAreTextsOnly) {
  const std::string hostile = "</td><script src=\"http://x\">alert('1')</script>&amp;";
  Evaluation evaluation = Pair();
  evaluation.demo = evaluation.scene = evaluation.level = evaluation.again = hostile;
  evaluation.program = hostile;
  evaluation.options = {hostile};
  for (EvaluatedBrain& brain : evaluation.brains) {
    brain.name += hostile;
    brain.brain = hostile;
    for (EvaluatedRun& run : brain.runs) {
      if (run.failure_reason) *run.failure_reason = {hostile, hostile};
      run.recording = hostile;
    }
  }
  const std::string page = PageOf(evaluation);
  for (const char* danger : {"<script", "\"http", "'http", "alert('", "&amp;amp;&amp;"}) {
    EXPECT_EQ(page.find(danger), std::string::npos) << danger;
  }
  EXPECT_NE(page.find("&lt;script src=&quot;http://x&quot;&gt;"), std::string::npos);
}

}  // namespace
}  // namespace smile::report
