#include "classic/redraw.h"

#include <array>
#include <charconv>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "base/diagnostic.h"
#include "base/files.h"
#include "base/wording.h"
#include "image/png.h"
#include "recording/beginning.h"
#include "recording/recording_files.h"
#include "recording/segment_files.h"
#include "recording/time_range.h"
#include "recording/trace_reader.h"
#include "scene_xml/mesh_files.h"

namespace smile::classic {
namespace {

constexpr std::size_t kMaxIndexBytes = 256u << 20, kMaxInfoBytes = 1u << 20;

/// A line of `frames.csv` with a picture.
struct PictureLine {
  std::uint64_t tick = 0;
  int segment = 0;
  std::string image;  ///< from the recording's directory
};

/// Takes a number from the front of a text, and the letter behind it.
std::optional<std::uint64_t> TakeNumber(std::string_view* text, char letter) {
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), number);
  const auto size = static_cast<std::size_t>(end - text->data());
  if (error != std::errc() || size >= text->size() || (*text)[size] != letter) return std::nullopt;
  text->remove_prefix(size + 1);
  return number;
}

/// Reads `frame,tick,image`; no image: nullopt.
std::optional<PictureLine> ReadPictureLine(const std::filesystem::path& path, int number,
                                           std::string_view line) {
  const auto fail = [&](const std::string& expected) {
    throw InputError({path.string(), number, "",
                      "found " + Quoted(std::string(line)) + ", expected " + expected});
  };
  std::string_view rest = line;
  const auto frame = TakeNumber(&rest, ','), tick = TakeNumber(&rest, ',');
  if (!frame || !tick) fail("frame,tick,image");
  if (rest.empty()) return std::nullopt;
  const std::string image(rest);
  const auto segment = TakeNumber(&rest, '/'), picture = TakeNumber(&rest, '.');
  if (!segment || *segment > 1'000'000'000 || !picture || rest != "png") {
    fail("a picture like 3/14.png");
  }
  return PictureLine{
      .tick = tick.value_or(0), .segment = static_cast<int>(segment.value_or(0)), .image = image};
}

/// The pictures of the classic view, in order of time. A last line without its end is none.
std::vector<PictureLine> PicturesOf(const std::filesystem::path& path) {
  const std::string text = ReadFile(path, kMaxIndexBytes);
  std::vector<PictureLine> pictures;
  int number = 0;
  for (std::size_t start = 0;;) {
    const std::size_t end = text.find('\n', start);
    if (end == std::string::npos) return pictures;
    const std::string_view line(text.data() + start, end - start);
    start = end + 1;
    if (++number == 1) continue;  // the head
    auto picture = ReadPictureLine(path, number, line);
    if (!picture) continue;
    if (!pictures.empty() && picture->tick <= pictures.back().tick) {
      throw InputError({path.string(), number, "",
                        "found tick " + std::to_string(picture->tick) + ", expected more than " +
                            std::to_string(pictures.back().tick)});
    }
    pictures.push_back(*std::move(picture));
  }
}

void RequireNoLink(const std::filesystem::path& path) {
  if (!std::filesystem::is_symlink(path)) return;
  throw InputError(
      {path.string(), 0, "", "is a link; expected a recording whose files are its own to copy it"});
}

/// Copies a file or a folder, if it is there.
void CopyOf(const std::filesystem::path& from, const std::filesystem::path& to) {
  RequireNoLink(from);
  if (std::filesystem::is_directory(from)) {
    MakeDirectories(to);
    for (const auto& entry : std::filesystem::directory_iterator(from)) {
      CopyOf(entry.path(), to / entry.path().filename());
    }
  } else if (std::filesystem::is_regular_file(from)) {
    std::error_code error;
    std::filesystem::copy_file(from, to, error);
    if (error) throw std::runtime_error(to.string() + ": cannot be written: " + error.message());
  }
}

void CopyTexts(const std::filesystem::path& from, const std::filesystem::path& to,
               bool has_symbols) {
  for (int segment = 0; std::filesystem::is_directory(recording::SegmentPictures(from, segment));
       ++segment) {
    MakeDirectories(recording::SegmentPictures(to, segment));
    if (has_symbols)
      CopyOf(recording::SegmentText(from, segment), recording::SegmentText(to, segment));
  }
}

std::size_t DrawAll(const recording::Recording& recording, const std::filesystem::path& directory,
                    const DrawMoment& draw, const recording::Progress& progress) {
  if (!draw) return 0;
  const std::filesystem::path index = recording.directory / "frames.csv";
  const std::vector<PictureLine> pictures = PicturesOf(index);
  recording::TraceReader trace(recording);
  auto moment = trace.Next();
  for (const PictureLine& picture : pictures) {
    while (moment && moment->tick < picture.tick) moment = trace.Next();
    if (!moment || moment->tick != picture.tick) {
      throw InputError({index.string(), 0, "",
                        "has a picture of tick " + std::to_string(picture.tick) +
                            ", which the trace does not have"});
    }
    MakeDirectories(recording::SegmentPictures(directory, picture.segment));
    WritePng(directory / picture.image, draw(*moment));
    const bool goes_on =
        !progress || progress(recording::SecondsInto(recording, picture.tick),
                              recording::SecondsInto(recording, pictures.back().tick));
    if (!goes_on) throw std::runtime_error("interrupted");
  }
  return pictures.size();
}

std::size_t RedrawInto(const recording::Recording& recording,
                       const std::filesystem::path& directory, const RedrawOptions& options,
                       const DrawMoment& draw, const recording::Progress& progress) {
  constexpr std::array kCopied{"scene.xml",
                               scene_xml::kMeshFolder,
                               recording::kRobotFolder,
                               recording::kOldRobotFile,
                               "robot.robot.json",
                               "commands.jsonl",
                               "trace.bin",
                               "frames.csv",
                               "brain.log"};
  recording::BeginningMark mark(directory);
  for (const char* name : kCopied) CopyOf(recording.directory / name, directory / name);
  CopyTexts(recording.directory, directory, options.has_symbols);
  const std::size_t num_pictures = DrawAll(recording, directory, draw, progress);
  recording::DemoInfo info = recording.info;
  info.format = recording::kFormatVersion;
  info.has_symbols = options.has_symbols;
  info.demonstrator = options.demonstrator;
  // As it is if it says the same: written anew, a number may end in another bit.
  const std::string text = info == recording.info
                               ? ReadFile(recording.directory / "demo.json", kMaxInfoBytes)
                               : recording::ToJsonText(info);
  // Last: whatever has it can be opened.
  WriteFile(directory / "demo.json", text);
  mark.Remove();
  return num_pictures;
}

}  // namespace

std::size_t Redraw(const recording::Recording& recording, const std::filesystem::path& directory,
                   const RedrawOptions& options, const DrawMoment& draw,
                   const recording::Progress& progress) {
  recording::RequireFree(directory);
  if (draw && !recording.info.eye) {
    throw InputError({recording.directory.string(), 0, "",
                      "has no pictures; expected a recording with some to draw them again"});
  }
  if (options.has_symbols && !recording.info.has_symbols) {
    throw std::invalid_argument(recording.directory.string() +
                                ": has no texts, its copy can have none");
  }
  std::error_code error;
  const bool was_there =
      std::filesystem::exists(directory, error) && !recording::IsAbandoned(directory);
  try {
    return RedrawInto(recording, directory, options, draw, progress);
  } catch (...) {
    if (!was_there) std::filesystem::remove_all(directory, error);
    throw;
  }
}

}  // namespace smile::classic
