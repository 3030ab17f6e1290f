// Get() is called by the web server's threads, with any path that anyone sends. A path reaches
// files only through the id of a link, which its owner made, and through numbers.

#include "sharing/sharing.h"

#include <charconv>
#include <stdexcept>
#include <utility>

#include "base/file_state.h"
#include "base/files.h"
#include "page/mesh_route.h"
#include "page/request_fields.h"

namespace smile::sharing {
namespace {

namespace fs = std::filesystem;
using web_server::HttpResponse;

constexpr std::size_t kMaxPageBytes = 1 << 20, kMaxPictureBytes = 16u << 20;

/// Returns the number in `begin`NUMBER`.png`; nullopt for any other text.
std::optional<std::size_t> NumberOfPicture(std::string_view begin, std::string_view text) {
  constexpr std::string_view kEnd = ".png";
  if (!text.starts_with(begin) || !text.ends_with(kEnd)) return std::nullopt;
  text.remove_prefix(begin.size());
  if (text.size() <= kEnd.size()) return std::nullopt;
  text.remove_suffix(kEnd.size());
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

Json Describe(const ShareLink& link) { return {{"secret", link.secret}, {"made", link.made}}; }

}  // namespace

Sharing::Sharing(SharingOptions options, const library::Library* library)
    : options_(std::move(options)), library_(library), links_(library) {}

void Sharing::AddTo(page::RequestTable* table, const PublicPlace& place,
                    const page::InBackground& in_background) {
  AddLinkRequests(table, place, in_background);
  // Also after it is restored, a recording is shared only if its owner says so again.
  auto& bin = table->requests.at("bin");
  bin.handle = [this, before = bin.handle](const page::Request& request) {
    Json answer = before(request);
    links_.StopAll(page::RequestFields(request).Text("recording"));
    return answer;
  };
}

void Sharing::AddLinkRequests(page::RequestTable* table, const PublicPlace& place,
                              const page::InBackground& in_background) {
  table->requests["share"] = {[this, in_background](const page::Request& request) {
    // Made once before there is a link, so that its owner learns if it cannot be shown.
    in_background(request, [this, id = page::RequestFields(request).Text("recording")]() -> Json {
      (void)recordings_.Get(library_->DirectoryOf(id));
      return {{"link", Describe(links_.Make(id))}};
    });
    return page::AnswersLater();
  }};
  table->requests["share_links"] = {[this, place](const page::Request& request) -> Json {
    Json links = Json::array();
    for (const ShareLink& link : links_.Of(page::RequestFields(request).Text("recording"))) {
      links.push_back(Describe(link));
    }
    return {{"links", std::move(links)}, {"origin", place.origin}, {"is_local", place.is_local}};
  }};
  table->requests["stop_sharing"] = {[this](const page::Request& request) {
    const page::RequestFields fields(request);
    links_.Stop(fields.Text("recording"), fields.Text("secret"));
    return Json::object();
  }};
}

std::optional<HttpResponse> Sharing::Get(const std::string& path) {
  constexpr std::string_view kPrefix = kPublicPrefix;
  if (!path.starts_with(kPrefix)) return std::nullopt;
  const std::size_t end = std::min(path.find('/', kPrefix.size()), path.size());
  const std::string secret = path.substr(kPrefix.size(), end - kPrefix.size());
  try {
    // The same page for any secret: it asks for the recording, and says if there is none.
    if (end + 1 >= path.size()) return GetPage();
    const auto link = links_.Find(secret);
    return link ? GetPart(*link, path.substr(end)) : std::nullopt;
  } catch (const library::LibraryError&) {
    return std::nullopt;  // it has just been removed
  } catch (const std::exception&) {
    // Reasons contain names of files.
    throw std::runtime_error("this cannot be shown now; try again later");
  }
}

std::optional<HttpResponse> Sharing::GetPage() const {
  const fs::path file = options_.page / "index.html";
  return HttpResponse{
      .type = "text/html; charset=utf-8", .body = ReadFile(file, kMaxPageBytes), .file_name = ""};
}

std::optional<HttpResponse> Sharing::GetPart(const ShareLink& link, const std::string& rest) {
  if (const auto segment = NumberOfPicture("/segments/", rest)) {
    if (!options_.content) return std::nullopt;
    return options_.content("/recordings/" + link.recording + "/segments/" +
                            std::to_string(*segment) + ".png");
  }
  const fs::path directory = library_->DirectoryOf(link.recording);
  const auto shared = recordings_.Get(directory);
  if (rest == "/recording") {
    return HttpResponse{.type = "application/octet-stream",
                        .body = "",
                        .file_name = "",
                        .gzipped = shared->gzipped()};
  }
  if (const auto number = NumberOfPicture("/eye/", rest)) {
    return GetEyePicture(directory, *shared, *number);
  }
  return GetMesh(*shared, rest);
}

std::optional<HttpResponse> Sharing::GetMesh(const SharedRecording& shared,
                                             const std::string& path) const {
  const auto mesh = page::ParseMeshPath(path);
  if (!mesh || mesh->scene != kSharedScene) return std::nullopt;
  return page::MeshResponse(shared.meshes().Bytes(mesh->mesh));
}

std::optional<HttpResponse> Sharing::GetEyePicture(const fs::path& directory,
                                                   const SharedRecording& shared,
                                                   std::size_t number) const {
  const auto name = shared.EyePicture(number);
  if (!name) return std::nullopt;
  const fs::path file = directory / *name;
  // The name comes from a file of the recording, which may come from anywhere.
  if (!IsWithin(file, directory) || !StateOf(file).is_file) return std::nullopt;
  return HttpResponse{
      .type = "image/png", .body = ReadFile(file, kMaxPictureBytes), .file_name = ""};
}

}  // namespace smile::sharing
