#pragma once

#include <filesystem>
#include <vector>

namespace smile::catalog::internal {

/// Returns the folder of the robots that ship.
std::filesystem::path ShippedFolder();
/// Returns the entries of a folder, sorted, and no more than 1000; nothing if it does not exist.
std::vector<std::filesystem::path> EntriesOf(const std::filesystem::path& folder);

}  // namespace smile::catalog::internal
