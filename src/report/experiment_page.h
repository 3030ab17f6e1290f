#pragma once

#include <string>
#include <vector>

#include "base/json.h"
#include "recording/recording.h"

namespace smile::report {

/// File beside the page.
struct Enclosure {
  std::string file;   ///< name or relative path
  std::string words;  ///< description
};

/// Outcome of an experiment: a task was demonstrated, and the robot imitated it.
struct ExperimentOutcome {
  std::string name;
  const recording::Recording& demonstration;
  const recording::Recording& imitation;
  const Json& result;  ///< `result.json`, see task::ResultOf()
  std::vector<Enclosure> enclosures;
};

/// Returns `report.html`: an experiment for people, as one self-contained page with pictures.
/// @throws InputError if a recording's trace cannot be read; std::runtime_error if rendering is
///         unavailable.
std::string PageOf(const ExperimentOutcome& outcome);

}  // namespace smile::report
