#include "scene_xml/internal_object_reader.h"

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "scene_xml/internal_element_choice.h"
#include "scene_xml/internal_values.h"
#include "scene_xml/mesh_files.h"

namespace smile::scene_xml {
namespace {

using scene::Description;
using scene::ObjectSpec;
using scene::Part;

constexpr Range<double> kMassKilograms{0, 1e6};
constexpr std::string_view kDescription = "description";

bool IsDescription(const XmlElement& element) {
  return element.is_in_scene_namespace && element.name == kDescription;
}

/// A later value of the same name takes the place of the earlier one.
void Describe(Description description, std::vector<Description>* descriptions) {
  for (Description& earlier : *descriptions) {
    if (earlier.name == description.name) {
      earlier.value = std::move(description.value);
      return;
    }
  }
  descriptions->push_back(std::move(description));
}

Description ReadDescription(const XmlElement& element, Reading* reading) {
  AttributeReader attributes(element, reading);
  Description description{attributes.RequiredName("name"), attributes.RequiredText("value")};
  attributes.RefuseUnknown();
  for (const XmlElement& child : element.children) RefuseElement(child, {}, reading);
  return description;
}

std::string ClaimId(AttributeReader* attributes, Reading* reading) {
  std::string wanted = attributes->Id();
  if (!IsRenamedId(wanted)) return reading->ids.Claim(wanted);
  if (!reading->ids.ClaimExactly(wanted)) {
    attributes->Refuse("id", "one that is not used yet: an id with # is never changed");
  }
  return wanted;
}

/// What wholes and parts have in common: all but children, mass and the check for unknown
/// attributes. Whole objects and what can be pointed at get an id of their own.
Part ReadPartAttributes(const ShapeElement& shape, bool is_whole, AttributeReader* attributes,
                        Reading* reading) {
  Part part;
  part.is_pointable = attributes->Boolean("pointable", false);
  part.id = is_whole || part.is_pointable ? ClaimId(attributes, reading) : attributes->Id();
  part.X_PE = attributes->Pose();
  if (!shape.is_composite) part.color = attributes->Color();
  part.shape = shape.read(attributes);
  return part;
}

Part ReadPart(const XmlElement& element, const ShapeElement& shape, Reading* reading);

void ReadPartInto(scene::Composite* composite, const XmlElement& element, Reading* reading) {
  if (const ShapeElement* shape = FindShape(element, reading)) {
    composite->parts.push_back(ReadPart(element, *shape, reading));
  }
}

Part ReadPart(const XmlElement& element, const ShapeElement& shape, Reading* reading) {
  AttributeReader attributes(element, reading);
  Part part = ReadPartAttributes(shape, /*is_whole=*/false, &attributes, reading);
  for (const char* name : {"mass", "friction", "restitution", "rollingFriction"}) {
    attributes.Forbid(name, std::string(name) + " only on the whole object");
  }
  attributes.RefuseUnknown();
  auto* composite = std::get_if<scene::Composite>(&part.shape);
  for (const XmlElement& child : element.children) {
    if (IsDescription(child)) {
      reading->findings->Add(child.place, AddressOf(child),
                             "found a description of a part, expected it in the whole object");
    } else if (composite) {
      ReadPartInto(composite, child, reading);
    } else if (CheckNamespace(child, reading)) {
      RefuseElement(child, {}, reading);
    }
  }
  return part;
}

}  // namespace

ObjectSpec ReadObject(const XmlElement& element, const ShapeElement& shape, Reading* reading) {
  AttributeReader attributes(element, reading);
  ObjectSpec object;
  object.whole = ReadPartAttributes(shape, /*is_whole=*/true, &attributes, reading);
  object.mass = attributes.Number("mass", 1, kMassKilograms);
  object.surface = ReadSurface(&attributes);
  attributes.RefuseUnknown();
  object.descriptions = {{"shape", ShapeWordOf(object.whole.shape, shape.name)}};
  auto* composite = std::get_if<scene::Composite>(&object.whole.shape);
  for (const XmlElement& child : element.children) {
    if (IsDescription(child)) {
      Describe(ReadDescription(child, reading), &object.descriptions);
    } else if (composite) {
      ReadPartInto(composite, child, reading);
    } else if (CheckNamespace(child, reading)) {
      RefuseElement(child, std::array{kDescription}, reading);
    }
  }
  return object;
}

}  // namespace smile::scene_xml
