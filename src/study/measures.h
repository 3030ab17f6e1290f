#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "model/relations.h"

namespace smile::study {

/// What a recording says about a trial. It can be computed again at any time.
struct Measures {
  double seconds = 0;  ///< of simulated time
  std::size_t undos = 0, redos = 0;
  std::size_t grasps = 0;   ///< by hands, without those that were undone
  std::size_t falls = 0;    ///< of objects from the table, without those that were undone
  double path_meters = 0;   ///< that objects moved while hands held them
  bool is_success = false;  ///< all relations of the goal hold at the end

  bool operator==(const Measures&) const = default;
};

/// Measures a recording.
/// @throws InputError if it cannot be read.
Measures MeasuresOf(const std::filesystem::path& recording,
                    const std::vector<model::Relation>& goal);

/// What the log of a participant's mouse, keys and window says about a trial.
struct InputMeasures {
  std::size_t camera_moves = 0;  ///< after rests of at least half a second
  std::size_t focus_losses = 0;  ///< of the page

  bool operator==(const InputMeasures&) const = default;
};

/// Name of the log of mouse, keys, camera and focus, beside the recording of a trial.
inline constexpr const char* kInputLog = "input.jsonl";

/// Reads an input log. A missing file counts as an empty one, and so does an incomplete last line.
/// @throws InputError if it cannot be read.
InputMeasures InputMeasuresOf(const std::filesystem::path& file);

}  // namespace smile::study
