#include "study/check.h"

#include <algorithm>
#include <map>
#include <set>

#include "base/diagnostic.h"
#include "recording/recording.h"
#include "study/orders.h"
#include "study/progress.h"
#include "web_server/digest.h"

namespace smile::study {
namespace {

std::string CountOf(std::size_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

/// Reports what a complete trial lacks.
void CheckTrial(const Participant& participant, const Step& step, const Progress& progress,
                std::vector<std::string>* findings) {
  const std::vector<Trial> trials = progress.TrialsOf(step.name);
  const auto complete = std::ranges::find_if(trials, &Trial::is_complete);
  const std::string where = participant.id + ": " + step.name + ": ";
  if (complete == trials.end()) return findings->push_back(where + "no complete trial");
  const auto directory = participant.folder / complete->folder / complete->recording;
  if (complete->recording.empty() || !recording::IsRecording(directory)) {
    findings->push_back(where + "its recording is missing");
  }
}

void CheckParticipant(const Definition& study, const Participant& participant,
                      const Progress& progress, std::vector<std::string>* findings) {
  if (progress.consent_sha256 != web_server::Sha256(study.consent)) {
    findings->push_back(participant.id + ": consent: found the hash " + progress.consent_sha256 +
                        ", expected that of the text, " + web_server::Sha256(study.consent));
  }
  for (const Step& step : StepsOf(study, participant.number)) {
    if (!progress.done.contains(step.name)) continue;
    if (step.is_trial()) CheckTrial(participant, step, progress, findings);
    if (step.kind == StepKind::kQuestions && !progress.answers.contains(step.name)) {
      findings->push_back(participant.id + ": " + step.name + ": no answers");
    }
  }
}

/// Reports conditions that were not equally often at each position.
void CheckBalance(const Definition& study, const std::vector<int>& complete, CheckResult* result) {
  const std::size_t n = study.conditions.size();
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> counts;  // by position, condition
  for (const int number : complete) {
    const auto order = BalancedOrder(n, static_cast<std::size_t>(number) - 1);
    for (std::size_t position = 0; position < n; ++position) ++counts[{position, order[position]}];
  }
  std::size_t least = complete.size(), most = 0;
  for (std::size_t position = 0; position < n; ++position) {
    for (std::size_t condition = 0; condition < n; ++condition) {
      least = std::min(least, counts[{position, condition}]);
      most = std::max(most, counts[{position, condition}]);
    }
  }
  if (least == most) return;
  result->findings.push_back("order: each condition is between " + std::to_string(least) + " and " +
                             std::to_string(most) +
                             " times at a position, expected equal numbers: "
                             "a multiple of " +
                             CountOf(NumOrders(n), "complete participant"));
}

}  // namespace

CheckResult Check(const StudyData& data) {
  CheckResult result;
  std::vector<int> complete;
  std::size_t num_begun = 0, num_declined = 0;
  for (const Participant& participant : data.participants()) {
    const std::string file = participant.events_file().string();
    const Progress progress = ProgressOf(ReadEvents(file), file);
    num_declined += progress.is_declined ? 1 : 0;
    if (progress.consented_at.empty()) continue;
    ++num_begun;
    CheckParticipant(data.study(), participant, progress, &result.findings);
    if (progress.completion_code.empty()) {
      const std::vector<Step> steps = StepsOf(data.study(), participant.number);
      result.findings.push_back(participant.id + ": not complete: stopped at " +
                                progress.Next(steps).name);
    } else {
      complete.push_back(participant.number);
    }
  }
  const std::size_t num_withdrawn =
      static_cast<std::size_t>(data.num_issued()) - data.participants().size();
  result.notes.push_back(CountOf(static_cast<std::size_t>(data.num_issued()), "link") + ", " +
                         std::to_string(num_begun) + " begun, " + std::to_string(complete.size()) +
                         " complete, " + std::to_string(num_declined) + " declined, " +
                         std::to_string(num_withdrawn) + " withdrawn");
  CheckBalance(data.study(), complete, &result);
  return result;
}

}  // namespace smile::study
