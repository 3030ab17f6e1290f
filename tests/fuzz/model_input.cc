#include "model_input.h"

#include "base/diagnostic.h"
#include "scene_xml/mesh_files.h"
#include "scene_xml/scene_reader.h"
#include "scene_xml/scene_writer.h"

namespace smile::fuzz {

scene_import::ImportedScene ImportHostileModel(std::string_view text) {
  std::string_view format = "mjcf";
  if (text.find("<sdf") != std::string_view::npos) format = "sdf";
  if (text.find("<robot") != std::string_view::npos) format = "urdf";
  return scene_import::ImportSceneText(text, format, "fuzzed.xml");
}

std::string FaultWithModel(std::string_view text) {
  scene_import::ImportedScene imported;
  try {
    imported = ImportHostileModel(text);
  } catch (const InputError& error) {
    const Diagnostic& found = error.diagnostics().front();
    return found.file.empty() || found.message.empty() ? "refused without a reason" : "";
  }
  // Meshes would have to be in files.
  if (!scene_xml::MeshFilesOf(imported.scene).empty()) return {};
  const scene_xml::SceneReading again =
      scene_xml::ReadSceneText(scene_xml::WriteScene(imported.scene), "fuzzed.xml");
  if (!again.scene) return "its scene is refused: " + ToString(again.diagnostics.front());
  return *again.scene == imported.scene ? "" : "its scene reads differently";
}

}  // namespace smile::fuzz
