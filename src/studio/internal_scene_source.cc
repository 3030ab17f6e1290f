#include "studio/internal_scene_source.h"

#include <algorithm>
#include <utility>

#include "base/wording.h"
#include "library/scene_catalog.h"
#include "texts/user_message.h"

namespace smile::studio {

using texts::Say;
namespace {

/// Limits of scenes from pages, which are stricter than those of files, since the session waits
/// while they are read.
constexpr int kMaxObjects = 2'000, kMaxElements = 20'000;
constexpr std::size_t kMaxText = std::size_t{1} << 20;

}  // namespace

SceneSource::SceneSource(std::filesystem::path scene_folder, scene_xml::SceneReaderOptions reader)
    : scene_folder_(std::move(scene_folder)), reader_(std::move(reader)) {}

scene::SceneSpec SceneSource::Named(const std::string& name) const {
  const auto file = library::SceneCatalog(scene_folder_).FileOf(name);
  if (!file) throw page::RequestError(Say("session.noScene", {{"scene", Quoted(name)}}));
  return scene_xml::LoadScene(*file, reader_);
}

scene_xml::SceneReading SceneSource::ReadText(const page::RequestFields& fields) const {
  const std::string text = fields.Text("xml", kMaxText);
  std::string name = fields.OptionalText("name").value_or("scene.xml");
  // A client may send a path; only its last component names the scene.
  name = std::filesystem::path(name).filename().string();
  scene_xml::SceneReaderOptions options = reader_;
  // Text from a page may include the files of the scene folder, as if it were saved there.
  options.search_roots.push_back(scene_folder_);
  options.limits.max_objects = std::min(options.limits.max_objects, kMaxObjects);
  options.limits.max_elements = std::min(options.limits.max_elements, kMaxElements);
  return scene_xml::ReadSceneText(text, name, options);
}

scene::SceneSpec SceneSource::SceneOf(const page::RequestFields& fields) const {
  if (!fields.Has("xml")) return Named(fields.Text("scene"));
  scene_xml::SceneReading reading = ReadText(fields);
  // All findings, and not only the first: the page shows them at their lines.
  if (!reading.scene) throw InputError(std::move(reading.diagnostics));
  return *std::move(reading.scene);
}

}  // namespace smile::studio
