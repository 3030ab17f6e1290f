#pragma once

#include <filesystem>

namespace smile::recording {

std::filesystem::path SegmentText(const std::filesystem::path& directory, int segment);
std::filesystem::path SegmentPictures(const std::filesystem::path& directory, int segment);

/// Removes the text and the pictures of a segment; other files in its folder stay.
void RemoveSegment(const std::filesystem::path& directory, int segment);
/// Removes texts and pictures of all segments, and `frames.csv`.
void RemoveClassicView(const std::filesystem::path& directory);

}  // namespace smile::recording
