#include "studio/console.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <optional>
#include <tuple>
#include <utility>

// Finds in a line of output the place to which it refers, so that the page can show file and line.
// The forms are those of compilers and of our own messages, of Python's tracebacks, and of
// Octave's; the first form that fits decides.

namespace smile::studio {
namespace {

// Extensions of brains in Octave, Python and C++. Without this check, times such as `12:30` and
// prefixes such as `error: 3` would be taken for places.
constexpr std::array<std::string_view, 5> kEndings = {".m", ".py", ".cc", ".cpp", ".h"};

/// True for letters of paths in messages; everything beyond ASCII counts.
bool IsOfPath(char letter) {
  const auto byte = static_cast<unsigned char>(letter);
  return byte >= 0x80 || std::isalnum(byte) != 0 ||
         std::string_view("_-+./#").find(letter) != std::string_view::npos;
}

/// Returns the positive number at the begin of a text; nullopt if there is none.
std::optional<int> LeadingNumber(std::string_view text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || number < 1) return std::nullopt;
  return number;
}

/// Returns the path at the end of a text.
std::string_view TrailingPath(std::string_view text) {
  std::size_t begin = text.size();
  while (begin > 0 && IsOfPath(text[begin - 1])) --begin;
  return text.substr(begin);
}

/// True if the path has an extension of a program.
bool NamesProgram(std::string_view path) {
  return std::ranges::any_of(kEndings, [path](std::string_view ending) {
    return path.size() > ending.size() && path.ends_with(ending);
  });
}

using Place = std::pair<std::string, int>;

/// Finds a place of the form `name.m:12`.
std::optional<Place> PlaceWithColon(std::string_view text) {
  for (std::size_t at = text.find(':'); at != std::string_view::npos; at = text.find(':', at + 1)) {
    // The text before each colon in turn: a line may have several, as in `error: wave.m:12: ...`.
    const std::string_view path = TrailingPath(text.substr(0, at));
    const auto line = LeadingNumber(text.substr(at + 1));
    if (line && NamesProgram(path)) return Place(path, *line);
  }
  return std::nullopt;
}

/// Finds a place as Python prints it: `File "name.py", line 12`.
std::optional<Place> PlaceOfPython(std::string_view text) {
  constexpr std::string_view kBegin = "File \"", kMiddle = "\", line ";
  const std::size_t begin = text.find(kBegin);
  if (begin == std::string_view::npos) return std::nullopt;
  const std::size_t middle = text.find(kMiddle, begin + kBegin.size());
  if (middle == std::string_view::npos) return std::nullopt;
  const auto line = LeadingNumber(text.substr(middle + kMiddle.size()));
  if (!line) return std::nullopt;
  const std::size_t first = begin + kBegin.size();
  return Place(text.substr(first, middle - first), *line);
}

/// Finds a place as Octave prints it: `name at line 12`.
std::optional<Place> PlaceOfOctave(std::string_view text) {
  constexpr std::string_view kAt = " at line ";
  const std::size_t at = text.find(kAt);
  if (at == std::string_view::npos) return std::nullopt;
  const std::string_view name = TrailingPath(text.substr(0, at));
  const auto line = LeadingNumber(text.substr(at + kAt.size()));
  if (name.empty() || !line) return std::nullopt;
  // Octave names the function; its file has the same name.
  return Place(std::string(name) + ".m", *line);
}

}  // namespace

ConsoleLine ParseConsoleLine(std::string_view text) {
  // Cut before it is searched, so that one line costs a bounded time.
  ConsoleLine line{.text = std::string(text.substr(0, Console::kMaxLineBytes))};
  for (const auto find : {&PlaceWithColon, &PlaceOfPython, &PlaceOfOctave}) {
    const auto place = find(line.text);
    if (!place) continue;
    std::tie(line.file, line.line) = *place;
    break;
  }
  return line;
}

void Console::Write(std::string_view text) {
  // Parsed by the thread that reads the output, without the lock.
  ConsoleLine line = ParseConsoleLine(text);
  const std::lock_guard lock(mutex_);
  // The newest lines are kept, as errors come last.
  if (lines_.size() == kMaxLines) {
    lines_.erase(lines_.begin());
    ++num_lost_;
  }
  lines_.push_back(std::move(line));
}

std::vector<ConsoleLine> Console::Take() {
  const std::lock_guard lock(mutex_);
  std::vector<ConsoleLine> taken = std::exchange(lines_, {});
  const std::size_t num_lost = std::exchange(num_lost_, 0);
  if (num_lost > 0) {
    taken.insert(taken.begin(), {.text = "... " + std::to_string(num_lost) + " lines omitted"});
  }
  return taken;
}

}  // namespace smile::studio
