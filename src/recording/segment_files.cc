#include "recording/segment_files.h"

#include <algorithm>
#include <cctype>
#include <string>
#include <system_error>
#include <vector>

// The classic view has one text and one folder of pictures per segment, named by its number. Only
// files with such names are deleted, as users may keep others beside them.

namespace smile::recording {
namespace {

bool IsNumber(const std::string& name) {
  return !name.empty() &&
         std::ranges::all_of(name, [](unsigned char letter) { return std::isdigit(letter) != 0; });
}

/// True for names such as `12.png`, with any number.
bool IsNumbered(const std::filesystem::path& path, const std::string& extension) {
  return path.extension() == extension && IsNumber(path.stem().string());
}

/// Deletes the numbered pictures of a folder, and the folder if nothing else is in it.
void RemovePictures(const std::filesystem::path& folder) {
  // Collected first: deleting while iterating is unspecified.
  std::vector<std::filesystem::path> pictures;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const bool is_picture = entry.is_regular_file() && IsNumbered(entry.path(), ".png");
    if (is_picture) pictures.push_back(entry.path());
  }
  for (const auto& picture : pictures) std::filesystem::remove(picture);
  // Folders with other files stay.
  std::error_code not_empty;
  std::filesystem::remove(folder, not_empty);
}

}  // namespace

std::filesystem::path SegmentText(const std::filesystem::path& directory, int segment) {
  return directory / (std::to_string(segment) + ".txt");
}

std::filesystem::path SegmentPictures(const std::filesystem::path& directory, int segment) {
  return directory / std::to_string(segment);
}

void RemoveSegment(const std::filesystem::path& directory, int segment) {
  std::filesystem::remove(SegmentText(directory, segment));
  const auto folder = SegmentPictures(directory, segment);
  if (std::filesystem::is_directory(folder)) RemovePictures(folder);
}

void RemoveClassicView(const std::filesystem::path& directory) {
  std::vector<std::filesystem::path> texts, folders;
  for (const auto& entry : std::filesystem::directory_iterator(directory)) {
    if (entry.is_regular_file() && IsNumbered(entry.path(), ".txt")) texts.push_back(entry.path());
    if (entry.is_directory() && IsNumber(entry.path().filename().string())) {
      folders.push_back(entry.path());
    }
  }
  for (const auto& text : texts) std::filesystem::remove(text);
  for (const auto& folder : folders) RemovePictures(folder);
  std::filesystem::remove(directory / "frames.csv");
}

}  // namespace smile::recording
