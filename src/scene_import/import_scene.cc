#include "scene_import/import_scene.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "base/files.h"
#include "base/wording.h"
#include "scene_import/internal_model_readers.h"
#include "scene_import/internal_scene_of_world.h"

namespace smile::scene_import {
namespace {

constexpr std::size_t kMaxFileBytes = 16u << 20;

struct SceneFormat {
  std::string_view name, root;
  ForeignWorld (*read)(const SourceElement&, ModelFiles*, ImportFindings*) = nullptr;
};
constexpr std::array kSceneFormats{SceneFormat{"mjcf", "mujoco", &ReadMjcf},
                                   SceneFormat{"sdf", "sdf", &ReadSdf},
                                   SceneFormat{"urdf", "robot", &ReadUrdf}};

const SceneFormat& SceneFormatOf(std::string_view name) {
  const auto* found = std::ranges::find(kSceneFormats, name, &SceneFormat::name);
  if (found != kSceneFormats.end()) return *found;
  throw std::invalid_argument("--from is " + Quoted(name) + ", expected " +
                              OneOf(SceneFormatNames()));
}

ImportedScene ImportText(std::string_view text, std::string_view format, const std::string& file,
                         ModelFiles* files, const ImportSceneOptions& options) {
  const SceneFormat& reader = SceneFormatOf(format);
  ImportFindings findings;
  const std::optional<SourceElement> root = ParseSource(text, file, reader.root, &findings);
  findings.ThrowIfRefused();
  const ForeignWorld world = reader.read(*root, files, &findings);
  findings.ThrowIfRefused();
  ImportedScene imported{.scene = SceneOfWorld(world, options.table, &findings)};
  findings.ThrowIfRefused();
  imported.scene.name = std::filesystem::path(file).stem().string();
  imported.remarks = findings.Remarks();
  for (Diagnostic& remark : imported.remarks) {
    if (remark.file.empty()) remark.file = file;
  }
  return imported;
}

}  // namespace

std::vector<std::string_view> SceneFormatNames() {
  std::vector<std::string_view> names;
  for (const SceneFormat& format : kSceneFormats) names.push_back(format.name);
  return names;
}

ImportedScene ImportScene(const std::filesystem::path& path, std::string_view format,
                          const ImportSceneOptions& options) {
  SceneFormatOf(format);
  ModelFiles files(path, options.search_roots);
  return ImportText(ReadFile(path, kMaxFileBytes), format, path.string(), &files, options);
}

ImportedScene ImportSceneText(std::string_view text, std::string_view format,
                              const std::string& name, const ImportSceneOptions& options) {
  ModelFiles files(std::nullopt, options.search_roots);
  return ImportText(text, format, name, &files, options);
}

}  // namespace smile::scene_import
