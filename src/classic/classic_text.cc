// Formats of single values in classic texts. They match the 2015 program to the letter, so that its
// tools can read these recordings and files can be compared.

#include "classic/classic_text.h"

#include <charconv>
#include <cmath>

namespace smile::classic {

std::string ClassicNumber(double number) {
  // The original prints Java floats: shortest digits of single precision, plain from 1e-3 to below
  // 1e7. Rounded to float first: the shortest text of the double would have more digits.
  const auto value = static_cast<float>(number);
  if (std::isnan(value)) return "NaN";
  if (std::isinf(value)) return value < 0 ? "-Infinity" : "Infinity";
  char buffer[32];
  const auto size = std::fabs(value);
  const bool is_plain = value == 0 || (size >= 1e-3f && size < 1e7f);
  const auto end =
      std::to_chars(buffer, buffer + sizeof buffer, value,
                    is_plain ? std::chars_format::fixed : std::chars_format::scientific)
          .ptr;
  std::string text(buffer, end);
  if (is_plain) return text.find('.') == std::string::npos ? text + ".0" : text;

  // 3.4144908e-04 becomes 3.4144908E-4, 1e+07 becomes 1.0E7.
  const std::size_t e = text.find('e');
  std::string mantissa = text.substr(0, e);
  if (mantissa.find('.') == std::string::npos) mantissa += ".0";
  // std::stoi() drops the plus sign and leading zeros of the exponent.
  return mantissa + "E" + std::to_string(std::stoi(text.substr(e + 1)));
}

std::string ClassicValue(std::string_view text) {
  std::string escaped;
  for (char letter : text) {
    if (letter == ',') escaped += '\\';
    escaped += letter;
  }
  return escaped;
}

std::string_view ClassicHandName(demonstrator::HandName hand) {
  switch (hand) {
    case demonstrator::HandName::kLeft:
      return "LeftHand";
    case demonstrator::HandName::kRight:
      return "RightHand";
    case demonstrator::HandName::kBoth:
      return "BothHands";
    case demonstrator::HandName::kAny:
      return "AnyHand";
  }
  return "";
}

std::string_view ClassicWordFor(sim::EventKind kind) {
  for (const ClassicWord& word : kClassicWords) {
    if (word.kind == kind) return word.word;
  }
  return "";
}

}  // namespace smile::classic
