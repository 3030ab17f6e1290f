#include "scene_xml/internal_root_reader.h"

#include <string>

#include "scene_xml/internal_attribute_reader.h"
#include "scene_xml/internal_element_choice.h"
#include "scene_xml/internal_units.h"
#include "scene_xml/internal_values.h"
#include "scene_xml/value_ranges.h"

namespace smile::scene_xml {
namespace {

// Scene files cannot change it.
constexpr double kTableThicknessUnits = 4;

bool CheckIsScene(const SceneElement& root, ReadingContext* reading) {
  if (!CheckNamespace(root, reading)) return false;
  if (root.name == "tabletop") return true;
  reading->findings->Add(root.place, AddressOf(root), "found this element, expected <tabletop>");
  return false;
}

/// Reads the attributes of the table of a root element.
scene::TableSpec ReadTable(AttributeReader* attributes, const ReadingContext& reading) {
  scene::TableSpec table;
  table.x_span = attributes->Span("xspan", 20);
  table.y_span = attributes->Span("yspan", 12);
  table.thickness = MetersFromUnits(kTableThicknessUnits, reading.meters_per_unit);
  table.color = attributes->Color("white");
  table.pattern = static_cast<scene::TablePattern>(
      attributes->Choice("pattern", kTablePatterns, static_cast<int>(table.pattern)));
  if (table.pattern == scene::TablePattern::kPlain) {
    for (const char* name : {"patternColor", "patternSpan"}) {
      attributes->Forbid(name, std::string(name) + " only with pattern=\"stripes\" or \"checks\"");
    }
    return table;
  }
  table.pattern_color = attributes->Color("lightgray", "patternColor");
  table.pattern_span = attributes->Span("patternSpan", 1);
  return table;
}

}  // namespace

bool ReadRoot(const SceneElement& root, ReadingContext* reading, scene::SceneSpec* scene) {
  if (!CheckIsScene(root, reading)) return false;
  AttributeReader attributes(root, reading);
  // The unit comes first, as the spans are measured in it.
  reading->meters_per_unit =
      attributes.Number("metersPerUnit", scene::kMetersPerUnit, kMetersPerUnitRange);
  scene->meters_per_unit = reading->meters_per_unit;
  scene->table = ReadTable(&attributes, *reading);
  attributes.RefuseUnknown();
  return true;
}

bool CheckIncludedRoot(const SceneElement& root, ReadingContext* reading) {
  if (!CheckIsScene(root, reading)) return false;
  AttributeReader attributes(root, reading);
  const double unit =
      attributes.Number("metersPerUnit", reading->meters_per_unit, kMetersPerUnitRange);
  // Converting included lengths would be possible, but their numbers would mean something else than
  // in the files that use their templates.
  if (unit != reading->meters_per_unit) {
    attributes.Refuse("metersPerUnit", "the unit of the scene that includes this file, " +
                                           PlainNumberText(reading->meters_per_unit));
  }
  // Read only to be known and checked: the table is that of the main file.
  ReadTable(&attributes, *reading);
  attributes.RefuseUnknown();
  return true;
}

}  // namespace smile::scene_xml
