// Links to single recordings, and what is served at them.

#include "sharing/sharing.h"

#include <sys/stat.h>

#include <thread>

#include "base/bytes.h"
#include "page/page_protocol.h"
#include "recorder/test/recording_fixture.h"
#include "recording/trace_reader.h"
#include "recording/view_sample.h"
#include "sharing/pose_track.h"
#include "texts/message_json.h"
#include "web_server/secret.h"

namespace smile::sharing {
namespace {

namespace fs = std::filesystem;

/// What a page reads of a shared recording.
struct Received {
  Json description;
  std::uint32_t num_ticks = 0;
  std::string track;
};

Received Receive(const fs::path& directory) {
  const std::string bytes = ReadForPage(directory).bytes;
  ByteReader reader(std::as_bytes(std::span(bytes.data(), bytes.size())));
  const auto length = reader.Get<std::uint32_t>();
  Received received{.description = Json::parse(bytes.substr(4, length))};
  ByteReader rest(std::as_bytes(std::span(bytes.data(), bytes.size()).subspan(4 + length)));
  received.num_ticks = rest.Get<std::uint32_t>();
  received.track = bytes.substr(8 + length);
  return received;
}

/// Reads a pose track as docs/studio-protocol.md specifies it.
class TrackReader {
 public:
  TrackReader(std::string track, std::size_t num_frames)
      : track_(std::move(track)), steps_(num_frames) {}

  /// The poses at the next tick, seven steps a frame.
  const std::vector<std::array<std::int64_t, 7>>& Next() {
    std::size_t frame = 0;
    for (std::uint64_t left = Number(); left > 0; --left) {
      frame += Number();
      for (std::int64_t& step : steps_.at(frame)) {
        const std::uint64_t folded = Number();
        step += static_cast<std::int64_t>(folded >> 1) ^ -static_cast<std::int64_t>(folded & 1);
      }
    }
    return steps_;
  }
  bool is_at_end() const { return at_ == track_.size(); }

 private:
  std::uint64_t Number() {
    std::uint64_t number = 0;
    for (int shift = 0;; shift += 7) {
      const auto byte = static_cast<unsigned char>(track_.at(at_++));
      number |= std::uint64_t{byte & 0x7FU} << shift;
      if (byte < 0x80) return number;
    }
  }

  std::string track_;
  std::size_t at_ = 0;
  std::vector<std::array<std::int64_t, 7>> steps_;
};

class SharingTest : public recorder::RecordingFixture {
 protected:
  SharingTest() {
    fs::create_directories(root_ / "page");
    WriteFile(root_ / "page" / "index.html", "<p>the page of shared recordings</p>");
    fs::create_directories(library_.root());
    table_.requests["bin"] = {[this](const page::Request& request) -> Json {
      return {{"recording", library_.Bin(request.fields["recording"])}};
    }};
    sharing_.AddTo(&table_, {.origin = "http://127.0.0.1:8470", .is_local = true},
                   [this](const page::Request& request, const std::function<Json()>& work) {
                     late_ = page::AnswerWith(request, work);
                   });
  }

  /// Records into the library.
  void RecordAs(const std::string& id, const char* script = kStackAOnB) {
    fs::rename(Record(script), library_.root() / id);
  }
  Json Ask(const char* what, Json fields, bool is_controller = true) {
    const page::Request request{.client = 1, .seq = 1, .what = what, .fields = std::move(fields)};
    const Json answer = Answer(table_, request, is_controller);
    const Json reply = page::IsLater(answer) ? late_ : answer;
    EXPECT_EQ(page::MisfitOf(reply, what), "") << reply;
    return reply;
  }
  /// Makes a link; returns its path.
  std::string Share(const std::string& id) {
    const Json reply = Ask("share", {{"recording", id}});
    EXPECT_EQ(reply["ok"], true) << reply;
    return "/shared/" + reply["link"]["secret"].get<std::string>();
  }
  bool IsServed(const std::string& path) { return sharing_.Get(path).has_value(); }
  Json LinksOf(const std::string& id) { return Ask("share_links", {{"recording", id}})["links"]; }

  library::Library library_{root_ / "library"};
  Sharing sharing_{
      {.page = root_ / "page",
       .content = [](const std::string& path) -> std::optional<web_server::HttpResponse> {
         return web_server::HttpResponse{.type = "image/png", .body = path, .file_name = ""};
       }},
      &library_};
  page::RequestTable table_;
  Json late_;
};

TEST_F(SharingTest, ALinkShowsItsRecordingUntilItIsStopped) {
  RecordAs("demo");
  const std::string path = Share("demo"), other = Share("demo");
  EXPECT_NE(path, other);
  EXPECT_EQ(path.size(), 8 + web_server::kSecretDigits);
  const Json reply = Ask("share_links", {{"recording", "demo"}});
  EXPECT_EQ(reply["links"].size(), 2u);
  EXPECT_EQ("/shared/" + reply["links"][0]["secret"].get<std::string>(), path);
  EXPECT_EQ(reply["origin"], "http://127.0.0.1:8470");
  EXPECT_EQ(reply["is_local"], true);

  EXPECT_EQ(sharing_.Get(path)->body, "<p>the page of shared recordings</p>");
  EXPECT_EQ(sharing_.Get(path + "/recording")->gzipped->substr(0, 2), "\x1f\x8b");
  EXPECT_EQ(sharing_.Get(path + "/segments/2.png")->body, "/recordings/demo/segments/2.png");
  EXPECT_EQ(Ask("stop_sharing", {{"recording", "demo"}, {"secret", path.substr(8)}})["ok"], true);
  EXPECT_FALSE(IsServed(path + "/recording"));
  EXPECT_FALSE(IsServed(path + "/segments/2.png"));
  EXPECT_TRUE(IsServed(other + "/recording")) << "each link ends by itself";
  EXPECT_EQ(LinksOf("demo").size(), 1u);
}

TEST_F(SharingTest, LinksSurviveTheProgramInAFileOfTheirOwnerAlone) {
  RecordAs("demo");
  const std::string path = Share("demo");
  Sharing next({.page = root_ / "page", .content = nullptr}, &library_);
  EXPECT_TRUE(next.Get(path + "/recording").has_value());
  struct stat folder {};
  ASSERT_EQ(stat((library_.root() / ".sharing").c_str(), &folder), 0);
  EXPECT_EQ(folder.st_mode & 0777U, 0700U);
  EXPECT_EQ(ToText(library_.List()).find(path.substr(8)), std::string::npos);
  EXPECT_EQ(library_.List().size(), 1u);
}

TEST_F(SharingTest, ALinkShowsNoOtherRecordingThatTakesThePlace) {
  RecordAs("demo");
  const std::string path = Share("demo");
  fs::rename(library_.root() / "demo", library_.root() / "moved");
  EXPECT_FALSE(IsServed(path + "/recording"));
  RecordAs("demo", R"({"do":"wait","seconds":0.5})");
  EXPECT_FALSE(IsServed(path + "/recording"));
  EXPECT_EQ(LinksOf("demo").size(), 0u);

  const std::string second = Share("demo");
  EXPECT_TRUE(IsServed(second + "/recording"));
  const Json binned = Ask("bin", {{"recording", "demo"}});
  EXPECT_EQ(binned["ok"], true);
  EXPECT_FALSE(IsServed(second + "/recording"));
  EXPECT_EQ(library_.Unbin(binned["recording"]), "demo");
  EXPECT_FALSE(IsServed(second + "/recording")) << "the bin ends links for good";
}

TEST_F(SharingTest, OnlyTheControllerSeesAndMakesLinks) {
  RecordAs("demo");
  const std::string secret = Share("demo").substr(8);
  for (const char* what : {"share", "share_links"}) {
    EXPECT_EQ(Ask(what, {{"recording", "demo"}}, false)["ok"], false) << what;
  }
  const Json stop{{"recording", "demo"}, {"secret", secret}};
  EXPECT_EQ(Ask("stop_sharing", stop, false)["ok"], false);
  EXPECT_EQ(LinksOf("demo").size(), 1u);
}

TEST_F(SharingTest, RefusesWhatCannotBeShared) {
  RecordAs("demo");
  RecordAs("binned");
  RecordAs("damaged");
  WriteFile(library_.root() / "damaged" / "demo.json", "{}");
  const std::string binned = library_.Bin("binned");
  const auto error_of = [this](const char* what, const Json& fields) {
    const Json reply = Ask(what, fields);
    EXPECT_EQ(reply["ok"], false) << reply;
    return std::string(texts::MessageOf(reply["error"]));
  };
  EXPECT_EQ(error_of("share", {{"recording", binned}}),
            "\"binned~1\" is in the bin; restore it first");
  EXPECT_NE(error_of("share", {{"recording", "damaged"}}).find("demo.json: has no member"),
            std::string::npos);
  for (const char* id : {"none", "../demo", ".", ".sharing", "/etc"}) {
    EXPECT_NE(error_of("share", {{"recording", id}}).find("there is no recording"),
              std::string::npos);
  }
  EXPECT_NE(error_of("share", {{"recording", 3}}).find("expected a string"), std::string::npos);
  EXPECT_EQ(error_of("stop_sharing", {{"recording", "demo"}, {"secret", std::string(32, '0')}}),
            "\"demo\" has no such link");
  EXPECT_FALSE(fs::exists(library_.root() / ".sharing" / "links.json"));
}

TEST_F(SharingTest, WrongPathsLeadNowhere) {
  RecordAs("demo");
  const std::string path = Share("demo"), wrong = "/shared/" + std::string(32, '0');
  for (const std::string& any : {path, path + "/", path.substr(0, 20), std::string("/shared/")}) {
    EXPECT_EQ(sharing_.Get(any)->body, sharing_.Get(wrong)->body) << "one page for any secret";
  }
  for (const std::string& begin :
       {wrong, path.substr(0, 39), path + "0", std::string("/shared/"), std::string("/shared/demo"),
        std::string("/shared/links.json")}) {
    EXPECT_FALSE(IsServed(begin + "/recording")) << begin;
  }
  for (const char* rest :
       {"/demo.json", "/recording/", "/recording.zip", "/segments/-1.png", "/segments/.png",
        "/segments/1.png/", "/segments/1 .png", "/segments/99999999999999999999.png",
        "/segments/../../demo.png", "/meshes/2/0", "/meshes/1/999", "/eye/0.png", "/eye/x.png",
        "/ws", "/picture.png", "/../recordings/demo.zip"}) {
    EXPECT_FALSE(IsServed(path + rest)) << rest;
  }
  EXPECT_FALSE(IsServed("/recordings/demo.zip"));
}

TEST_F(SharingTest, PicturesOfTheEyeComeFromTheRecordingOnly) {
  RecordAs("demo");
  const fs::path demo = library_.root() / "demo";
  WriteFile(demo / "frames.csv", "frame,tick,image\n0,0,0/0.png\n1,15,0/1.png\n2,30,9/2.png\n");
  WriteFile(demo / "0" / "0.png", "a picture");
  WriteFile(root_ / "2.png", "a secret");
  fs::create_symlink(root_ / "2.png", demo / "0" / "1.png");
  fs::create_directory_symlink(root_, demo / "9");
  const std::string path = Share("demo");
  EXPECT_EQ(sharing_.Get(path + "/eye/0.png")->body, "a picture");
  EXPECT_FALSE(IsServed(path + "/eye/1.png")) << "it is a link";
  EXPECT_FALSE(IsServed(path + "/eye/2.png")) << "it is in a link";
  EXPECT_FALSE(IsServed(path + "/eye/3.png"));
  const Received received = Receive(demo);
  EXPECT_EQ(received.description["eye"], Json::array({0, 15, 30}));

  WriteFile(demo / "frames.csv", "frame,tick,image\n0,0,../2.png\n");
  EXPECT_THROW((void)sharing_.Get(path + "/eye/0.png"), std::runtime_error);
}

TEST_F(SharingTest, ADamagedFileOfLinksIsReportedToItsOwnerOnly) {
  RecordAs("demo");
  const std::string path = Share("demo");
  const fs::path file = library_.root() / ".sharing" / "links.json";
  for (const char* text :
       {"", "[]", R"({"format":2,"links":[]})", R"({"format":1,"links":[{"secret":""}]})",
        R"({"format":1,"links":[{"secret":"a","recording":"demo","directory":"","made":""}]})"}) {
    WriteFile(file, text);
    const Json reply = Ask("share_links", {{"recording", "demo"}});
    EXPECT_NE(reply.value("error", "").find(file.string()), std::string::npos) << reply;
    try {
      (void)sharing_.Get(path + "/recording");
      ADD_FAILURE() << text;
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "this cannot be shown now; try again later");
    }
  }
}

TEST_F(SharingTest, APageGetsTheRecordedMotionAndNothingThatWasUndone) {
  RecordAs("demo", R"({"hand":"left","do":"grasp","object":"b"}
{"do":"wait","seconds":0.5}
{"do":"undo"}
{"hand":"left","do":"grasp","object":"a"}
{"hand":"left","do":"move_to","position":[0,-2,3]}
{"do":"wait","seconds":1}
{"hand":"left","do":"destroy"}
{"do":"wait","seconds":0.5})");
  recording::Retitle(library_.root() / "demo", "A title", "private notes");
  const Received received = Receive(library_.root() / "demo");
  EXPECT_EQ(received.description["title"], "A title");
  EXPECT_EQ(ToText(received.description).find("private"), std::string::npos);
  EXPECT_EQ(ToText(received.description).find("takes b"), std::string::npos);
  EXPECT_EQ(received.description["segments"].size(), 3u);
  EXPECT_EQ(received.description["changes"].back()["gone"], Json::array({"a"}));

  const auto recording = recording::OpenRecording(library_.root() / "demo");
  recording::TraceReader trace(recording);
  TrackReader track(received.track, received.description["scene"]["numFrames"]);
  std::uint32_t num_ticks = 0;
  for (auto moment = trace.Next(); moment; moment = trace.Next(), ++num_ticks) {
    const auto& steps = track.Next();
    const auto poses = recording::VisualStateAt(*moment, *recording.model).poses;
    for (std::size_t frame = 1; frame < poses.size(); ++frame) {
      for (int k = 0; k < 3; ++k) {
        // Half a step, in meters.
        EXPECT_NEAR(static_cast<double>(steps[frame][static_cast<std::size_t>(k)]) / 1e5,
                    poses[frame].translation()[k], 0.5001e-5);
      }
    }
  }
  EXPECT_EQ(received.num_ticks, num_ticks);
  EXPECT_TRUE(track.is_at_end());
}

TEST_F(SharingTest, KeepsTheRecordingsThatAreWatched) {
  RecordAs("demo", R"({"do":"wait","seconds":0.1})");
  SharedRecordings recordings;
  const fs::path demo = library_.root() / "demo";
  const auto watched = recordings.Get(demo);
  for (std::size_t k = 0; k < 2 * SharedRecordings::kMaxKept; ++k) {
    const fs::path other = root_ / ("other" + std::to_string(k));
    fs::copy(demo, other, fs::copy_options::recursive);
    (void)recordings.Get(other);
    EXPECT_EQ(recordings.Get(demo), watched) << k;
  }
  recording::Retitle(demo, "Another title", std::nullopt);
  EXPECT_NE(recordings.Get(demo), watched) << "it has changed";
  std::weak_ptr<const SharedRecording> left = recordings.Get(root_ / "other0");
  for (std::size_t k = 1; k <= SharedRecordings::kMaxKept; ++k) {
    (void)recordings.Get(root_ / ("other" + std::to_string(k)));
  }
  EXPECT_TRUE(left.expired()) << "memory is bounded";
}

TEST(PoseTrack, BoundsItsLengthAndTheWorld) {
  PoseTrack track("trace.bin", 0.1);
  scene::FramePoses poses(2);
  poses[1] = RigidTransform(Vector3(std::nan(""), 0, 0));
  EXPECT_THROW(track.Add(poses), InputError);
  poses[1] = RigidTransform(Vector3(1e9, 0, 0));
  EXPECT_THROW(track.Add(poses), InputError);
  poses[1] = RigidTransform();
  for (std::size_t k = 0; k < PoseTrack::kMaxTicks; ++k) track.Add(poses);
  EXPECT_LT(track.bytes().size(), PoseTrack::kMaxTicks + 100) << "rest costs a byte per tick";
  try {
    track.Add(poses);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "trace.bin: is longer than an hour, the most that can be shared");
  }
}

TEST_F(SharingTest, ManyWatchersShareOneRecordingInMemory) {
  RecordAs("demo");
  const std::string path = Share("demo") + "/recording";
  std::vector<std::thread> watchers;
  std::vector<std::shared_ptr<const std::string>> received(16);
  for (auto& mine : received) {
    watchers.emplace_back([&] { mine = sharing_.Get(path)->gzipped; });
  }
  for (std::thread& watcher : watchers) watcher.join();
  for (const auto& one : received) EXPECT_EQ(one, received.front());
}

}  // namespace
}  // namespace smile::sharing
