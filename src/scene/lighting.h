#pragma once

#include <optional>

#include "math/color.h"

namespace smile::scene {

/// Light in which a scene is drawn, relative to the usual one. It does not change physics.
struct Lighting {
  double brightness = 1;            ///< factor of all colors, except those of lamps that are on
  Color color{1, 1, 1};             ///< of the light: factors of red, green and blue
  double turn = 0;                  ///< from the usual direction, about the vertical [rad]
  std::optional<Color> background;  ///< nullopt: that of the style of the picture

  bool operator==(const Lighting&) const = default;
};

}  // namespace smile::scene
