#include "scene_xml/scene_reader.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "base/files.h"
#include "base/wording.h"
#include "scene_xml/internal_element_choice.h"
#include "scene_xml/internal_object_reader.h"
#include "scene_xml/internal_units.h"

namespace smile::scene_xml {
namespace {

constexpr Range<double> kMetersPerUnitRange{1e-12, 1000};
constexpr double kTableThicknessUnits = 4;

void ReadTable(const XmlElement& root, Reading* reading, scene::SceneSpec* scene) {
  AttributeReader attributes(root, reading);
  // The unit first: the spans are measured in it.
  reading->meters_per_unit =
      attributes.Number("metersPerUnit", scene::kMetersPerUnit, kMetersPerUnitRange);
  scene->meters_per_unit = reading->meters_per_unit;
  scene->table.x_span = attributes.Span("xspan", 20);
  scene->table.y_span = attributes.Span("yspan", 12);
  scene->table.thickness = MetersFromUnits(kTableThicknessUnits, reading->meters_per_unit);
  attributes.RefuseUnknown();
}

scene::SceneSpec ReadRoot(const XmlElement& root, Findings* findings) {
  scene::SceneSpec scene;
  Reading reading{.findings = findings, .ids = {}};
  if (!CheckNamespace(root, &reading)) return scene;
  if (root.name != "tabletop") {
    findings->Add(root.place, AddressOf(root), "found this element, expected <tabletop>");
    return scene;
  }
  ReadTable(root, &reading, &scene);
  for (const XmlElement& child : root.children) {
    if (const ShapeElement* shape = FindShape(child, &reading)) {
      scene.objects.push_back(ReadObject(child, *shape, &reading));
    }
  }
  return scene;
}

/// ReadFile() begins its messages with the path, which a diagnostic already names.
std::string WithoutPath(std::string reason, const std::string& file) {
  if (reason.starts_with(file + ": ")) reason.erase(0, file.size() + 2);
  return reason;
}

}  // namespace

SceneReading ReadSceneText(std::string_view xml, const std::string& file_name,
                           const SceneReaderOptions& options) {
  Findings findings(file_name, options.limits.max_diagnostics);
  SceneReading reading;
  int num_elements = 0;
  if (const std::optional<XmlElement> root =
          ParseXml(xml, /*file=*/0, options.limits, &num_elements, &findings)) {
    reading.scene = ReadRoot(*root, &findings);
    reading.scene->name = std::filesystem::path(file_name).stem().string();
  }
  reading.diagnostics = findings.Take();
  if (!reading.diagnostics.empty()) reading.scene.reset();
  return reading;
}

SceneReading ReadScene(const std::filesystem::path& path, const SceneReaderOptions& options) {
  std::string text;
  try {
    text = ReadFile(path, options.limits.max_file_bytes);
  } catch (const std::runtime_error& error) {
    // Line 1: programs that read diagnostics are promised a line.
    return {{}, {{path.string(), 1, "", WithoutPath(error.what(), path.string())}}};
  }
  return ReadSceneText(text, path.string(), options);
}

scene::SceneSpec LoadScene(const std::filesystem::path& path, const SceneReaderOptions& options) {
  SceneReading reading = ReadScene(path, options);
  if (!reading.scene) throw InputError(std::move(reading.diagnostics));
  return *std::move(reading.scene);
}

}  // namespace smile::scene_xml
