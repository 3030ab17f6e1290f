#include "library/library.h"

#include <archive.h>
#include <archive_entry.h>

#include <clocale>
#include <map>

#include "recorder/test/recording_fixture.h"
#include "replay/replay.h"

namespace smile::library {
namespace {

namespace fs = std::filesystem;

class LibraryTest : public recorder::RecordingFixture {
 protected:
  /// Records `demo`, and gives it another name.
  fs::path RecordAs(const std::string& id, const char* script = R"({"do":"wait","seconds":0.5})") {
    const fs::path demo = Record(script);
    fs::rename(demo, root_ / id);
    return root_ / id;
  }

  Json EntryOf(const std::string& id) const {
    for (const Json& entry : library_.List()) {
      if (entry["id"] == id) return entry;
    }
    return nullptr;
  }

  Library library_{root_};
};

/// All that is in a ZIP file, by name.
std::map<std::string, std::string> Unzipped(const std::string& zip) {
  std::map<std::string, std::string> files;
  std::setlocale(LC_CTYPE, "C.UTF-8");  // libarchive gives names in the user's letters
  archive* in = archive_read_new();
  archive_read_support_format_zip(in);
  EXPECT_EQ(archive_read_open_memory(in, zip.data(), zip.size()), ARCHIVE_OK);
  archive_entry* entry = nullptr;
  while (archive_read_next_header(in, &entry) == ARCHIVE_OK) {
    std::string& text = files[archive_entry_pathname(entry)];
    char bytes[4096];
    for (la_ssize_t n = 0; (n = archive_read_data(in, bytes, sizeof bytes)) > 0;) {
      text.append(bytes, static_cast<std::size_t>(n));
    }
  }
  archive_read_free(in);
  std::setlocale(LC_CTYPE, "C");
  return files;
}

TEST_F(LibraryTest, ListsTheNewestFirstAndWhatCannotBeRead) {
  RecordAs("old", kStackAOnB);
  RecordAs("new");
  RecordAs("wrong");
  WriteFile(root_ / "wrong" / "demo.json", "{}");
  fs::create_directories(root_ / "no_recording");
  const auto age = fs::last_write_time(root_ / "old" / "commands.jsonl");
  for (const auto& [id, days] : {std::pair{"old", 2}, {"new", 0}, {"wrong", 1}}) {
    fs::last_write_time(root_ / id / "commands.jsonl", age - std::chrono::hours(24 * days));
  }
  const Json list = library_.List();
  ASSERT_EQ(list.size(), 3u);
  EXPECT_EQ(list[0]["id"], "new");
  EXPECT_EQ(list[0]["scene"], "pair");
  EXPECT_DOUBLE_EQ(list[0]["seconds"], 0.5);
  EXPECT_EQ(list[0]["segments"], 1);
  EXPECT_EQ(list[0]["binned"], false);
  EXPECT_NE(list[1]["error"].get<std::string>().find("demo.json: has no member"), std::string::npos)
      << list[1];
  EXPECT_EQ(list[2]["segments"], 3);
  EXPECT_EQ(list[2]["made"].get<std::string>().size(), std::string("2026-01-01T00:00:00Z").size());
}

TEST_F(LibraryTest, RenamesPermanentlyAndChangesNothingElse) {
  const auto demo = RecordAs("demo2");
  const auto before = recording::ReadDemoInfo(demo / "demo.json");
  ASSERT_EQ(EntryOf("demo2")["title"], "");
  library_.Rename("demo2", "Türme \"hoch\"", std::nullopt);
  library_.Rename("demo2", std::nullopt, "two\nlines");
  EXPECT_EQ(EntryOf("demo2")["title"], "Türme \"hoch\"");
  EXPECT_EQ(EntryOf("demo2")["notes"], "two\nlines");
  auto after = recording::OpenRecording(demo).info;
  after.title = before.title;
  after.notes = before.notes;
  EXPECT_EQ(after, before);
  EXPECT_THROW(library_.Rename("demo2", std::string(300, 'x'), {}), std::invalid_argument);
}

TEST_F(LibraryTest, DoesNotTouchARecordingInProgress) {
  auto simulation = MakeSimulation(/*with_robot=*/false);
  const recorder::Recorder recorder(root_ / "now", {}, nullptr, *simulation);
  EXPECT_EQ(EntryOf("now")["binned"], false);
  EXPECT_THROW(library_.Rename("now", "later", {}), std::runtime_error);
  EXPECT_THROW(library_.Bin("now"), LibraryError);
  EXPECT_EQ(EntryOf("now")["title"], "");
}

TEST_F(LibraryTest, RestoresFromTheBinEvenIfTheNameIsInUse) {
  RecordAs("um");
  EXPECT_EQ(library_.Bin("um"), "um~1");
  EXPECT_EQ(EntryOf("um~1")["binned"], true);
  EXPECT_THROW(library_.DirectoryOf("um"), LibraryError);
  EXPECT_TRUE(recording::IsRecording(library_.DirectoryOf("um~1")));
  RecordAs("um");
  EXPECT_EQ(library_.Bin("um"), "um~2");
  RecordAs("um");
  EXPECT_THROW(library_.Bin("um~1"), LibraryError) << "is there already";
  EXPECT_THROW(library_.Unbin("um"), LibraryError) << "never was there";
  EXPECT_EQ(library_.Unbin("um~1"), "um-2");
  EXPECT_EQ(EntryOf("um-2")["binned"], false);
  EXPECT_EQ(library_.List().size(), 3u);
}

TEST_F(LibraryTest, ListsOnlyItsOwnDirectories) {
  RecordAs("inside");
  const fs::path shelf = root_ / "shelf";
  fs::create_directories(shelf);
  fs::rename(root_ / "inside", shelf / "inside");
  fs::create_directory_symlink(shelf / "inside", shelf / "link");
  fs::create_directory_symlink(shelf, shelf / ".bin");
  RecordAs("outside");
  const Library library(shelf);
  EXPECT_NO_THROW(library.DirectoryOf("inside"));
  EXPECT_EQ(library.List().size(), 1u);
  for (const std::string id : {"../outside", "..", ".", "", "link", ".bin", "inside/", "inside/0",
                               "/etc", ".bin/inside", "none"}) {
    EXPECT_THROW(library.DirectoryOf(id), LibraryError) << id;
    EXPECT_THROW(library.Bin(id), LibraryError) << id;
  }
  EXPECT_THROW(library.DirectoryOf(std::string("inside\0", 7)), LibraryError);
}

TEST_F(LibraryTest, DescribesActionsWithTheirTimes) {
  const std::string script = R"({"hand":"left","do":"grasp","object":"b"}
{"do":"wait","seconds":1}
{"do":"undo"}
)" + std::string(kStackAOnB);
  RecordAs("stack", script.c_str());
  const Json timeline = library_.TimelineOf("stack");
  const Json& segments = timeline["segments"];
  ASSERT_EQ(segments.size(), 3u) << timeline;
  EXPECT_EQ(segments[0]["deed"], nullptr);
  EXPECT_EQ(segments[1]["deed"],
            Json::parse(R"({"do":"take","hand":"left","what":"a","words":"left hand takes a"})"));
  EXPECT_EQ(segments[2]["deed"], timeline["steps"][3]["deed"]);
  EXPECT_EQ(segments[1]["end"], segments[2]["begin"]);
  EXPECT_EQ(segments[2]["end"], timeline["seconds"]);
  const Json& steps = timeline["steps"];
  ASSERT_EQ(steps.size(), 4u) << timeline;
  EXPECT_EQ(steps[1]["deed"]["what"], "b");
  EXPECT_EQ(steps[1]["on_way"], false);
  EXPECT_EQ(steps[3]["parent"], 2);
  EXPECT_EQ(steps[3]["begin"], segments[2]["begin"]);
}

TEST_F(LibraryTest, PutsAllFilesIntoAZipThatOpensAgain) {
  const fs::path demo = RecordAs("größe");
  WriteFile(root_ / "secret", "not of the recording");
  fs::create_symlink(root_ / "secret", demo / "link");
  const std::string zip = library_.ZipOf("größe");
  EXPECT_EQ(zip, library_.ZipOf("größe"));
  EXPECT_TRUE((zip.at(7) & 8) != 0) << "its names are UTF-8 (general purpose bit 11)";
  const auto files = Unzipped(zip);
  std::size_t num_plain = 0;
  for (const auto& entry : fs::recursive_directory_iterator(demo)) {
    if (!entry.is_regular_file() || entry.is_symlink()) continue;
    ++num_plain;
    const auto name = ("größe" / entry.path().lexically_relative(demo)).string();
    ASSERT_TRUE(files.contains(name)) << name;
    EXPECT_TRUE(files.at(name) == ReadFile(entry.path(), 1 << 24)) << name;
  }
  EXPECT_EQ(files.size(), num_plain);
  for (const auto& [name, text] : files) {
    fs::create_directories((root_ / "unzipped" / name).parent_path());
    WriteFile(root_ / "unzipped" / name, text);
  }
  const auto again = recording::OpenRecording(root_ / "unzipped" / "größe");
  EXPECT_FALSE(replay::Replay(again).first_difference);
}

TEST_F(LibraryTest, RecordingsOfGeneratedSetsAreFoundAndNeverChanged) {
  const fs::path folder = root_ / "generated" / "many" / "failures" / "seed-0007";
  fs::create_directories(folder);
  fs::rename(RecordAs("demo"), folder / "imitation");
  const std::string id = AttemptId("many", "seed-0007");
  EXPECT_EQ(library_.DirectoryOf(id), fs::canonical(folder / "imitation"));
  EXPECT_TRUE(library_.List().empty());
  const std::string stamp = library_.Stamp();
  fs::create_directories(root_ / "generated" / "others");
  EXPECT_NE(library_.Stamp(), stamp);
  EXPECT_THROW(library_.Rename(id, "another", std::nullopt), LibraryError);
  EXPECT_THROW((void)library_.Bin(id), LibraryError);
  EXPECT_THROW((void)library_.ChangeableDirectoryOf(id), LibraryError);
  for (const char* other : {"many:seed-0008", "many:..", "..:seed-0007", "many:", ":seed-0007",
                            "many/failures:seed-0007", "many:seed-0007/imitation"}) {
    EXPECT_THROW((void)library_.DirectoryOf(other), LibraryError) << other;
  }
  // Links are not followed.
  fs::rename(root_ / "generated", root_ / "elsewhere");
  fs::create_directory_symlink(root_ / "elsewhere", root_ / "generated");
  EXPECT_THROW((void)library_.DirectoryOf(id), LibraryError);
}

}  // namespace
}  // namespace smile::library
