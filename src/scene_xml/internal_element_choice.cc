#include "scene_xml/internal_element_choice.h"

#include <algorithm>
#include <string>
#include <vector>

#include "base/wording.h"

namespace smile::scene_xml {
namespace {

using Names = std::span<const std::string_view>;

void Refuse(const XmlElement& element, Names expected, Names possible, Reading* reading) {
  const std::string what = expected.empty() ? "nothing inside this element" : OneOf(expected);
  reading->findings->Add(
      element.place, AddressOf(element),
      "found an unknown element, expected " + what + DidYouMean(element.name, possible));
}

}  // namespace

bool CheckNamespace(const XmlElement& element, Reading* reading) {
  if (element.is_in_scene_namespace) return true;
  const std::string found = element.found_namespace.empty()
                                ? "found no namespace"
                                : "found namespace " + element.found_namespace;
  reading->findings->Add(element.place, AddressOf(element),
                         found + ", expected xmlns=" + Quoted(kSceneNamespace));
  return false;
}

const ShapeElement* FindShape(const XmlElement& element, Container container, Reading* reading) {
  if (!CheckNamespace(element, reading)) return nullptr;
  std::vector<std::string_view> names;
  for (const ShapeElement& shape : ShapeElements()) {
    if (shape.is_control && container == Container::kState) continue;
    if (shape.name == element.name) return &shape;
    names.push_back(shape.name);
  }
  if (container == Container::kTabletop) names.insert(names.end(), {"chain", "sliderJoint"});
  if (container == Container::kComposite) {
    names.insert(names.end(), {"guestBondPoint", "hostBondPoint"});
  }
  std::sort(names.begin(), names.end());
  // Not listed, to keep the message short, but possibly meant.
  std::vector<std::string_view> words = names;
  words.insert(words.end(), {"def", "include", "instance", "var"});
  Refuse(element, names, words, reading);
  return nullptr;
}

void RefuseElement(const XmlElement& element, std::span<const std::string_view> expected,
                   Reading* reading) {
  if (CheckNamespace(element, reading)) Refuse(element, expected, expected, reading);
}

void RefuseContent(const XmlElement& element, Reading* reading) {
  for (const XmlElement& child : element.children) RefuseElement(child, {}, reading);
}

}  // namespace smile::scene_xml
