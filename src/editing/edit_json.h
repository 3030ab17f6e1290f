#pragma once

#include <vector>

#include "base/json.h"
#include "editing/edit.h"
#include "editing/re_simulation.h"

namespace smile::editing {

inline constexpr std::size_t kMaxEdits = 1000;

/// Parses a list of edits, in order of application:
///
///     [{"do":"drop","first":1,"last":2}, {"do":"move","segment":5,"place":2},
///      {"do":"trim","segment":3,"from":0.5,"to":2}, {"do":"max_pause","seconds":0.5},
///      {"do":"retime","segment":3,"seconds":1.5}, {"do":"speed","factor":1.5},
///      {"do":"shift","first":3,"last":4,"seconds":-0.5},
///      {"do":"stretch","first":3,"last":4,"factor":1.2}]
///
/// @throws std::invalid_argument saying which, what was found and what was expected.
std::vector<Edit> ParseEdits(const Json& json);

/// Returns the demonstration after all edits.
/// @throws std::invalid_argument as Edited(), saying which.
recording::Demonstration EditedByAll(recording::Demonstration demonstration,
                                     const std::vector<Edit>& edits);

/// Returns the report in the format of docs/editing.md.
Json ToJson(const EditReport& report);
/// Returns the same for the page: the reasons of left-out commands are messages with ids.
Json ToPageJson(const EditReport& report);

}  // namespace smile::editing
