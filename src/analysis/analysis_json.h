#pragma once

#include "analysis/analysis.h"
#include "base/json.h"

namespace smile::analysis {

inline constexpr int kAnalysisFormat = 2;

/// Returns the content of `analysis.json` (docs/analysis.md).
Json ToJson(const Analysis& analysis);

}  // namespace smile::analysis
