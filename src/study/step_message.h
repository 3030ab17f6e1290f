#pragma once

#include "base/json.h"
#include "study/progress.h"

namespace smile::study {

/// Returns what a page needs to show a step, as the message `step` (docs/studies.md).
Json StepMessage(const Definition& study, const std::vector<Step>& steps, const Step& step,
                 const Progress& progress);

/// Returns the paths of all pictures and films of a study, which pages may ask for.
std::vector<std::string> PublicFilesOf(const Definition& study);

}  // namespace smile::study
