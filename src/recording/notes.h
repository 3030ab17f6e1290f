#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "recording/recording.h"
#include "sim/note.h"

namespace smile::recording {

/// Name of the file with the notes of the robot's program, in a recording.
inline constexpr const char* kNotesFile = "notes.jsonl";

/// Note and when it was made.
struct RecordedNote {
  std::uint64_t tick = 0;
  sim::Note note;

  bool operator==(const RecordedNote&) const = default;
};

/// Returns a line of `notes.jsonl`, without its end (docs/recording-format.md).
std::string LineOf(const RecordedNote& note);

/// Returns the notes of a recording in their order; none if it has no `notes.jsonl`. Lines that are
/// not notes are left out: they are for people only, and nothing depends on them.
std::vector<RecordedNote> NotesOf(const Recording& recording);

}  // namespace smile::recording
