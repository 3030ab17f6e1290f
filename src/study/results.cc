#include "study/results.h"

#include <algorithm>
#include <functional>
#include <map>
#include <utility>

#include "base/files.h"
#include "base/wording.h"
#include "report/study_page.h"

namespace smile::study {
namespace {

/// Returns a cell as RFC 4180 has it.
std::string Cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char letter : text) quoted += letter == '"' ? "\"\"" : std::string(1, letter);
  return quoted + "\"";
}

std::string Line(const std::vector<std::string>& cells) {
  std::string line;
  for (const std::string& cell : cells) line += (line.empty() ? "" : ",") + Cell(cell);
  return line + "\r\n";
}

/// A column of trials.csv, with its meaning for the codebook.
struct Column {
  const char* name;
  const char* meaning;
  std::function<std::string(const TrialRow&)> text;
};

std::string Text(std::size_t number) { return std::to_string(number); }

const std::vector<Column>& Columns() {
  static const std::vector<Column> kColumns{
      {"participant", "pseudonym", [](const TrialRow& row) { return row.participant; }},
      {"task", "name of the task", [](const TrialRow& row) { return row.task; }},
      {"condition", "name of the condition", [](const TrialRow& row) { return row.condition; }},
      {"position", "position of the condition in the participant's order, from 1 on",
       [](const TrialRow& row) { return Text(row.position); }},
      {"interrupted", "number of earlier attempts that were interrupted and do not count",
       [](const TrialRow& row) { return Text(row.num_interrupted); }},
      {"reason", "done: the participant ended the trial; limit: the limit of time did",
       [](const TrialRow& row) { return row.trial.reason; }},
      {"success", "1 if all relations of the goal hold at the end, else 0",
       [](const TrialRow& row) { return std::string(row.measures.is_success ? "1" : "0"); }},
      {"seconds", "simulated time of the recording [s]; time that was undone does not count",
       [](const TrialRow& row) { return NumberText(row.measures.seconds); }},
      {"wall_seconds", "wall-clock time of the trial [s]",
       [](const TrialRow& row) { return NumberText(row.trial.wall_seconds); }},
      {"undos", "number of undone actions",
       [](const TrialRow& row) { return Text(row.measures.undos); }},
      {"redos", "number of redone actions",
       [](const TrialRow& row) { return Text(row.measures.redos); }},
      {"grasps", "number of grasps, without those that were undone",
       [](const TrialRow& row) { return Text(row.measures.grasps); }},
      {"falls", "number of objects that fell from the table, without those that were undone",
       [](const TrialRow& row) { return Text(row.measures.falls); }},
      {"path_meters", "length of the paths of objects in hands [m]",
       [](const TrialRow& row) { return NumberText(row.measures.path_meters); }},
      {"camera_moves", "number of moves of the participant's camera",
       [](const TrialRow& row) { return Text(row.input.camera_moves); }},
      {"focus_losses", "number of times that the page lost the focus",
       [](const TrialRow& row) { return Text(row.input.focus_losses); }},
      {"recording", "directory of the recording, below that of the data", [](const TrialRow& row) {
         return row.participant + "/" + row.trial.folder + "/" + row.trial.recording;
       }}};
  return kColumns;
}

/// Adds the complete trials of a participant.
void AddTrials(const Definition& study, const Participant& participant, const Progress& progress,
               std::vector<TrialRow>* rows) {
  std::vector<std::size_t> order;
  for (const Step& step : StepsOf(study, participant.number)) {
    if (step.kind != StepKind::kTask) continue;
    if (order.empty() || order.back() != step.condition) order.push_back(step.condition);
    const std::vector<Trial> trials = progress.TrialsOf(step.name);
    const auto complete = std::ranges::find_if(trials, &Trial::is_complete);
    if (complete == trials.end() || complete->recording.empty()) continue;
    const auto folder = participant.folder / complete->folder;
    rows->push_back(
        {.participant = participant.id,
         .task = study.tasks[step.task].name,
         .condition = study.conditions[step.condition].name,
         .position = order.size(),
         .num_interrupted = static_cast<std::size_t>(complete - trials.begin()),
         .trial = *complete,
         .measures = MeasuresOf(folder / complete->recording, study.tasks[step.task].goal),
         .input = InputMeasuresOf(folder / kInputLog)});
  }
}

void AddAnswers(const Definition& study, const Participant& participant, const Progress& progress,
                std::vector<AnswerRow>* rows) {
  for (const Step& step : StepsOf(study, participant.number)) {
    const auto answers = progress.answers.find(step.name);
    if (step.kind != StepKind::kQuestions || answers == progress.answers.end()) continue;
    AnswerRow row{.participant = participant.id,
                  .condition = step.has_condition ? study.conditions[step.condition].name : "",
                  .questionnaire = step.questionnaire.name};
    for (const Question& question : step.questionnaire.questions) {
      const auto answer = answers->second.find(question.name);
      if (answer == answers->second.end()) continue;
      row.question = question.name;
      row.answer = answer->second;
      rows->push_back(row);
    }
    if (const auto score = ScoreOf(step.questionnaire, answers->second)) {
      row.question = "score";
      row.answer = *score;
      rows->push_back(row);
    }
  }
}

/// Numbers by condition and participant, each of which is averaged.
class Averages {
 public:
  void Add(const std::string& condition, const std::string& participant, double number) {
    numbers_[{condition, participant}].push_back(number);
  }
  std::optional<double> Of(const std::string& condition, const std::string& participant) const {
    const auto found = numbers_.find({condition, participant});
    if (found == numbers_.end()) return std::nullopt;
    return report::MeanOf(found->second)->value;
  }
  bool is_empty() const { return numbers_.empty(); }

 private:
  std::map<std::pair<std::string, std::string>, std::vector<double>> numbers_;
};

report::StudyMeasure MeasureOf(const std::string& name, int digits, const Averages& averages,
                               const Definition& study,
                               const std::vector<std::string>& participants) {
  report::StudyMeasure measure{.name = name, .digits = digits};
  for (const Condition& condition : study.conditions) {
    std::vector<std::optional<double>>& numbers = measure.numbers.emplace_back();
    for (const std::string& participant : participants) {
      numbers.push_back(averages.Of(condition.name, participant));
    }
  }
  return measure;
}

struct TrialNumber {
  const char* name;
  int digits;
  std::function<double(const TrialRow&)> number;
};

const std::vector<TrialNumber>& TrialNumbers() {
  static const std::vector<TrialNumber> kNumbers{
      {"Time, s (wall clock)", 1, [](const TrialRow& row) { return row.trial.wall_seconds; }},
      {"Time, s (simulated)", 1, [](const TrialRow& row) { return row.measures.seconds; }},
      {"Undone actions", 2,
       [](const TrialRow& row) { return static_cast<double>(row.measures.undos); }},
      {"Grasps", 2, [](const TrialRow& row) { return static_cast<double>(row.measures.grasps); }},
      {"Path of held objects, m", 2, [](const TrialRow& row) { return row.measures.path_meters; }},
      {"Camera moves", 2,
       [](const TrialRow& row) { return static_cast<double>(row.input.camera_moves); }}};
  return kNumbers;
}

std::vector<std::string> ParticipantsIn(const StudyRows& rows) {
  std::vector<std::string> participants;
  for (const TrialRow& row : rows.trials) {
    if (participants.empty() || participants.back() != row.participant) {
      participants.push_back(row.participant);
    }
  }
  return participants;
}

/// Adds a measure for each questionnaire of conditions that has a score.
void AddScores(const Definition& study, const StudyRows& rows,
               const std::vector<std::string>& participants,
               std::vector<report::StudyMeasure>* measures) {
  for (const Questionnaire& questionnaire : study.after_condition) {
    Averages scores;
    for (const AnswerRow& row : rows.answers) {
      const bool is_score = row.questionnaire == questionnaire.name && row.question == "score";
      if (is_score) scores.Add(row.condition, row.participant, row.answer.get<double>());
    }
    if (scores.is_empty()) continue;
    const std::string name =
        questionnaire.type == "sus" ? "SUS score, 0 to 100" : "NASA-TLX, raw, 0 to 100";
    measures->push_back(MeasureOf(name, 1, scores, study, participants));
  }
}

}  // namespace

StudyRows RowsOf(const StudyData& data) {
  StudyRows rows;
  for (const Participant& participant : data.participants()) {
    const std::string file = participant.events_file().string();
    const Progress progress = ProgressOf(ReadEvents(file), file);
    if (progress.consented_at.empty()) continue;
    AddTrials(data.study(), participant, progress, &rows.trials);
    AddAnswers(data.study(), participant, progress, &rows.answers);
  }
  return rows;
}

std::string TrialsCsv(const std::vector<TrialRow>& rows) {
  std::vector<std::string> cells;
  for (const Column& column : Columns()) cells.emplace_back(column.name);
  std::string csv = Line(cells);
  for (const TrialRow& row : rows) {
    cells.clear();
    for (const Column& column : Columns()) cells.push_back(column.text(row));
    csv += Line(cells);
  }
  return csv;
}

std::string AnswersCsv(const std::vector<AnswerRow>& rows) {
  std::string csv = Line({"participant", "condition", "questionnaire", "question", "answer"});
  for (const AnswerRow& row : rows) {
    const std::string answer = row.answer.is_string() ? row.answer.get<std::string>()
                                                      : NumberText(row.answer.get<double>());
    csv += Line({row.participant, row.condition, row.questionnaire, row.question, answer});
  }
  return csv;
}

std::string Codebook(const Definition& study) {
  std::string text = "# Codebook of " + study.title + "\n\n## trials.csv\n\n";
  text += "One row for each complete trial of a task.\n\n";
  for (const Column& column : Columns()) {
    text += "- `" + std::string(column.name) + "`: " + column.meaning + "\n";
  }
  text += "\nConditions:\n\n";
  for (const Condition& condition : study.conditions) {
    text += "- `" + condition.name + "`: " + condition.title + "\n";
  }
  text += "\nTasks:\n\n";
  for (const StudyTask& task : study.tasks) text += "- `" + task.name + "`: " + task.title + "\n";
  text +=
      "\n## answers.csv\n\nOne row for each answer. `condition` is empty for questions at the end. "
      "The question `score` is computed from the others: the raw NASA-TLX is the mean of its six "
      "scales, the SUS score is that of Brooke (1996). Both go from 0 to 100.\n";
  for (const auto* questionnaires : {&study.after_condition, &study.at_end}) {
    for (const Questionnaire& questionnaire : *questionnaires) {
      text += "\n### " + questionnaire.name + "\n\n";
      for (const Question& question : questionnaire.questions) {
        text += "- `" + question.name + "`: " + question.prompt;
        if (question.is_scale) text += " 0: " + question.labels[0] + ", 100: " + question.labels[1];
        for (std::size_t k = 0; !question.is_scale && k < question.labels.size(); ++k) {
          text += (k == 0 ? " " : ", ") + std::to_string(k) + ": " + question.labels[k];
        }
        text += "\n";
      }
    }
  }
  return text;
}

report::StudyResults ResultsOf(const Definition& study, const StudyRows& rows) {
  const std::vector<std::string> participants = ParticipantsIn(rows);
  report::StudyResults results{.title = study.title, .num_participants = participants.size()};
  for (const Condition& condition : study.conditions) {
    report::StudyCondition& shown = results.conditions.emplace_back();
    shown.name = condition.title;
    for (const TrialRow& row : rows.trials) {
      if (row.condition != condition.name) continue;
      shown.trials += 1;
      shown.successes += row.measures.is_success ? 1 : 0;
    }
  }
  for (const TrialNumber& one : TrialNumbers()) {
    Averages averages;
    for (const TrialRow& row : rows.trials) {
      averages.Add(row.condition, row.participant, one.number(row));
    }
    results.measures.push_back(MeasureOf(one.name, one.digits, averages, study, participants));
  }
  AddScores(study, rows, participants, &results.measures);
  return results;
}

std::filesystem::path WriteReport(const StudyData& data) {
  const std::filesystem::path folder = data.folder() / kReportFolder;
  MakeDirectories(folder);
  const StudyRows rows = RowsOf(data);
  WriteFile(folder / "trials.csv", TrialsCsv(rows.trials));
  WriteFile(folder / "answers.csv", AnswersCsv(rows.answers));
  WriteFile(folder / "codebook.md", Codebook(data.study()));
  WriteFile(folder / "report.html", report::StudyPage(ResultsOf(data.study(), rows)));
  return folder;
}

}  // namespace smile::study
