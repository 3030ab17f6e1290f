#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

namespace smile::studio {

/// The files of the page, read once: nothing else in the file system can be asked for.
class Page {
 public:
  struct File {
    std::string type, bytes;
    std::string gzipped;  ///< the same, smaller; empty if there is none
    std::string tag;      ///< another one for other bytes
  };

  /// @throws std::runtime_error saying how it is built when there is no page in the folder.
  explicit Page(const std::filesystem::path& folder);

  /// `/studio.js`; `/` is `/index.html`. nullptr if there is none.
  const File* Find(std::string_view path) const;

 private:
  std::map<std::string, File, std::less<>> files_;
};

}  // namespace smile::studio
