#pragma once

#include "base/json.h"
#include "task/structure.h"

namespace smile::task {

/// id -> position [units] and rotation [degrees].
Json PosesJson(const ObjectPoses& poses, double meters_per_unit);

/// As `smile describe --json` tells it (docs/results.md).
Json ToJson(const Structure& structure, double meters_per_unit);

/// Line by line, for people: `1. ShortPlank on the table`, …, effects, what matters.
std::vector<std::string> WordsOf(const Structure& structure, double meters_per_unit);

}  // namespace smile::task
