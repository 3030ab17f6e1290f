#include "web_server/internal_static_files.h"

#include <cstdio>
#include <stdexcept>

#include "base/files.h"
#include "base/state_hash.h"

// Reading all files at the start costs a few megabytes and makes every later answer safe and fast:
// no path of a request ever reaches the file system.

namespace smile::web_server {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxFileBytes = 32 << 20;

/// Returns the type in the header `Content-Type`, by the file's extension.
std::string MediaTypeOf(const fs::path& file) {
  static const std::map<std::string, std::string> kTypes = {
      {".html", "text/html; charset=utf-8"},
      {".js", "text/javascript; charset=utf-8"},
      {".css", "text/css; charset=utf-8"},
      {".map", "application/json"},
      {".json", "application/json"},
      {".svg", "image/svg+xml"},
      {".png", "image/png"},
      {".woff2", "font/woff2"}};
  const auto type = kTypes.find(file.extension().string());
  return type == kTypes.end() ? "application/octet-stream" : type->second;
}

/// Returns the tag by which a browser asks if its copy is up to date: a hash of the content.
std::string EntityTagOf(std::string_view bytes) {
  StateHash hash;
  hash.Add(bytes);
  // W/, two quotes, 16 digits and the zero at the end.
  char tag[21];
  std::snprintf(tag, sizeof tag, "W/\"%016llx\"", static_cast<unsigned long long>(hash.value()));
  return tag;
}

}  // namespace

StaticFiles::StaticFiles(const fs::path& folder) {
  if (!fs::is_regular_file(folder / "index.html")) {
    throw std::runtime_error(folder.string() + ": this folder has no index.html to serve");
  }
  const auto read = [](const fs::path& file) {
    return std::make_shared<const std::string>(ReadFile(file, kMaxFileBytes));
  };
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const fs::path& path = entry.path();
    // Links are skipped, as they could lead out of the folder.
    // Compressed copies are served in place of their originals, not under their own names.
    if (!entry.is_regular_file() || entry.is_symlink() || path.extension() == ".gz") continue;
    File file{.type = MediaTypeOf(path), .bytes = read(path)};
    const fs::path gzipped = path.string() + ".gz";
    if (fs::is_regular_file(gzipped)) file.gzipped = read(gzipped);
    // Of the original bytes also when the compressed ones are sent, hence weak (RFC 9110, 8.8.1).
    file.tag = EntityTagOf(*file.bytes);
    files_["/" + fs::relative(path, folder).generic_string()] = std::move(file);
  }
}

const StaticFiles::File* StaticFiles::Find(std::string_view path) const {
  const auto file = files_.find(path == "/" ? std::string_view("/index.html") : path);
  return file == files_.end() ? nullptr : &file->second;
}

}  // namespace smile::web_server
