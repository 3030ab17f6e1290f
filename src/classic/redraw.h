#pragma once

#include <filesystem>
#include <functional>

#include "image/image.h"
#include "recording/demo_info.h"
#include "recording/progress.h"
#include "recording/recording.h"
#include "recording/trace.h"

namespace smile::classic {

/// Options for a copy of a recording.
struct RedrawOptions {
  recording::DemonstratorAppearance demonstrator = recording::DemonstratorAppearance::kInvisible;
  bool has_symbols = true;  ///< false: the classic view has pictures only
};

/// Draws a tick as the recording's eye saw it, in color. The image is valid until the next call.
using DrawMoment = std::function<const Image&(const recording::TraceTick& moment)>;

/// Copies a recording into a new directory, with its pictures drawn again: of the same moments,
/// under the same names. Everything else is the same: history, trace, texts. A failure leaves no
/// partial copy.
/// @param draw  empty: nothing is drawn, as for a recording that has no pictures.
/// @returns the number of pictures.
/// @throws InputError if the directory is there and not empty, the recording has no pictures, its
///         `frames.csv` or trace cannot be read, or something in it is a link.
/// @throws std::invalid_argument if texts are wanted that the recording does not have.
/// @throws std::runtime_error with path and reason if something cannot be written; or if `progress`
///         returns false.
std::size_t Redraw(const recording::Recording& recording, const std::filesystem::path& directory,
                   const RedrawOptions& options, const DrawMoment& draw,
                   const recording::Progress& progress = {});

}  // namespace smile::classic
