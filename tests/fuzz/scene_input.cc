#include "scene_input.h"

#include <cmath>
#include <vector>

#include "scene/solid.h"
#include "scene/visual_model.h"
#include "scene_xml/scene_writer.h"

namespace smile::fuzz {
namespace {

constexpr const char* kFileName = "fuzzed.xml";

scene_xml::SceneReaderOptions TightOptions() {
  return {.search_roots = {SMILE_SOURCE_DIR "/tests/fuzz/includes"},
          .limits = {.max_file_bytes = 1u << 17,
                     .max_depth = 64,
                     .max_elements = 500,
                     .max_objects = 500,
                     .max_attributes = 32,
                     .max_files = 8,
                     .max_mesh_bytes = 1u << 16,
                     .max_mesh_triangles = 500,
                     .max_instances = 16,
                     .max_diagnostics = 50}};
}

bool IsFinite(const RigidTransform& X) {
  return X.translation().allFinite() && X.rotation().allFinite();
}

std::string FaultOf(const std::vector<Diagnostic>& diagnostics) {
  if (diagnostics.empty()) return "neither a scene nor a reason why there is none";
  for (const Diagnostic& diagnostic : diagnostics) {
    if (diagnostic.file.empty() || diagnostic.line < 1 || diagnostic.message.empty()) {
      return "a diagnostic without an address: " + ToString(diagnostic);
    }
  }
  return {};
}

std::string RoundTripFaultOf(const scene_xml::SceneReading& reading) {
  const auto written = [&reading](const scene::SceneSpec& scene) {
    return scene_xml::WriteScene(scene, reading.origins, scene_xml::MeshNames::kWhereTheyAre);
  };
  const std::string text = written(*reading.scene);
  // With the usual limits: written out, templates and numbers take more room.
  const scene_xml::SceneReading again =
      scene_xml::ReadSceneText(text, kFileName, {.search_roots = TightOptions().search_roots});
  if (!again.scene) {
    return "a written scene is refused: " + ToString(again.diagnostics.front()) + "\n" + text;
  }
  if (*again.scene != *reading.scene) return "a written scene reads differently:\n" + text;
  if (written(*again.scene) != text) {
    return "the same scene is written differently:\n" + text;
  }
  return {};
}

std::string FaultOf(const scene::ObjectSpec& object) {
  const std::string name = object.id() + ": ";
  if (!IsFinite(object.pose_in_world())) return name + "a pose that is none";
  const std::vector<scene::Solid> solids = scene::SolidsOf(object.whole);
  for (const scene::Solid& solid : solids) {
    if (!IsFinite(solid.X_BS)) return name + "a solid at a pose that is none";
  }
  const scene::MassProperties properties =
      scene::MassPropertiesOf(solids, object.mass, object.center_of_mass);
  if (!std::isfinite(properties.mass) || !properties.inertia.allFinite()) {
    return name + "mass or inertia that is no number";
  }
  for (const scene::Visual& visual : scene::VisualsOf(object.whole)) {
    if (!IsFinite(visual.X_FV)) return name + "a visual at a pose that is none";
  }
  return {};
}

}  // namespace

scene_xml::SceneReading ReadHostileScene(std::string_view text) {
  static const scene_xml::SceneReaderOptions options = TightOptions();
  return scene_xml::ReadSceneText(text, kFileName, options);
}

std::string FaultWithScene(std::string_view text) {
  const scene_xml::SceneReading reading = ReadHostileScene(text);
  if (!reading.scene) return FaultOf(reading.diagnostics);
  if (std::string fault = RoundTripFaultOf(reading); !fault.empty()) return fault;
  for (const scene::ObjectSpec& object : reading.scene->objects) {
    if (std::string fault = FaultOf(object); !fault.empty()) return fault;
  }
  return {};
}

}  // namespace smile::fuzz
