// A gripper of a side file is a template: its texts contain placeholders such as `{slot}`, one per
// choice. The wanted name, for example `electric-wide-2`, selects the gripper and a word for some
// of its choices.

#include "robot/internal_gripper_choice.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "base/wording.h"

namespace smile::robot::internal {
namespace {

constexpr std::size_t kMaxChoices = 16;  // of a gripper
constexpr std::size_t kMaxMadeText = 1000;

/// A property of a gripper that can be chosen.
struct Choice {
  std::string name;
  std::vector<std::string> words;
  std::optional<std::string> chosen;
};

std::vector<std::string> SplitAtDashes(const std::string& text) {
  std::vector<std::string> words;
  // An empty word between two dashes stays and is refused as unknown.
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find('-', start), text.size());
    words.push_back(text.substr(start, end - start));
    start = end + 1;
  }
  return words;
}

void ExpectShortName(const std::string& name, const JsonNode& parent) {
  if (name.size() <= kMaxShortText) return;
  parent.Fail("found the name " + Quoted(name) + ", expected at most " +
              std::to_string(kMaxShortText) + " characters");
}

/// Reads the choices of a gripper, none made yet. Words must not contain the separator.
std::vector<Choice> ReadChoices(const JsonNode& gripper) {
  std::vector<Choice> choices;
  if (!gripper.Has("choices")) return choices;
  const JsonNode all = gripper.Member("choices");
  for (const auto& [name, words] : all.MembersUpTo(kMaxChoices)) {
    ExpectShortName(name, all);
    Choice& choice = choices.emplace_back(Choice{.name = name, .words = {}, .chosen = {}});
    for (const JsonNode& word : words.Items()) {
      choice.words.push_back(word.ShortString(kMaxShortText));
      if (choice.words.back().empty() || choice.words.back().find('-') != std::string::npos) {
        word.Fail("found " + Quoted(word.String()) + ", expected a word without -");
      }
    }
    if (choice.words.empty()) words.Fail("is empty, expected words to choose from");
  }
  return choices;
}

bool IsOf(const Choice& choice, const std::string& word) {
  return std::ranges::find(choice.words, word) != choice.words.end();
}

/// Makes the choice that a word belongs to; returns false if no open choice has the word.
bool Choose(const std::string& word, std::vector<Choice>* choices) {
  for (Choice& choice : *choices) {
    if (choice.chosen || !IsOf(choice, word)) continue;
    choice.chosen = word;
    return true;
  }
  return false;
}

/// Reports a word that selects nothing: used twice, excluded by another word, or unknown.
[[noreturn]] void FailForWord(const JsonNode& gripper, const std::string& word,
                              const std::vector<Choice>& choices) {
  for (const Choice& choice : choices) {
    if (!IsOf(choice, word)) continue;  // or else it has been chosen already
    gripper.Fail(word == *choice.chosen
                     ? "found the word " + Quoted(word) + " twice, expected it once"
                     : "found the words " + Quoted(*choice.chosen) + " and " + Quoted(word) +
                           ", expected one of them");
  }
  std::string expected = choices.empty() ? "no words after its name" : "one of each";
  for (const Choice& choice : choices) {
    const std::vector<std::string_view> words(choice.words.begin(), choice.words.end());
    expected += (&choice == choices.data() ? ": " : "; ") + OneOf(words);
  }
  gripper.Fail("found the word " + Quoted(word) + ", expected " + expected);
}

/// Returns the text with all placeholders `{CHOICE}` replaced by the chosen words.
std::string Replaced(std::string text, const std::vector<Choice>& choices,
                     const JsonNode& gripper) {
  for (const Choice& choice : choices) {
    const std::string pattern = "{" + choice.name + "}";
    for (std::size_t at = text.find(pattern); at != std::string::npos;
         // Continues behind the inserted word, which may itself look like a placeholder.
         at = text.find(pattern, at + choice.chosen->size())) {
      text.replace(at, pattern.size(), *choice.chosen);
      if (text.size() <= kMaxMadeText) continue;
      gripper.Fail("with the choice, a string becomes " + Quoted(text) + ", expected at most " +
                   std::to_string(kMaxMadeText) + " characters");
    }
  }
  return text;
}

/// Replaces placeholders in all texts of a JSON value.
void ReplaceIn(Json* json, const std::vector<Choice>& choices, const JsonNode& gripper) {
  // Placeholders may be in any text of the gripper, at any depth.
  if (json->is_string()) *json = Replaced(json->get<std::string>(), choices, gripper);
  if (!json->is_structured()) return;
  for (Json& child : *json) ReplaceIn(&child, choices, gripper);
}

}  // namespace

GripperChoice ChooseGripper(const JsonNode& grippers, const std::string& wanted) {
  std::vector<std::string> names;
  std::string best;
  for (const auto& [name, gripper] : grippers.Members()) {
    ExpectShortName(name, grippers);
    names.push_back(name);
    // The longest matching name wins: a gripper's name may be the beginning of another's.
    const bool fits = wanted == name || wanted.starts_with(name + "-");
    if (fits && name.size() > best.size()) best = name;
  }
  if (best.empty()) {
    const std::vector<std::string_view> known(names.begin(), names.end());
    grippers.Fail("found the choice " + Quoted(wanted) + ", expected " + OneOf(known) +
                  DidYouMean(wanted, known));
  }
  const JsonNode gripper = grippers.Member(best);
  gripper.ExpectObject();
  std::vector<Choice> choices = ReadChoices(gripper);
  if (wanted != best) {
    for (const std::string& word : SplitAtDashes(wanted.substr(best.size() + 1))) {
      if (!Choose(word, &choices)) FailForWord(gripper, word, choices);
    }
  }
  GripperChoice chosen{.name = best, .place = gripper.place(), .value = gripper.value()};
  for (Choice& choice : choices) {
    // The first word is the default. The name lists all words, so that it is complete.
    if (!choice.chosen) choice.chosen = choice.words.front();
    chosen.name += "-" + *choice.chosen;
  }
  chosen.value.erase("choices");
  ReplaceIn(&chosen.value, choices, gripper);
  return chosen;
}

}  // namespace smile::robot::internal
