#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "base/json.h"

namespace smile::library {

/// The scenes in a folder, by name: `tower` is `tower.xml`.
class Gallery {
 public:
  static constexpr std::size_t kMaxScenes = 500;

  explicit Gallery(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// By name, at most kMaxScenes: `[{"name","title","picture"}]`. A title is how the comment begins
  /// that stands before all else in the file; without one it is the name. A picture is a path over
  /// HTTP.
  Json List() const;
  /// nullopt if there is no such scene. No name leads out of the folder.
  std::optional<std::filesystem::path> FileOf(const std::string& name) const;

  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
};

}  // namespace smile::library
