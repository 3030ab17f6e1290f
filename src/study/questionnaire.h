#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/json.h"
#include "base/json_node.h"

namespace smile::study {

/// A question. With labels, the answer is the number of one of them, from 0 on; without labels it
/// is a number of a scale, or a text.
struct Question {
  std::string name, prompt;
  std::vector<std::string> labels;  ///< of the answers; of a scale: of its two ends
  bool is_scale = false;            ///< 0 to 100 in steps of 5
  bool is_required = true;

  bool operator==(const Question&) const = default;
};

/// Questions that are asked together. Its JSON has the names of jsPsych's plugins survey-likert and
/// survey-text, and accepts their questions.
struct Questionnaire {
  std::string type;  ///< `nasa-tlx`, `sus`, `survey-likert` or `survey-text`
  std::string name, preamble;
  std::vector<Question> questions;

  bool operator==(const Questionnaire&) const = default;
};

/// Number or text for each question that was answered, by its name.
using Answers = std::map<std::string, Json>;

inline constexpr std::size_t kMaxAnswerBytes = 10'000;

/// Reads a questionnaire.
/// @throws InputError with the element.
Questionnaire ReadQuestionnaire(const JsonNode& node);
Json ToJson(const Questionnaire& questionnaire);

/// Checks the answers of a participant.
/// @throws std::invalid_argument with the question, what was found and what was expected.
Answers CheckedAnswers(const Questionnaire& questionnaire, const Json& answers);

/// Returns the score of complete answers: the mean of the six scales for the raw NASA-TLX, 0 to 100
/// (J. C. Byers, A. C. Bittner and S. G. Hill, "Traditional and raw task load index (TLX)
/// correlations", 1989); 0 to 100 for the SUS (J. Brooke, "SUS: a quick and dirty usability scale",
/// 1996). nullopt for other types.
std::optional<double> ScoreOf(const Questionnaire& questionnaire, const Answers& answers);

}  // namespace smile::study
