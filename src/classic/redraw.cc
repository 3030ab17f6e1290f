// Copies a recording file by file, except the pictures, which a caller draws for the same ticks.
// The trace and not the log is the source: what was recorded is drawn, also where physics would
// replay differently today.

#include "classic/redraw.h"

#include <array>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "base/diagnostic.h"
#include "base/files.h"
#include "classic/frame_index.h"
#include "image/png.h"
#include "recording/beginning.h"
#include "recording/recording_files.h"
#include "recording/segment_files.h"
#include "recording/time_range.h"
#include "recording/trace_reader.h"
#include "scene_xml/mesh_files.h"

namespace smile::classic {
namespace {

// Far above any demo.json.
constexpr std::size_t kMaxInfoBytes = 1u << 20;

void RequireNoLink(const std::filesystem::path& path) {
  if (!std::filesystem::is_symlink(path)) return;
  throw InputError(
      {path.string(), 0, "", "is a link; only a recording with its own files can be copied"});
}

/// Copies a file or a folder if it exists; links are refused, as they may lead out of the
/// recording.
void CopyOf(const std::filesystem::path& from, const std::filesystem::path& to) {
  RequireNoLink(from);
  // A missing file is no error: older recordings lack some of them, and not every run has a brain.
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

/// Makes the folders of all segments and copies the texts, if wanted. Pictures are drawn later.
void CopyTexts(const std::filesystem::path& from, const std::filesystem::path& to,
               bool has_symbols) {
  // Segments are numbered without gaps, so the first missing folder ends them.
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
  std::vector<FrameEntry> pictures = ReadFrameIndex(index);
  std::erase_if(pictures, [](const FrameEntry& entry) { return entry.image.empty(); });
  // Pictures are in order of ticks, so one pass through the trace is enough.
  recording::TraceReader trace(recording);
  for (const FrameEntry& picture : pictures) {
    const recording::TraceTick moment = ReadMomentOf(picture, index, &trace);
    MakeDirectories(recording::SegmentPictures(directory, picture.segment));
    WritePng(directory / picture.image, draw(moment));
    const bool should_continue =
        !progress || progress(recording::SecondsInto(recording, picture.tick),
                              recording::SecondsInto(recording, pictures.back().tick));
    if (!should_continue) throw std::runtime_error("interrupted");
  }
  return pictures.size();
}

std::size_t RedrawInto(const recording::Recording& recording,
                       const std::filesystem::path& directory, const RedrawOptions& options,
                       const DrawMoment& draw, const recording::Progress& progress) {
  // A list instead of everything: what else lies in the folder is not part of the recording.
  constexpr std::array kCopied{"scene.xml",
                               scene_xml::kMeshFolder,
                               recording::kRobotFolder,
                               recording::kOldRobotFile,
                               "robot.robot.json",
                               "commands.jsonl",
                               "trace.bin",
                               "trace.index",
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
  // Unchanged information is copied as text, since writing it again could change the last bit of a
  // number.
  const std::string text = info == recording.info
                               ? ReadFile(recording.directory / "demo.json", kMaxInfoBytes)
                               : recording::ToJsonText(info);
  // Written last: a directory with demo.json can be opened.
  WriteFile(directory / "demo.json", text);
  mark.Remove();
  return num_pictures;
}

}  // namespace

std::size_t Redraw(const recording::Recording& recording, const std::filesystem::path& directory,
                   const RedrawOptions& options, const DrawMoment& draw,
                   const recording::Progress& progress) {
  recording::RequireNewDirectory(directory);
  if (draw && !recording.info.eye) {
    throw InputError({recording.directory.string(), 0, "",
                      "has no pictures, expected a recording with pictures"});
  }
  if (options.has_symbols && !recording.info.has_symbols) {
    throw std::invalid_argument(recording.directory.string() +
                                ": has no texts, so a copy cannot have texts");
  }
  std::error_code error;
  // A directory that existed empty stays; one that this call made is removed after a failure.
  const bool was_there =
      std::filesystem::exists(directory, error) && !recording::IsAbandoned(directory);
  try {
    return RedrawInto(recording, directory, options, draw, progress);
    // Whole or not at all: a failed copy leaves nothing behind.
  } catch (...) {
    if (!was_there) std::filesystem::remove_all(directory, error);
    throw;
  }
}

}  // namespace smile::classic
