#include "scene_xml/internal_object_reader.h"

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/solid.h"
#include "scene_xml/internal_part_reader.h"
#include "scene_xml/internal_tool_reader.h"
#include "scene_xml/mesh_files.h"
#include "scene_xml/value_ranges.h"

namespace smile::scene_xml {
namespace {

using scene::Description;
using scene::ObjectSpec;

/// Limit of the physics on the convex pieces of one body.
constexpr std::size_t kMaxPieces = 4096;
/// Elements that belong to an object as a whole.
constexpr std::array<std::string_view, 2> kOfWholes{"description", "tool"};

/// Adds a description; a later value of the same name replaces the earlier one.
void Describe(Description description, std::vector<Description>* descriptions) {
  // Replaced in place: the order of first mention stays, and `shape` is always first.
  for (Description& earlier : *descriptions) {
    if (earlier.name == description.name) {
      earlier.value = std::move(description.value);
      return;
    }
  }
  descriptions->push_back(std::move(description));
}

Description ReadDescription(const SceneElement& element, ReadingContext* reading) {
  AttributeReader attributes(element, reading);
  Description description{attributes.RequiredName("name"), attributes.RequiredText("value")};
  attributes.RefuseUnknown();
  RefuseContent(element, reading);
  return description;
}

/// Returns the value of an object's first description, `shape`.
std::string ShapeNameOf(const ShapeElement& shape, const scene::Part& part) {
  const auto* custom = std::get_if<scene::CustomControl>(&part.shape);
  return custom ? custom->name : ShapeWordOf(part.shape, shape.name);
}

/// Refuses an object of too many convex pieces.
void CheckPieces(const scene::Part& whole, AttributeReader* attributes) {
  const std::size_t count = scene::NumSolidsOf(whole);
  if (count <= kMaxPieces) return;
  attributes->AddFinding("found " + std::to_string(count) +
                         " convex pieces, a ring having one for each side up to 64, expected at "
                         "most " +
                         std::to_string(kMaxPieces) + " in an object");
}

}  // namespace

ObjectSpec ReadObject(const SceneElement& element, const ShapeElement& shape, Container container,
                      ReadingContext* reading) {
  AttributeReader attributes(element, reading);
  const PartPlace place{.container = container};
  ObjectSpec object;
  object.whole = ReadPartAttributes(element, shape, place, &attributes, reading);
  // Mass 0 means static: the object cannot move.
  object.mass = attributes.Number("mass", 1, kMassKilograms);
  if (attributes.Text("centerOfMass")) object.center_of_mass = attributes.Point("centerOfMass");
  object.surface = ReadSurface(&attributes);
  attributes.RefuseUnknown();
  // The default comes first, so that a description in the file replaces it.
  object.descriptions = {{"shape", ShapeNameOf(shape, object.whole)}};
  std::vector<const SceneElement*> content;
  for (const SceneElement& child : element.children) {
    if (child.Is("description")) {
      Describe(ReadDescription(child, reading), &object.descriptions);
    } else if (child.Is("tool") && object.tool) {
      reading->findings->Add(child.place, AddressOf(child),
                             "found a second tool, expected one in an object");
    } else if (child.Is("tool")) {
      object.tool = ReadTool(child, reading);
    } else {
      content.push_back(&child);
    }
  }
  ReadContent(place, content, kOfWholes, &attributes, &object.whole, reading);
  // Counted from the shapes; the pieces themselves are not made here.
  CheckPieces(object.whole, &attributes);
  return object;
}

}  // namespace smile::scene_xml
