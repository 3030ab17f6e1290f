#include "recording/recording_names.h"

#include <algorithm>
#include <cctype>
#include <string_view>

#include "base/wording.h"
#include "recording/beginning.h"

// Names of recordings are names of directories and parts of URLs: no separator, no leading point,
// valid on common file systems.

namespace smile::recording {
namespace {

// File systems allow 255 bytes; a number may be appended.
constexpr std::size_t kMaxNameBytes = 100;
constexpr int kMaxSameNames = 100'000;

/// True for letters allowed in names: UTF-8 beyond ASCII, alphanumerics and a few signs. No
/// separator, no control character.
bool IsNameLetter(char letter) {
  const auto byte = static_cast<unsigned char>(letter);
  const bool is_ordinary = byte >= 0x80 || std::isalnum(byte) != 0;
  return is_ordinary || std::string_view(" -_.").find(letter) != std::string_view::npos;
}

}  // namespace

bool IsRecordingName(const std::string& name) {
  // A leading point would hide the folder or name a parent.
  return !name.empty() && name.size() <= kMaxNameBytes && name.front() != '.' &&
         std::ranges::all_of(name, &IsNameLetter);
}

texts::UserMessage FaultOfName(const std::string& name) {
  return texts::Say("library.badName", {{"name", Quoted(name)}});
}

std::string RecordingNameFor(const std::string& title) {
  std::string name = title;
  if (name.size() > kMaxNameBytes) {
    // Moves the cut back over UTF-8 continuation bytes (10xxxxxx), so that no character is split.
    std::size_t end = kMaxNameBytes;
    while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xc0) == 0x80) --end;
    name.resize(end);
  }
  for (char& letter : name) {
    if (!IsNameLetter(letter)) letter = '_';
  }
  if (name.empty()) return "recording";
  // Cutting may leave nothing of the name, and every name needs a valid first letter.
  if (name.front() == '.') name.front() = '_';
  return name;
}

std::filesystem::path NewDirectory(const std::filesystem::path& root, const std::string& name) {
  std::filesystem::path directory = root / name;
  const auto is_taken = [&] {
    return std::filesystem::exists(directory) && !IsAbandoned(directory);
  };
  for (int number = 2; is_taken() && number < kMaxSameNames; ++number) {
    directory = root / (name + "-" + std::to_string(number));
  }
  return directory;
}

}  // namespace smile::recording
