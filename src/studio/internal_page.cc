#include "studio/internal_page.h"

#include <cstdio>
#include <stdexcept>

#include "base/files.h"
#include "base/state_hash.h"

namespace smile::studio {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxFileBytes = 32 << 20;

std::string PageFileType(const fs::path& file) {
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

std::string PageFileTag(std::string_view bytes) {
  StateHash hash;
  hash.Add(bytes);
  char tag[19];
  std::snprintf(tag, sizeof tag, "\"%016llx\"", static_cast<unsigned long long>(hash.value()));
  return tag;
}

}  // namespace

Page::Page(const fs::path& folder) {
  if (!fs::is_regular_file(folder / "index.html")) {
    throw std::runtime_error(folder.string() +
                             ": the studio's page is not built; ./run studio builds it");
  }
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const fs::path& file = entry.path();
    if (!entry.is_regular_file() || entry.is_symlink() || file.extension() == ".gz") continue;
    File read{.type = PageFileType(file), .bytes = ReadFile(file, kMaxFileBytes)};
    const fs::path gzipped = file.string() + ".gz";
    if (fs::is_regular_file(gzipped)) read.gzipped = ReadFile(gzipped, kMaxFileBytes);
    read.tag = PageFileTag(read.bytes);
    files_["/" + fs::relative(file, folder).generic_string()] = std::move(read);
  }
}

const Page::File* Page::Find(std::string_view path) const {
  const auto file = files_.find(path == "/" ? std::string_view("/index.html") : path);
  return file == files_.end() ? nullptr : &file->second;
}

}  // namespace smile::studio
