#include "study/visit.h"

#include <thread>

#include "study/participant_requests.h"
#include "study_fixture.h"

namespace smile::study {
namespace {

/// A participant, with a program in place of sessions that only prints a link.
class VisitTest : public StudyTest {
 protected:
  VisitTest() : data_(Data(1)) {
    SetProgram("trap 'exit 0' INT; echo http://127.0.0.1:1234/; while :; do sleep 0.02; done");
    services_ = {.send = [this](PageId page, const Json& message) { sent_[page] = message; },
                 .set_port = [this](const std::string&, std::optional<int> port) { port_ = port; },
                 .has_room = [this] { return has_room_; },
                 .program = folder() / "program",
                 // Enough for the tables that the address sanitizer reserves.
                 .memory_bytes = std::uint64_t{1} << 46,
                 .disk_bytes = 1 << 20};
    visit_.emplace(&data_.study(), data_.participants()[0], &services_);
    visit_->Enter(1);
  }

  void SetProgram(const std::string& line) const {
    Write("program", "#!/bin/bash\n" + line + "\n");
    std::filesystem::permissions(folder() / "program", std::filesystem::perms::owner_all);
  }
  /// Returns the reason for which a message is refused; empty if it is not.
  std::string Refusal(const Json& message) {
    try {
      visit_->Receive(message);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  }
  std::string step() { return sent_[1].value("step", ""); }
  void GoTo(const std::string& name) {
    EventLog log(data_.participants()[0].events_file());
    for (const Step& step : StepsOf(data_.study(), 1)) {
      if (step.name == name) break;
      log.Add("done", {{"step", step.name}});
    }
  }
  /// Begins again as after a restart of the server, with the steps before this one done.
  void RestartAt(const std::string& name) {
    visit_.reset();
    GoTo(name);
    visit_.emplace(&data_.study(), data_.participants()[0], &services_);
    visit_->Enter(1);
    ASSERT_EQ(step(), name);
  }
  template <typename Condition>
  bool Await(const Condition& holds) {
    for (int k = 0; k < 2000 && !holds(); ++k) {
      visit_->Update();
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return holds();
  }
  const Trial& last_trial() const { return visit_->progress().trials.back(); }

  StudyData data_;
  VisitServices services_;
  std::map<PageId, Json> sent_;
  std::optional<int> port_;
  bool has_room_ = true;
  std::optional<Visit> visit_;
};

TEST_F(VisitTest, BeginsWithTheConsent) {
  EXPECT_EQ(step(), "consent");
  EXPECT_EQ(Refusal({{"do", "done"}, {"step", "consent"}}),
            "message: consent is not done this way");
  visit_->Receive({{"do", "consent"}, {"step", "consent"}, {"agreed", false}});
  EXPECT_EQ(sent_[1]["content"]["declined"], true);
  visit_->Receive({{"do", "consent"}, {"step", "consent"}, {"agreed", true}});
  EXPECT_EQ(step(), "instruction-1");
  EXPECT_EQ(visit_->progress().consent_sha256, web_server::Sha256("You may stop at any time.\n"));
  EXPECT_FALSE(visit_->progress().is_declined);
}

TEST_F(VisitTest, RefusesWhatIsNotOfItsStep) {
  EXPECT_EQ(Refusal({{"do", "answers"}, {"step", "questions-sus"}}),
            "message: found step \"questions-sus\", expected consent");
  EXPECT_EQ(Refusal({{"do", "leap"}}), "message: there is no \"leap\"");
  EXPECT_EQ(Refusal({{"step", 1}}), "message: expected the member \"do\", a text");
  RestartAt("break-1");
  EXPECT_EQ(Refusal({{"do", "done"}, {"step", "thanks"}}),
            "message: found step \"thanks\", expected break-1");
  RestartAt("questions-sus");
  EXPECT_EQ(Refusal({{"do", "answers"}, {"step", "questions-sus"}, {"answers", {{"sus1", 9}}}}),
            "answer \"sus1\": found \"9\", expected a number from 0 to 4 in steps of 1");
  EXPECT_EQ(step(), "questions-sus");
}

TEST_F(VisitTest, HasOnePage) {
  visit_->Enter(2);
  EXPECT_EQ(sent_[1], (Json{{"t", "replaced"}}));
  EXPECT_EQ(sent_[2]["step"], "consent");
}

TEST_F(VisitTest, RepeatsATrialThatLeftNoRecording) {
  RestartAt("practice");
  visit_->Receive({{"do", "trial_begin"}, {"step", "practice"}});
  ASSERT_TRUE(Await([&] { return port_ == 1234; }));
  EXPECT_EQ(sent_[1]["t"], "session");
  EXPECT_EQ(Refusal({{"do", "trial_end"}, {"step", "practice"}, {"reason", "limit"}}),
            "message: found reason \"limit\", expected done, or limit at the limit of time");
  visit_->Receive({{"do", "log"}, {"lines", {{{"ms", 5}, {"kind", "move"}}}}});
  EXPECT_NE(Refusal({{"do", "log"}, {"lines", {{{"ms", 5}}}}}), "");
  visit_->Receive({{"do", "trial_end"}, {"step", "practice"}, {"reason", "done"}});
  ASSERT_TRUE(Await([&] { return last_trial().has_ended; }));
  EXPECT_EQ(port_, std::nullopt);
  EXPECT_EQ(last_trial().reason, "failed: no recording");
  EXPECT_EQ(sent_[1]["content"]["interrupted"], true);
  const auto log = data_.participants()[0].folder / last_trial().folder / "input.jsonl";
  EXPECT_EQ(ReadFile(log, 1000), "{\"ms\":5,\"kind\":\"move\"}\n");
}

TEST_F(VisitTest, WaitsForRoomAndSurvivesSessionsThatFail) {
  RestartAt("practice");
  has_room_ = false;
  visit_->Receive({{"do", "trial_begin"}, {"step", "practice"}});
  visit_->Update();
  EXPECT_FALSE(visit_->is_in_session());
  SetProgram("echo no scene; exit 1");
  has_room_ = true;
  ASSERT_TRUE(Await([&] { return last_trial().has_ended; }));
  EXPECT_EQ(last_trial().reason.find("failed: the session ended: it ended with exit code 1"), 0u)
      << last_trial().reason;
  EXPECT_EQ(step(), "practice");
}

TEST_F(VisitTest, EndsASessionThatFillsTheDisk) {
  SetProgram(
      "trap 'exit 0' INT; echo http://127.0.0.1:1234/; "
      "for k in 1 2 3; do head -c 500000 /dev/zero >$k.bin; done; "
      "while :; do sleep 0.02; done");
  RestartAt("practice");
  visit_->Receive({{"do", "trial_begin"}, {"step", "practice"}});
  ASSERT_TRUE(Await([&] { return last_trial().has_ended; }));
  EXPECT_EQ(last_trial().reason, "disk");
}

TEST_F(VisitTest, InterruptsATrialWhenTheServerIsKilled) {
  RestartAt("practice");
  visit_->Receive({{"do", "trial_begin"}, {"step", "practice"}});
  visit_.reset();
  visit_.emplace(&data_.study(), data_.participants()[0], &services_);
  EXPECT_EQ(last_trial().reason, "server");
  visit_->Enter(1);
  EXPECT_EQ(step(), "practice");
}

TEST_F(VisitTest, EndsWithACompletionCode) {
  RestartAt("thanks");
  EXPECT_EQ(visit_->progress().completion_code.size(), 8u);
  EXPECT_EQ(sent_[1]["content"]["code"], visit_->progress().completion_code);
  EXPECT_NE(data_.participants()[0].token.find(visit_->progress().completion_code), 0u);
}

TEST(ParticipantRequests, OnlyDemonstrate) {
  const auto is_refused = [](const std::string& what, const Json& fields) {
    return RefuseToParticipant({.what = what, .fields = fields}).has_value();
  };
  const auto command = [](const char* what) { return Json{{"command", {{"do", what}}}}; };
  EXPECT_FALSE(is_refused("command", command("grasp")));
  EXPECT_FALSE(is_refused("command", Json::object()));
  EXPECT_FALSE(is_refused("snap", Json::object()));
  for (const char* what : {"load", "destroy", "add", "clear", "joint_angles", "spawn"}) {
    EXPECT_TRUE(is_refused("command", command(what))) << what;
  }
  for (const char* what : {"load", "start_brain", "pause", "speed", "generate", "edit", "bin"}) {
    EXPECT_TRUE(is_refused(what, Json::object())) << what;
  }
}

}  // namespace
}  // namespace smile::study
