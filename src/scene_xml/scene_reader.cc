#include "scene_xml/scene_reader.h"

#include <stdexcept>
#include <utility>

#include "base/files.h"
#include "scene_xml/internal_allowed_folders.h"
#include "scene_xml/internal_camera_reader.h"
#include "scene_xml/internal_element_choice.h"
#include "scene_xml/internal_expansion.h"
#include "scene_xml/internal_inclusion.h"
#include "scene_xml/internal_joint_reader.h"
#include "scene_xml/internal_lighting_reader.h"
#include "scene_xml/internal_mechanisms.h"
#include "scene_xml/internal_mesh_cache.h"
#include "scene_xml/internal_object_reader.h"
#include "scene_xml/internal_root_reader.h"

// Reads a scene in passes over one tree of elements. Every pass adds its findings and continues
// where that is possible; if there are any at the end, the scene is dropped and all are reported.

namespace smile::scene_xml {
namespace {

void ReadElement(const SceneElement& element, ReadingContext* reading, ObjectList* objects,
                 std::optional<scene::Lighting>* lighting) {
  if (element.Is("chain")) {
    ReadChain(element, reading, objects);
  } else if (element.Is("sliderJoint")) {
    ReadSlider(element, reading, objects);
  } else if (element.Is("camera")) {
    ReadCamera(element, reading, &objects->scene().cameras);
  } else if (element.Is("cameraOffset")) {
    ReadCameraOffset(element, reading, &objects->scene().camera_offsets);
  } else if (element.Is("lighting")) {
    ReadLighting(element, reading, lighting);
  } else if (const ShapeElement* shape = FindShape(element, Container::kTabletop, reading)) {
    scene::ObjectSpec object = ReadObject(element, *shape, Container::kTabletop, reading);
    // Read even without room, so that its faults are listed.
    if (objects->HasRoomFor(1, element.place)) objects->Add(std::move(object), element.place);
  }
}

/// @param path  nullptr for a text without a file.
SceneReading ReadTree(SceneElement root, const std::filesystem::path* path,
                      const SceneReaderOptions& options, const ReadCounts& counts,
                      Findings* findings) {
  SceneReading result;
  scene::SceneSpec& scene = result.scene.emplace();
  MeshCache meshes(path, options.search_roots, options.limits);
  ReadingContext reading{.findings = findings, .meshes = &meshes};
  // The passes in order: unit and table, included files, templates, objects, references. Each needs
  // the result of the ones before.
  if (!ReadRoot(root, &reading, &scene)) return result;
  const bool has_all_files =
      ResolveIncludes(path, options.search_roots, options.limits, counts, &root, &reading);
  ExpandTemplates(options.limits, has_all_files, &root, &reading);
  ObjectList objects(options.limits, &scene, findings);
  std::optional<scene::Lighting> lighting;
  for (const SceneElement& child : root.children) {
    ReadElement(child, &reading, &objects, &lighting);
  }
  if (lighting) scene.lighting = *lighting;
  // A missing target may be in a missing file.
  if (has_all_files) ConnectMechanisms(&scene, &reading);
  const Sources& sources = findings->sources();
  // For people: comments in the written scene name where each object came from.
  for (const SourceLocation& place : objects.places()) {
    result.origins.push_back(sources.Address(place) + sources.ExpansionNote(place));
  }
  return result;
}

/// @param path  nullptr for a text without a file.
SceneReading Read(std::string_view xml, const std::filesystem::path* path,
                  const std::string& file_name, const SceneReaderOptions& options) {
  Findings findings(file_name, options.limits.max_diagnostics);
  ReadCounts counts{.num_bytes = xml.size()};
  SceneReading reading;
  if (std::optional<SceneElement> root =
          ParseSceneXml(xml, /*file=*/0, options.limits, &counts.num_elements, &findings)) {
    reading = ReadTree(*std::move(root), path, options, counts, &findings);
    reading.scene->name = std::filesystem::path(file_name).stem().string();
  }
  reading.diagnostics = findings.Take();
  // A scene with any fault is not returned, so that users cannot overlook it.
  if (!reading.diagnostics.empty()) reading = {.diagnostics = std::move(reading.diagnostics)};
  return reading;
}

}  // namespace

SceneReading ReadSceneText(std::string_view xml, const std::string& file_name,
                           const SceneReaderOptions& options) {
  return Read(xml, nullptr, file_name, options);
}

SceneReading ReadScene(const std::filesystem::path& path, const SceneReaderOptions& options) {
  std::string text;
  try {
    text = ReadFile(path, options.limits.max_file_bytes);
  } catch (const std::runtime_error& error) {
    // Line 1: each diagnostic has a line, for programs that parse them.
    return {.diagnostics = {{path.string(), 1, "", WithoutPath(error.what(), path.string())}}};
  }
  return Read(text, &path, path.string(), options);
}

scene::SceneSpec LoadScene(const std::filesystem::path& path, const SceneReaderOptions& options) {
  SceneReading reading = ReadScene(path, options);
  if (!reading.scene) throw InputError(std::move(reading.diagnostics));
  return *std::move(reading.scene);
}

}  // namespace smile::scene_xml
