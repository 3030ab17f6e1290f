#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>

namespace smile::web_server {

/// Files of a folder, read once: no request reaches any other file.
class StaticFiles {
 public:
  struct File {
    std::string type;  ///< media type
    std::shared_ptr<const std::string> bytes;
    std::shared_ptr<const std::string> gzipped;  ///< nullptr without a `.gz` file beside it
    std::string tag;                             ///< entity tag; differs for other bytes
  };

  /// @throws std::runtime_error if the folder has no index.html.
  explicit StaticFiles(const std::filesystem::path& folder);

  /// Returns the file at a path like `/studio.js`; `/` is `/index.html`. nullptr if it is missing.
  const File* Find(std::string_view path) const;

 private:
  std::map<std::string, File, std::less<>> files_;
};

}  // namespace smile::web_server
