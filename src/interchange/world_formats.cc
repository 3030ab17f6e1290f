#include "interchange/world_formats.h"

#include <algorithm>
#include <array>

#include "base/demand.h"
#include "base/files.h"
#include "interchange/mjcf.h"
#include "interchange/sdf.h"

namespace smile::interchange {
namespace {

struct WorldFormat {
  std::string_view name;
  /// @param mesh_folder  for files beside the exported one.
  ExportedText (*text_of)(const ExportedWorld& world, const std::string& mesh_folder);
};
constexpr std::array kFormats{WorldFormat{"mjcf", [](const ExportedWorld& world,
                                                     const std::string&) { return ToMjcf(world); }},
                              WorldFormat{"sdf", &ToSdf}};

}  // namespace

std::vector<std::string_view> WorldFormatNames() {
  std::vector<std::string_view> names;
  for (const WorldFormat& format : kFormats) names.push_back(format.name);
  return names;
}

std::vector<std::string> WriteWorld(const ExportedWorld& world, std::string_view format,
                                    const std::filesystem::path& out) {
  const auto* found = std::ranges::find(kFormats, format, &WorldFormat::name);
  SMILE_DEMAND(found != kFormats.end());
  ExportedText exported = found->text_of(world, out.stem().string() + "_meshes");
  for (const auto& [name, content] : exported.files) {
    const std::filesystem::path path = out.parent_path() / name;
    MakeDirectories(path.parent_path());
    WriteFile(path, content);
  }
  WriteFile(out, exported.text);
  return std::move(exported.left_out);
}

}  // namespace smile::interchange
