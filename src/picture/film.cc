#include "picture/film.h"

#include <cstdio>
#include <functional>
#include <stdexcept>
#include <system_error>

#include "base/diagnostic.h"
#include "base/files.h"
#include "base/wording.h"
#include "recording/append_file.h"
#include "recording/markers.h"
#include "recording/trace_reader.h"
#include "video/video_writer.h"

// Films are functions of the trace: each frame is rendered from the recorded poses, without
// physics. A film runs at its own rate; `speed` maps its time to that of the recording.

namespace smile::picture {
namespace {

/// Callback for the picture of a frame.
using AddFrame = std::function<void(std::uint64_t frame, std::uint64_t tick, const Image& image)>;

/// Renders each frame of a range of a recording.
/// @returns false if `progress` cancelled it.
bool ForEachFrame(const recording::Recording& recording, const recording::TickRange& range,
                  const FilmOptions& options, RecordingRenderer* renderer,
                  const recording::Progress& progress, const AddFrame& add) {
  const double rate = options.frames_per_second / options.speed;
  const double total = recording::SecondsInto(recording, range.last);
  // Frames per second of the recording, not of the film.
  const auto is_due = [&](std::uint64_t frame, std::uint64_t tick) {
    return recording::IsFrameDue(frame, tick - range.first, rate);
  };
  const auto report_progress = [&](std::uint64_t tick) {
    return !progress || progress(recording::SecondsInto(recording, tick), total);
  };
  recording::TraceReader trace(recording);
  const recording::MarkerTrack markers(recording);
  std::uint64_t frame = 0;
  for (auto moment = trace.At(range.first); moment && moment->tick <= range.last;
       moment = trace.Next()) {
    if (!report_progress(moment->tick)) return false;
    if (!is_due(frame, moment->tick)) continue;
    const Image& image = renderer->Take(*moment, markers.At(moment->tick));
    // A rate above that of the ticks shows a tick more than once.
    for (; is_due(frame, moment->tick); ++frame) {
      add(frame, moment->tick, image);
      if (!report_progress(moment->tick)) return false;
    }
  }
  return true;
}

/// Makes a directory; an existing empty one will do.
/// @throws InputError if it has content.
void MakeNewDirectory(const std::filesystem::path& directory) {
  std::error_code error;
  if (std::filesystem::exists(directory, error) && !std::filesystem::is_empty(directory, error)) {
    throw InputError({directory.string(), 0, "",
                      "exists already, expected a new directory; pictures are never overwritten"});
  }
  MakeDirectories(directory);
}

std::string NumberedName(std::uint64_t frame) {
  char name[40];
  // Six digits sort correctly up to four and a half hours at 60 frames per second.
  std::snprintf(name, sizeof name, "%06llu.png", static_cast<unsigned long long>(frame));
  return name;
}

/// Encodes the frames.
/// @throws std::runtime_error if `progress` cancels it.
void FilmInto(const std::filesystem::path& mp4, const recording::Recording& recording,
              const recording::TickRange& range, const FilmOptions& options,
              const recording::Progress& progress, RecordingRenderer* renderer) {
  video::VideoWriter video(mp4, options.request.width_px, options.request.height_px,
                           options.frames_per_second);
  const bool is_whole = ForEachFrame(
      recording, range, options, renderer, progress,
      [&video](std::uint64_t, std::uint64_t, const Image& image) { video.Add(image); });
  // By an exception, so that the caller removes the partial file.
  if (!is_whole) throw std::runtime_error("interrupted");
  video.Finish();
}

}  // namespace

void Film(const recording::Recording& recording, const std::filesystem::path& mp4,
          const FilmOptions& options, const recording::Progress& progress) {
  const recording::TickRange range = TicksOf(options.range, recording);
  const model::Model& model = *recording.model;
  const auto demonstrator = DemonstratorOf(recording, options.demonstrator);
  RecordingRenderer renderer(model, options.request, demonstrator.get());
  // Written under another name until complete: an older film is not replaced by a partial one.
  const std::filesystem::path part = mp4.string() + ".part.mp4";
  try {
    FilmInto(part, recording, range, options, progress, &renderer);
    std::filesystem::rename(part, mp4);
  } catch (...) {
    std::error_code error;
    std::filesystem::remove(part, error);
    throw;
  }
}

void FilmAsPictures(const recording::Recording& recording, const std::filesystem::path& directory,
                    const FilmOptions& options, const recording::Progress& progress) {
  const recording::TickRange range = TicksOf(options.range, recording);
  const model::Model& model = *recording.model;
  const auto demonstrator = DemonstratorOf(recording, options.demonstrator);
  RecordingRenderer renderer(model, options.request, demonstrator.get());
  MakeNewDirectory(directory);
  recording::AppendFile index(directory / "frames.csv");
  index.Append("frame,tick,seconds,image\n");
  ForEachFrame(recording, range, options, &renderer, progress,
               [&](std::uint64_t frame, std::uint64_t tick, const Image& image) {
                 const auto written = WriteChannels(directory / NumberedName(frame), image,
                                                    options.request.channels);
                 // After its picture: each line of the index names a file that exists.
                 index.Append(std::to_string(frame) + "," + std::to_string(tick) + "," +
                              NumberText(recording::SecondsInto(recording, tick)) + "," +
                              written.front().filename().string() + "\n");
               });
}

}  // namespace smile::picture
