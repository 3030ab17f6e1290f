#pragma once

#include <filesystem>

#include "brain/brain_values.h"
#include "sim/eye.h"

namespace smile::experiment {

/// Returns the frames of a demonstration's classic view, for a brain that watches it.
///
/// A frame without a picture shows the one before; frames before the first picture are left out. A
/// recording without pictures is drawn, as the given eye would have seen it. Nothing is read before
/// the first frame is asked for.
/// @param demonstration  recording.
/// @param eye            draws; nullptr if nothing can be drawn. Must outlive the frames.
/// The frames throw InputError or std::runtime_error if files of the recording cannot be read, and
/// std::invalid_argument if it has no such eye.
brain::DemonstrationFrames FramesOf(std::filesystem::path demonstration, sim::Eye* eye);

}  // namespace smile::experiment
