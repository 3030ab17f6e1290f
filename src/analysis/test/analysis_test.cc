#include "analysis/analysis.h"

#include <gtest/gtest.h>

#include <fstream>

#include "analysis/analysis_json.h"
#include "base/diagnostic.h"
#include "recorder/test/recording_fixture.h"

namespace smile::analysis {
namespace {

using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

bool Contains(const std::string& text, const char* part) {
  return text.find(part) != std::string::npos;
}

/// Red on green, with an errand in between that changes nothing, and blue beside them.
class AnalysisTest : public recorder::RecordingFixture {
 protected:
  static constexpr const char* kBlocks =
      R"xml(<tabletop xmlns="http://synapse.cs.umd.edu/tabletop-xml">
  <block id="red" color="red" location="(-3, -2, 0.5)"/>
  <block id="green" color="green" location="(0, -3, 0.5)"/>
  <block id="blue" color="blue" location="(3, -2, 0.5)"/>
</tabletop>)xml";

  /// Returns the script that carries an object.
  static std::string Carry(const std::string& id, const std::string& to) {
    return R"({"hand":"left","do":"grasp","object":")" + id + R"("}
{"hand":"left","do":"move_to","position":[)" +
           to + R"(,3]}
{"do":"wait","until":"arrived"}
{"hand":"left","do":"move_to","position":[)" +
           to + R"(,HEIGHT]}
{"do":"wait","until":"arrived"}
{"hand":"left","do":"release"}
{"do":"wait","seconds":0.5}
)";
  }
  static std::string At(const std::string& height, std::string script) {
    return script.replace(script.find("HEIGHT"), 6, height);
  }

  recording::Recording Recorded(const std::string& script) {
    // Each keeps its own directory.
    const auto directory = root_ / ("demo" + std::to_string(num_recorded_++));
    std::filesystem::rename(Record(script.c_str(), false, nullptr, kBlocks), directory);
    return recording::OpenRecording(directory);
  }
  recording::Recording TowerAndErrand() {
    return Recorded(At("0.51", Carry("green", "0,-1")) + At("0.51", Carry("blue", "3,-4")) +
                    At("1.51", Carry("red", "0,-1")) + At("0.51", Carry("blue", "3,-2")) +
                    R"({"do":"wait","seconds":1})");
  }

  static std::vector<bool> Necessary(const Analysis& analysis) {
    std::vector<bool> necessary;
    for (const SubtaskFinding& finding : analysis.subtasks)
      necessary.push_back(finding.harm.has_value());
    return necessary;
  }
  static Pairs Order(const Analysis& analysis) {
    Pairs order;
    for (const Precedence& one : analysis.precedences) order.emplace_back(one.before, one.after);
    return order;
  }

  int num_recorded_ = 0;
};

TEST_F(AnalysisTest, FindsTheSubtasksThatMatterAndTheirOrder) {
  const recording::Recording recording = TowerAndErrand();
  const Analysis analysis = Analyze(recording, {});
  ASSERT_EQ(analysis.subtasks.size(), 4u);
  EXPECT_EQ(analysis.subtasks[2].subtask.words, "left hand puts red on green");
  // Blue comes back to where it was: it need not have left, but if it did, it must come back.
  EXPECT_EQ(Necessary(analysis), (std::vector{true, false, true, true}));
  EXPECT_EQ(NumbersOf(analysis.sufficient), "1 and 3");
  EXPECT_EQ(Order(analysis), (Pairs{{0, 2}, {1, 3}}));
  EXPECT_TRUE(Contains(analysis.precedences.front().harm, "red"));
  EXPECT_EQ(analysis.Levels(), (std::vector<std::size_t>{0, 0, 1, 1}));
  const Json json = ToJson(analysis);
  EXPECT_EQ(json["subtasks"][2]["segments"], (Json{5, 6}));
  EXPECT_EQ(json["subtasks"][1]["without"], nullptr);
  EXPECT_EQ(json["subtasks"][1]["objects"], Json{"blue"});
  EXPECT_EQ(json["order"][0]["after"], 3);
}

TEST_F(AnalysisTest, WhatDoesNotCountNeedNoSubtask) {
  const recording::Recording recording =
      Recorded(At("0.51", Carry("blue", "3,-4")) + At("1.51", Carry("red", "0,-3")) +
               R"({"do":"wait","seconds":1})");
  EXPECT_EQ(Necessary(Analyze(recording, {})), (std::vector{true, true}));
  const Analysis analysis = Analyze(recording, {.ignored = {"blue"}});
  EXPECT_EQ(Necessary(analysis), (std::vector{false, true}));
  const Json goals = ToJson(analysis)["goals"];
  EXPECT_EQ(goals[0],
            (Json{{"id", "red"}, {"words", "red on green"}, {"kind", "place"}, {"counts", true}}));
  EXPECT_EQ(goals[2]["counts"], false);
  EXPECT_THROW((void)Analyze(recording, {.ignored = {"purple"}}), std::invalid_argument);
}

TEST_F(AnalysisTest, ContentIsThatOfTheCommands) {
  const recording::Recording one = TowerAndErrand(), again = TowerAndErrand();
  EXPECT_EQ(ContentOf(one), ContentOf(again));
  EXPECT_NE(ContentOf(one), ContentOf(Recorded(At("1.51", Carry("red", "0,-3")))));
}

TEST_F(AnalysisTest, DoesNotDependOnTheNumberOfThreads) {
  const recording::Recording recording = TowerAndErrand();
  const Analysis one = Analyze(recording, {}), three = Analyze(recording, {.num_threads = 3});
  EXPECT_EQ(ToText(ToJson(one)), ToText(ToJson(three)));
}

TEST_F(AnalysisTest, WhatTwoHandsDoAtTheSameTimeIsOneSubtask) {
  const recording::Recording recording = Recorded(
      R"({"hand":"left","do":"grasp","object":"green"}
{"hand":"right","do":"grasp","object":"red"}
{"hand":"left","do":"move_to","position":[0,-1,0.52]}
{"hand":"right","do":"move_to","position":[-3,-1,0.52]}
{"do":"wait","until":"arrived"}
{"hand":"left","do":"release"}
{"hand":"right","do":"release"}
{"do":"wait","seconds":1}
)" + At("0.51", Carry("blue", "3,-4")));
  const std::vector<Subtask> subtasks = SubtasksOf(recording);
  ASSERT_EQ(subtasks.size(), 2u);
  EXPECT_EQ(subtasks[0].actions.size(), 4u);
  EXPECT_EQ(subtasks[1].first, 5);
}

TEST_F(AnalysisTest, EndsWhenItIsInterrupted) {
  const recording::Recording recording = TowerAndErrand();
  const auto stop = [](std::size_t done, std::size_t at_most) {
    EXPECT_EQ(at_most, 24u);
    return done < 3;
  };
  EXPECT_THROW((void)Analyze(recording, {.num_threads = 2, .progress = stop}), std::runtime_error);
}

TEST_F(AnalysisTest, TriesOtherColorsAndPlaces) {
  const Analysis analysis = Analyze(TowerAndErrand(), {});
  ASSERT_EQ(analysis.properties.size(), 7u);
  const PropertyFinding& red = analysis.properties[0];
  EXPECT_EQ(red.object, "red");
  EXPECT_TRUE(Contains(red.tried, "instead of red")) << red.tried;
  EXPECT_EQ(analysis.properties[3].tried, "100 mm to the right");
  for (const PropertyFinding& one : analysis.properties) EXPECT_FALSE(one.harm) << *one.harm;
  const Json json = ToJson(analysis)["properties"];
  EXPECT_EQ(json[0]["property"], "color");
  EXPECT_EQ(json[6]["object"], nullptr);
}

TEST_F(AnalysisTest, ReportsPropertiesThatMatter) {
  // The tower stands at the left edge of the table, and the color of red matters.
  const recording::Recording recording = Recorded(At("0.51", Carry("green", "-9.4,-1")) +
                                                  R"({"hand":"left","do":"grasp","object":"red"}
{"hand":"left","do":"attend","properties":["color"]}
{"hand":"left","do":"release"}
)" + At("1.51", Carry("red", "-9.4,-1")) + R"({"do":"wait","seconds":1})");
  const Analysis analysis = Analyze(recording, {});
  for (const PropertyFinding& one : analysis.properties) {
    const bool is_color = one.property == PropertyFinding::Property::kColor;
    const bool matters = is_color ? one.object == "red" : one.tried == "100 mm to the left";
    EXPECT_EQ(one.harm.has_value(), matters) << one.object << one.tried;
  }
}

class KeptProgress : public AnalysisTest {
 protected:
  /// Analyzes until it is interrupted after some simulations.
  void Interrupt(const recording::Recording& recording, std::size_t after) {
    AnalysisOptions options = Options();
    options.progress = [&](std::size_t done, std::size_t) { return done < after; };
    EXPECT_THROW((void)Analyze(recording, options), std::runtime_error);
    EXPECT_TRUE(std::filesystem::exists(file()));
  }
  AnalysisOptions Options() {
    return {.num_threads = 2,
            .progress_file = file(),
            .build = "one",
            .say = [this](std::string_view message) { said_ += std::string(message) + "\n"; }};
  }
  /// Returns the analysis, and the number of the first finished simulation that it reported.
  std::pair<std::string, std::size_t> Continued(const recording::Recording& recording,
                                                AnalysisOptions options) {
    std::size_t first = 0;
    options.progress = [&](std::size_t done, std::size_t) {
      if (first == 0) first = done;
      return true;
    };
    const std::string text = ToText(ToJson(Analyze(recording, options)));
    EXPECT_FALSE(std::filesystem::exists(file()));
    return {text, first};
  }
  std::filesystem::path file() const { return root_ / "progress.jsonl"; }

  std::string said_;
};

TEST_F(KeptProgress, ContinuesWhereItWasInterrupted) {
  const recording::Recording recording = TowerAndErrand();
  const std::string whole = ToText(ToJson(Analyze(recording, {})));
  Interrupt(recording, 5);
  // The line that was being written is cut.
  std::ofstream(file(), std::ios::app) << R"({"trial":"order)";
  const auto [text, first] = Continued(recording, Options());
  EXPECT_EQ(text, whole);
  EXPECT_GE(first, 5u);
  EXPECT_TRUE(Contains(said_, "continues after")) << said_;
}

TEST_F(KeptProgress, OfAnotherProgramOrGoalIsNotUsed) {
  const recording::Recording recording = TowerAndErrand();
  Interrupt(recording, 5);
  AnalysisOptions options = Options();
  options.build = "two";
  EXPECT_LT(Continued(recording, options).second, 5u);
  EXPECT_TRUE(Contains(said_, "starts over")) << said_;
  Interrupt(recording, 5);
  options = Options();
  options.ignored = {"blue"};
  EXPECT_LT(Continued(recording, options).second, 5u);
}

TEST_F(KeptProgress, IsNotUsedIfDamaged) {
  const recording::Recording recording = TowerAndErrand();
  Interrupt(recording, 5);
  std::ofstream(file(), std::ios::app) << "{\"trial\": 7}\n";
  EXPECT_LT(Continued(recording, Options()).second, 5u);
  EXPECT_TRUE(Contains(said_, "is damaged: starts over")) << said_;
}

TEST_F(AnalysisTest, RefusesWhatDoesNotStand) {
  // Red is released in the air, and the recording ends at once.
  const recording::Recording recording = Recorded(
      R"({"hand":"left","do":"grasp","object":"red"}
{"hand":"left","do":"move_to","position":[0,-3,4]}
{"do":"wait","until":"arrived"}
{"hand":"left","do":"release"}
{"do":"wait","seconds":0.05})");
  try {
    (void)Analyze(recording, {});
    FAIL() << "was analyzed";
  } catch (const InputError& error) {
    EXPECT_TRUE(Contains(error.what(), "does not keep what it achieved for 2 s")) << error.what();
  }
}

}  // namespace
}  // namespace smile::analysis
