#include "studio/library_requests.h"

#include <algorithm>
#include <atomic>
#include <future>
#include <map>
#include <thread>

#include "library_requests_fixture.h"
#include "replay/replay.h"
#include "texts/message_json.h"

namespace smile::studio {
namespace {

using LibraryRequestsTest = LibraryRequestsFixture;

TEST_F(LibraryRequestsTest, NotifiesAllClientsOfChangedRecordings) {
  Record(R"({"do":"wait","seconds":0.2})");
  const auto num_updates = [this] {
    int count = 0;
    for (int i = 0; i < 120; ++i) {
      for (const page::DeferredMessage& deferred : TakeDeferred(table_)) {
        if (deferred.client == 0 && deferred.message["t"] == "library") ++count;
      }
    }
    return count;
  };
  EXPECT_EQ(num_updates(), 1);
  EXPECT_EQ(num_updates(), 0) << "nothing changed";
  std::filesystem::remove_all(root_ / "demo");
  EXPECT_EQ(num_updates(), 1);
  Record(R"({"do":"wait","seconds":0.2})");
  EXPECT_EQ(num_updates(), 1);
  EXPECT_EQ(Ask("bin", {{"recording", "demo"}})["ok"], true);
  EXPECT_EQ(num_updates(), 1);
  std::filesystem::remove_all(root_ / ".bin/demo~1");
  EXPECT_EQ(num_updates(), 1);
  // A recording also goes when its folder stays.
  Record(R"({"do":"wait","seconds":0.2})");
  EXPECT_EQ(num_updates(), 1);
  std::filesystem::rename(root_ / "demo/demo.json", root_ / "demo/kept.json");
  EXPECT_EQ(num_updates(), 1);
  std::filesystem::rename(root_ / "demo/kept.json", root_ / "demo/demo.json");
  EXPECT_EQ(num_updates(), 1);
  EXPECT_EQ(Ask("bin", {{"recording", "demo"}})["ok"], true);
  EXPECT_EQ(num_updates(), 1);
  for (const auto& entry : std::filesystem::directory_iterator(root_ / ".bin/demo~1")) {
    std::filesystem::remove_all(entry);
  }
  EXPECT_EQ(num_updates(), 1);
  EXPECT_EQ(num_updates(), 0);
}

TEST_F(LibraryRequestsTest, TidyUp) {
  Record(R"({"do":"wait","seconds":0.2})");
  EXPECT_EQ(Ask("rename", {{"recording", "demo"}, {"title", "Um"}, {"notes", nullptr}})["ok"],
            true);
  EXPECT_EQ(Ask("library", {}, /*is_controller=*/false)["recordings"][0]["title"], "Um");
  EXPECT_EQ(Ask("rename", {{"recording", "demo"}, {"title", "  "}, {"notes", nullptr}})["error"],
            recording::BlankTitle());
  EXPECT_EQ(library_.List()[0]["title"], "Um");
  EXPECT_EQ(Ask("bin", {{"recording", "demo"}})["recording"], "demo~1");
  EXPECT_EQ(Ask("unbin", {{"recording", "demo~1"}})["recording"], "demo");
  EXPECT_EQ(Ask("rename", {{"recording", 7}})["error"],
            R"("recording" is number, expected a string)");
  EXPECT_EQ(texts::MessageOf(Ask("bin", {{"recording", "../demo"}})["error"]),
            R"(there is no recording "../demo")");
  EXPECT_EQ(Ask("open", Json::object())["error"], R"("recording" is missing)");
}

TEST_F(LibraryRequestsTest, OpensATimelineForEachClient) {
  Record();
  const Json answer = Ask("open", {{"recording", "demo"}}, /*is_controller=*/false);
  EXPECT_EQ(answer["timeline"], library_.TimelineOf("demo"));
}

TEST_F(LibraryRequestsTest, TryEditReportsTheEffectAndWritesNothing) {
  Record();
  const Json edits = {{{"do", "drop"}, {"first", 1}}};
  const Json answer = Ask("try_edit", {{"recording", "demo"}, {"edits", edits}});
  ASSERT_EQ(answer["ok"], true) << answer;
  EXPECT_EQ(answer["report"]["displaced"][0]["id"], "a");
  EXPECT_EQ(texts::MessageOf(answer["report"]["left_out"][0]["reason"]),
            "the left hand holds nothing");
  EXPECT_EQ(library_.List().size(), 1u);
  // Everyone sees how far it is, and that it ends.
  const auto last = std::ranges::find_if(
      deferred_.rbegin(), deferred_.rend(),
      [](const page::DeferredMessage& deferred) { return deferred.message["t"] == "progress"; });
  ASSERT_NE(last, deferred_.rend());
  EXPECT_EQ(last->client, 0);
  EXPECT_EQ(last->message["what"], "try_edit");
  EXPECT_EQ(last->message["done"], last->message["total"]);
}

TEST_F(LibraryRequestsTest, AnalyzeSaysWhatMatteredAndDrawsIt) {
  Record();
  const Json answer = Ask("analyze", {{"recording", "demo"}});
  ASSERT_EQ(answer["ok"], true) << answer;
  EXPECT_EQ(answer["analysis"]["subtasks"].size(), 1u);
  EXPECT_EQ(answer["analysis"]["subtasks"][0]["necessary"], true);
  // As a message, which the page renders in its language.
  EXPECT_EQ(answer["analysis"]["subtasks"][0]["without"]["say"], "failures.neverTaken");
  EXPECT_EQ(answer["analysis"]["subtasks"][0]["parts"][0]["do"], "put");
  EXPECT_NE(answer["graph"].get<std::string>().find("class=\"subtask\""), std::string::npos);
  EXPECT_EQ(Ask("analyze", {{"recording", "other"}})["ok"], false);
}

TEST_F(LibraryRequestsTest, AnEditIsANewRecordingThatReplays) {
  Record();
  const Json edits = {{{"do", "max_pause"}, {"seconds", 0.25}}, {{"do", "speed"}, {"factor", 2}}};
  const auto edit = [&] {
    return Ask("edit", {{"recording", "demo"}, {"edits", edits}, {"name", "brisk: <1>"}});
  };
  EXPECT_EQ(edit()["recording"], "brisk_ _1_");
  EXPECT_EQ(edit()["recording"], "brisk_ _1_-2") << "nothing is overwritten";
  const auto made = recording::OpenRecording(root_ / "brisk_ _1_");
  EXPECT_EQ(made.info.title, "brisk: <1>");
  EXPECT_EQ(made.info.origin, recording::Origin::kEdited);
  const auto replay = replay::Replay(made);
  EXPECT_FALSE(replay.first_difference);
  EXPECT_LT(replay.ticks(), replay::Replay(recording::OpenRecording(root_ / "demo")).ticks());
}

TEST_F(LibraryRequestsTest, SavesWhatItsPreviewSimulated) {
  Record();
  const Json edits = {{{"do", "drop"}, {"first", 1}}};
  const auto save = [&] {
    deferred_.clear();
    return Ask("edit", {{"recording", "demo"}, {"edits", edits}, {"name", "short"}});
  };
  // Simulations report progress; copies are made at once.
  const auto is_simulated = [this] {
    return std::ranges::any_of(deferred_, [](const page::DeferredMessage& deferred) {
      return deferred.message["t"] == "progress" && deferred.message["what"] == "edit";
    });
  };
  const Json simulated = save();
  EXPECT_TRUE(is_simulated());
  const Json preview = Ask("try_edit", {{"recording", "demo"}, {"edits", edits}});
  const Json saved = save();
  EXPECT_FALSE(is_simulated());
  EXPECT_EQ(saved["report"], preview["report"]);
  EXPECT_EQ(saved["report"], simulated["report"]);
  EXPECT_EQ(FilesThatDiffer("short", "short-2"), std::vector<std::string>());
}

TEST_F(LibraryRequestsTest, CanceledPreviewsAndSavesLeaveNoFiles) {
  Record();
  for (const char* what : {"try_edit", "edit"}) {
    const page::Request request{
        .client = 3,
        .seq = 1000,
        .what = what,
        // Takes long.
        .fields = {{"recording", "demo"},
                   {"edits", {{{"do", "retime"}, {"segment", 0}, {"seconds", 80'000}}}},
                   {"name", "long"}}};
    ASSERT_TRUE(page::IsLater(Answer(table_, request, /*is_controller=*/true)));
    const auto has_begun = [&](const page::DeferredMessage& deferred) {
      return deferred.message["t"] == "progress" && deferred.message["what"] == what;
    };
    while (std::ranges::none_of(deferred_, has_begun)) {
      for (page::DeferredMessage& deferred : TakeDeferred(table_))
        deferred_.push_back(std::move(deferred));
    }
    EXPECT_EQ(Ask("cancel", {{"request", 1001}})["ok"], true) << "nothing is canceled";
    EXPECT_EQ(Ask("cancel", {{"request", 1000}}, /*is_controller=*/false)["ok"], true);
    EXPECT_EQ(texts::MessageOf(AnswerTo(1000)["error"]), "canceled");
    deferred_.clear();
  }
  EXPECT_EQ(library_.List().size(), 1u);
  EXPECT_EQ(Ask("cancel", {{"request", -1}})["error"],
            "\"request\" is -1, expected a number from 0 to 4294967295");
}

TEST_F(LibraryRequestsTest, NamesInvalidEdits) {
  Record(R"({"do":"wait","seconds":0.2})");
  const auto error_of = [&](const Json& edits) {
    return Ask("try_edit", {{"recording", "demo"}, {"edits", edits}})["error"];
  };
  const Json sound = {{"do", "drop"}, {"first", 0}};
  EXPECT_EQ(error_of({sound, {{"do", "dorp"}}}),
            "edits[1]: there is no edit \"dorp\", expected drop, move, trim, max_pause, retime, "
            "speed, shift or stretch; did you mean \"drop\"?");
  EXPECT_EQ(error_of({{{"do", "drop"}, {"first", 0.5}}}),
            "edits[0]: \"first\" is 0.5, expected a whole number");
  EXPECT_EQ(error_of({{{"do", "trim"}, {"segment", 1}, {"from", "a"}}}),
            "edits[0]: \"from\" is string, expected a number");
  EXPECT_EQ(error_of({{{"do", "speed"}, {"factor", 2}, {"last", 1}}}),
            "edits[0]: there is no field \"last\", expected do or factor");
  EXPECT_EQ(error_of({sound, {{"do", "drop"}, {"first", 4}}}),
            "edits[1]: segment is 4, expected 0 to 0");
  EXPECT_EQ(error_of(7), "\"edits\" is not a list of at most 1000");
}

TEST(BackgroundJobs, CancelsReplacedJobs) {
  BackgroundJobs jobs;
  std::promise<void> has_begun;
  const auto endless = [&has_begun](const recording::Progress& progress) {
    has_begun.set_value();
    while (progress(1, 2)) std::this_thread::yield();
    return Json{{"never", "sent"}};
  };
  const auto begin = [&](std::uint32_t seq, const BackgroundJobs::Work& work) {
    jobs.Begin({.request = {.client = 1, .seq = seq, .what = "try_edit"},
                .work = work,
                .replaces_older = true});
  };
  begin(1, endless);
  has_begun.get_future().wait();
  begin(2, [](const recording::Progress&) { return Json{{"is", "newest"}}; });
  std::map<int, Json> answers;
  while (answers.size() < 2) {
    for (const page::DeferredMessage& deferred : jobs.TakeDeferred()) {
      if (deferred.client == 1) answers[deferred.message["seq"]] = deferred.message;
    }
  }
  EXPECT_EQ(texts::MessageOf(answers[1]["error"]), "canceled by a newer request");
  EXPECT_EQ(answers[2]["is"], "newest");
}

TEST(BackgroundJobs, CancelsUnfinishedCancelableJobs) {
  BackgroundJobs jobs;
  std::promise<void> is_canceled;
  const auto begin = [&](std::uint32_t seq, bool can_be_canceled,
                         const BackgroundJobs::Work& work) {
    jobs.Begin({.request = {.client = 1, .seq = seq, .what = "edit"},
                .work = work,
                .can_be_canceled = can_be_canceled});
  };
  const auto do_nothing = [](const recording::Progress&) { return Json{{"is", "done"}}; };
  // The first two keep both threads until all is canceled.
  const std::shared_future<void> all(is_canceled.get_future());
  std::atomic<int> num_begun = 0;
  begin(1, true, [&](const recording::Progress&) {
    ++num_begun;
    all.wait();
    return Json{{"is", "done"}};
  });
  begin(2, true, [&](const recording::Progress& progress) -> Json {
    ++num_begun;
    all.wait();
    if (!progress(1, 2)) throw std::runtime_error("interrupted");
    return Json::object();
  });
  while (num_begun < 2) std::this_thread::yield();
  begin(3, true, do_nothing);
  begin(4, false, do_nothing);
  for (std::uint32_t seq = 1; seq <= 5; ++seq) jobs.Cancel(1, seq);
  is_canceled.set_value();
  std::map<int, Json> answers;
  while (answers.size() < 4) {
    for (const page::DeferredMessage& deferred : jobs.TakeDeferred()) {
      if (deferred.client == 1) answers[deferred.message["seq"]] = deferred.message;
    }
  }
  EXPECT_EQ(answers[1]["is"], "done") << "it could no longer be stopped";
  EXPECT_EQ(texts::MessageOf(answers[2]["error"]), "canceled");
  EXPECT_EQ(texts::MessageOf(answers[3]["error"]), "canceled") << "before it began";
  EXPECT_EQ(answers[4]["is"], "done");
}

TEST(BackgroundJobs, LimitsTheJobsOfAClient) {
  BackgroundJobs jobs;
  const auto begin = [&](page::ClientId client) {
    jobs.Begin({.request = {.client = client, .what = "library"},
                .work = [](const recording::Progress& progress) {
                  while (progress(1, 2)) std::this_thread::yield();
                  return Json::object();
                }});
  };
  for (int i = 0; i < 8; ++i) begin(1);
  EXPECT_THROW(begin(1), page::RequestError);
  EXPECT_NO_THROW(begin(2));
}

TEST(BackgroundJobs, DestructionEndsRunningJobs) {
  std::atomic<bool> has_begun = false, has_ended = false;
  {
    BackgroundJobs jobs;
    jobs.Begin({.request = {.what = "edit"}, .work = [&](const recording::Progress& progress) {
                  has_begun = true;
                  while (progress(1, 2)) std::this_thread::yield();
                  has_ended = true;
                  return Json::object();
                }});
    while (!has_begun) std::this_thread::yield();
  }
  EXPECT_TRUE(has_ended);
}

}  // namespace
}  // namespace smile::studio
