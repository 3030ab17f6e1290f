#pragma once

#include <filesystem>
#include <string>

namespace smile::recording {

/// True of a name that stays in its folder on every system.
bool IsRecordingName(const std::string& name);
/// What such names are, for messages.
inline constexpr const char* kNameForm =
    "up to 100 letters, digits, spaces, - _ and ., not . first";

/// Such a name, as like the title as can be: what it may not have becomes `_`.
std::string RecordingNameFor(const std::string& title);

/// A directory under the root for a new recording: `um`, or `um-2` if that is taken, … One that
/// holds nothing but a beginning that was abandoned is free.
std::filesystem::path NewDirectory(const std::filesystem::path& root, const std::string& name);

}  // namespace smile::recording
