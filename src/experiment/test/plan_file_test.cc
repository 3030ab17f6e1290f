#include "experiment/plan_file.h"

#include "analysis/analysis.h"
#include "analysis/analysis_json.h"
#include "base/diagnostic.h"
#include "experiment_fixture.h"
#include "recording/recording.h"

namespace smile::experiment {
namespace {

class PlanFile : public ExperimentTest {
 protected:
  PlanFile()
      : demonstration_(recording::OpenRecording(RecordStacking())),
        json_(ToJson(analysis::Analyze(demonstration_, {}))) {}

  brain::TaskPlan ReadJson(const Json& json) const {
    return ReadPlan(Write("analysis.json", ToText(json)), demonstration_);
  }
  /// Returns why a changed file is refused.
  std::string FaultOf(const Json& patch) const {
    Json json = json_;
    json.merge_patch(patch);
    try {
      (void)ReadJson(json);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no fault";
  }

  recording::Recording demonstration_;
  Json json_;
};

TEST_F(PlanFile, IsWhatTheAnalysisFound) {
  const brain::TaskPlan plan = ReadJson(json_);
  ASSERT_EQ(plan.subtasks.size(), 1u);
  EXPECT_EQ(plan.subtasks[0], (brain::PlanSubtask{"right hand puts a on b", {"a"}, 1, 2, true}));
  EXPECT_TRUE(plan.order.empty());
  EXPECT_EQ(plan.sufficient, std::vector<std::size_t>{0});
  EXPECT_EQ(plan.goals, (std::vector<std::string>{"a", "b"}));
}

TEST_F(PlanFile, LeavesOutGoalsThatDoNotCount) {
  const analysis::Analysis analysis = analysis::Analyze(demonstration_, {.ignored = {"b"}});
  EXPECT_EQ(ReadJson(ToJson(analysis)).goals, std::vector<std::string>{"a"});
}

TEST_F(PlanFile, OfAnotherDemonstrationOrFormatIsRefused) {
  EXPECT_NE(FaultOf({{"demonstration", "0123456789abcdef"}}).find("is of another demonstration"),
            std::string::npos);
  EXPECT_NE(FaultOf({{"format", 1}}).find("format"), std::string::npos);
  EXPECT_NE(FaultOf({{"format", 3}}).find("format"), std::string::npos);
}

TEST_F(PlanFile, DamagedContentIsRefusedWithItsPlace) {
  EXPECT_NE(FaultOf({{"subtasks", Json::array()}}).find("subtasks"), std::string::npos);
  EXPECT_NE(FaultOf({{"sufficient", {2}}}).find("found 2, expected a whole number from 1 to 1"),
            std::string::npos);
  EXPECT_NE(FaultOf({{"sufficient", {1, 1}}}).find("sufficient"), std::string::npos);
  EXPECT_NE(FaultOf({{"order", {{{"before", 1}, {"after", 1}}}}}).find("order/0"),
            std::string::npos);
  EXPECT_NE(FaultOf({{"goals", nullptr}}).find("goals"), std::string::npos);
  Json json = json_;
  json["subtasks"].push_back(json["subtasks"][0]);
  EXPECT_THROW((void)ReadJson(json), InputError);
  EXPECT_THROW((void)ReadPlan(Write("analysis.json", "{"), demonstration_), InputError);
  EXPECT_THROW((void)ReadPlan(root_ / "missing.json", demonstration_), InputError);
}

}  // namespace
}  // namespace smile::experiment
