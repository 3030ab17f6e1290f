#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace smile::scene_xml {

/// The folders a scene may read files from: its own and the search roots, with all below them.
class AllowedFolders {
 public:
  /// @param main_file  nullptr for a text, which lies in no folder.
  AllowedFolders(const std::filesystem::path* main_file,
                 std::vector<std::filesystem::path> search_roots);

  struct FoundFile {
    std::filesystem::path name;       ///< for people
    std::filesystem::path canonical;  ///< without links and dots
  };
  struct Search {
    std::optional<FoundFile> found;
    std::string expected;  ///< else: `expected a file in …`, in words that follow the file's name
  };
  /// Looks for a file beside the one that names it, then in the search roots. It must lie in an
  /// allowed folder after all links have been followed.
  ///
  /// @param folder  of the file that names it; nullptr when it has none.
  Search Find(const std::filesystem::path* folder, const std::string& file) const;

  /// How the main file would name a file that was found: relative to the first folder from which
  /// that leads there; absolute when none does.
  std::string NameFromScene(const std::filesystem::path& canonical) const;

 private:
  bool Contain(const std::filesystem::path& canonical) const;

  std::vector<std::filesystem::path> roots_;
  std::vector<std::filesystem::path> allowed_;  // canonical, in the order of the search
};

/// The folder of a file, as it can be opened.
std::filesystem::path FolderOf(const std::filesystem::path& file);

/// The reason in a message of ReadFile(), which begins with the path, for a diagnostic that names
/// the file itself.
std::string WithoutPath(std::string reason, const std::string& path);

}  // namespace smile::scene_xml
