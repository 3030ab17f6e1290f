#pragma once

#include <string>

#include "report/study_results.h"

namespace smile::report {

/// Returns the page of a study: success of each condition with Wilson's intervals, all measures
/// with Student's intervals, and differences to the first condition with effect sizes.
std::string StudyPage(const StudyResults& results);

}  // namespace smile::report
