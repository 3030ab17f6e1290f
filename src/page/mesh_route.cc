#include "page/mesh_route.h"

#include <charconv>
#include <utility>

namespace smile::page {

std::optional<MeshName> ParseMeshPath(std::string_view path) {
  // std::from_chars accepts neither signs nor blanks, and refuses numbers that do not fit the type.
  constexpr std::string_view kFolder = "/meshes/";
  if (!path.starts_with(kFolder)) return std::nullopt;
  const char* end = path.data() + path.size();
  MeshName name;
  const auto scene = std::from_chars(path.data() + kFolder.size(), end, name.scene);
  if (scene.ec != std::errc() || scene.ptr == end || *scene.ptr != '/') return std::nullopt;
  const auto mesh = std::from_chars(scene.ptr + 1, end, name.mesh);
  if (mesh.ec != std::errc() || mesh.ptr != end) return std::nullopt;
  return name;
}

std::optional<web_server::HttpResponse> MeshResponse(std::optional<std::string> bytes) {
  if (!bytes) return std::nullopt;
  return web_server::HttpResponse{.type = "application/octet-stream", .body = *std::move(bytes)};
}

}  // namespace smile::page
