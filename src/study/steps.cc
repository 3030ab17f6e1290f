#include "study/steps.h"

#include <algorithm>
#include <utility>

#include "study/orders.h"

namespace smile::study {
namespace {

void AddQuestions(const std::vector<Questionnaire>& questionnaires, const Definition& study,
                  const std::size_t* condition, std::vector<Step>* steps) {
  for (const Questionnaire& questionnaire : questionnaires) {
    Step step{.kind = StepKind::kQuestions,
              .name = "questions-" + questionnaire.name,
              .questionnaire = questionnaire};
    if (condition != nullptr) {
      step.condition = *condition;
      step.has_condition = true;
      step.name += "-" + study.conditions[*condition].name;
    }
    steps->push_back(std::move(step));
  }
}

void AddTask(const Definition& study, std::size_t condition, std::size_t task,
             std::vector<Step>* steps) {
  steps->push_back(
      {.kind = StepKind::kTask,
       .name = "task-" + study.tasks[task].name + "-" + study.conditions[condition].name,
       .condition = condition,
       .has_condition = true,
       .task = task});
}

/// Adds the tasks of the condition at a position of the participant's order.
void AddTasks(const Definition& study, std::size_t condition, std::size_t position,
              std::size_t cycle, std::vector<Step>* steps) {
  const std::size_t n = study.tasks.size();
  // A condition comes once to each position within a cycle of orders, so it meets each task once.
  if (study.has_one_task_per_condition) {
    return AddTask(study, condition, (position + cycle) % n, steps);
  }
  for (std::size_t task = 0; task < n; ++task) AddTask(study, condition, task, steps);
}

}  // namespace

std::string_view ToString(StepKind kind) {
  switch (kind) {
    case StepKind::kConsent:
      return "consent";
    case StepKind::kInstruction:
      return "instruction";
    case StepKind::kPractice:
      return "practice";
    case StepKind::kTask:
      return "task";
    case StepKind::kQuestions:
      return "questions";
    case StepKind::kBreak:
      return "break";
    case StepKind::kThanks:
      break;
  }
  return "thanks";
}

std::vector<Step> StepsOf(const Definition& study, int number) {
  const std::size_t row = static_cast<std::size_t>(number) - 1;
  const std::size_t n = study.conditions.size();
  const std::vector<std::size_t> order = BalancedOrder(n, row);
  std::vector<Step> steps{{.kind = StepKind::kConsent, .name = "consent"}};
  for (std::size_t k = 0; k < study.instructions.size(); ++k) {
    steps.push_back({.kind = StepKind::kInstruction,
                     .name = "instruction-" + std::to_string(k + 1),
                     .instruction = k});
  }
  // Practice has the aids of the condition that comes first.
  if (study.practice) {
    steps.push_back({.kind = StepKind::kPractice, .name = "practice", .condition = order[0]});
  }
  for (std::size_t position = 0; position < n; ++position) {
    if (position > 0 && study.break_seconds > 0) {
      steps.push_back({.kind = StepKind::kBreak, .name = "break-" + std::to_string(position)});
    }
    AddTasks(study, order[position], position, row / NumOrders(n), &steps);
    AddQuestions(study.after_condition, study, &order[position], &steps);
  }
  AddQuestions(study.at_end, study, nullptr, &steps);
  steps.push_back({.kind = StepKind::kThanks, .name = "thanks"});
  return steps;
}

const Step* FindStep(const std::vector<Step>& steps, std::string_view name) {
  const auto step = std::ranges::find(steps, name, &Step::name);
  return step == steps.end() ? nullptr : &*step;
}

const StudyTask& TaskOf(const Definition& study, const Step& step) {
  return step.kind == StepKind::kPractice ? study.practice->task : study.tasks.at(step.task);
}

std::string FilmOf(const Definition& study, const Step& step) {
  const auto& films = TaskOf(study, step).films;
  const auto film = films.find(study.conditions[step.condition].name);
  if (film != films.end()) return film->second;
  const auto any = films.find("");
  return any == films.end() ? "" : any->second;
}

}  // namespace smile::study
