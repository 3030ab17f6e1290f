#pragma once

#include <string>
#include <vector>

#include "base/json.h"

namespace smile::datasets {

/// Returns what `smile generate` can draw for each attempt, as pages offer it: kinds, each with
/// named degrees and their ranges: `[{"kind","degrees":[{"name","ranges"}]}]`; see
/// docs/generation.md.
Json DescribeVariations();

/// Returns the arguments of `smile generate` for the chosen degrees: of each kind at most one, as
/// `{"noise":"mild"}`.
/// @throws page::RequestError if there is no such kind or degree.
std::vector<std::string> VariationArguments(const Json& chosen);

}  // namespace smile::datasets
