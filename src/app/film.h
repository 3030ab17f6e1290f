#pragma once

#include <filesystem>
#include <string>

#include "picture/photographer.h"
#include "record/recording.h"
#include "record/time_range.h"

namespace smile::app {

struct FilmOptions {
  picture::Shot shot;
  double frames_per_second = 30;
  double speed = 1;         ///< 2 shows two seconds in one
  record::TimeRange range;  ///< of the demonstration
  record::DemonstratorLook demonstrator = record::DemonstratorLook::kInvisible;
  std::string progress;  ///< shown while it works; empty for silence
};

// Both film a recording from its trace, without physics. Frame k shows the first tick that is at
// least k / frames_per_second * speed after the range's start, as the classic view does. When the
// user asks to end, what was filmed until then is whole.

/// Makes one file that players show.
/// @throws std::invalid_argument if the range is none of the recording's, or there is no such
///         camera.
/// @throws InputError if the trace cannot be read; std::runtime_error if the film cannot be
/// written.
void Film(const record::Recording& recording, const std::filesystem::path& mp4,
          const FilmOptions& options = {});

/// Makes a new directory of numbered pictures `000000.png`, one for each frame and channel, with a
/// `frames.csv` that tells tick, seconds since the demonstration began and picture of every frame.
/// Throws as Film() does, and
/// @throws InputError if the directory is there and not empty.
void FilmAsPictures(const record::Recording& recording, const std::filesystem::path& directory,
                    const FilmOptions& options = {});

}  // namespace smile::app
