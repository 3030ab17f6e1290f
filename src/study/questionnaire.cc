#include "study/questionnaire.h"

#include <array>
#include <cmath>
#include <set>
#include <stdexcept>
#include <utility>

#include "base/wording.h"

namespace smile::study {
namespace {

constexpr std::size_t kMaxQuestions = 50, kMaxLabels = 11, kMaxQuestionNameBytes = 40,
                      kMaxPromptBytes = 2000;
constexpr double kMaxScale = 100, kScaleStep = 5;
constexpr std::size_t kNumSusLabels = 5;

/// The six scales. Source: S. G. Hart and L. E. Staveland, "Development of NASA-TLX (Task Load
/// Index)", in: Human Mental Workload (1988). All but `performance` go from very low to very high.
constexpr std::array<std::pair<const char*, const char*>, 6> kTaskLoadScales{{
    {"mental", "Mental demand: how mentally demanding was the task?"},
    {"physical", "Physical demand: how physically demanding was the task?"},
    {"temporal", "Temporal demand: how hurried or rushed was the pace of the task?"},
    {"performance",
     "Performance: how successful were you in accomplishing what you were asked to do?"},
    {"effort", "Effort: how hard did you have to work to accomplish your level of performance?"},
    {"frustration",
     "Frustration: how insecure, discouraged, irritated, stressed and annoyed were you?"},
}};

/// The ten statements. Source: J. Brooke, "SUS: a quick and dirty usability scale", in: Usability
/// Evaluation in Industry (1996).
constexpr std::array<const char*, 10> kUsabilityStatements{
    "I think that I would like to use this system frequently.",
    "I found the system unnecessarily complex.",
    "I thought the system was easy to use.",
    "I think that I would need the support of a technical person to be able to use this system.",
    "I found the various functions in this system were well integrated.",
    "I thought there was too much inconsistency in this system.",
    "I would imagine that most people would learn to use this system very quickly.",
    "I found the system very cumbersome to use.",
    "I felt very confident using the system.",
    "I needed to learn a lot of things before I could get going with this system.",
};

std::vector<Question> TaskLoadQuestions() {
  std::vector<Question> questions;
  for (const auto& [name, prompt] : kTaskLoadScales) {
    const bool is_performance = std::string_view(name) == "performance";
    questions.push_back({.name = name,
                         .prompt = prompt,
                         .labels = is_performance
                                       ? std::vector<std::string>{"perfect", "failure"}
                                       : std::vector<std::string>{"very low", "very high"},
                         .is_scale = true});
  }
  return questions;
}

std::vector<Question> UsabilityQuestions() {
  std::vector<Question> questions;
  for (std::size_t k = 0; k < kUsabilityStatements.size(); ++k) {
    questions.push_back({.name = "sus" + std::to_string(k + 1),
                         .prompt = kUsabilityStatements[k],
                         .labels = {"strongly disagree", "2", "3", "4", "strongly agree"}});
  }
  return questions;
}

Question ReadQuestion(const JsonNode& node, bool is_choice) {
  static constexpr std::array<std::string_view, 4> kChoiceMembers{"prompt", "name", "labels",
                                                                  "required"};
  static constexpr std::array<std::string_view, 3> kTextMembers{"prompt", "name", "required"};
  if (is_choice) {
    node.ExpectMembers(kChoiceMembers);
  } else {
    node.ExpectMembers(kTextMembers);
  }
  Question question{.name = node.Member("name").ShortString(kMaxQuestionNameBytes),
                    .prompt = node.Member("prompt").ShortString(kMaxPromptBytes)};
  if (question.name.empty()) node.Member("name").Fail("is empty, expected a name");
  if (node.Has("required")) question.is_required = node.Member("required").Flag();
  if (!is_choice) return question;
  for (const JsonNode& label : node.Member("labels").ItemsUpTo(kMaxLabels)) {
    question.labels.push_back(label.ShortString(kMaxPromptBytes));
  }
  if (question.labels.size() < 2) node.Member("labels").Fail("expected at least two labels");
  return question;
}

std::vector<Question> ReadQuestions(const JsonNode& node, bool is_choice) {
  std::vector<Question> questions;
  std::set<std::string> names;
  for (const JsonNode& item : node.Member("questions").ItemsUpTo(kMaxQuestions)) {
    questions.push_back(ReadQuestion(item, is_choice));
    if (!names.insert(questions.back().name).second) {
      item.Member("name").Fail("found " + Quoted(questions.back().name) +
                               " twice, expected a name of its own for each question");
    }
  }
  if (questions.empty()) node.Member("questions").Fail("is empty, expected questions");
  return questions;
}

/// Returns the answer to a question, if it is one.
Json CheckedAnswer(const Question& question, const Json& answer) {
  const std::string where = "answer " + Quoted(question.name) + ": ";
  if (!question.is_scale && question.labels.empty()) {
    if (!answer.is_string()) throw std::invalid_argument(where + "expected a text");
    const auto text = answer.get<std::string>();
    if (text.size() <= kMaxAnswerBytes) return text;
    throw std::invalid_argument(where + "is longer than " + std::to_string(kMaxAnswerBytes) +
                                " bytes");
  }
  const double max =
      question.is_scale ? kMaxScale : static_cast<double>(question.labels.size()) - 1;
  const double step = question.is_scale ? kScaleStep : 1;
  const double number = answer.is_number() ? answer.get<double>() : -1;
  if (number >= 0 && number <= max && std::fmod(number, step) == 0) return static_cast<int>(number);
  throw std::invalid_argument(where + "found " + Quoted(ToText(answer)) +
                              ", expected a number from 0 to " + NumberText(max) + " in steps of " +
                              NumberText(step));
}

}  // namespace

Questionnaire ReadQuestionnaire(const JsonNode& node) {
  static constexpr std::array<std::string_view, 4> kTypes{"nasa-tlx", "sus", "survey-likert",
                                                          "survey-text"};
  static constexpr std::array<std::string_view, 4> kMembers{"type", "name", "preamble",
                                                            "questions"};
  node.ExpectMembers(kMembers);
  Questionnaire read{.type = node.Member("type").String()};
  if (std::ranges::find(kTypes, read.type) == kTypes.end()) {
    node.Member("type").Fail("found " + Quoted(read.type) + ", expected " + OneOf(kTypes) +
                             DidYouMean(read.type, kTypes));
  }
  read.name = node.Has("name") ? node.Member("name").ShortString(kMaxQuestionNameBytes) : read.type;
  if (node.Has("preamble")) read.preamble = node.Member("preamble").ShortString(kMaxPromptBytes);
  const bool is_standard = read.type == "nasa-tlx" || read.type == "sus";
  if (is_standard && node.Has("questions")) {
    node.Member("questions").Fail("expected none: those of " + read.type + " are fixed");
  }
  if (read.type == "nasa-tlx") {
    read.questions = TaskLoadQuestions();
  } else if (read.type == "sus") {
    read.questions = UsabilityQuestions();
  } else {
    read.questions = ReadQuestions(node, read.type == "survey-likert");
  }
  return read;
}

Json ToJson(const Questionnaire& questionnaire) {
  Json questions = Json::array();
  for (const Question& question : questionnaire.questions) {
    questions.push_back({{"prompt", question.prompt},
                         {"name", question.name},
                         {"labels", question.labels},
                         {"scale", question.is_scale},
                         {"required", question.is_required}});
  }
  return {{"type", questionnaire.type},
          {"name", questionnaire.name},
          {"preamble", questionnaire.preamble},
          {"questions", questions}};
}

Answers CheckedAnswers(const Questionnaire& questionnaire, const Json& answers) {
  if (!answers.is_object()) throw std::invalid_argument("answers: expected an object");
  Answers checked;
  for (const Question& question : questionnaire.questions) {
    const bool is_given = answers.contains(question.name) && !answers[question.name].is_null() &&
                          answers[question.name] != "";
    if (is_given) {
      checked[question.name] = CheckedAnswer(question, answers[question.name]);
    } else if (question.is_required) {
      throw std::invalid_argument("answer " + Quoted(question.name) + " is missing");
    }
  }
  for (const auto& [name, answer] : answers.items()) {
    if (!checked.contains(name) && !answer.is_null() && answer != "") {
      throw std::invalid_argument("answer " + Quoted(name) + ": there is no such question");
    }
  }
  return checked;
}

std::optional<double> ScoreOf(const Questionnaire& questionnaire, const Answers& answers) {
  if (questionnaire.type != "nasa-tlx" && questionnaire.type != "sus") return std::nullopt;
  double sum = 0;
  for (std::size_t k = 0; k < questionnaire.questions.size(); ++k) {
    const auto answer = answers.find(questionnaire.questions[k].name);
    if (answer == answers.end()) return std::nullopt;
    const auto number = answer->second.get<double>();
    // Of the SUS, every other statement is a complaint.
    const bool is_complaint = questionnaire.type == "sus" && k % 2 == 1;
    sum += is_complaint ? static_cast<double>(kNumSusLabels) - 1 - number : number;
  }
  const auto count = static_cast<double>(questionnaire.questions.size());
  return questionnaire.type == "sus" ? sum * 2.5 : sum / count;
}

}  // namespace smile::study
