#include "scene_xml/internal_root_reader.h"

#include "scene_xml/internal_attribute_reader.h"
#include "scene_xml/internal_element_choice.h"
#include "scene_xml/internal_units.h"
#include "scene_xml/internal_values.h"

namespace smile::scene_xml {
namespace {

constexpr Range<double> kMetersPerUnitRange{1e-12, 1000};
constexpr double kTableThicknessUnits = 4;

bool CheckIsScene(const XmlElement& root, Reading* reading) {
  if (!CheckNamespace(root, reading)) return false;
  if (root.name == "tabletop") return true;
  reading->findings->Add(root.place, AddressOf(root), "found this element, expected <tabletop>");
  return false;
}

}  // namespace

bool ReadRoot(const XmlElement& root, Reading* reading, scene::SceneSpec* scene) {
  if (!CheckIsScene(root, reading)) return false;
  AttributeReader attributes(root, reading);
  // The unit first: the spans are measured in it.
  reading->meters_per_unit =
      attributes.Number("metersPerUnit", scene::kMetersPerUnit, kMetersPerUnitRange);
  scene->meters_per_unit = reading->meters_per_unit;
  scene->table.x_span = attributes.Span("xspan", 20);
  scene->table.y_span = attributes.Span("yspan", 12);
  scene->table.thickness = MetersFromUnits(kTableThicknessUnits, reading->meters_per_unit);
  attributes.RefuseUnknown();
  return true;
}

bool CheckIncludedRoot(const XmlElement& root, Reading* reading) {
  if (!CheckIsScene(root, reading)) return false;
  AttributeReader attributes(root, reading);
  const double unit =
      attributes.Number("metersPerUnit", reading->meters_per_unit, kMetersPerUnitRange);
  if (unit != reading->meters_per_unit) {
    attributes.Refuse("metersPerUnit", "the unit of the scene that includes this file, " +
                                           PlainNumberText(reading->meters_per_unit));
  }
  attributes.Span("xspan", 20);
  attributes.Span("yspan", 12);
  attributes.RefuseUnknown();
  return true;
}

std::string WithoutPath(std::string reason, const std::string& file) {
  if (reason.starts_with(file + ": ")) reason.erase(0, file.size() + 2);
  return reason;
}

}  // namespace smile::scene_xml
