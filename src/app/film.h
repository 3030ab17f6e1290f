#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "record/recording.h"
#include "record/trace.h"
#include "sim/eye.h"

namespace smile::app {

struct FilmOptions {
  std::string camera = "nice";  ///< see ViewNames()
  sim::EyeSpec size{.width_px = 1280, .height_px = 720};
  double frames_per_second = 30;
  double speed = 1;      ///< 2 shows two seconds in one
  std::string progress;  ///< shown while it works; empty for silence
};

/// Frames that were not to be seen at that moment: a hidden robot's; from the eye, the head it sits
/// in.
std::vector<int> HiddenFrames(const record::TraceTick& moment, const sim::Simulation& simulation,
                              bool is_eye);

/// Films a recording from outside, from its trace, without physics.
/// @throws InputError if the trace cannot be read; std::runtime_error if the film cannot be
/// written.
void Film(const record::Recording& recording, const std::filesystem::path& mp4,
          const FilmOptions& options = {});

/// The last moment of a recording; nullopt when its trace holds none.
std::optional<record::TraceTick> LastMoment(const record::Recording& recording);

}  // namespace smile::app
