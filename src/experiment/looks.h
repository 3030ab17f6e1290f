#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/json.h"
#include "base/json_node.h"
#include "experiment/range.h"
#include "scene/scene_spec.h"

namespace smile::experiment {

/// Ranges from which the looks of a scene are drawn. The defaults change nothing.
struct LookChoices {
  Range brightness{1, 1};  ///< of the light
  Range warmth;            ///< of the light: above 0 less blue, below 0 less red
  Range turn_deg;          ///< of the light, about the vertical
  Range hue_deg;           ///< by which each color of objects is shifted
  Range value{1, 1};       ///< factor of the brightness of each color of objects
  Range table{1, 1};       ///< brightness of the table
  Range tint;              ///< saturation of the table, in any hue
  Range background;        ///< brightness of the background; black: that of each style
  std::vector<std::string> patterns{"plain"};  ///< of the table; not empty
  std::vector<std::string> cameras;            ///< that are displaced
  Range shift;                                 ///< of these along each axis [units]
  Range tilt_deg;                              ///< of these about each axis
  Range view{1, 1};                            ///< factor of their field of view

  bool operator==(const LookChoices&) const = default;
};

/// Looks of a scene that were drawn: how it differs from the scene file, apart from the layout.
/// Colors are those of scene files; an empty one changes nothing. Numbers are rounded: a scene that
/// is written and read draws to the same bits.
struct Looks {
  double brightness = 1, turn_deg = 0;  ///< of the light
  std::string light, background, table;
  std::string pattern, pattern_color;         ///< of the table; empty: unchanged
  double pattern_span = 1;                    ///< [units]
  std::map<std::string, std::string> colors;  ///< new colors of objects, by the old ones
  struct Jitter {
    std::string camera;
    Vector3 shift = Vector3::Zero(), tilt_deg = Vector3::Zero();  ///< [units]; about x, y, z
    double view = 1;

    bool operator==(const Jitter&) const = default;
  };
  std::vector<Jitter> cameras;

  bool operator==(const Looks&) const = default;
};

/// Limit of the different colors of objects that can be varied.
inline constexpr std::size_t kMaxColors = 1000;

/// Returns the colors of the objects of a scene, as in scene files, in alphabetical order. Lamps
/// are not among them: their colors have a meaning.
std::vector<std::string> ColorsOf(const scene::SceneSpec& scene);

/// Draws looks. Each value depends on the seed and its own range only.
/// @param colors  of the objects, see ColorsOf().
Looks DrawLooks(const LookChoices& choices, const std::vector<std::string>& colors,
                std::uint64_t seed);

/// Changes the looks of a scene; recordings, pictures and exports of it need nothing else.
void Apply(const Looks& looks, scene::SceneSpec* scene);

Json ToJson(const LookChoices& choices);
Json ToJson(const Looks& looks);

/// Returns the looks that ToJson() wrote.
/// @throws InputError if they are damaged.
Looks LooksIn(const JsonNode& node);

}  // namespace smile::experiment
