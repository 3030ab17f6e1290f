#include "scene_xml/internal_control_shapes.h"

#include <string>

#include "math/angles.h"
#include "scene_xml/value_ranges.h"

namespace smile::scene_xml {

scene::TriggerRule ReadTriggerRule(scene::TriggerCause cause, AttributeReader* attributes) {
  const scene::TriggerRule usual;
  scene::TriggerRule rule{.cause = static_cast<scene::TriggerCause>(attributes->Choice(
                              "trigger", scene::kTriggerCauses, static_cast<int>(cause)))};
  rule.press_force = attributes->Number("pressForce", usual.press_force, kPressNewtons);
  rule.press_angle = DegreesToRadians(attributes->Number("pressAngle", 45, kPressDegrees));
  // Both have a meaning only with a press; set without one, something else was wanted.
  for (const char* name : {"pressForce", "pressAngle"}) {
    const bool is_of_press = rule.cause == scene::TriggerCause::kPress;
    if (!is_of_press && attributes->Text(name)) {
      attributes->Refuse(name, std::string(name) + " only with trigger=\"press\"");
    }
  }
  return rule;
}

scene::Shape ReadToggleSwitch(AttributeReader* attributes) {
  // Sizes are in units here and in meters in the shape, so only the other defaults come from it.
  const scene::ToggleSwitch usual;
  scene::ToggleSwitch toggle;
  const double x = attributes->Span("xspan", 0.6);
  const double y = attributes->Span("yspan", 0.3);
  const double z = attributes->Span("zspan", 0.1);
  toggle.size = {x, y, z};
  toggle.angle = DegreesToRadians(attributes->Number("angle", 6, kButtonDegrees));
  toggle.is_left_pressed = attributes->Boolean("leftPressed", usual.is_left_pressed);
  toggle.num_states = attributes->Count("numStates", usual.num_states, kNumStates);
  toggle.initial_state = attributes->Count("initState", 0, kStates);
  toggle.trigger = ReadTriggerRule(usual.trigger.cause, attributes);
  return toggle;
}

scene::Shape ReadIndicatorLights(AttributeReader* attributes) {
  return scene::IndicatorLights{
      .light_radius = attributes->Span("lightRadius", 0.03),
      .light_height = attributes->Span("lightZspan", 0.005),
      .num_lights = attributes->Count("numLights", 2, kNumLights),
      .x_span = attributes->Span("xspan", 0.15),
      // Checked against the number of states when those have been read (ReadControlContent).
      .initial_state = attributes->Count("initState", 0, kStates),
  };
}

scene::Shape ReadCustomControl(AttributeReader* attributes) {
  scene::CustomControl control;
  const std::string name = attributes->OptionalName("name");
  // An empty name would be an empty `shape` description of the object.
  if (!name.empty()) control.name = name;
  control.initial_state = attributes->Count("initState", 0, kStates);
  return control;
}

}  // namespace smile::scene_xml
