#pragma once

#include <filesystem>

#include "picture/recording_renderer.h"
#include "recording/progress.h"
#include "recording/recording.h"
#include "recording/time_range.h"

namespace smile::picture {

struct FilmOptions {
  RenderRequest request;
  double frames_per_second = 30;
  double speed = 1;            ///< 2 shows two seconds in one
  recording::TimeRange range;  ///< of the demonstration
  recording::DemonstratorAppearance demonstrator = recording::DemonstratorAppearance::kInvisible;
};

// Both functions film a recording from its trace, without physics. Frame k shows the first tick
// that is at least k / frames_per_second * speed after the range's start, as the classic view does.

/// Writes a video file; none if cancelled by `progress`.
/// @throws std::invalid_argument if the range is not within the recording, or the camera does not
///         exist.
/// @throws InputError if the trace cannot be read; std::runtime_error if the film cannot be
///         written, or `progress` cancels it.
void Film(const recording::Recording& recording, const std::filesystem::path& mp4,
          const FilmOptions& options = {}, const recording::Progress& progress = {});

/// Writes a new directory of numbered pictures `000000.png`, one for each frame and channel, with a
/// `frames.csv` of tick, seconds since the demonstration began and picture of every frame. If
/// `progress` cancels it, the pictures written so far are kept.
/// @throws InputError if the directory exists and is not empty.
void FilmAsPictures(const recording::Recording& recording, const std::filesystem::path& directory,
                    const FilmOptions& options = {}, const recording::Progress& progress = {});

}  // namespace smile::picture
