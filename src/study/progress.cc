#include "study/progress.h"

#include <algorithm>
#include <functional>
#include <stdexcept>

#include "base/diagnostic.h"

namespace smile::study {
namespace {

std::string TextOf(const Json& event, const char* name) {
  if (!event.contains(name) || !event[name].is_string()) {
    throw std::invalid_argument("expected the member \"" + std::string(name) + "\", a text");
  }
  return event[name].get<std::string>();
}

void AddConsent(const Json& event, Progress* progress) {
  progress->is_declined = !event.value("agreed", false);
  if (progress->is_declined) return;
  progress->consent_sha256 = TextOf(event, "sha256");
  progress->consented_at = TextOf(event, "at");
}

void BeginTrial(const Json& event, Progress* progress) {
  progress->trials.push_back({.step = TextOf(event, "step"),
                              .attempt = event.value("attempt", 1),
                              .folder = TextOf(event, "folder"),
                              .began_at = TextOf(event, "at")});
}

void EndTrial(const Json& event, Progress* progress) {
  if (progress->trials.empty() || progress->trials.back().has_ended ||
      progress->trials.back().step != TextOf(event, "step")) {
    throw std::invalid_argument("expected the begin of the trial before its end");
  }
  Trial& trial = progress->trials.back();
  trial.has_ended = true;
  trial.reason = TextOf(event, "reason");
  trial.recording = event.value("recording", "");
  trial.wall_seconds = event.value("wall_seconds", 0.0);
  trial.is_success = event.value("success", false);
}

void AddAnswers(const Json& event, Progress* progress) {
  Answers answers;
  if (event.contains("answers") && event["answers"].is_object()) {
    for (const auto& [name, answer] : event["answers"].items()) answers[name] = answer;
  }
  progress->answers[TextOf(event, "step")] = answers;
}

}  // namespace

std::string TrialFolder(const std::string& step, int attempt) {
  return "trials/" + step + "-" + std::to_string(attempt);
}

std::vector<Trial> Progress::TrialsOf(const std::string& step) const {
  std::vector<Trial> found;
  std::ranges::copy_if(trials, std::back_inserter(found),
                       [&](const Trial& trial) { return trial.step == step; });
  return found;
}

const Step& Progress::Next(const std::vector<Step>& steps) const {
  for (const Step& step : steps) {
    if (!done.contains(step.name)) return step;
  }
  return steps.back();
}

void Add(const Json& event, Progress* progress) {
  const std::string what = TextOf(event, "event");
  if (what == "consent") AddConsent(event, progress);
  if (what == "begin") progress->began_at.emplace(TextOf(event, "step"), TextOf(event, "at"));
  if (what == "trial") BeginTrial(event, progress);
  if (what == "trial_end") EndTrial(event, progress);
  if (what == "answers") AddAnswers(event, progress);
  if (what == "done") progress->done.insert(TextOf(event, "step"));
  if (what == "code") progress->completion_code = TextOf(event, "code");
}

Progress ProgressOf(const std::vector<Json>& events, const std::string& file) {
  Progress progress;
  for (std::size_t k = 0; k < events.size(); ++k) {
    try {
      Add(events[k], &progress);
    } catch (const std::exception& error) {
      throw InputError(
          Diagnostic{.file = file, .line = static_cast<int>(k) + 1, .message = error.what()});
    }
  }
  return progress;
}

}  // namespace smile::study
