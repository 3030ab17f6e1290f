#include "record/recording_names.h"

#include <cctype>
#include <string_view>

namespace smile::record {
namespace {

constexpr std::size_t kMaxNameBytes = 100;
constexpr int kMaxSameNames = 100'000;

}  // namespace

bool IsRecordingName(const std::string& name) {
  if (name.empty() || name.size() > kMaxNameBytes || name.front() == '.') return false;
  for (const char letter : name) {
    const auto byte = static_cast<unsigned char>(letter);
    const bool is_ordinary = byte >= 0x80 || std::isalnum(byte) != 0;
    if (!is_ordinary && std::string_view(" -_.").find(letter) == std::string_view::npos) {
      return false;
    }
  }
  return true;
}

std::filesystem::path NewDirectory(const std::filesystem::path& root, const std::string& name) {
  std::filesystem::path directory = root / name;
  for (int number = 2; std::filesystem::exists(directory) && number < kMaxSameNames; ++number) {
    directory = root / (name + "-" + std::to_string(number));
  }
  return directory;
}

}  // namespace smile::record
