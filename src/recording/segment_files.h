#pragma once

#include <filesystem>

namespace smile::recording {

std::filesystem::path SegmentText(const std::filesystem::path& directory, int segment);
std::filesystem::path SegmentPictures(const std::filesystem::path& directory, int segment);

/// Takes away the text of a segment and its pictures; what else lies among these stays.
void RemoveSegment(const std::filesystem::path& directory, int segment);
/// The same of all segments, and `frames.csv`.
void RemoveClassicView(const std::filesystem::path& directory);

}  // namespace smile::recording
