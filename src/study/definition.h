#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "model/relations.h"
#include "study/questionnaire.h"

namespace smile::study {

/// Aids that help a participant to demonstrate. Those not named in a condition are as in the
/// studio.
struct Aids {
  std::vector<std::string> snap;  ///< names of page::kSnapNames; empty: none
  bool has_ghost = true;          ///< where the held object would come to rest
  bool has_rings = true;          ///< to turn the held object

  bool operator==(const Aids&) const = default;
};

/// What differs between the parts of a study.
struct Condition {
  std::string name, title;
  Aids aids;

  bool operator==(const Condition&) const = default;
};

/// A page that a participant reads or watches.
struct Instruction {
  std::string title, text;
  std::string picture, film;  ///< paths from the folder of the definition; empty: none

  bool operator==(const Instruction&) const = default;
};

/// A demonstration that a participant is asked for.
struct StudyTask {
  std::string name, title, text;
  /// Film that is shown before, by condition; the name "" stands for all other conditions.
  std::map<std::string, std::string> films;
  std::string scene;                  ///< path of the scene file, from the folder of the definition
  std::vector<model::Relation> goal;  ///< that hold at the end of a success
  double limit_seconds = 300;         ///< of wall-clock time

  bool operator==(const StudyTask&) const = default;
};

/// Attempts until the goal is reached.
struct Practice {
  StudyTask task;
  int max_attempts = 3;  ///< after these, the study goes on

  bool operator==(const Practice&) const = default;
};

/// Content of a study's file (docs/studies.md).
struct Definition {
  std::filesystem::path folder;  ///< of the file; other paths begin there
  std::string text;              ///< of the file
  std::string name, title;
  std::string language =
      "en";             ///< of the page's own texts, for all participants: texts/LANGUAGE.json
  std::string consent;  ///< the text itself
  std::vector<Condition> conditions;
  std::vector<Instruction> instructions;
  std::optional<Practice> practice;
  std::vector<StudyTask> tasks;
  /// Each condition comes with one of the tasks, in a Latin square; otherwise with all of them.
  bool has_one_task_per_condition = false;
  double break_seconds = 0;  ///< between two conditions, at least; 0: no breaks
  std::vector<Questionnaire> after_condition, at_end;
  std::string thanks;
  std::string
      completion_url;  ///< the completion code is added to it; empty: the code is shown only
};

/// Reads a study's file, and checks the files that it names: scenes with the objects of the goals,
/// the consent text, pictures and films.
/// @throws InputError with file, line and element of the first fault.
Definition ReadDefinition(const std::filesystem::path& path);

}  // namespace smile::study
