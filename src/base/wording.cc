#include "base/wording.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <vector>

namespace smile {
namespace {

constexpr std::size_t kMaxQuotedBytes = 60;
constexpr std::size_t kMaxWordBytes =
    40;  // longer than any known name; keeps the table below small

bool SameLetter(char a, char b) {
  return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
}

/// Returns how many letters must be added, dropped, changed or swapped with their neighbor to turn
/// one word into the other (restricted Damerau-Levenshtein distance); case is ignored.
std::size_t EditDistance(std::string_view a, std::string_view b) {
  // Dynamic programming: cost[i][j] is the distance of the first i letters of a to the first j
  // letters of b.
  std::vector<std::vector<std::size_t>> cost(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        cost[i][j] = i + j;
        continue;
      }
      // Three ways to reach this cell: drop a letter of a, add one of b, or change one into the
      // other.
      const std::size_t change = SameLetter(a[i - 1], b[j - 1]) ? 0 : 1;
      cost[i][j] = std::min({cost[i - 1][j] + 1, cost[i][j - 1] + 1, cost[i - 1][j - 1] + change});
      // Neighbors swapped: the commonest slip, counted as one.
      if (i > 1 && j > 1 && SameLetter(a[i - 1], b[j - 2]) && SameLetter(a[i - 2], b[j - 1])) {
        cost[i][j] = std::min(cost[i][j], cost[i - 2][j - 2] + 1);
      }
    }
  }
  return cost[a.size()][b.size()];
}

}  // namespace

std::string NumberText(double number) {
  if (std::isnan(number)) return "NaN";
  if (std::isinf(number)) return number > 0 ? "Inf" : "-Inf";
  char buffer[32];
  // The shortest text that reads back as the same number.
  const auto result = std::to_chars(buffer, buffer + sizeof buffer, number);
  return {buffer, result.ptr};
}

std::string Printable(std::string_view text) {
  std::string printable(text);
  for (char& letter : printable) {
    const bool is_control = static_cast<unsigned char>(letter) < 0x20 || letter == 0x7F;
    if (is_control) letter = '?';
  }
  return printable;
}

std::string Quoted(std::string_view text) {
  std::string_view shown = text;
  if (text.size() > kMaxQuotedBytes) {
    std::size_t end = kMaxQuotedBytes;
    // Never cut inside a UTF-8 letter: its later bytes all look like 10xxxxxx.
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
    shown = text.substr(0, end);
  }
  return "\"" + Printable(shown) + (shown.size() < text.size() ? "…\"" : "\"");
}

std::string OneOf(std::span<const std::string_view> words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 == words.size() ? " or " : ", ";
    text += words[i];
  }
  return text;
}

std::string DidYouMean(std::string_view word, std::span<const std::string_view> known) {
  // The table has a cell for each pair of letters; words from outside may be of any length.
  if (word.empty() || word.size() > kMaxWordBytes) return {};
  // A third of the letters may be wrong: enough for typing slips, too few to mix up two words.
  const std::size_t allowed = std::max<std::size_t>(1, word.size() / 3);
  std::string_view best;
  std::size_t best_distance = allowed + 1;
  for (std::string_view candidate : known) {
    const std::size_t distance = EditDistance(word, candidate);
    // The first of equally near words is suggested. A word of which every letter differs is not.
    if (distance < best_distance && distance < candidate.size()) {
      best = candidate;
      best_distance = distance;
    }
  }
  if (best.empty()) return {};
  return "; did you mean " + Quoted(best) + "?";
}

}  // namespace smile
