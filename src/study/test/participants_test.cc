#include "study/participants.h"

#include <fstream>
#include <set>

#include "study/check.h"
#include "study/deletion.h"
#include "study/progress.h"
#include "study_fixture.h"

namespace smile::study {
namespace {

class Participants : public StudyTest {};

TEST_F(Participants, HavePseudonymsAndSecrets) {
  const StudyData data = Data(3);
  std::set<std::string> tokens;
  for (const Participant& participant : data.participants()) tokens.insert(participant.token);
  EXPECT_EQ(tokens.size(), 3u);
  for (const std::string& token : tokens) EXPECT_EQ(token.size(), 32u);
  EXPECT_EQ(data.participants()[2].id, "P03");
  EXPECT_EQ(data.FindByToken(data.participants()[1].token)->id, "P02");
  EXPECT_EQ(data.FindByToken("0"), nullptr);
  // They stay the same.
  EXPECT_EQ(StudyData(data_folder()).participants()[0].token, data.participants()[0].token);
}

TEST_F(Participants, BelongToOneUnchangedStudy) {
  Data(1);
  Json changed = Study();
  changed["break_seconds"] = 2;
  WriteStudy(changed);
  EXPECT_THROW(StudyData{data_folder()}, InputError);
  EXPECT_THROW(Data(0), InputError);
}

TEST_F(Participants, ContinueAfterTheServerWasKilled) {
  const StudyData data = Data(1);
  const Participant& participant = data.participants()[0];
  {
    EventLog log(participant.events_file());
    log.Add("consent", {{"agreed", true}, {"sha256", "x"}});
    log.Add("done", {{"step", "consent"}});
  }
  // Killed while a line was being written.
  std::ofstream(participant.events_file(), std::ios::app) << R"({"at":"2026)";
  {
    EventLog log(participant.events_file());
    EXPECT_EQ(log.events().size(), 2u);
    log.Add("done", {{"step", "instruction-1"}});
  }
  const std::vector<Json> events = ReadEvents(participant.events_file());
  EXPECT_EQ(events.size(), 3u);
  const std::vector<Step> steps = StepsOf(data.study(), 1);
  EXPECT_EQ(ProgressOf(events, "").Next(steps).name, "practice");
}

TEST_F(Participants, HaveLogsWhoseFaultsHaveALine) {
  const StudyData data = Data(1);
  const auto file = data.participants()[0].events_file();
  WriteFile(file, "{\"at\":\"t\",\"event\":\"begin\",\"step\":\"a\"}\nno event\n");
  try {
    ReadEvents(file);
    FAIL() << "it was read";
  } catch (const InputError& error) {
    EXPECT_EQ(error.diagnostics().at(0).line, 2);
  }
  WriteFile(file, "{\"at\":\"t\",\"event\":\"trial_end\",\"step\":\"a\",\"reason\":\"done\"}\n");
  EXPECT_THROW(ProgressOf(ReadEvents(file), file), InputError);
}

TEST_F(Participants, AreCheckedForBalanceAndCompleteness) {
  const StudyData data = Data(6);
  for (int k = 0; k < 5; ++k) Complete(data, data.participants()[k], 10);
  CheckResult result = Check(data);
  EXPECT_EQ(result.notes[0], "6 links, 5 begun, 5 complete, 0 declined, 0 withdrawn");
  const auto found = [&](const std::string& text) {
    return std::ranges::any_of(result.findings, [&](const std::string& finding) {
      return finding.find(text) != std::string::npos;
    });
  };
  EXPECT_TRUE(found("order: each condition is between 1 and 2 times at a position"));
  EXPECT_TRUE(found("P01: task-stack-none: its recording is missing"));
  Complete(data, data.participants()[5], 10);
  result = Check(data);
  EXPECT_FALSE(found("order"));
  // One who stopped.
  EventLog(data.participants()[0].events_file())
      .Add("consent", {{"agreed", true}, {"sha256", "?"}});
  result = Check(data);
  EXPECT_TRUE(found("P01: consent: found the hash ?"));
}

TEST_F(Participants, WithdrawWithoutATrace) {
  const StudyData data = Data(3);
  const std::string token = data.participants()[1].token;
  MakeDirectories(data.folder() / kReportFolder);
  WriteFile(data.folder() / kReportFolder / "trials.csv", "P02,1\r\n");
  const DeletionProof proof = DeleteParticipant(data, "P02");
  EXPECT_EQ(proof.num_deleted, 3u);
  EXPECT_EQ(proof.num_searched, 5u);  // two files of two others, and study.json
  EXPECT_TRUE(proof.remains.empty());
  const StudyData left(data.folder());
  EXPECT_EQ(left.FindById("P02"), nullptr);
  EXPECT_EQ(left.num_issued(), 3);
  EXPECT_THROW(DeleteParticipant(left, "P02"), InputError);
  // The search finds what remains elsewhere, and only that.
  WriteFile(data.folder() / "P01" / "notes.txt", "xP03 P031 P03");
  WriteFile(data.folder() / "copy.bin", left.FindById("P03")->token);
  EXPECT_EQ(DeleteParticipant(left, "P03").remains.size(), 2u);
}

TEST_F(Participants, AreNotDeletedWhileAServerWrites) {
  const StudyData data = Data(1);
  const EventLog log(data.participants()[0].events_file());
  EXPECT_THROW(DeleteParticipant(data, "P01"), std::runtime_error);
  EXPECT_NE(data.FindById("P01"), nullptr);
}

}  // namespace
}  // namespace smile::study
