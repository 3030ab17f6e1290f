#pragma once

#include <string>

#include "report/evaluation.h"

namespace smile::report {

/// Returns `report.html`: an evaluation for people, as one self-contained page.
std::string PageOf(const Evaluation& evaluation);

}  // namespace smile::report
