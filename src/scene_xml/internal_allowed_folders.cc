#include "scene_xml/internal_allowed_folders.h"

#include <algorithm>
#include <cstddef>
#include <system_error>
#include <utility>

#include "base/files.h"

// A scene may come from a stranger, and messages about a file that it names can show parts of that
// file. So includes and meshes are confined to a few folders, by the canonical name of what is
// opened and not by how it is written.

namespace smile::scene_xml {
namespace {

namespace fs = std::filesystem;

// Below the limits of all file systems; keeps absurd names out of messages.
constexpr std::size_t kMaxPathBytes = 1000;

}  // namespace

fs::path FolderOf(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

AllowedFolders::AllowedFolders(const fs::path* main_file, std::vector<fs::path> search_roots)
    : roots_(std::move(search_roots)) {
  std::vector<fs::path> folders = roots_;
  // The scene's own folder is searched first.
  if (main_file) folders.insert(folders.begin(), FolderOf(*main_file));
  for (const fs::path& folder : folders) {
    std::error_code error;
    fs::path canonical = fs::canonical(folder, error);
    // A folder that does not exist allows nothing.
    if (!error) allowed_.push_back(std::move(canonical));
  }
}

bool AllowedFolders::Contain(const fs::path& canonical) const {
  return std::ranges::any_of(allowed_,
                             [&](const fs::path& allowed) { return IsWithin(canonical, allowed); });
}

AllowedFolders::Search AllowedFolders::Find(const fs::path* folder, const std::string& file) const {
  std::vector<fs::path> folders = roots_;
  if (folder) folders.insert(folders.begin(), *folder);
  bool is_outside = false;
  if (!file.empty() && file.size() <= kMaxPathBytes) {
    for (const fs::path& base : folders) {
      const fs::path name = base / file;
      std::error_code error;
      // Links and `..` are resolved before the check, so that neither can lead out of the allowed
      // folders.
      const fs::path canonical = fs::canonical(name, error);
      if (error) continue;
      // The first file that is found and allowed; one outside is passed over, as a later folder may
      // have an allowed file of this name.
      if (Contain(canonical)) return {.found = FoundFile{name, canonical}};
      is_outside = true;
    }
  }
  return {.expected =
              std::string(is_outside ? " elsewhere, expected it in " : ", expected a file in ") +
              (folder ? "the folder of the scene, in a --path folder or below these"
                      : "a --path folder or below it")};
}

std::string AllowedFolders::NameFromScene(const fs::path& canonical) const {
  for (const fs::path& folder : allowed_) {
    if (!IsWithin(canonical, folder)) continue;
    // The name must lead back to the same file.
    const fs::path name = canonical.lexically_relative(folder);
    // Another file of that name may be found first.
    for (const fs::path& earlier : allowed_) {
      std::error_code error;
      const fs::path there = fs::canonical(earlier / name, error);
      if (error || !Contain(there)) continue;
      if (there == canonical) return name.string();
      break;
    }
  }
  return canonical.string();
}

std::string WithoutPath(std::string reason, const std::string& path) {
  if (reason.starts_with(path + ": ")) reason.erase(0, path.size() + 2);
  return reason;
}

}  // namespace smile::scene_xml
