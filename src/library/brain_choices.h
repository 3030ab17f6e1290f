#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace smile::library {

/// A brain that can be started.
struct BrainChoice {
  /// Shortest end of its path that no other brain has: `wave.py`, `matlab/learner`.
  std::string name;
  std::string kind;            ///< `octave`, `python` or `program`
  std::filesystem::path path;  ///< for brain::BrainProcess
  bool imitates = false;       ///< see DeclaresImitation()
};

/// Returns the brains in some folders: folder by folder, each sorted by name. A brain is a folder
/// with `agentBehavior.m`, a folder NAME with `NAME.py`, a Python file or an executable. Missing
/// folders are skipped; duplicates are listed once.
std::vector<BrainChoice> BrainsIn(const std::vector<std::filesystem::path>& folders);

/// Returns the folders of brains: one's own come first, since the first match of a name wins, then
/// the shipped ones.
std::vector<std::filesystem::path> BrainFolders(std::vector<std::filesystem::path> own);

/// Returns the first choice with this name or with a path that ends with it, also for a former name
/// of a shipped brain; nullptr if none matches.
const BrainChoice* BrainNamed(const std::vector<BrainChoice>& choices, const std::string& name);

/// Returns the present path of a shipped brain if `brain` is its former path (`matlab/um` is now
/// `matlab/learner`) and no longer exists; otherwise returns `brain`. Scripts with former paths
/// continue to work.
std::filesystem::path PresentBrainPath(const std::filesystem::path& brain);

/// Returns true if a brain declares that it reads demonstrations: one of the first lines of its
/// script, in a comment or a docstring, is `smile: imitates` (docs/brains.md).
/// @param script  `agentBehavior.m`, the Python file, or a script that starts something else.
bool DeclaresImitation(const std::filesystem::path& script);

}  // namespace smile::library
