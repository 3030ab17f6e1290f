#pragma once

#include <filesystem>
#include <string>

namespace smile::datasets {

/// Folder of things that pages have made, in that of the recordings.
struct ProductFolder {
  const char* folder = "";
  const char* kind = "";  ///< one of its things, for messages
};

/// Returns the path of a new thing.
/// @param name    comes from anyone.
/// @param ending  of the file; empty for a folder.
/// @throws page::RequestError if the name is invalid or taken, or if the folder is anything else.
std::filesystem::path NewPathIn(const std::filesystem::path& root, const ProductFolder& products,
                                const std::string& name, const std::string& ending = "");

}  // namespace smile::datasets
