#pragma once

#include <string>

namespace smile::app {

/// Returns a text as one word of a shell command.
std::string ShellWord(const std::string& word);

}  // namespace smile::app
