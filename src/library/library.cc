// The library has no index file: the folders are the truth, and people may change them by other
// means at any time. Each call looks at the file system; only what is expensive to read (titles,
// durations) is cached, under a stamp of the files it came from.

#include "library/library.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <system_error>
#include <tuple>
#include <vector>

#include "base/file_state.h"
#include "base/state_hash.h"
#include "base/wording.h"
#include "library/internal_zip.h"
#include "library/timeline.h"
#include "library/utc_text.h"
#include "recording/append_file.h"
#include "recording/recording.h"
#include "recording/recording_names.h"
#include "sim/tick.h"
#include "texts/user_message.h"

namespace smile::library {

using texts::Say;
namespace {

namespace fs = std::filesystem;

// Bounds the time of a list in a folder that is not a library, such as a home directory.
constexpr std::size_t kMaxDirectories = 10'000;  ///< examined in a folder
// The longest file name on Linux.
constexpr std::size_t kMaxIdBytes = 255;

/// Returns a text that changes whenever the listed facts of a recording change.
std::string ListingStampOf(const fs::path& directory) {
  // Title and notes are in demo.json, the duration in frames.csv; folders of segments change the
  // stamp of the directory.
  return StampOf(directory / "demo.json") + ";" + StampOf(directory / "frames.csv") + ";" +
         StampOf(directory);
}

/// Visits the entries of a folder, at most `most`. The order is that of the file system, which is
/// stable while nothing changes there. Errors end the visit silently: a folder that does not exist
/// yet contains no recordings.
template <class Visit>
void ForEachIn(const fs::path& folder, std::size_t most, const Visit& visit) {
  std::error_code error;
  std::size_t num_seen = 0;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    if (++num_seen > most) break;
    visit(it->path());
  }
}

/// True for names that cannot lead out of a folder; ids come from clients.
bool IsPlainName(const std::string& id) {
  // No slash, hence no parent and no absolute path; no leading dot, hence neither `..` nor the bin
  // itself.
  return !id.empty() && id.size() <= kMaxIdBytes && id.front() != '.' &&
         id.find('/') == std::string::npos && id.find('\0') == std::string::npos;
}

/// True if a folder contains a recording of this name. StateOf() does not follow links.
bool IsRecordingIn(const fs::path& folder, const std::string& id) {
  return StateOf(folder).is_directory && StateOf(folder / id).is_directory &&
         StateOf(folder / id / "demo.json").is_file;
}

/// Returns the directory with the recording of an attempt, see AttemptId(); nullopt if there is
/// none.
std::optional<fs::path> AttemptIn(const fs::path& generated, const std::string& id) {
  const std::size_t colon = id.rfind(':');
  if (colon == std::string::npos) return std::nullopt;
  const std::string set = id.substr(0, colon), attempt = id.substr(colon + 1);
  if (!IsPlainName(set) || !IsPlainName(attempt)) return std::nullopt;
  // None of the folders on the way may be a link.
  if (!StateOf(generated).is_directory || !StateOf(generated / set).is_directory) {
    return std::nullopt;
  }
  for (const char* outcome : {"episodes", "failures"}) {
    const fs::path folder = generated / set / outcome;
    if (!StateOf(folder).is_directory) continue;
    if (IsRecordingIn(folder / attempt, "imitation")) return folder / attempt / "imitation";
  }
  return std::nullopt;
}

/// Returns the tick of the last frame of the classic view; nullopt if it has none. Reads only the
/// end of frames.csv, since listing must be fast.
std::optional<std::uint64_t> LastFrameTick(const fs::path& directory) {
  // Lines are a few dozen bytes; the last complete one lies in this tail. A line without its line
  // end is still being written and does not count. Its second cell is the tick.
  constexpr std::streamoff kTail = 4096;
  std::ifstream file(directory / "frames.csv", std::ios::binary | std::ios::ate);
  if (!file) return std::nullopt;
  const std::streamoff size = file.tellg();
  file.seekg(std::max<std::streamoff>(0, size - kTail));
  std::string tail(static_cast<std::size_t>(std::min(size, kTail)), '\0');
  file.read(tail.data(), static_cast<std::streamsize>(tail.size()));
  const std::size_t end = tail.rfind('\n');
  if (!file || end == std::string::npos || end == 0) return std::nullopt;
  const std::size_t before = tail.rfind('\n', end - 1);
  const std::string line = tail.substr(before + 1, end - before - 1);
  const std::size_t comma = line.find(',');
  if (comma == std::string::npos) return std::nullopt;
  std::uint64_t tick = 0;
  const auto [rest, error] =
      std::from_chars(line.data() + comma + 1, line.data() + line.size(), tick);
  if (error != std::errc()) return std::nullopt;
  return tick;
}

/// Returns the number of segments of the classic view, which are numbered from 0 and have a folder
/// of pictures each.
int NumSegments(const fs::path& directory) {
  // A bound for a damaged folder; no recording comes near it.
  constexpr int kMostSegments = 100'000;
  int count = 0;
  while (count < kMostSegments && StateOf(directory / std::to_string(count)).is_directory) ++count;
  return count;
}

/// Returns the listed facts of a recording; an `error` if it cannot be read.
Json EntryOf(const fs::path& directory) {
  try {
    const recording::DemoInfo info = recording::ReadDemoInfo(directory / "demo.json");
    const std::uint64_t first = info.start.tick;
    const std::uint64_t last = LastFrameTick(directory).value_or(first);
    Json corrects;
    if (info.corrects) {
      corrects = {{"recording", info.corrects->recording}, {"seconds", info.corrects->seconds}};
    }
    return {{"title", info.title},
            {"corrects", std::move(corrects)},
            {"notes", info.notes},
            {"scene", info.scene},
            {"seconds", last > first ? sim::SecondsOf(last - first) : 0.0},
            {"segments", NumSegments(directory)}};
  } catch (const std::exception& error) {
    // A damaged recording stays in the list, with its fault: it must not hide the others, and
    // people may want to delete it.
    return {{"error", error.what()}};
  }
}

[[noreturn]] void FailToFind(const std::string& id) {
  throw LibraryError(Say("library.noRecording", {{"recording", Quoted(id)}}));
}

/// Returns a lock that excludes recording there; nullopt if the recording has no log. Throws
/// LibraryError if it is being recorded.
std::optional<recording::AppendFile> Hold(const fs::path& directory) {
  // Opening the log takes its lock, which a recorder of any process holds while it records.
  if (!StateOf(directory / "commands.jsonl").is_file) return std::nullopt;
  try {
    return recording::AppendFile(directory / "commands.jsonl", recording::AppendFile::kExisting);
  } catch (const std::runtime_error& error) {
    throw LibraryError(Quoted(directory.filename().string()) +
                       " cannot be changed now: " + error.what());
  }
}

void Move(const fs::path& from, const fs::path& to) {
  std::error_code error;
  // Within one file system, so it is atomic: a recording is in one place or the other, never in
  // both.
  fs::rename(from, to, error);
  if (error) throw LibraryError(from.string() + " cannot be moved: " + error.message());
}

/// Returns an id without the number that it got in the bin.
std::string NameOutsideOfBin(const std::string& id) {
  // Only `~` and digits at the end are removed; a name that contains other tildes keeps them.
  const std::size_t mark = id.rfind('~');
  const bool is_numbered = mark != std::string::npos && mark > 0 && mark + 1 < id.size() &&
                           id.find_first_not_of("0123456789", mark + 1) == std::string::npos;
  return is_numbered ? id.substr(0, mark) : id;
}

}  // namespace

struct Library::Place {
  std::string id;
  fs::path directory;
  bool is_binned = false;
  std::int64_t recorded = 0;  ///< [ns]
};

std::vector<Library::Place> Library::Places() const {
  std::vector<Place> places;
  for (const bool is_binned : {false, true}) {
    const fs::path folder = is_binned ? bin() : root_;
    ForEachIn(folder, kMaxDirectories, [&](const fs::path& directory) {
      Place place{
          .id = directory.filename().string(), .directory = directory, .is_binned = is_binned};
      if (!IsPlainName(place.id) || !IsRecordingIn(folder, place.id)) return;
      // The log changes only by recording, so its time orders recordings; titles may change later.
      const FileState log = StateOf(directory / "commands.jsonl");
      place.recorded = log.is_file ? log.changed : StateOf(directory / "demo.json").changed;
      places.push_back(std::move(place));
    });
  }
  // Newest first (a and b are swapped for the time); equal times, which copied files may have, are
  // ordered by directory, so that the list is stable.
  std::ranges::sort(places, [](const Place& a, const Place& b) {
    return std::tie(b.recorded, a.directory) < std::tie(a.recorded, b.directory);
  });
  if (places.size() > kMaxListed) places.resize(kMaxListed);
  return places;
}

Json Library::List() const {
  const std::vector<Place> places = Places();
  Json list = Json::array();
  // Rebuilt with each list, so that the cache forgets recordings that disappeared.
  std::map<std::string, Listed> listed;
  const std::lock_guard lock(mutex_);
  for (const Place& place : places) {
    Listed& now = listed[place.directory.string()];
    now.stamp = ListingStampOf(place.directory);
    const auto before = listed_.find(place.directory.string());
    // Unchanged recordings are not read again.
    const bool is_known = before != listed_.end() && before->second.stamp == now.stamp;
    now.entry = is_known ? before->second.entry : EntryOf(place.directory);
    Json entry = {{"id", place.id}};
    entry.update(now.entry);
    entry["made"] = UtcText(place.recorded);
    entry["binned"] = place.is_binned;
    list.push_back(std::move(entry));
  }
  listed_ = std::move(listed);
  return list;
}

std::string Library::Stamp() const {
  // A hash of names and stamps, not of contents: it is asked for again and again to notice changes.
  StateHash hash;
  hash.Add(StampOf(root_ / kGeneratedFolder));
  for (const fs::path& folder : {root_, bin()}) {
    hash.Add(StampOf(folder));
    // An unchanged folder may still gain or lose a recording's demo.json. Checking 1000 takes 3 ms.
    ForEachIn(folder, kMaxListed, [&](const fs::path& directory) {
      hash.Add(directory.filename().string());
      hash.Add(StampOf(directory / "demo.json"));
    });
  }
  return std::to_string(hash.value());
}

fs::path Library::DirectoryOf(const std::string& id) const {
  if (!IsPlainName(id)) FailToFind(id);
  // The root may be a link; anything below it must not be.
  std::error_code error;
  const fs::path root = fs::canonical(root_, error);
  if (error) FailToFind(id);
  for (const fs::path& folder : {root, root / bin().filename()}) {
    if (IsRecordingIn(folder, id)) return folder / id;
  }
  if (const auto attempt = AttemptIn(root / kGeneratedFolder, id)) return *attempt;
  FailToFind(id);
}

fs::path Library::ChangeableDirectoryOf(const std::string& id) const {
  fs::path directory = DirectoryOf(id);
  // The directory of any other recording has its id as its name.
  if (directory.filename() == id) return directory;
  throw LibraryError(Say("library.isOfSet", {{"recording", Quoted(id)}}));
}

void Library::Rename(const std::string& id, const std::optional<std::string>& title,
                     const std::optional<std::string>& notes) const {
  recording::Retitle(ChangeableDirectoryOf(id), title, notes);
}

std::string Library::Bin(const std::string& id) const {
  const fs::path directory = ChangeableDirectoryOf(id);
  if (directory.parent_path().filename() == bin().filename()) {
    throw LibraryError(Say("library.isInBin", {{"recording", Quoted(id)}}));
  }
  // Held during the move, so that no recording can begin in between.
  const auto hold = Hold(directory);
  std::error_code error;
  fs::create_directory(bin(), error);
  if (error) throw LibraryError(bin().string() + " cannot be created: " + error.message());
  // Recordings of the same name meet in the bin: each gets the next free number.
  for (int number = 1;; ++number) {
    const std::string name = id + "~" + std::to_string(number);
    // Unique in both folders, as ids are looked up in both.
    if (fs::exists(bin() / name) || fs::exists(root_ / name)) continue;
    Move(directory, bin() / name);
    return name;
  }
}

std::string Library::Unbin(const std::string& id) const {
  const fs::path directory = DirectoryOf(id);
  if (directory.parent_path().filename() != bin().filename()) {
    throw LibraryError(Say("library.isNotInBin", {{"recording", Quoted(id)}}));
  }
  // The name is only chosen here. If another recording takes it in between, Move() fails: rename()
  // replaces no directory that contains files.
  const fs::path back = recording::NewDirectory(root_, NameOutsideOfBin(id));
  Move(directory, back);
  return back.filename().string();
}

Json Library::TimelineOf(const std::string& id) const {
  return library::TimelineOf(recording::OpenRecording(DirectoryOf(id)));
}

std::string Library::ZipOf(const std::string& id) const {
  return Zipped(DirectoryOf(id), kMaxZipped);
}

}  // namespace smile::library
