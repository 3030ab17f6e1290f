#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "base/json.h"

namespace smile::library {

/// Scene catalog: the scenes of a folder by name; `tower` is `tower.xml`.
class SceneCatalog {
 public:
  static constexpr std::size_t kMaxScenes = 500;

  explicit SceneCatalog(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Returns at most kMaxScenes scenes, sorted by name: `[{"name","title","picture"}]`. A title is
  /// the first phrase of the comment before the root element, or the name if this is missing. A
  /// picture is an HTTP path.
  Json List() const;
  /// Returns the file of a scene; nullopt if it does not exist. No name leads out of the folder.
  std::optional<std::filesystem::path> FileOf(const std::string& name) const;

  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
};

}  // namespace smile::library
