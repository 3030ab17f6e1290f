#include "scene_xml/internal_lighting_reader.h"

#include "math/angles.h"
#include "scene_xml/internal_attribute_reader.h"
#include "scene_xml/internal_element_choice.h"
#include "scene_xml/value_ranges.h"

namespace smile::scene_xml {

void ReadLighting(const SceneElement& element, ReadingContext* reading,
                  std::optional<scene::Lighting>* lighting) {
  AttributeReader attributes(element, reading);
  scene::Lighting read;
  read.brightness = attributes.Number("brightness", 1, kBrightness);
  read.color = attributes.Color("white");
  read.turn = DegreesToRadians(attributes.Number("turn", 0, kAngleDegrees));
  if (attributes.Text("background")) read.background = attributes.Color("black", "background");
  attributes.RefuseUnknown();
  RefuseContent(element, reading);
  if (attributes.has_findings()) return;
  if (*lighting) return attributes.AddFinding("found a second lighting, expected one");
  *lighting = read;
}

}  // namespace smile::scene_xml
