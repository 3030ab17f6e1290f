#pragma once

#include <filesystem>
#include <mutex>
#include <optional>
#include <string>

#include "base/json.h"
#include "library/library.h"
#include "library/scene_catalog.h"
#include "library/thumbnail_queue.h"
#include "web_server/http.h"

namespace smile::library {

struct ContentRoutesOptions {
  std::filesystem::path scenes;      ///< the catalog's folder
  std::filesystem::path recordings;  ///< folder of the library
  Json presets = Json::array();      ///< `[{"name","title"}]`
};

/// Content routes: serves scenes and recordings, their thumbnails and their files over HTTP; see
/// docs/studio-protocol.md. Thread-safe.
class ContentRoutes {
 public:
  explicit ContentRoutes(ContentRoutesOptions options);

  /// Returns the content at a path; nullopt if the path does not exist. Waits while a thumbnail is
  /// rendered.
  /// @throws InputError if a scene or recording cannot be read; std::runtime_error with the reason
  ///         if rendering is unavailable or too many thumbnails are queued.
  std::optional<web_server::HttpResponse> Get(const std::string& path);

 private:
  std::optional<web_server::HttpResponse> GetScene(const std::string& name);
  std::optional<web_server::HttpResponse> GetRecording(const std::string& name);
  /// Returns a film that a page has made.
  std::optional<web_server::HttpResponse> GetFilm(const std::string& name);
  std::optional<web_server::HttpResponse> PictureOf(const std::string& id,
                                                    std::optional<std::size_t> segment);
  /// Returns the end of a recording as the robot sees it.
  std::optional<web_server::HttpResponse> EyePictureOf(const std::string& id);

  ContentRoutesOptions options_;
  SceneCatalog catalog_;
  Library library_;
  std::mutex packing_;  ///< one ZIP file or film at a time: they are large
  ThumbnailQueue thumbnails_;
};

}  // namespace smile::library
