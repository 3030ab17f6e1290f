#pragma once

#include "base/json.h"
#include "task/structure.h"
#include "texts/user_message.h"

namespace smile::task {

/// Returns an object from ids to `position` [units] and `rotation` (fixed axes x, y, z) [degrees].
Json PosesJson(const ObjectPoses& poses, double meters_per_unit);

/// Returns the structure in the format of `smile describe --json` (docs/results.md).
Json ToJson(const Structure& structure, double meters_per_unit);

/// Returns the place of an object for people, as `Red1 on ShortPlank`. An object may have several
/// supports.
texts::UserMessage PlaceWordsOf(const std::string& id, const std::vector<Relation>& relations);

/// Returns a description for people, line by line: `1. ShortPlank on the table`, …, effects,
/// attention.
std::vector<std::string> WordsOf(const Structure& structure, double meters_per_unit);

}  // namespace smile::task
