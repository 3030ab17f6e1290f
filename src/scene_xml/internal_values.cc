#include "scene_xml/internal_values.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "scene_xml/internal_letters.h"
#include "scene_xml/value_ranges.h"

// Text to values, independent of the locale and without partial matches: std::from_chars must
// consume all of the trimmed text. Lengths of input are bounded before anything is parsed.

namespace smile::scene_xml {
namespace {

constexpr std::size_t kMaxNumberBytes = 100;  // longer than any sensible number; bounds the work

std::string_view Trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

/// Removes a leading plus, which from_chars() does not accept.
std::string_view WithoutPlus(std::string_view text) {
  // `+-1` is no number.
  return text.size() > 1 && text[0] == '+' && text[1] != '-' ? text.substr(1) : text;
}

}  // namespace

template <class Float>
std::optional<Float> ParseNumber(std::string_view text) {
  text = WithoutPlus(Trimmed(text));
  if (text.empty() || text.size() > kMaxNumberBytes) return std::nullopt;
  Float number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  // std::from_chars accepts `inf` and `nan`; unlike std::strtod it ignores the locale.
  if (!std::isfinite(number)) return std::nullopt;
  return number + Float{0};  // -0 becomes 0: one zero is enough for a scene
}

template <std::size_t N, class Float>
std::optional<std::array<Float, N>> ParseNumbers(std::string_view text) {
  text = Trimmed(text);
  if (text.size() < 2 || text.front() != '(' || text.back() != ')') return std::nullopt;
  // Nested parentheses need no check: no number contains one.
  text = text.substr(1, text.size() - 2);
  std::array<Float, N> numbers;
  for (std::size_t i = 0; i < N; ++i) {
    const std::size_t comma = text.find(',');
    // Only the last number has no comma behind it.
    if ((comma == std::string_view::npos) != (i + 1 == N)) return std::nullopt;
    const std::optional<Float> number = ParseNumber<Float>(text.substr(0, comma));
    if (!number) return std::nullopt;
    numbers[i] = *number;
    if (comma != std::string_view::npos) text = text.substr(comma + 1);
  }
  return numbers;
}

template std::optional<double> ParseNumber(std::string_view);
template std::optional<long double> ParseNumber(std::string_view);
template std::optional<std::array<double, 3>> ParseNumbers(std::string_view);
template std::optional<std::array<double, 9>> ParseNumbers(std::string_view);
template std::optional<std::array<long double, 3>> ParseNumbers(std::string_view);

std::optional<int> ParseCount(std::string_view text) {
  text = WithoutPlus(Trimmed(text));
  int count = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return count;
}

std::optional<bool> ParseBoolean(std::string_view text) {
  text = Trimmed(text);
  if (text == "true" || text == "1") return true;
  if (text == "false" || text == "0") return false;
  return std::nullopt;
}

bool IsId(std::string_view text) {
  return text.size() <= kMaxIdBytes && std::all_of(text.begin(), text.end(), IsIdLetter);
}

bool IsRenamedId(std::string_view text) {
  const std::size_t hash = text.find('#');
  // Exactly one # can pass, since it is no letter of ids.
  if (hash == 0 || hash == std::string_view::npos) return false;
  const std::string_view number = text.substr(hash + 1);
  return IsId(text.substr(0, hash)) && !number.empty() && number.size() <= kMaxRenameDigits &&
         std::all_of(number.begin(), number.end(), IsDigit);
}

std::string PlainNumberText(double number) {
  char buffer[400];  // the largest double has 309 digits
  const auto result =
      std::to_chars(buffer, buffer + sizeof buffer, number, std::chars_format::fixed);
  return {buffer, result.ptr};
}

}  // namespace smile::scene_xml
