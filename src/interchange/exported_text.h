#pragma once

#include <string>
#include <utility>
#include <vector>

#include "interchange/exported_world.h"

namespace smile::interchange {

/// A world in a format of another program.
struct ExportedText {
  std::string text;  ///< of the file itself
  /// Files beside it, which it refers to: their names relative to its folder, and their contents.
  std::vector<std::pair<std::string, std::string>> files{};
  /// What has no counterpart in the format, in words; ExportedWorld::left_out among it.
  std::vector<std::string> left_out{};
};

/// Returns true if two bodies have different friction: formats combine that of two bodies in ways
/// of their own.
bool HasUnequalFriction(const ExportedWorld& world);

}  // namespace smile::interchange
