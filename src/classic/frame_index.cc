#include "classic/frame_index.h"

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

#include "base/diagnostic.h"
#include "base/files.h"
#include "base/wording.h"

namespace smile::classic {
namespace {

// Enough for weeks of recording; a larger file is not an index.
constexpr std::size_t kMaxIndexBytes = 256u << 20;

/// Removes a number and the letter after it from the front of a text; nullopt, with the text
/// unchanged, if they are not there.
std::optional<std::uint64_t> TakeNumber(std::string_view* text, char letter) {
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), number);
  const auto size = static_cast<std::size_t>(end - text->data());
  if (error != std::errc() || size >= text->size() || (*text)[size] != letter) return std::nullopt;
  text->remove_prefix(size + 1);
  return number;
}

/// Parses a line `frame,tick,image`.
FrameEntry ReadEntry(const std::filesystem::path& csv, int number, std::string_view line) {
  const auto fail = [&](const std::string& expected) {
    throw InputError({csv.string(), number, "",
                      "found " + Quoted(std::string(line)) + ", expected " + expected});
  };
  std::string_view rest = line;
  const auto frame = TakeNumber(&rest, ','), tick = TakeNumber(&rest, ',');
  if (!frame || !tick) fail("frame,tick,image");
  FrameEntry entry{.tick = tick.value_or(0), .image = std::string(rest)};
  if (rest.empty()) return entry;
  const auto segment = TakeNumber(&rest, '/'), picture = TakeNumber(&rest, '.');
  // The path is not used as it is written: only this form is accepted, so it cannot lead out of the
  // recording.
  if (!segment || *segment > 1'000'000'000 || !picture || rest != "png") {
    fail("a picture like 3/14.png");
  }
  entry.segment = static_cast<int>(segment.value_or(0));
  return entry;
}

}  // namespace

std::vector<FrameEntry> ReadFrameIndex(const std::filesystem::path& csv) {
  const std::string text = ReadFile(csv, kMaxIndexBytes);
  std::vector<FrameEntry> entries;
  int number = 0;
  for (std::size_t start = 0;;) {
    const std::size_t end = text.find('\n', start);
    // A last line without newline was interrupted and is ignored.
    if (end == std::string::npos) return entries;
    const std::string_view line(text.data() + start, end - start);
    start = end + 1;
    if (++number == 1) continue;  // the head
    FrameEntry entry = ReadEntry(csv, number, line);
    if (!entries.empty() && entry.tick <= entries.back().tick) {
      throw InputError({csv.string(), number, "",
                        "found tick " + std::to_string(entry.tick) + ", expected more than " +
                            std::to_string(entries.back().tick)});
    }
    entries.push_back(std::move(entry));
  }
}

recording::TraceTick ReadMomentOf(const FrameEntry& frame, const std::filesystem::path& csv,
                                  recording::TraceReader* trace) {
  if (auto moment = trace->At(frame.tick)) return *std::move(moment);
  throw InputError(
      {csv.string(), 0, "",
       "has a frame of tick " + std::to_string(frame.tick) + ", which is missing in the trace"});
}

}  // namespace smile::classic
