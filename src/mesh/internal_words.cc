#include "mesh/internal_words.h"

#include <algorithm>
#include <charconv>

#include "base/wording.h"
#include "mesh/internal_triangle_soup.h"

namespace smile::mesh {
namespace {

// Not std::isblank(), whose answer depends on the locale. A carriage return before the line end
// counts as a blank.
bool IsBlank(char letter) {
  return letter == ' ' || letter == '\t' || letter == '\r' || letter == '\v' || letter == '\f';
}

/// ASCII only, independent of the locale.
char Lower(char letter) {
  return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
}

}  // namespace

std::string_view Words::NextInLine() {
  std::size_t begin = 0;
  while (begin < rest_.size() && IsBlank(rest_[begin])) ++begin;
  std::size_t end = begin;
  while (end < rest_.size() && !IsBlank(rest_[end]) && rest_[end] != '\n') ++end;
  const std::string_view word = rest_.substr(begin, end - begin);
  rest_.remove_prefix(end);
  return word;
}

bool Words::NextLine() {
  const std::size_t end = rest_.find('\n');
  if (end == std::string_view::npos) return false;
  rest_.remove_prefix(end + 1);
  ++line_;
  return !rest_.empty();
}

std::string_view Words::Next() {
  while (true) {
    const std::string_view word = NextInLine();
    if (!word.empty() || !NextLine()) return word;
  }
}

float Words::Number(std::string_view word) const {
  std::string_view digits = word;
  if (digits.starts_with('+')) digits.remove_prefix(1);
  // Parse as double: values beyond the range of a float become 0 or infinity.
  double number = 0;
  // from_chars() knows neither a plus sign nor a locale.
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (error != std::errc() || end != digits.data() + digits.size()) {
    if (word.empty()) Fail("the end", "a number");
    Fail(Quoted(word), "a number");
  }
  return static_cast<float>(number);
}

void Words::Fail(const std::string& found, const std::string& expected) const {
  throw BadMesh("line " + std::to_string(line_) + ": found " + found + ", expected " + expected);
}

bool IsSameWord(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char x, char y) { return Lower(x) == Lower(y); });
}

}  // namespace smile::mesh
