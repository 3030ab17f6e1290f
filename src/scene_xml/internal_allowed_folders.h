#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace smile::scene_xml {

/// Folders from which a scene may read files: its own and the search roots, with all below them.
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
  /// @param folder  of the file that names it; nullptr if it has none.
  Search Find(const std::filesystem::path* folder, const std::string& file) const;

  /// Returns the name by which the main file would find this file: relative to the first folder
  /// from which that leads there; absolute if none does.
  std::string NameFromScene(const std::filesystem::path& canonical) const;

 private:
  bool Contain(const std::filesystem::path& canonical) const;

  std::vector<std::filesystem::path> roots_;
  std::vector<std::filesystem::path> allowed_;  // canonical, in the order of the search
};

/// Returns the folder of a file; `.` for a file without a folder.
std::filesystem::path FolderOf(const std::filesystem::path& file);

/// Returns the reason in a message of ReadFile(), without the path at its begin, for a diagnostic
/// that names the file itself.
std::string WithoutPath(std::string reason, const std::string& path);

}  // namespace smile::scene_xml
