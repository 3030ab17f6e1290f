#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "study/event_log.h"
#include "study/questionnaire.h"
#include "study/steps.h"

namespace smile::study {

/// One attempt at a task or the practice.
struct Trial {
  std::string step;
  int attempt = 1;
  std::string folder;    ///< below that of the participant, see TrialFolder()
  std::string began_at;  ///< UTC
  bool has_ended = false;
  std::string reason;     ///< `done`, `limit`, or why it was interrupted
  std::string recording;  ///< name of its directory in `folder`; empty: none
  double wall_seconds = 0;
  bool is_success = false;

  /// Returns true if the participant, or the limit of time, ended it.
  bool is_complete() const { return has_ended && (reason == "done" || reason == "limit"); }
  bool operator==(const Trial&) const = default;
};

/// Returns `trials/task-tower-ghost-1`.
std::string TrialFolder(const std::string& step, int attempt);

/// What a participant has done, from the events in order.
struct Progress {
  bool is_declined = false;
  std::string consent_sha256, consented_at;     ///< empty before the consent
  std::set<std::string> done;                   ///< names of steps
  std::map<std::string, std::string> began_at;  ///< of steps
  std::vector<Trial> trials;
  std::map<std::string, Answers> answers;  ///< by step
  std::string completion_code;             ///< empty before the end

  /// Returns the trials of a step, in order.
  std::vector<Trial> TrialsOf(const std::string& step) const;
  /// Returns the step that is next; the last one if all are done.
  const Step& Next(const std::vector<Step>& steps) const;
};

/// Adds an event.
/// @throws std::invalid_argument if it cannot follow the ones before.
void Add(const Json& event, Progress* progress);
/// @param file  of the events, for messages.
/// @throws InputError with the line of an event that cannot be.
Progress ProgressOf(const std::vector<Json>& events, const std::string& file);

}  // namespace smile::study
