#include "texts/internal_message_format.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "base/wording.h"

// The same syntax as web/src/message_format.ts, with the plurals and the numbers of English.

namespace smile::texts {
namespace {

[[noreturn]] void Misfit(std::string_view problem, std::string_view field) {
  throw std::logic_error("message " + std::string(problem) + ": {" + std::string(field) + "}");
}

std::string_view Trimmed(std::string_view text) {
  constexpr std::string_view kSpace = " \n";
  const std::size_t begin = std::min(text.find_first_not_of(kSpace), text.size());
  return text.substr(begin, text.find_last_not_of(kSpace) + 1 - begin);
}

/// Returns the text before the next comma, trimmed, and removes both from `rest`.
std::string_view TakeWord(std::string_view* rest) {
  const std::size_t comma = std::min(rest->find(','), rest->size());
  const std::string_view word = Trimmed(rest->substr(0, comma));
  rest->remove_prefix(std::min(comma + 1, rest->size()));
  return word;
}

/// Returns the text between the brace at `open` and the one that closes it.
std::string_view Braced(std::string_view format, std::size_t open) {
  int depth = 0;
  for (std::size_t k = open; k < format.size(); ++k) {
    if (format[k] == '{') ++depth;
    if (format[k] == '}' && --depth == 0) return format.substr(open + 1, k - open - 1);
  }
  Misfit("without an end of its argument", format.substr(open));
}

std::string NumberIn(std::string_view style, double number) {
  if (style.empty()) return NumberText(number);
  const int digits = style == "whole" ? 0 : style == "tenths" ? 1 : style == "hundredths" ? 2 : -1;
  if (digits < 0) Misfit("with an unknown style of numbers", style);
  char text[64];
  std::snprintf(text, sizeof(text), "%.*f", digits, number);
  return text;
}

/// Returns the case `word {…}` or `other {…}` of a plural or a select.
std::string_view CaseOf(std::string_view word, std::string_view cases) {
  std::string_view other;
  bool has_other = false;
  for (std::string_view rest = cases; rest.find('{') != std::string_view::npos;) {
    const std::size_t open = rest.find('{');
    const std::string_view name = Trimmed(rest.substr(0, open));
    const std::string_view text = Braced(rest, open);
    if (name == word) return text;
    if (name == "other") other = text, has_other = true;
    rest.remove_prefix(open + text.size() + 2);
  }
  if (!has_other) Misfit("without a case for " + std::string(word), cases);
  return other;
}

/// @param counted  what `#` stands for; empty outside of plurals.
std::string RenderCase(std::string_view format, const std::vector<MessageArgument>& arguments,
                       const std::string& counted);

std::string Insert(std::string_view field, const std::vector<MessageArgument>& arguments,
                   const std::string& counted) {
  std::string_view rest = field;
  const std::string_view name = TakeWord(&rest);
  const auto argument = std::ranges::find(arguments, name, &MessageArgument::name);
  if (argument == arguments.end()) Misfit("without its argument", field);
  const auto* number = std::get_if<double>(&argument->value);
  const std::string text =
      number != nullptr ? NumberText(*number) : std::string(std::get<UserMessage>(argument->value));
  const std::string_view kind = TakeWord(&rest);
  if (kind.empty()) return text;
  if (kind == "select") return RenderCase(CaseOf(text, rest), arguments, counted);
  if (number == nullptr) Misfit("whose argument is not a number", field);
  if (kind == "number") return NumberIn(Trimmed(rest), *number);
  if (kind != "plural") Misfit("with an unknown kind of argument", field);
  return RenderCase(CaseOf(*number == 1 ? "one" : "other", rest), arguments, text);
}

std::string RenderCase(std::string_view format, const std::vector<MessageArgument>& arguments,
                       const std::string& counted) {
  std::string text;
  for (std::size_t k = 0; k < format.size(); ++k) {
    if (format[k] == '{') {
      const std::string_view field = Braced(format, k);
      text += Insert(field, arguments, counted);
      k += field.size() + 1;
    } else if (format[k] == '#' && !counted.empty()) {
      text += counted;
    } else {
      text += format[k];
    }
  }
  return text;
}

}  // namespace

std::string Render(std::string_view format, const std::vector<MessageArgument>& arguments) {
  return RenderCase(format, arguments, "");
}

}  // namespace smile::texts
