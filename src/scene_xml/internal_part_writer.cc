#include "scene_xml/internal_part_writer.h"

#include <string_view>
#include <variant>

#include "base/overloaded.h"
#include "scene_xml/internal_mechanism_writer.h"

// Writes objects and their parts. The written scene is the `scene.xml` of a recording, from which
// the recording replays: values must read back to the same bits, and what equals its default for a
// reason of compatibility is left out.

namespace smile::scene_xml {
namespace {

using scene::ObjectSpec;
using scene::Part;

/// Returns the name of the element.
std::string_view NameOf(const scene::Shape& shape) {
  return std::visit(Overloaded{[](const scene::Block&) { return "block"; },
                               [](const scene::Cylinder&) { return "cylinder"; },
                               [](const scene::Sphere&) { return "sphere"; },
                               [](const scene::Box&) { return "box"; },
                               [](const scene::Frustum&) { return "frustum"; },
                               [](const scene::Ring&) { return "ring"; },
                               [](const scene::Custom&) { return "custom"; },
                               [](const scene::Composite&) { return "composite"; },
                               [](const scene::ToggleSwitch&) { return "toggleSwitch"; },
                               [](const scene::IndicatorLights&) { return "indicatorLights"; },
                               [](const scene::CustomControl&) { return "customControl"; }},
                    shape);
}

void Sizes(const scene::Block& block, XmlText* text) { text->Spans(block.size); }
void Sizes(const scene::Cylinder& cylinder, XmlText* text) {
  text->Length("radius", cylinder.radius);
  text->Length("yspan", cylinder.length);
  text->Count("sides", cylinder.sides);
}
void Sizes(const scene::Sphere& sphere, XmlText* text) { text->Length("radius", sphere.radius); }
void Sizes(const scene::Box& box, XmlText* text) {
  text->Spans(box.size);
  text->Length("thickness", box.thickness);
}
void Sizes(const scene::Frustum& frustum, XmlText* text) {
  text->Length("radiusTop", frustum.radius_top);
  text->Length("radiusBottom", frustum.radius_bottom);
  text->Length("zspan", frustum.height);
  text->Count("sides", frustum.sides);
}
void Sizes(const scene::Ring& ring, XmlText* text) {
  text->Length("radiusOuter", ring.radius_outer);
  text->Length("radiusInner", ring.radius_inner);
  text->Length("zspan", ring.height);
  text->Count("sides", ring.sides);
}
void Sizes(const scene::Custom& custom, XmlText* text) {
  text->Attribute("file", text->FileOf(custom));
  text->Length("scale", custom.scale);
}
/// A composite has no size of its own.
void Sizes(const scene::Composite&, XmlText*) {}
template <class Control>
void Sizes(const Control& control, XmlText* text) {
  WriteControlAttributes(control, text);
}

/// True for shapes with one color: lights and states of controls have their own.
bool HasColor(const scene::Shape& shape) {
  return !std::holds_alternative<scene::Composite>(shape) &&
         (!scene::IsControl(shape) || std::holds_alternative<scene::ToggleSwitch>(shape));
}

/// Writes the attributes that objects and parts share.
/// @param X_PE  pose in the enclosing element.
void WriteShapeAttributes(const Part& part, const RigidTransform& X_PE, XmlText* text) {
  if (!part.id.empty()) text->Attribute("id", part.id);
  text->Pose(X_PE);
  std::visit([&](const auto& shape) { Sizes(shape, text); }, part.shape);
  if (HasColor(part.shape)) text->Attribute("color", ToString(part.color));
  if (part.next_state) text->Count("nextStateWhenTriggered", *part.next_state);
  if (part.trigger) WriteTriggerRule(*part.trigger, std::nullopt, text);
}

/// Writes the children.
void WriteContent(const Part& part, XmlText* text) {
  if (const auto* composite = std::get_if<scene::Composite>(&part.shape)) {
    for (const Part& child : composite->parts) WritePart(child, text);
    WriteBondPoints(*composite, text);
  } else if (scene::IsControl(part.shape)) {
    WriteControlContent(part.shape, text);
  }
}

/// Writes only values other than the defaults, since older programs refuse these attributes.
void WriteSurface(const scene::Surface& surface, XmlText* text) {
  const scene::Surface usual;
  if (surface.friction != usual.friction) text->Number("friction", surface.friction);
  if (surface.restitution != usual.restitution) text->Number("restitution", surface.restitution);
  if (surface.rolling_friction) text->Length("rollingFriction", *surface.rolling_friction);
}

/// Returns the `shape` description that the reader gives to an object without one.
std::string ShapeWord(const scene::Shape& shape, const XmlText& text) {
  if (const auto* custom = std::get_if<scene::Custom>(&shape)) {
    return WordOfMeshFile(text.FileOf(*custom));
  }
  const auto* control = std::get_if<scene::CustomControl>(&shape);
  return control ? control->name : std::string(NameOf(shape));
}

/// Writes all descriptions except a `shape` that the reader adds by itself.
void WriteDescriptions(const ObjectSpec& object, XmlText* text) {
  const std::string shape = ShapeWord(object.whole.shape, *text);
  for (const scene::Description& description : object.descriptions) {
    // The reader would otherwise have it twice, which is harmless, but makes files longer.
    if (description.name == "shape" && description.value == shape) continue;
    text->Open("description");
    text->Attribute("name", description.name);
    text->Attribute("value", description.value);
    text->Close();
  }
}

}  // namespace

void WriteObject(const ObjectSpec& object, const RigidTransform& X_PE, XmlText* text) {
  text->Open(NameOf(object.whole.shape));
  WriteShapeAttributes(object.whole, X_PE, text);
  text->Number("mass", object.mass);
  if (object.center_of_mass != Vector3(Vector3::Zero())) {
    text->Point("centerOfMass", object.center_of_mass);
  }
  WriteSurface(object.surface, text);
  if (object.whole.is_pointable) text->Boolean("pointable", true);
  WriteDescriptions(object, text);
  if (object.tool) WriteTool(*object.tool, text);
  WriteContent(object.whole, text);
  text->Close();
}

void WritePart(const Part& part, XmlText* text) {
  text->Open(NameOf(part.shape));
  WriteShapeAttributes(part, part.X_PE, text);
  if (part.is_pointable) text->Boolean("pointable", true);
  WriteContent(part, text);
  text->Close();
}

}  // namespace smile::scene_xml
