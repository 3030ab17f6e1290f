#include "interchange/world_formats.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "base/demand.h"
#include "base/files.h"
#include "base/wording.h"
#include "interchange/gltf.h"
#include "interchange/mjcf.h"
#include "interchange/sdf.h"
#include "interchange/urdf.h"
#include "interchange/usd.h"

namespace smile::interchange {
namespace {

struct WorldFormat {
  std::string_view name;
  bool is_animated = false;
  /// @param mesh_folder  for files beside the exported one.
  ExportedText (*text_of)(const ExportedScene& scene, const std::string& mesh_folder) = nullptr;
};
constexpr std::array kFormats{
    WorldFormat{"mjcf", false,
                [](const ExportedScene& scene, const std::string&) { return ToMjcf(scene.world); }},
    WorldFormat{"sdf", false,
                [](const ExportedScene& scene, const std::string& folder) {
                  return ToSdf(scene.world, folder);
                }},
    WorldFormat{"urdf", false,
                [](const ExportedScene& scene, const std::string& folder) {
                  return ToUrdf(scene.world, folder);
                }},
    WorldFormat{"gltf", true,
                [](const ExportedScene& scene, const std::string&) { return ToGltf(scene); }},
    WorldFormat{"usd", true,
                [](const ExportedScene& scene, const std::string&) { return ToUsd(scene); }}};

const WorldFormat& FormatOf(std::string_view name) {
  const auto* found = std::ranges::find(kFormats, name, &WorldFormat::name);
  SMILE_DEMAND(found != kFormats.end());
  return *found;
}

}  // namespace

std::vector<std::string_view> WorldFormatNames() {
  std::vector<std::string_view> names;
  for (const WorldFormat& format : kFormats) names.push_back(format.name);
  return names;
}

void RequireAnimated(std::string_view format, std::string_view recording) {
  if (FormatOf(format).is_animated) return;
  throw std::invalid_argument(std::string(format) + " is of a scene file, found the recording " +
                              Quoted(recording));
}

std::vector<std::string> WriteScene(const ExportedScene& scene, std::string_view format,
                                    const std::filesystem::path& out) {
  ExportedText exported = FormatOf(format).text_of(scene, out.stem().string() + "_meshes");
  for (const auto& [name, content] : exported.files) {
    const std::filesystem::path path = out.parent_path() / name;
    MakeDirectories(path.parent_path());
    WriteFile(path, content);
  }
  WriteFile(out, exported.text);
  return std::move(exported.left_out);
}

}  // namespace smile::interchange
