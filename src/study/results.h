#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "report/study_results.h"
#include "study/measures.h"
#include "study/participants.h"
#include "study/progress.h"

namespace smile::study {

/// A complete trial of a task: a row of trials.csv.
struct TrialRow {
  std::string participant, task, condition;
  std::size_t position = 1;         ///< of the condition in the participant's order, from 1 on
  std::size_t num_interrupted = 0;  ///< earlier attempts, which do not count
  Trial trial;
  Measures measures;
  InputMeasures input;
};

/// An answer, or a score of a questionnaire: a row of answers.csv.
struct AnswerRow {
  std::string participant, condition, questionnaire, question;
  Json answer;  ///< a number or a text
};

/// Everything that a study has found so far.
struct StudyRows {
  std::vector<TrialRow> trials;
  std::vector<AnswerRow> answers;
};

/// Collects and measures complete trials and answers of participants who consented.
/// @throws InputError if a file is damaged.
StudyRows RowsOf(const StudyData& data);

/// Returns tables in the format of RFC 4180, which R and pandas read.
std::string TrialsCsv(const std::vector<TrialRow>& rows);
std::string AnswersCsv(const std::vector<AnswerRow>& rows);
/// Returns the meaning of all columns, questions and labels, as Markdown.
std::string Codebook(const Definition& study);

/// Returns what the page of the report shows.
report::StudyResults ResultsOf(const Definition& study, const StudyRows& rows);

/// Writes `trials.csv`, `answers.csv`, `codebook.md` and `report.html` into the folder `report` of
/// the data.
/// @returns the folder.
std::filesystem::path WriteReport(const StudyData& data);

}  // namespace smile::study
