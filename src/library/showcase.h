#pragma once

#include <filesystem>
#include <mutex>
#include <optional>
#include <string>

#include "base/json.h"
#include "library/darkroom.h"
#include "library/gallery.h"
#include "library/library.h"
#include "web_server/http.h"

namespace smile::library {

struct ShowcaseOptions {
  std::filesystem::path scenes;      ///< the gallery's folder
  std::filesystem::path recordings;  ///< the library's
  Json presets = Json::array();      ///< `[{"name","title"}]`
};

/// What is looked at over HTTP: scenes and recordings, their pictures and their files, see
/// docs/studio-protocol.md. May be used from several threads at once.
class Showcase {
 public:
  explicit Showcase(ShowcaseOptions options);

  /// nullopt where there is nothing. Waits while a picture is drawn.
  /// @throws InputError if a scene or recording cannot be read; std::runtime_error with the reason
  ///         if nothing can draw here, or too many want to see something.
  std::optional<web_server::HttpResponse> Get(const std::string& path);

 private:
  std::optional<web_server::HttpResponse> GetScene(const std::string& name);
  std::optional<web_server::HttpResponse> GetRecording(const std::string& name);
  std::optional<web_server::HttpResponse> PictureOf(const std::string& id,
                                                    std::optional<std::size_t> segment);

  ShowcaseOptions options_;
  Gallery gallery_;
  Library library_;
  std::mutex packing_;  ///< one ZIP file at a time: they are large
  Darkroom darkroom_;
};

}  // namespace smile::library
