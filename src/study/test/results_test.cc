#include "study/results.h"

#include "report/study_page.h"
#include "study_fixture.h"

namespace smile::study {
namespace {

TrialRow RowOf(const std::string& participant, const std::string& condition, double seconds,
               bool is_success) {
  TrialRow row{.participant = participant, .task = "stack", .condition = condition};
  row.trial.wall_seconds = seconds;
  row.trial.reason = "done";
  row.measures.is_success = is_success;
  return row;
}

class Results : public StudyTest {};

// Differences 4, 6 and 8: mean 6, standard deviation 2, so d is 3; Student's t for two degrees of
// freedom is 4.302653, and the half width of the interval 4.302653 * 2 / sqrt(3) = 4.968274.
TEST_F(Results, AreThoseOfAComputationByHand) {
  StudyRows rows;
  const double none[] = {10, 20, 30}, ghost[] = {14, 26, 38};
  for (int k = 0; k < 3; ++k) {
    const std::string id = ParticipantId(k + 1);
    rows.trials.push_back(RowOf(id, "none", none[k], k > 0));
    rows.trials.push_back(RowOf(id, "ghost", ghost[k], true));
  }
  // Two trials of a participant in one condition count as their mean.
  rows.trials[0].trial.wall_seconds = 8;
  rows.trials.insert(rows.trials.begin(), RowOf("P01", "none", 12, false));
  const report::StudyResults results = ResultsOf(ReadDefinition(file()), rows);
  EXPECT_EQ(results.num_participants, 3u);
  EXPECT_EQ(results.conditions[0].trials, 4u);
  EXPECT_EQ(results.conditions[0].successes, 2u);
  const report::StudyMeasure& time = results.measures[0];
  EXPECT_EQ(time.numbers[0], (std::vector<std::optional<double>>{10, 20, 30}));
  const auto effect = report::EffectOf(time.numbers[0], time.numbers[1]);
  ASSERT_TRUE(effect);
  EXPECT_DOUBLE_EQ(effect->difference.value, 6);
  EXPECT_NEAR(effect->difference.interval->low, 6 - 4.968274, 1e-5);
  EXPECT_NEAR(effect->difference.interval->high, 6 + 4.968274, 1e-5);
  EXPECT_DOUBLE_EQ(*effect->cohens_dz, 3);
  // There are no trials of the third condition.
  EXPECT_FALSE(report::EffectOf(time.numbers[0], time.numbers[2]));
  const std::string page = report::StudyPage(results);
  EXPECT_NE(page.find("+6.0 (+1.0 to +11.0)"), std::string::npos) << page;
  EXPECT_NE(page.find("2 of 4"), std::string::npos);
  EXPECT_EQ(page.find("http://"), page.find("http://www.w3.org"));
}

TEST_F(Results, AreTablesThatRAndPandasRead) {
  std::vector<TrialRow> rows{RowOf("P01", "none", 1.5, true)};
  rows[0].trial.folder = "trials/task-stack-none-1";
  rows[0].trial.recording = "pair";
  EXPECT_EQ(TrialsCsv(rows),
            "participant,task,condition,position,interrupted,reason,success,seconds,wall_seconds,"
            "undos,redos,grasps,falls,path_meters,camera_moves,focus_losses,recording\r\n"
            "P01,stack,none,1,0,done,1,0,1.5,0,0,0,0,0,0,0,P01/trials/task-stack-none-1/pair\r\n");
  EXPECT_EQ(AnswersCsv({{"P01", "", "remarks", "remarks", "One, \"two\"\nthree"}}),
            "participant,condition,questionnaire,question,answer\r\n"
            "P01,,remarks,remarks,\"One, \"\"two\"\"\nthree\"\r\n");
}

TEST_F(Results, AreWrittenWithACodebook) {
  const StudyData data = Data(2);
  for (const Participant& participant : data.participants()) Complete(data, participant, 12);
  const auto report = WriteReport(data);
  const std::string answers = ReadFile(report / "answers.csv", 1 << 20);
  EXPECT_NE(answers.find("P01,none,nasa-tlx,score,40\r\n"), std::string::npos) << answers;
  EXPECT_NE(answers.find("P02,,sus,score,50\r\n"), std::string::npos);
  const std::string codebook = ReadFile(report / "codebook.md", 1 << 20);
  EXPECT_NE(codebook.find("- `path_meters`: "), std::string::npos);
  EXPECT_NE(codebook.find("- `sus1`: "), std::string::npos);
}

TEST_F(Results, CountMovesOfTheCameraAfterRests) {
  Write("input.jsonl",
        "{\"ms\":0,\"kind\":\"camera\"}\n{\"ms\":100,\"kind\":\"camera\"}\n"
        "{\"ms\":700,\"kind\":\"camera\"}\n{\"ms\":800,\"kind\":\"blur\"}\n{\"ms\":9");
  EXPECT_EQ(InputMeasuresOf(folder() / "input.jsonl"),
            (InputMeasures{.camera_moves = 2, .focus_losses = 1}));
  EXPECT_EQ(InputMeasuresOf(folder() / "missing.jsonl"), InputMeasures{});
}

}  // namespace
}  // namespace smile::study
