#include "page/request_fields.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/wording.h"

// Reads the fields of a request one by one. Every fault names the field, what was found and what
// was expected, in the words of JSON, since authors of clients read it.

namespace smile::page {
namespace {

std::array<std::string_view, demonstrator::kHandNames.size()> HandWords() {
  std::array<std::string_view, demonstrator::kHandNames.size()> words;
  std::ranges::transform(demonstrator::kHandNames, words.begin(), demonstrator::ToString);
  return words;
}

/// Returns a value as messages name it: numbers and flags themselves, anything else by its type.
std::string Found(const Json& value) {
  if (value.is_number()) return NumberText(value.get<double>());
  if (value.is_boolean()) return value.get<bool>() ? "true" : "false";
  if (value.is_string()) return "text";
  if (value.is_array()) return "a list";
  return value.is_null() ? "null" : "an object";
}

/// Refuses a field, in the form "found, expected" of all error messages.
/// @throws RequestError in any case.
[[noreturn]] void Expected(const std::string& name, const std::string& found,
                           const std::string& expected) {
  throw RequestError("\"" + name + "\" is " + found + ", expected " + expected);
}

std::string Size(std::size_t bytes) { return std::to_string(bytes); }

}  // namespace

const Json* RequestFields::Find(const char* name) const {
  if (!fields_.is_object()) return nullptr;
  const auto found = fields_.find(name);
  return found == fields_.end() ? nullptr : &*found;
}

const Json& RequestFields::Get(const char* name, const std::string& expected) const {
  if (const Json* value = Find(name)) return *value;
  throw RequestError("\"" + std::string(name) + "\" is missing, expected " + expected);
}

bool RequestFields::Has(const char* name) const { return Find(name) != nullptr; }

std::string RequestFields::Text(const char* name, std::size_t max_bytes) const {
  const std::string expected = "a string of 1 to " + Size(max_bytes) + " characters";
  const Json& value = Get(name, expected);
  if (!value.is_string()) Expected(name, Found(value), expected);
  auto text = value.get<std::string>();
  if (text.empty()) Expected(name, "empty", expected);
  if (text.size() > max_bytes) Expected(name, Size(text.size()) + " bytes long", expected);
  return text;
}

std::optional<std::string> RequestFields::OptionalText(const char* name,
                                                       std::size_t max_bytes) const {
  const Json* value = Find(name);
  // An empty text is the same as a missing one here: a client may send an input that its user left
  // empty.
  if (value == nullptr || *value == "") return std::nullopt;
  return Text(name, max_bytes);
}

double RequestFields::Number(const char* name, double low, double high) const {
  const std::string expected = "a number from " + NumberText(low) + " to " + NumberText(high);
  const Json& value = Get(name, expected);
  if (!value.is_number()) Expected(name, Found(value), "a number");
  const auto number = value.get<double>();
  // Written so that NaN, if a parser should ever let it pass, is refused.
  if (!(number >= low && number <= high)) Expected(name, Found(value), expected);
  return number;
}

std::optional<double> RequestFields::OptionalNumber(const char* name, double low,
                                                    double high) const {
  return Has(name) ? std::optional(Number(name, low, high)) : std::nullopt;
}

std::uint64_t RequestFields::Whole(const char* name, std::uint64_t high) const {
  // By way of double, so that 1 and 1.0 are the same, as in JavaScript. Exact up to 2^53.
  const double number = Number(name, 0, static_cast<double>(high));
  if (number != std::floor(number)) Expected(name, NumberText(number), "a whole number");
  return static_cast<std::uint64_t>(number);
}

bool RequestFields::Flag(const char* name) const {
  const Json* value = Find(name);
  if (value == nullptr) return false;
  if (!value->is_boolean()) Expected(name, Found(*value), "true or false");
  return value->get<bool>();
}

std::string RequestFields::Word(const char* name, std::span<const std::string_view> known) const {
  std::string word = Text(name);
  if (std::ranges::find(known, word) == known.end()) {
    Expected(name, Quoted(word), OneOf(known) + DidYouMean(word, known));
  }
  return word;
}

demonstrator::HandName RequestFields::Hand(const char* name) const {
  return *demonstrator::ParseHandName(Word(name, HandWords()));
}

std::set<demonstrator::HandName> RequestFields::Hands(const char* name) const {
  std::set<demonstrator::HandName> hands;
  for (const std::string& word : Words(name, HandWords())) {
    hands.insert(*demonstrator::ParseHandName(word));
  }
  return hands;
}

std::vector<std::string> RequestFields::Words(const char* name,
                                              std::span<const std::string_view> known) const {
  const std::string expected = "a list of any of " + OneOf(known);
  const Json& list = Get(name, expected);
  if (!list.is_array()) Expected(name, Found(list), expected);
  // Checked before the words, so that a huge list is refused at once.
  if (list.size() > known.size()) Expected(name, Size(list.size()) + " words long", expected);
  std::vector<std::string> words;
  for (const Json& item : list) {
    if (!item.is_string()) Expected(name, "a list with " + Found(item), expected);
    auto word = item.get<std::string>();
    if (std::ranges::find(known, word) == known.end()) {
      Expected(name, "a list with " + Quoted(word), expected + DidYouMean(word, known));
    }
    // A repeated word counts once.
    if (std::ranges::find(words, word) == words.end()) words.push_back(std::move(word));
  }
  return words;
}

const Json& RequestFields::List(const char* name, std::size_t max_count) const {
  const std::string expected = "a list of up to " + Size(max_count);
  const Json& list = Get(name, expected);
  if (!list.is_array()) Expected(name, Found(list), expected);
  if (list.size() > max_count) Expected(name, "a list of " + Size(list.size()), expected);
  return list;
}

const Json& RequestFields::Object(const char* name) const {
  const Json& value = Get(name, "an object");
  if (!value.is_object()) Expected(name, Found(value), "an object");
  return value;
}

}  // namespace smile::page
