#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "study/definition.h"

namespace smile::study {

enum class StepKind { kConsent, kInstruction, kPractice, kTask, kQuestions, kBreak, kThanks };
std::string_view ToString(StepKind kind);

/// One page of a participant's way through a study.
struct Step {
  StepKind kind = StepKind::kConsent;
  std::string name;           ///< unique within the study: `task-tower-ghost`
  std::size_t condition = 0;  ///< index; of steps that belong to a condition, and of the practice
  bool has_condition = false;
  std::size_t task = 0;         ///< index; of a task
  std::size_t instruction = 0;  ///< index; of an instruction
  Questionnaire questionnaire;  ///< of questions

  bool is_trial() const { return kind == StepKind::kPractice || kind == StepKind::kTask; }
  bool operator==(const Step&) const = default;
};

/// Returns all steps of a participant in order. They depend on the definition and the number only.
/// @param number  of the participant, from 1 on.
std::vector<Step> StepsOf(const Definition& study, int number);

/// Returns the step with a name; nullptr if there is none.
const Step* FindStep(const std::vector<Step>& steps, std::string_view name);
/// Returns the task of a trial.
const StudyTask& TaskOf(const Definition& study, const Step& step);
/// Returns the film that is shown before a trial; empty: none.
std::string FilmOf(const Definition& study, const Step& step);

}  // namespace smile::study
