#include "scene_xml/internal_control_shapes.h"

#include <string>

#include "math/angles.h"
#include "scene_xml/value_ranges.h"

namespace smile::scene_xml {

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
