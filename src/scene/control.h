#pragma once

#include <optional>
#include <string>
#include <vector>

#include "math/angles.h"
#include "math/color.h"
#include "math/rigid_transform.h"
#include "scene/trigger_rule.h"

namespace smile::scene {

struct Part;

// Controls have a state and may drive others downstream. They are shapes: a whole object, or a part
// of a composite.

/// Button of a switch.
enum class Button { kLeft, kRight };

/// A rocker switch of two buttons about a hinge along y at its origin. In position 0 the left
/// button (-x) lies flat and the right one is raised; in position 1 vice versa.
struct ToggleSwitch {
  Vector3 size{0.06, 0.03, 0.01};                      ///< x: of both buttons together [m]
  double angle = DegreesToRadians(6.0);                ///< by which a button is raised [rad]
  bool is_left_pressed = true;                         ///< position 0 at the start, else 1
  int num_states = 2;                                  ///< each press selects the next one
  int initial_state = 0;                               ///< independent of the position
  std::vector<std::string> downstream;                 ///< ids of the controls it drives
  TriggerRule trigger{.cause = TriggerCause::kPress};  ///< of the raised button

  bool operator==(const ToggleSwitch&) const = default;
};

/// Light that is on.
struct Light {
  int number = 0;  ///< 0 is the leftmost (-x)
  Color color{1, 0, 0};

  bool operator==(const Light&) const = default;
};

/// Round lamps in a row along x, their axes along **z**; only driven by other things.
struct IndicatorLights {
  struct State {
    std::string name;           ///< for the log; empty: its number
    std::vector<Light> lights;  ///< those that are on; the others are invisible

    bool operator==(const State&) const = default;
  };

  double light_radius = 0.003;   ///< [m]
  double light_height = 0.0005;  ///< along z, on z = 0 [m]
  int num_lights = 2;
  double x_span = 0.015;  ///< of the whole row [m]
  int initial_state = 0;
  std::vector<State> states;            ///< at least one
  std::vector<std::string> downstream;  ///< ids of the controls it drives

  bool operator==(const IndicatorLights&) const = default;
};

/// Control of the author's own design, with parts for each of its states.
struct CustomControl {
  struct State {
    std::string name;         ///< for the log; empty: its number
    std::vector<Part> parts;  ///< simple shapes, containers, meshes and composites of them

    bool operator==(const State&) const;
  };

  std::string name = "customControl";  ///< its kind, for the log
  int initial_state = 0;
  std::vector<State> states;            ///< at least one
  std::vector<std::string> downstream;  ///< ids of the controls it drives

  bool operator==(const CustomControl&) const = default;
};

}  // namespace smile::scene
