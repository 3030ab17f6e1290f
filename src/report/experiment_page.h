#pragma once

#include <string>
#include <vector>

#include "base/json.h"
#include "recording/recording.h"

namespace smile::report {

/// A file beside the page.
struct Enclosure {
  std::string file;   ///< its name, or path from there
  std::string words;  ///< what it is
};

/// One experiment: somebody showed a task, the robot did it.
struct ExperimentOutcome {
  std::string name;
  const recording::Recording& demonstration;
  const recording::Recording& imitation;
  const Json& result;  ///< `result.json`, as task::ResultOf() and its caller have made it
  std::vector<Enclosure> enclosures;
};

/// `report.html`: an experiment for people, as one page that stands for itself, with pictures.
/// @throws InputError if a recording's trace cannot be read; std::runtime_error if nothing can draw
///         here.
std::string PageOf(const ExperimentOutcome& outcome);

}  // namespace smile::report
