#pragma once

#include <string>

#include "report/evaluation.h"

namespace smile::report {

/// `report.html`: an evaluation for people, as one page that stands for itself.
std::string PageOf(const Evaluation& evaluation);

}  // namespace smile::report
