#include "scene_xml/internal_tool_reader.h"

#include <algorithm>
#include <array>
#include <string>

#include "math/angles.h"
#include "scene_xml/internal_element_choice.h"
#include "scene_xml/internal_letters.h"
#include "scene_xml/value_ranges.h"

// Tools, and the places where they work. An attribute without a meaning for the action of a tool is
// an error: something else was wanted.

namespace smile::scene_xml {
namespace {

using scene::ToolAction;

/// Refuses an attribute that only tools of another action have.
void AllowOnlyFor(bool is_allowed, std::string_view name, const std::string& actions,
                  AttributeReader* attributes) {
  if (is_allowed || !attributes->Text(name)) return;
  attributes->Refuse(name, std::string(name) + " only with action=" + actions);
}

Vector3 RequiredDirection(std::string_view name, const Vector3& fallback,
                          AttributeReader* attributes) {
  // A missing one gets the finding of a required point, in the same form.
  return attributes->Text(name) ? attributes->Direction(name, fallback) : attributes->Point(name);
}

}  // namespace

std::string ReadTypeWord(std::string_view name, AttributeReader* attributes) {
  const auto is_token_letter = [](char letter) {
    return IsIdLetter(letter) || letter == '.' || letter == '-' || letter == ':';
  };
  std::string type = attributes->RequiredText(name);
  // Missing: a finding already.
  if (!attributes->Text(name)) return type;
  if (type.empty() || type.size() > kMaxBondTypeBytes ||
      !std::ranges::all_of(type, is_token_letter)) {
    attributes->Refuse(name, "a word of letters A-Z and a-z, digits, _, -, . and :, at most 100");
  }
  return type;
}

bool ReadCut(bool fallback, AttributeReader* attributes) {
  return attributes->Choice("cut", kNoYes, fallback ? 1 : 0) == 1;
}

scene::ToolSpec ReadTool(const SceneElement& element, ReadingContext* reading) {
  AttributeReader attributes(element, reading);
  scene::ToolSpec tool;
  if (!attributes.RequiredText("action").empty()) {
    tool.action = static_cast<ToolAction>(attributes.Choice("action", scene::kToolActions, 0));
  } else if (attributes.Text("action")) {
    attributes.Refuse("action", "cut, drive, fasten or loosen");
  }
  const bool cuts = tool.action == ToolAction::kCut, is_known = !attributes.has_findings();
  tool.p_BT = attributes.Point("at");
  tool.axis = RequiredDirection("axis", tool.axis, &attributes);
  if (is_known && cuts && !attributes.Text("edge")) {
    attributes.AddFinding(
        "found no edge, expected edge=\"…\": the length of the blades, from at along axis");
  }
  if (attributes.Text("edge")) tool.edge = attributes.Span("edge", 1);
  if (is_known && !cuts) {
    tool.type = ReadTypeWord("type", &attributes);
  }
  if (attributes.Text("turn")) {
    tool.turn = DegreesToRadians(attributes.Number("turn", 360, kTurnDegrees));
  }
  tool.reach = attributes.Span("reach", 0.2);
  tool.angle = DegreesToRadians(attributes.Number("angle", 15, kToolDegrees));
  if (is_known) {
    AllowOnlyFor(cuts, "edge", "\"cut\"", &attributes);
    AllowOnlyFor(!cuts, "type", "\"drive\", \"fasten\" or \"loosen\"", &attributes);
    AllowOnlyFor(!cuts, "angle", "\"drive\", \"fasten\" or \"loosen\"", &attributes);
    AllowOnlyFor(tool.action == ToolAction::kDrive, "turn", "\"drive\"", &attributes);
  }
  attributes.Text("type");
  attributes.RefuseUnknown();
  RefuseContent(element, reading);
  return tool;
}

scene::ToolPlace ReadToolPlace(const SceneElement& element, ReadingContext* reading) {
  AttributeReader attributes(element, reading);
  scene::ToolPlace place{.type = ReadTypeWord("tool", &attributes)};
  if (attributes.Text("at")) place.p_GS = attributes.Point("at");
  place.axis = attributes.Direction("axis", place.axis);
  attributes.RefuseUnknown();
  RefuseContent(element, reading);
  return place;
}

}  // namespace smile::scene_xml
