// Routes of the studio's HTTP server for what does not change with the simulation: lists, scenes,
// recordings, thumbnails. A path comes from any client; names in it reach the file system only
// through SceneCatalog::FileOf() and Library::DirectoryOf(), which let none lead out of its folder.
// Called on several threads of the server at a time.

#include "library/content_routes.h"

#include <charconv>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/file_state.h"
#include "base/files.h"
#include "library/thumbnail_renderer.h"
#include "recording/recording_names.h"

namespace smile::library {
namespace {

constexpr std::size_t kMaxSceneBytes = 32u << 20;
constexpr std::size_t kMaxFilmBytes = 512u << 20;

/// Returns the text between `begin` and `end`; nullopt if `text` does not begin and end with them.
std::optional<std::string> Between(std::string_view begin, std::string_view text,
                                   std::string_view end) {
  if (text.size() < begin.size() + end.size() || !text.starts_with(begin) || !text.ends_with(end)) {
    return std::nullopt;
  }
  return std::string(text.substr(begin.size(), text.size() - begin.size() - end.size()));
}

/// Returns the number that a text consists of; nullopt for any other text.
std::optional<std::size_t> NumberIn(const std::string& text) {
  std::size_t number = 0;
  // No sign, blank or suffix: one number has one path, and so one entry in the cache.
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

/// Returns the response with a picture; nullopt if it could not be rendered.
std::optional<web_server::HttpResponse> PngResponse(ThumbnailQueue::Picture picture) {
  if (!picture) return std::nullopt;
  return web_server::HttpResponse{.type = "image/png", .body = *std::move(picture)};
}

}  // namespace

ContentRoutes::ContentRoutes(ContentRoutesOptions options)
    : options_(std::move(options)), catalog_(options_.scenes), library_(options_.recordings) {}

std::optional<web_server::HttpResponse> ContentRoutes::Get(const std::string& path) {
  if (path == "/scenes") {
    const Json answer = {{"scenes", catalog_.List()}, {"presets", options_.presets}};
    return web_server::HttpResponse{.type = "application/json", .body = ToText(answer)};
  }
  if (const auto scene = Between("/scenes/", path, "")) return GetScene(*scene);
  if (const auto film = Between("/films/", path, ".mp4")) return GetFilm(*film);
  // The prefix decides; what follows it is split by the two functions below.
  const auto recording = Between("/recordings/", path, "");
  if (!recording) return std::nullopt;
  try {
    return GetRecording(*recording);
  } catch (const LibraryError&) {
    return std::nullopt;  // no such recording
  }
}

std::optional<web_server::HttpResponse> ContentRoutes::GetScene(const std::string& name) {
  if (const auto text = Between("", name, ".xml")) {
    const auto file = catalog_.FileOf(*text);
    if (!file) return std::nullopt;
    return web_server::HttpResponse{.type = "application/xml",
                                    .body = ReadFile(*file, kMaxSceneBytes)};
  }
  const auto picture = Between("", name, ".png");
  const auto file = picture ? catalog_.FileOf(*picture) : std::nullopt;
  if (!file) return std::nullopt;
  const scene_xml::SceneReaderOptions reader{.search_roots = {options_.scenes}};
  // The stamp is part of the key, so a changed file gets a new thumbnail.
  return PngResponse(thumbnails_.Get(file->string() + "|" + StampOf(*file),
                                     [file = *file, reader](ThumbnailRenderer* renderer) {
                                       return renderer->RenderScene(file, reader);
                                     }));
}

std::optional<web_server::HttpResponse> ContentRoutes::GetRecording(const std::string& name) {
  if (const auto id = Between("", name, ".zip")) {
    // A recording is packed in memory, one at a time.
    const std::lock_guard lock(packing_);
    return web_server::HttpResponse{
        .type = "application/zip", .body = library_.ZipOf(*id), .file_name = *id + ".zip"};
  }
  // An id contains no slash, so nothing of the path is ambiguous.
  if (const auto id = Between("", name, "/picture.png")) return PictureOf(*id, std::nullopt);
  if (const auto id = Between("", name, "/eye.png")) return EyePictureOf(*id);
  const std::size_t slash = name.find('/');
  if (slash == std::string::npos) return std::nullopt;
  const auto number = Between("/segments/", std::string_view(name).substr(slash), ".png");
  const auto segment = number ? NumberIn(*number) : std::nullopt;
  if (!segment) return std::nullopt;
  return PictureOf(name.substr(0, slash), segment);
}

std::optional<web_server::HttpResponse> ContentRoutes::GetFilm(const std::string& name) {
  if (!recording::IsRecordingName(name)) return std::nullopt;
  const std::filesystem::path file = options_.recordings / kFilmFolder / (name + ".mp4");
  if (!StateOf(file).is_file) return std::nullopt;
  const std::lock_guard lock(packing_);
  return web_server::HttpResponse{
      .type = "video/mp4", .body = ReadFile(file, kMaxFilmBytes), .file_name = name + ".mp4"};
}

std::optional<web_server::HttpResponse> ContentRoutes::PictureOf(
    const std::string& id, std::optional<std::size_t> segment) {
  // A trace only grows or is replaced, so its stamp shows if the thumbnail is up to date. Throws
  // for an unknown id before anything is queued.
  const std::filesystem::path directory = library_.DirectoryOf(id);
  const std::string stamp = StampOf(directory / "trace.bin");
  const std::string which = segment ? std::to_string(*segment) : "end";
  return PngResponse(thumbnails_.Get(directory.string() + "|" + stamp + "|" + which,
                                     [directory, stamp, segment](ThumbnailRenderer* renderer) {
                                       return renderer->RenderRecording(directory, stamp, segment);
                                     }));
}

std::optional<web_server::HttpResponse> ContentRoutes::EyePictureOf(const std::string& id) {
  const std::filesystem::path directory = library_.DirectoryOf(id);
  const std::string stamp = StampOf(directory / "trace.bin");
  return PngResponse(thumbnails_.Get(directory.string() + "|" + stamp + "|eye",
                                     [directory, stamp](ThumbnailRenderer* renderer) {
                                       return renderer->RenderEye(directory, stamp);
                                     }));
}

}  // namespace smile::library
