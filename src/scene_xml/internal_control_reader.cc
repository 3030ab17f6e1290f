#include "scene_xml/internal_control_reader.h"

#include <array>
#include <string>
#include <vector>

#include "scene_xml/internal_element_choice.h"
#include "scene_xml/internal_part_reader.h"
#include "scene_xml/value_ranges.h"

// Content of controls: states, which lights and custom controls list and switches only count, and
// the controls downstream that follow them.

namespace smile::scene_xml {
namespace {

// Far more than any scene has; bounds the work that one press of a button causes.
constexpr int kMaxDownstreams = 256;

/// Returns the ticket of the control that a `downstream` element refers to; empty after a fault.
std::string ReadDownstream(const SceneElement& element, ReadingContext* reading) {
  AttributeReader attributes(element, reading);
  const std::string id = attributes.Reference("id");
  // Distinguishes two faults: a missing id, and an empty one, which is a valid id elsewhere.
  if (attributes.RequiredText("id").empty() && attributes.Text("id")) {
    attributes.Refuse("id", "the id of a control");
  }
  attributes.RefuseUnknown();
  RefuseContent(element, reading);
  if (id.empty()) return {};
  return reading->references.Add({Target::kControl, "id", id, element.place, AddressOf(element)});
}

/// Reads a light, by its number from 0.
scene::Light ReadLight(const SceneElement& element, int num_lights, ReadingContext* reading) {
  AttributeReader attributes(element, reading);
  attributes.RequiredText("id");
  scene::Light light{.number = attributes.Count("id", 0, {0, num_lights - 1})};
  light.color = attributes.Color("red");
  attributes.RefuseUnknown();
  RefuseContent(element, reading);
  return light;
}

/// Returns the name of a state; the caller reads its content.
std::string ReadStateName(const SceneElement& element, ReadingContext* reading) {
  AttributeReader attributes(element, reading);
  std::string name = attributes.OptionalName("descriptionName");
  attributes.RefuseUnknown();
  return name;
}

/// Reads a state of lights: those that are on, and their colors.
scene::IndicatorLights::State ReadLightsState(const SceneElement& element, int num_lights,
                                              ReadingContext* reading) {
  scene::IndicatorLights::State state{ReadStateName(element, reading), {}};
  std::vector<bool> is_on(num_lights);
  for (const SceneElement& child : element.children) {
    if (!child.Is("light")) {
      RefuseElement(child, std::array<std::string_view, 1>{"light"}, reading);
      continue;
    }
    state.lights.push_back(ReadLight(child, num_lights, reading));
    const int number = state.lights.back().number;
    // A light without an id counts as number 0 after its finding, and must not cause another one.
    if (child.FindAttribute("id") && is_on[number]) {
      AttributeReader(child, reading).Refuse("id", "each light once in a state");
    }
    is_on[number] = true;
  }
  return state;
}

/// Reads a state of a custom control: the parts that exist in it.
scene::CustomControl::State ReadCustomState(const SceneElement& element, int num_states,
                                            ReadingContext* reading) {
  scene::CustomControl::State state{ReadStateName(element, reading), {}};
  // The number of states is known before their content: parts may name any of them as the next.
  const PartPlace inside{Container::kState, num_states};
  for (const SceneElement& child : element.children) {
    if (const ShapeElement* shape = FindShape(child, inside.container, reading)) {
      state.parts.push_back(ReadPart(child, *shape, inside, reading));
    }
  }
  return state;
}

/// Child elements of a control, by kind.
struct ControlContent {
  std::vector<const SceneElement*> states, downstreams;
};

/// Adds a finding if there are more than allowed.
void CheckCount(std::size_t count, std::size_t limit, const std::string& what,
                AttributeReader* attributes) {
  if (count <= limit) return;
  attributes->AddFinding("found " + std::to_string(count) + " " + what + ", expected at most " +
                         std::to_string(limit));
}

/// Sorts the content of a control by kind, refuses other elements and checks the counts. Toggle
/// switches have no `state` elements.
ControlContent Sorted(std::span<const SceneElement* const> content, bool has_states,
                      std::span<const std::string_view> others, AttributeReader* attributes,
                      ReadingContext* reading) {
  std::vector<std::string_view> expected(others.begin(), others.end());
  expected.push_back("downstream");
  if (has_states) expected.push_back("state");
  ControlContent sorted;
  for (const SceneElement* child : content) {
    if (child->Is("downstream")) {
      sorted.downstreams.push_back(child);
    } else if (has_states && child->Is("state")) {
      sorted.states.push_back(child);
    } else {
      RefuseElement(*child, expected, reading);
    }
  }
  CheckCount(sorted.downstreams.size(), kMaxDownstreams, "downstream elements", attributes);
  CheckCount(sorted.states.size(), kMaxStates, "states", attributes);
  if (has_states && sorted.states.empty()) {
    attributes->AddFinding("found no state, expected at least one");
  }
  return sorted;
}

/// Refuses an initial state that does not exist. Without any states there is another finding.
void CheckInitialState(int initial_state, int num_states, AttributeReader* attributes) {
  if (num_states == 0 || initial_state < num_states) return;
  attributes->Refuse("initState",
                     "a state of this control, from 0 to " + std::to_string(num_states - 1));
}

}  // namespace

void ReadControlContent(std::span<const SceneElement* const> content,
                        std::span<const std::string_view> others, AttributeReader* attributes,
                        scene::Shape* control, ReadingContext* reading) {
  auto* toggle = std::get_if<scene::ToggleSwitch>(control);
  auto* lights = std::get_if<scene::IndicatorLights>(control);
  auto* custom = std::get_if<scene::CustomControl>(control);
  const ControlContent sorted = Sorted(content, !toggle, others, attributes, reading);
  const auto num_states = toggle ? toggle->num_states : static_cast<int>(sorted.states.size());
  // Already a finding. Reading on would cost time for states that are not kept.
  if (num_states > kMaxStates) return;
  for (const SceneElement* state : sorted.states) {
    if (lights) lights->states.push_back(ReadLightsState(*state, lights->num_lights, reading));
    if (custom) custom->states.push_back(ReadCustomState(*state, num_states, reading));
  }
  std::visit(
      [&](auto& any) {
        // Exactly the three kinds of controls have downstreams; other shapes never get here.
        if constexpr (requires { any.downstream; }) {
          CheckInitialState(any.initial_state, num_states, attributes);
          for (const SceneElement* downstream : sorted.downstreams) {
            any.downstream.push_back(ReadDownstream(*downstream, reading));
          }
        }
      },
      *control);
}

}  // namespace smile::scene_xml
