#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/json.h"
#include "demonstrator/hand.h"
#include "texts/user_message.h"

namespace smile::recording {

/// What was no longer as in the demonstration when commands of it acted again.
struct Conflict {
  std::optional<demonstrator::HandName> hand;  ///< nullopt: it was no command of a hand
  double seconds = 0;                          ///< from the start of the demonstration
  texts::UserMessage reason;

  bool operator==(const Conflict&) const = default;
};

/// `conflicts` of `conflicts.json`, of reports of edits, and of the page's protocol: each with its
/// `reason` in English, and with `message`, the same as the page renders it.
Json ToJson(const std::vector<Conflict>& conflicts);

inline constexpr std::size_t kMaxConflicts = 1000;

/// Writes `conflicts.json` into a recording; no file if there are none. Of more than kMaxConflicts,
/// or very long reasons, the last ones are left out.
/// @throws std::runtime_error with path and reason.
void WriteConflicts(const std::filesystem::path& directory, const std::vector<Conflict>& conflicts);

/// Reads `conflicts.json` of a recording; empty without one.
/// @throws InputError naming the place in the file, what was found and what was expected.
std::vector<Conflict> ReadConflicts(const std::filesystem::path& directory);

/// Removes those after a moment [s], from which a recording is continued.
/// @throws as ReadConflicts() and WriteConflicts().
void RemoveConflictsAfter(const std::filesystem::path& directory, double seconds);

}  // namespace smile::recording
