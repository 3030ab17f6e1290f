#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace smile::web_server {

/// Content of the answer to a GET.
struct HttpResponse {
  std::string type;  ///< media type: `application/json`, `image/png`, …
  std::string body;
  std::string file_name;  ///< name to save it under; empty: the browser displays it
  /// In place of `body`: bytes that many answers share, compressed by gzip. Null: `body` counts.
  std::shared_ptr<const std::string> gzipped = nullptr;
};

/// Returns the content at a path, nullopt if there is none. The path is decoded, begins with `/`
/// and contains no `.` or `..` segment. Called from several threads at once.
using HttpHandler = std::function<std::optional<HttpResponse>(const std::string& path)>;

}  // namespace smile::web_server
