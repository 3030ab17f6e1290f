#include "study/step_message.h"

#include <algorithm>

namespace smile::study {
namespace {

Json InstructionJson(const Instruction& instruction) {
  return {{"title", instruction.title},
          {"text", instruction.text},
          {"picture", instruction.picture},
          {"film", instruction.film}};
}

Json TrialJson(const Definition& study, const Step& step, const Progress& progress) {
  const StudyTask& task = TaskOf(study, step);
  const Aids& aids = study.conditions[step.condition].aids;
  const std::vector<Trial> trials = progress.TrialsOf(step.name);
  const auto num_complete = std::ranges::count_if(trials, &Trial::is_complete);
  Json json{{"title", task.title},
            {"text", task.text},
            {"film", FilmOf(study, step)},
            {"limit", task.limit_seconds},
            {"aids", {{"snap", aids.snap}, {"ghost", aids.has_ghost}, {"rings", aids.has_rings}}},
            {"completed", num_complete},
            {"interrupted", !trials.empty() && !trials.back().is_complete()}};
  if (step.kind == StepKind::kPractice) json["attempts"] = study.practice->max_attempts;
  return json;
}

Json ContentOf(const Definition& study, const Step& step, const Progress& progress) {
  switch (step.kind) {
    case StepKind::kConsent:
      return {{"text", study.consent}, {"declined", progress.is_declined}};
    case StepKind::kInstruction:
      return InstructionJson(study.instructions[step.instruction]);
    case StepKind::kPractice:
    case StepKind::kTask:
      return TrialJson(study, step, progress);
    case StepKind::kQuestions:
      return ToJson(step.questionnaire);
    case StepKind::kBreak:
      return {{"seconds", study.break_seconds}};
    case StepKind::kThanks:
      break;
  }
  return {
      {"text", study.thanks},
      {"code", progress.completion_code},
      {"url", study.completion_url.empty() ? "" : study.completion_url + progress.completion_code}};
}

}  // namespace

Json StepMessage(const Definition& study, const std::vector<Step>& steps, const Step& step,
                 const Progress& progress) {
  const auto index = std::ranges::find(steps, step.name, &Step::name) - steps.begin();
  return {{"t", "step"},
          {"study", study.title},
          {"step", step.name},
          {"kind", ToString(step.kind)},
          {"index", index},
          {"count", steps.size()},
          {"content", ContentOf(study, step, progress)}};
}

std::vector<std::string> PublicFilesOf(const Definition& study) {
  std::vector<std::string> files;
  for (const Instruction& instruction : study.instructions) {
    files.push_back(instruction.picture);
    files.push_back(instruction.film);
  }
  std::vector<StudyTask> tasks = study.tasks;
  if (study.practice) tasks.push_back(study.practice->task);
  for (const StudyTask& task : tasks) {
    for (const auto& [condition, film] : task.films) files.push_back(film);
  }
  std::erase(files, "");
  return files;
}

}  // namespace smile::study
