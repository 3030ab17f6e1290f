#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "web_server/http.h"

namespace smile::page {

/// Name of a mesh in a path. Each scene numbers its meshes from 0.
struct MeshName {
  std::uint32_t scene = 0;
  std::size_t mesh = 0;
};

/// Parses a path such as `/meshes/3/0`.
std::optional<MeshName> ParseMeshPath(std::string_view path);

/// Returns the answer that contains the bytes of a mesh.
std::optional<web_server::HttpResponse> MeshResponse(std::optional<std::string> bytes);

}  // namespace smile::page
