#include "scene_xml/internal_element_choice.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "base/wording.h"

// Decides which element may be where. A wrong element gets one of two messages: a known one is
// misplaced, an unknown one is probably misspelled.

namespace smile::scene_xml {
namespace {

using Names = std::span<const std::string_view>;

/// True if the scene language has such an element, here or elsewhere.
bool IsOfTheLanguage(std::string_view name) {
  // All elements except the shapes, which have a table of their own.
  constexpr std::array kOthers{std::string_view("accepts"),
                               std::string_view("camera"),
                               std::string_view("cameraOffset"),
                               std::string_view("chain"),
                               std::string_view("def"),
                               std::string_view("description"),
                               std::string_view("downstream"),
                               std::string_view("guestBondPoint"),
                               std::string_view("hostBondPoint"),
                               std::string_view("include"),
                               std::string_view("instance"),
                               std::string_view("light"),
                               std::string_view("lighting"),
                               std::string_view("sliderJoint"),
                               std::string_view("state"),
                               std::string_view("tabletop"),
                               std::string_view("tightness"),
                               std::string_view("tool"),
                               std::string_view("var")};
  return std::ranges::find(kOthers, name) != kOthers.end() ||
         std::ranges::find(ShapeElements(), name, &ShapeElement::name) != ShapeElements().end();
}

/// Adds the finding. A known element in the wrong place gets no spelling suggestion.
void Refuse(const SceneElement& element, Names expected, Names possible, ReadingContext* reading) {
  const std::string what = expected.empty() ? "nothing inside this element" : OneOf(expected);
  const bool is_misplaced = IsOfTheLanguage(element.name);
  reading->findings->Add(element.place, AddressOf(element),
                         (is_misplaced ? "found an element that does not belong here, expected "
                                       : "found an unknown element, expected ") +
                             what + (is_misplaced ? "" : DidYouMean(element.name, possible)));
}

}  // namespace

/// Returns false, with a finding, for an element of another namespace.
bool CheckNamespace(const SceneElement& element, ReadingContext* reading) {
  if (element.is_in_scene_namespace) return true;
  const std::string found = element.found_namespace.empty()
                                ? "found no namespace"
                                : "found namespace " + element.found_namespace;
  reading->findings->Add(element.place, AddressOf(element),
                         found + ", expected xmlns=" + Quoted(kSceneNamespace));
  return false;
}

const ShapeElement* FindShape(const SceneElement& element, Container container,
                              ReadingContext* reading) {
  if (!CheckNamespace(element, reading)) return nullptr;
  std::vector<std::string_view> names;
  for (const ShapeElement& shape : ShapeElements()) {
    // A control inside of another one's state would exist only at times.
    if (shape.is_control && container == Container::kState) continue;
    if (shape.name == element.name) return &shape;
    names.push_back(shape.name);
  }
  if (container == Container::kTabletop)
    names.insert(names.end(), {"camera", "cameraOffset", "chain", "lighting", "sliderJoint"});
  if (container == Container::kComposite) {
    names.insert(names.end(), {"guestBondPoint", "hostBondPoint"});
  }
  std::sort(names.begin(), names.end());
  // Candidates for spelling suggestions that the message does not list, to keep it short.
  std::vector<std::string_view> words = names;
  words.insert(words.end(), {"def", "include", "instance", "var"});
  Refuse(element, names, words, reading);
  return nullptr;
}

void RefuseElement(const SceneElement& element, std::span<const std::string_view> expected,
                   ReadingContext* reading) {
  if (CheckNamespace(element, reading)) Refuse(element, expected, expected, reading);
}

void RefuseContent(const SceneElement& element, ReadingContext* reading) {
  for (const SceneElement& child : element.children) RefuseElement(child, {}, reading);
}

}  // namespace smile::scene_xml
