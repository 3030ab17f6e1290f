#pragma once

#include "analysis/analysis.h"
#include "base/json.h"
#include "texts/message_json.h"

namespace smile::analysis {

inline constexpr int kAnalysisFormat = 2;

/// Returns the content of `analysis.json` (docs/analysis.md).
/// @param rendered  how messages appear: in English, or as texts::ToJson() for the page.
Json ToJson(const Analysis& analysis,
            Json (*rendered)(const texts::UserMessage& message) = texts::EnglishOf);

}  // namespace smile::analysis
