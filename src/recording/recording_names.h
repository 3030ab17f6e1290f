#pragma once

#include <filesystem>
#include <string>

#include "texts/user_message.h"

namespace smile::recording {

/// True if a name is valid on every file system and cannot lead out of its folder.
bool IsRecordingName(const std::string& name);
/// Returns the fault of a name that is not valid.
texts::UserMessage FaultOfName(const std::string& name);

/// Returns a valid name similar to the title; invalid letters become `_`.
std::string RecordingNameFor(const std::string& title);

/// Returns a directory under the root for a new recording: `um`, or `um-2` if that is taken, … A
/// directory with an abandoned beginning counts as free.
std::filesystem::path NewDirectory(const std::filesystem::path& root, const std::string& name);

}  // namespace smile::recording
