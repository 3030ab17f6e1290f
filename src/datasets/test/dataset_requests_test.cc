#include "datasets/dataset_requests.h"

#include <chrono>
#include <functional>
#include <memory>
#include <thread>

#include "page/page_protocol.h"
#include "recorder/test/recording_fixture.h"
#include "texts/message_json.h"

namespace smile::datasets {
namespace {

namespace fs = std::filesystem;

/// Plays the program: makes what the test has prepared, as soon as it may.
constexpr const char* kProgram = R"sh(#!/bin/sh
here=$(dirname "$0")
echo "$@" >> "$here/calls.txt"
what=$1
out=$2
while [ $# -gt 0 ]; do [ "$1" = --out ] && out=$2; shift; done
if [ -e "$here/error.txt" ]; then cat "$here/error.txt" >&2; exit 1; fi
if [ $what = doctor ]; then echo "$out: 1 errors, 0 warnings"; exit 1; fi
if [ $what = render ]; then echo "filming: 3 of 12 s" >&2; echo film > "$out"; else mkdir -p "$out"; fi
if [ $what = export ]; then echo "episode 2 of 3: run, 9 frames" >&2; fi
if [ $what = generate ]; then cp -r "$here/prepared/." "$out"; fi
while [ ! -e "$here/go" ]; do sleep 0.02; done
)sh";

class DatasetRequestsTest : public recorder::RecordingFixture {
 protected:
  DatasetRequestsTest() {
    Record(R"({"do":"wait","seconds":0.1})");
    for (const char* folder : {"scenes", "brains", "tools/prepared"}) {
      fs::create_directories(root_ / folder);
    }
    WriteFile(root_ / "scenes/pair.xml", kScene);
    WriteFile(root_ / "brains/copies.py", "# smile: imitates\n");
    WriteFile(root_ / "brains/waves.py", "\n");
    WriteFile(root_ / "tools/program", kProgram);
    fs::permissions(root_ / "tools/program", fs::perms::owner_all);
    WriteFile(root_ / "tools/prepared/generation.json", "{}");
    Begin(/*has_robot=*/true);
  }

  void Begin(bool has_robot) {
    table_ = {};
    requests_ = std::make_unique<DatasetRequests>(DatasetOptions{.program = root_ / "tools/program",
                                                                 .robot_arguments = {"--classic"},
                                                                 .has_robot = has_robot,
                                                                 .scene_folder = root_ / "scenes",
                                                                 .brains = {root_ / "brains"}},
                                                  &library_);
    requests_->AddTo(&table_, [this](const page::Request& request, auto work) {
      later_ = AnswerWith(request, work);
    });
  }

  /// Returns the reply, which fits the protocol, as the request does.
  Json Ask(const char* what, Json fields = Json::object(), bool is_controller = true) {
    const page::Request request{.client = 1, .seq = 1, .what = what, .fields = fields};
    const Json now = Answer(table_, request, is_controller);
    Json answer = page::IsLater(now) ? later_ : now;
    EXPECT_EQ(page::MisfitOf(answer, what), "") << ToText(answer);
    fields["do"] = what;
    if (answer["ok"] == true) {
      EXPECT_EQ(page::MisfitOfRequest(fields), "");
    }
    return answer;
  }

  static Json Wanted() {
    return {
        {"recording", "demo"}, {"name", "many"},       {"scene", "pair"}, {"brain", "copies.py"},
        {"count", 2},          {"level", "scattered"}, {"seed", 7},       {"jobs", 1}};
  }
  static Json ToExport() {
    return {
        {"recording", "demo"}, {"name", "data"}, {"format", "zarr"}, {"cameras", {"eye", "top"}},
        {"width", 160},        {"height", 120},  {"rate", 10}};
  }

  static Json ToFilm() {
    return {{"recording", "demo"}, {"name", "tower"}, {"camera", "nice"},
            {"width", 640},        {"height", 480},   {"rate", 30}};
  }

  Json JobAt(std::size_t index) { return Ask("jobs")["jobs"].at(index); }
  /// Waits for a job.
  Json Until(std::size_t index, const std::function<bool(const Json& job)>& holds) {
    for (int k = 0; k < 2000; ++k) {
      const Json job = JobAt(index);
      if (holds(job)) return job;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    ADD_FAILURE() << "this never came: " << ToText(JobAt(index));
    return {};
  }
  Json UntilStatus(std::size_t index, const std::string& status) {
    return Until(index, [&](const Json& job) { return job["status"] == status; });
  }
  void LetItEnd() { WriteFile(root_ / "tools/go", ""); }
  std::string Calls() const { return ReadFile(root_ / "tools/calls.txt", 1 << 20); }

  /// Prepares an attempt for the program to make.
  void Prepare(std::uint64_t seed, experiment::Outcome outcome) {
    experiment::EndedAttempt ended{
        .attempt = {.episode = 0, .seed = seed}, .outcome = outcome, .has_recording = true};
    ended.attempt.variation.scene = "scenes/pair.xml";
    ended.attempt.variation.level = "scattered";
    if (outcome == experiment::Outcome::kFailure) ended.cause = {"missed", "it missed"};
    const fs::path folder = root_ / "tools/prepared" / ended.folder();
    fs::create_directories(folder.parent_path());
    fs::create_directories(folder);
    fs::copy(root_ / "demo", folder / "imitation", fs::copy_options::recursive);
    WriteFile(folder / "attempt.json", ToText(ToJson(ended)) + "\n");
  }

  library::Library library_{root_};
  std::unique_ptr<DatasetRequests> requests_;
  page::RequestTable table_;
  Json later_;
};

TEST_F(DatasetRequestsTest, GeneratesWhileItReportsProgressAndListsTheSet) {
  Prepare(7, experiment::Outcome::kFailure);
  Prepare(8, experiment::Outcome::kSuccess);
  ASSERT_EQ(Ask("generate", Wanted())["job"], 1);
  const Json job = Until(0, [](const Json& now) { return now.value("attempts", 0) == 2; });
  EXPECT_EQ(job["status"], "running");
  EXPECT_EQ(job["done"], 1);
  EXPECT_EQ(job["total"], 2);
  EXPECT_EQ(job["causes"], (Json{{"missed", 1}}));
  EXPECT_EQ(job["interval"].size(), 2u);
  LetItEnd();
  UntilStatus(0, "done");
  const auto deferred = TakeDeferred(table_);
  ASSERT_EQ(deferred.size(), 1u) << "all clients are told";
  EXPECT_EQ(page::MisfitOf(deferred[0].message), "");
  EXPECT_TRUE(TakeDeferred(table_).empty());

  const std::string root = root_.string();
  EXPECT_EQ(Calls(), "generate " + root + "/demo --scene " + root + "/scenes/pair.xml --brain " +
                         root + "/brains/copies.py --count 2 --level scattered --seed 7 --jobs 1 " +
                         "--out " + root + "/generated/many --classic\n");
  const Json sets = Ask("sets")["sets"];
  ASSERT_EQ(sets.size(), 1u);
  EXPECT_EQ(sets[0]["name"], "many");
  EXPECT_EQ(sets[0]["episodes"], 1);
  EXPECT_EQ(sets[0]["yield"], 0.5);
  EXPECT_EQ(sets[0]["picture"], "many:seed-0008");
  const Json attempts = Ask("open_set", {{"set", "many"}})["attempts"];
  ASSERT_EQ(attempts.size(), 2u);
  EXPECT_EQ(attempts[0]["outcome"], "failure");
  EXPECT_EQ(attempts[0]["cause"]["word"], "missed");
  EXPECT_EQ(attempts[0]["scene"], "pair");
  EXPECT_EQ(library_.DirectoryOf(attempts[0]["recording"]),
            fs::canonical(root_) / "generated/many/failures/seed-0007/imitation");
}

TEST_F(DatasetRequestsTest, ASetThatWasMadeAgainIsReadAgain) {
  LetItEnd();
  for (const auto outcome : {experiment::Outcome::kFailure, experiment::Outcome::kSuccess}) {
    fs::remove_all(root_ / "generated");
    fs::remove_all(root_ / "tools/prepared/failures");
    Prepare(7, outcome);
    const int number = Ask("generate", Wanted())["job"];
    UntilStatus(static_cast<std::size_t>(number - 1), "done");
    EXPECT_EQ(Ask("sets")["sets"][0]["episodes"], outcome == experiment::Outcome::kSuccess ? 1 : 0);
  }
  // The same path, another content.
  const fs::path file = root_ / "generated/many/episodes/seed-0007/attempt.json";
  std::string text = ReadFile(file, 1 << 20);
  text.replace(text.find("scattered"), 9, "edges");
  WriteFile(file, text);
  EXPECT_EQ(Ask("open_set", {{"set", "many"}})["attempts"][0]["level"], "edges");
}

TEST_F(DatasetRequestsTest, AStoppedSetContinuesByTheSameCommand) {
  ASSERT_EQ(Ask("generate", Wanted())["job"], 1);
  Until(0, [&](const Json&) { return fs::exists(root_ / "generated/many/generation.json"); });
  EXPECT_FALSE(Ask("continue_set", {{"set", "many"}})["ok"]) << "it is being made";
  EXPECT_TRUE(Ask("stop_job", {{"job", 1}})["ok"]);
  UntilStatus(0, "stopped");
  EXPECT_FALSE(Ask("stop_job", {{"job", 1}})["ok"]);
  EXPECT_FALSE(Ask("sets")["sets"][0]["is_complete"]);
  LetItEnd();
  EXPECT_EQ(texts::MessageOf(Ask("generate", Wanted())["error"]),
            "there is a set \"many\" already; continue it, or choose another name");
  // Also after the studio has ended.
  Begin(/*has_robot=*/true);
  ASSERT_EQ(Ask("continue_set", {{"set", "many"}})["job"], 1);
  UntilStatus(0, "done");
  const std::string calls = Calls();
  const std::size_t middle = calls.size() / 2;
  EXPECT_EQ(calls.substr(0, middle), calls.substr(middle));
}

TEST_F(DatasetRequestsTest, WhatVariesBetweenAttemptsIsChosenByName) {
  LetItEnd();
  Json wanted = Wanted();
  const Json jobs = Ask("jobs");
  for (const Json& kind : jobs["variations"]) {
    wanted["variations"][kind["kind"]] = kind["degrees"][0]["name"];
  }
  ASSERT_EQ(Ask("generate", wanted)["job"], 1);
  UntilStatus(0, "done");
  EXPECT_NE(Calls().find(" --noise joints=0..0.003,image=0..0.01 --looks brightness=0.9..1.1,"),
            std::string::npos)
      << Calls();
  // A set continues with the same.
  fs::remove(root_ / "generated/many/summary.json");
  ASSERT_EQ(Ask("continue_set", {{"set", "many"}})["job"], 2);
  UntilStatus(1, "done");
  const std::string calls = Calls();
  EXPECT_EQ(calls.substr(0, calls.size() / 2), calls.substr(calls.size() / 2));

  wanted["name"] = "others";
  for (const Json& wrong : {Json{{"noise", "--help"}}, Json{{"--out", "mild"}}, Json{{"noise", 1}},
                            Json{{"", ""}}, Json::array(), Json("mild")}) {
    wanted["variations"] = wrong;
    EXPECT_FALSE(Ask("generate", wanted)["ok"]) << wrong;
  }
}

TEST_F(DatasetRequestsTest, SetsAreRenamedAndBinnedAndRestored) {
  Prepare(8, experiment::Outcome::kSuccess);
  ASSERT_EQ(Ask("generate", Wanted())["job"], 1);
  UntilStatus(0, "running");
  const char* busy = "\"many\" is being made or exported; wait until that is done";
  EXPECT_EQ(texts::MessageOf(Ask("bin_set", {{"set", "many"}})["error"]), busy);
  EXPECT_EQ(texts::MessageOf(Ask("rename_set", {{"set", "many"}, {"name", "towers"}})["error"]),
            busy);
  LetItEnd();
  UntilStatus(0, "done");

  EXPECT_TRUE(Ask("rename_set", {{"set", "many"}, {"name", "towers"}})["ok"]);
  const Json renamed = Ask("sets")["sets"][0];
  EXPECT_EQ(renamed["name"], "towers");
  EXPECT_EQ(renamed["picture"], "towers:seed-0008");
  EXPECT_EQ(renamed["can_continue"], true) << "the request moves, too";
  for (const char* name : {"towers", "../x", ".bin", "a/b"}) {
    EXPECT_FALSE(Ask("rename_set", {{"set", "towers"}, {"name", name}})["ok"]) << name;
    if (std::string(name) == "towers") continue;
    EXPECT_FALSE(Ask("bin_set", {{"set", name}})["ok"]) << name;
    EXPECT_FALSE(Ask("unbin_set", {{"set", name}})["ok"]) << name;
  }

  // Two sets of one name meet in the bin.
  ASSERT_EQ(Ask("bin_set", {{"set", "towers"}})["set"], "towers");
  EXPECT_EQ(Ask("sets")["sets"][0]["binned"], true);
  EXPECT_FALSE(Ask("open_set", {{"set", "towers"}})["ok"]);
  Json again = Wanted();
  again["name"] = "towers";
  UntilStatus(static_cast<std::size_t>(int{Ask("generate", again)["job"]} - 1), "done");
  EXPECT_EQ(Ask("bin_set", {{"set", "towers"}})["set"], "towers-2");
  EXPECT_EQ(Ask("unbin_set", {{"set", "towers-2"}})["set"], "towers-2");
  EXPECT_EQ(Ask("open_set", {{"set", "towers-2"}})["attempts"].size(), 1u);
}

TEST_F(DatasetRequestsTest, JobsWaitForEachOther) {
  ASSERT_EQ(Ask("generate", Wanted())["job"], 1);
  Json other = Wanted();
  other["name"] = "others";
  ASSERT_EQ(Ask("generate", other)["job"], 2);
  UntilStatus(0, "running");
  EXPECT_EQ(JobAt(1)["status"], "waiting");
  EXPECT_EQ(texts::MessageOf(Ask("generate", other)["error"]),
            "\"others\" is being made; wait until it is done");
  EXPECT_TRUE(Ask("stop_job", {{"job", 2}})["ok"]);
  EXPECT_EQ(JobAt(1)["status"], "stopped");
  LetItEnd();
  UntilStatus(0, "done");
  EXPECT_FALSE(fs::exists(root_ / "generated/others"));
}

TEST_F(DatasetRequestsTest, AFailureHasTheErrorThatWasPrinted) {
  WriteFile(root_ / "tools/error.txt", "seed 7: missed: it missed\nit differs in seed\n");
  ASSERT_EQ(Ask("generate", Wanted())["job"], 1);
  EXPECT_EQ(UntilStatus(0, "failed")["words"], "it differs in seed");
}

TEST_F(DatasetRequestsTest, NothingLeavesTheFolderAndLimitsHold) {
  const auto expect_refused = [this](const char* what, Json fields, const char* key,
                                     const Json& value) {
    fields[key] = value;
    EXPECT_FALSE(Ask(what, fields)["ok"]) << key << " " << value;
  };
  for (const char* name : {"", ".", "..", "../x", "a/b", ".bin", "/tmp/x", "a:b", "a\nb"}) {
    expect_refused("generate", Wanted(), "name", name);
    expect_refused("export", ToExport(), "name", name);
    expect_refused("film", ToFilm(), "name", name);
    EXPECT_FALSE(Ask("open_set", {{"set", name}})["ok"]) << name;
    EXPECT_FALSE(Ask("continue_set", {{"set", name}})["ok"]) << name;
  }
  for (const char* id : {"../demo", "none", "many:seed-0001", ".."}) {
    expect_refused("generate", Wanted(), "recording", id);
    expect_refused("export", ToExport(), "recording", id);
    expect_refused("film", ToFilm(), "recording", id);
  }
  for (const Json& count : {Json(0), Json(10'001), Json(-1), Json(1.5), Json("9"), Json()}) {
    expect_refused("generate", Wanted(), "count", count);
    expect_refused("generate", Wanted(), "jobs", count);
  }
  expect_refused("generate", Wanted(), "scene", "../demo/scene");
  expect_refused("generate", Wanted(), "level", "--help");
  for (const char* brain : {"/bin/sh", "waves.py", "../brains/copies.py"}) {
    expect_refused("generate", Wanted(), "brain", brain);
  }
  for (const char* key : {"width", "height", "rate"}) {
    for (const int value : {0, 7, 100'000}) {
      expect_refused("export", ToExport(), key, value);
      expect_refused("film", ToFilm(), key, value);
    }
  }
  expect_refused("export", ToExport(), "format", "--out");
  expect_refused("film", ToFilm(), "camera", "1,1,1:0,0,0");
  expect_refused("export", ToExport(), "cameras", {"eye", "--out"});
  EXPECT_FALSE(fs::exists(root_ / "tools/calls.txt")) << "no program was started";
  // A recording of this name is not written into.
  fs::copy(root_ / "demo", root_ / "generated");
  EXPECT_FALSE(Ask("generate", Wanted())["ok"]);
}

TEST_F(DatasetRequestsTest, WatchersOnlyLook) {
  for (const char* what : {"generate", "continue_set", "export", "film", "stop_job", "rename_set",
                           "bin_set", "unbin_set"}) {
    EXPECT_FALSE(Ask(what, Wanted(), /*is_controller=*/false)["ok"]) << what;
  }
  EXPECT_TRUE(Ask("jobs", Json::object(), /*is_controller=*/false)["ok"]);
  EXPECT_TRUE(Ask("sets", Json::object(), /*is_controller=*/false)["ok"]);
}

TEST_F(DatasetRequestsTest, WithoutARobotNothingIsGenerated) {
  Begin(/*has_robot=*/false);
  EXPECT_EQ(texts::MessageOf(Ask("generate", Wanted())["error"]),
            "there is no robot; start the studio without --no-robot");
  EXPECT_NE(AllowedRequests(table_)["generate"], true);
}

TEST_F(DatasetRequestsTest, AnExportEndsWithTheVerdict) {
  Json wanted = ToExport();
  wanted["include_failed"] = wanted["drop_constant"] = true;
  ASSERT_EQ(Ask("export", wanted)["job"], 1);
  const Json job = Until(0, [](const Json& now) { return now.contains("total"); });
  EXPECT_EQ(job["done"], 1);
  EXPECT_EQ(job["total"], 3);
  LetItEnd();
  const Json done = UntilStatus(0, "done");
  const std::string data = (root_ / "datasets/data").string();
  EXPECT_EQ(done["verdict"], (Json{{"ok", false}, {"lines", {data + ": 1 errors, 0 warnings"}}}));
  EXPECT_EQ(Calls(), "export " + (root_ / "demo").string() + " --to zarr --fps 10 --out " + data +
                         " --camera eye:160x120 --camera top:160x120 --include-failed " +
                         "--drop-constant\ndoctor " + data + "\n");
  EXPECT_FALSE(Ask("export", ToExport())["ok"]) << "there is a dataset of this name";
}

TEST_F(DatasetRequestsTest, AFilmIsMadeOnceUnderItsName) {
  ASSERT_EQ(Ask("film", ToFilm())["job"], 1);
  const Json job = Until(0, [](const Json& now) { return now.contains("total"); });
  EXPECT_EQ(job["do"], "film");
  EXPECT_EQ(job["done"], 3);
  EXPECT_EQ(job["total"], 12);
  LetItEnd();
  UntilStatus(0, "done");
  const std::string film = (root_ / "films/tower.mp4").string();
  EXPECT_EQ(Calls(), "render " + (root_ / "demo").string() + " --out " + film +
                         " --camera nice --size 640x480 --rate 30 --progress\n");
  EXPECT_EQ(texts::MessageOf(Ask("film", ToFilm())["error"]),
            "there is a film \"tower\" already; choose another name");
  // A recording of this name is not written into.
  fs::remove_all(root_ / "films");
  fs::copy(root_ / "demo", root_ / "films");
  EXPECT_EQ(texts::MessageOf(Ask("film", ToFilm())["error"]),
            (root_ / "films").string() + " is no folder of films; rename it");
}

TEST_F(DatasetRequestsTest, EndingTheStudioEndsItsPrograms) {
  ASSERT_EQ(Ask("generate", Wanted())["job"], 1);
  UntilStatus(0, "running");
  requests_.reset();
  const std::string calls = Calls();
  LetItEnd();
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  EXPECT_EQ(Calls(), calls);
}

}  // namespace
}  // namespace smile::datasets
