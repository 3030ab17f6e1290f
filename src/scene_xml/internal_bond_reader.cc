#include "scene_xml/internal_bond_reader.h"

#include <array>
#include <string>

#include "scene_xml/internal_attribute_reader.h"
#include "scene_xml/internal_element_choice.h"
#include "scene_xml/internal_tool_reader.h"
#include "scene_xml/value_ranges.h"

// Bond points: a guest (screw) fits a host (hole) of the same type, whose stages of tightness say
// how far it is in and what that does to the control downstream. References are tickets here, since
// their targets may come later in the file; internal_mechanisms.cc resolves them.

namespace smile::scene_xml {
namespace {

/// Returns the ticket of a reference, which is resolved when the whole scene has been read; empty
/// without a reference.
std::string ReadReference(const SceneElement& element, const char* name, Target target,
                          AttributeReader* attributes, ReadingContext* reading) {
  const std::string id = attributes->Reference(name);
  if (id.empty()) return {};
  return reading->references.Add({target, name, id, element.place, AddressOf(element)});
}

scene::TightnessStage ReadStage(const SceneElement& element, ReadingContext* reading) {
  AttributeReader attributes(element, reading);
  scene::TightnessStage stage{.X_HS = attributes.PoseOrOrigin()};
  // Without the attribute the stage leaves the control's state alone, which is not the same as 0.
  if (attributes.Text("downstreamState")) {
    stage.downstream_state = attributes.Count("downstreamState", 0, kStates);
  }
  stage.locks_downstream = attributes.Boolean("downstreamLock", false);
  attributes.RefuseUnknown();
  RefuseContent(element, reading);
  return stage;
}

/// Checks that a guest with an initial host is fastened to some degree.
void CheckInitialBond(const scene::GuestPoint& guest, AttributeReader* attributes) {
  if (guest.initial_host.empty() || guest.initial_tightness > 0 || attributes->has_findings()) {
    return;
  }
  attributes->Refuse("initBondTightness",
                     "1 or more with an initBondHostId: at 0 they are not fastened");
}

/// Reads the places where tools work on the bond of a guest.
void ReadToolPlaces(const SceneElement& element, scene::GuestPoint* guest,
                    AttributeReader* attributes, ReadingContext* reading) {
  for (const SceneElement& child : element.children) {
    if (child.Is("accepts")) {
      guest->accepts.push_back(ReadToolPlace(child, reading));
    } else {
      RefuseElement(child, std::array<std::string_view, 1>{"accepts"}, reading);
    }
  }
  if (guest->accepts.size() > static_cast<std::size_t>(kMaxToolPlaces)) {
    attributes->AddFinding("found " + std::to_string(guest->accepts.size()) +
                           " accepts elements, expected at most " + std::to_string(kMaxToolPlaces));
  }
  if (guest->refuses_hands && guest->accepts.empty()) {
    attributes->Refuse("by", "an accepts element inside: otherwise nothing can turn it");
  }
}

}  // namespace

scene::GuestPoint ReadGuestPoint(const SceneElement& element, ReadingContext* reading) {
  AttributeReader attributes(element, reading);
  scene::GuestPoint guest{.id = attributes.ClaimedId(),
                          .type = ReadTypeWord("type", &attributes),
                          .X_PG = attributes.PoseOrOrigin()};
  guest.initial_host =
      ReadReference(element, "initBondHostId", Target::kHost, &attributes, reading);
  guest.initial_tightness = attributes.Count("initBondTightness", 0, kTightness);
  // Guests have nothing downstream. The attributes are accepted because templates for both kinds of
  // points contain them.
  for (const char* name : {"downstream", "downstreamOverride", "downstreamLock"}) {
    attributes.Reference(name);
  }
  guest.can_be_cut = ReadCut(false, &attributes);
  guest.refuses_hands = attributes.Choice("by", kHandTool, 0) == 1;
  attributes.RefuseUnknown();
  ReadToolPlaces(element, &guest, &attributes, reading);
  CheckInitialBond(guest, &attributes);
  // A tightness without a host has no meaning, and templates may set it for all.
  if (guest.initial_host.empty()) guest.initial_tightness = 0;
  return guest;
}

scene::HostPoint ReadHostPoint(const SceneElement& element, ReadingContext* reading) {
  AttributeReader attributes(element, reading);
  scene::HostPoint host{.id = attributes.ClaimedId(),
                        .type = ReadTypeWord("type", &attributes),
                        .X_PH = attributes.PoseOrOrigin()};
  const auto read_reference = [&](const char* name, Target target) {
    return ReadReference(element, name, target, &attributes, reading);
  };
  host.downstream = read_reference("downstream", Target::kControl);
  host.downstream_override = read_reference("downstreamOverride", Target::kControl);
  host.downstream_lock = read_reference("downstreamLock", Target::kHost);
  attributes.RefuseUnknown();
  for (const SceneElement& child : element.children) {
    if (child.Is("tightness")) {
      host.stages.push_back(ReadStage(child, reading));
    } else {
      RefuseElement(child, std::array<std::string_view, 1>{"tightness"}, reading);
    }
  }
  if (host.stages.empty() || host.stages.size() > kMaxStages) {
    attributes.AddFinding("found " + std::to_string(host.stages.size()) +
                          " tightness elements, expected 1 to " + std::to_string(kMaxStages));
  }
  // References use the written id, which may differ from the unique one.
  const std::string* written = element.FindAttribute("id");
  reading->references.Declare(Target::kHost, written ? *written : "", host.id);
  return host;
}

}  // namespace smile::scene_xml
