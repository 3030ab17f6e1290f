#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace smile::library {

/// A robot program that can be started.
struct BrainChoice {
  /// The end of its path, as long as it takes to tell it from the others: `wave.py`, `matlab/um`.
  std::string name;
  std::string kind;            ///< `octave`, `python` or `program`
  std::filesystem::path path;  ///< what brain::BrainProcess takes
  bool imitates = false;       ///< see DeclaresImitation()
};

/// The robot programs in some folders: folder by folder, each in the order of names. A program is a
/// folder with `agentBehavior.m`, a folder NAME with `NAME.py`, a Python file or an executable. A
/// missing folder has none; what is found twice is listed once.
std::vector<BrainChoice> BrainsIn(const std::vector<std::filesystem::path>& folders);

/// The first choice with this name, or whose path ends with it; nullptr without one.
const BrainChoice* BrainNamed(const std::vector<BrainChoice>& choices, const std::string& name);

/// True if a program says that it reads demonstrations: one of the first lines of its script, in a
/// comment or a docstring, is `smile: imitates` (docs/brains.md).
/// @param script  `agentBehavior.m`, the Python file, or a script that starts something else.
bool DeclaresImitation(const std::filesystem::path& script);

}  // namespace smile::library
