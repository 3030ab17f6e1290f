#include "scene_xml/internal_part_reader.h"

#include <string>
#include <variant>

#include "scene_xml/internal_bond_reader.h"
#include "scene_xml/internal_control_reader.h"
#include "scene_xml/internal_control_shapes.h"
#include "scene_xml/value_ranges.h"

namespace smile::scene_xml {
namespace {

using scene::Part;

/// Reads `nextStateWhenTriggered`, which only parts inside a state of a custom control have.
void ReadNextState(const PartPlace& place, AttributeReader* attributes, Part* part) {
  constexpr std::string_view kName = "nextStateWhenTriggered";
  if (place.container != Container::kState) {
    attributes->Forbid(kName, std::string(kName) + " only inside a state of a customControl");
  } else if (attributes->Text(kName)) {
    part->next_state = attributes->Count(kName, -1, {kNextStates.least, place.num_states - 1});
  }
}

/// Reads what triggers a part: inside a state of a custom control, if it says so. A switch reads
/// its own.
void ReadTrigger(const PartPlace& place, AttributeReader* attributes, Part* part) {
  if (std::holds_alternative<scene::ToggleSwitch>(part->shape)) return;
  for (const char* name : {"trigger", "pressForce", "pressAngle"}) {
    if (place.container != Container::kState) {
      attributes->Forbid(
          name, std::string(name) + " only on a toggleSwitch or inside a state of a customControl");
    } else if (attributes->Text(name) && !part->trigger) {
      part->trigger = ReadTriggerRule(scene::TriggerCause::kHand, attributes);
    }
  }
}

/// Reads a child of a composite: a bond point, except inside states, or a part.
void ReadMember(const SceneElement& element, const PartPlace& inside, scene::Composite* composite,
                ReadingContext* reading) {
  if (inside.container == Container::kComposite && element.Is("guestBondPoint")) {
    composite->guests.push_back(ReadGuestPoint(element, reading));
  } else if (inside.container == Container::kComposite && element.Is("hostBondPoint")) {
    composite->hosts.push_back(ReadHostPoint(element, reading));
  } else if (const ShapeElement* shape = FindShape(element, inside.container, reading)) {
    composite->parts.push_back(ReadPart(element, *shape, inside, reading));
  }
}

}  // namespace

Part ReadPartAttributes(const SceneElement& element, const ShapeElement& shape,
                        const PartPlace& place, AttributeReader* attributes,
                        ReadingContext* reading) {
  Part part;
  // Before the id, since it decides whether the id must be unique.
  part.is_pointable = attributes->Boolean("pointable", false);
  // Other parts may share ids, as nothing refers to them.
  const bool has_own_id = HoldsWholes(place.container) || part.is_pointable || shape.is_control;
  // Claiming adds a suffix to an id in use, and gives one to an element without.
  part.id = has_own_id ? attributes->ClaimedId() : attributes->Id();
  part.X_PE = attributes->Pose();
  if (!shape.default_color.empty()) part.color = attributes->Color(shape.default_color);
  part.shape = shape.read(attributes);
  ReadNextState(place, attributes, &part);
  ReadTrigger(place, attributes, &part);
  if (shape.is_control) {
    const std::string* written = element.FindAttribute("id");
    reading->references.Declare(Target::kControl, written ? *written : "", part.id);
  }
  return part;
}

void ReadContent(const PartPlace& place, std::span<const SceneElement* const> content,
                 std::span<const std::string_view> others, AttributeReader* attributes, Part* part,
                 ReadingContext* reading) {
  if (auto* composite = std::get_if<scene::Composite>(&part->shape)) {
    PartPlace inside = place;
    // Inside a state, composites keep the restrictions of states.
    if (place.container != Container::kState) inside.container = Container::kComposite;
    for (const SceneElement* child : content) ReadMember(*child, inside, composite, reading);
  } else if (scene::IsControl(part->shape)) {
    ReadControlContent(content, others, attributes, &part->shape, reading);
  } else {
    for (const SceneElement* child : content) RefuseElement(*child, others, reading);
  }
}

Part ReadPart(const SceneElement& element, const ShapeElement& shape, const PartPlace& place,
              ReadingContext* reading) {
  AttributeReader attributes(element, reading);
  Part part = ReadPartAttributes(element, shape, place, &attributes, reading);
  for (const char* name : {"mass", "centerOfMass", "friction", "restitution", "rollingFriction"}) {
    // Mass and surface are properties of rigid bodies, not of their parts.
    attributes.Forbid(name, std::string(name) + " only on the whole object");
  }
  attributes.RefuseUnknown();
  std::vector<const SceneElement*> content;
  for (const SceneElement& child : element.children) {
    if (child.Is("description")) {
      reading->findings->Add(child.place, AddressOf(child),
                             "found a description of a part, expected it in the whole object");
    } else {
      content.push_back(&child);
    }
  }
  ReadContent(place, content, {}, &attributes, &part, reading);
  return part;
}

}  // namespace smile::scene_xml
