#pragma once

#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "base/json.h"
#include "task/episode.h"

namespace smile::task {

// What else than its moved objects a demonstration left otherwise than it was. Effects name objects
// of their own scene; mechanisms of counterparts are found by their number within the object.

/// A switch, light or custom control shows another state.
struct ControlEffect {
  std::string object;    ///< whose control it is
  std::size_t number;    ///< of the control within the object, from 0
  std::string control;   ///< id
  std::string from, to;  ///< as recordings have them, see model::RecordedState()

  bool operator==(const ControlEffect&) const = default;
};

/// A plug is fastened to a hole, more or less tightly than before, or no longer.
struct BondEffect {
  std::string guest_object, host_object;
  std::size_t guest_number = 0, host_number = 0;  ///< within their objects
  std::string guest, host;                        ///< ids of the points
  int tightness = 0;                              ///< in the end; 0: it came free

  bool operator==(const BondEffect&) const = default;
};

/// A drawer or lid is farther out or in on its slider.
struct SlideEffect {
  std::string object;       ///< the second member
  double from = 0, to = 0;  ///< offset [m]

  bool operator==(const SlideEffect&) const = default;
};

/// An object came to lie in a container, or out of it.
struct ContainerEffect {
  std::string object, container;
  bool is_inside = true;

  bool operator==(const ContainerEffect&) const = default;
};

using Effect = std::variant<ControlEffect, BondEffect, SlideEffect, ContainerEffect>;

/// In the order of the kinds above, each in scene order.
std::vector<Effect> EffectsOf(const Episode& episode);

/// What is fastened at a moment, in the order of the hosts.
std::vector<BondEffect> BondsAt(const scene::SceneSpec& scene, const recording::TraceTick& moment);

/// The objects an effect is about.
std::vector<std::string> ObjectsOf(const Effect& effect);

/// Who plays an object's part.
using Counterpart = std::function<std::string(const std::string& object)>;

/// Returns for each effect whether, at the end of another episode, it is as the effect wants it: a
/// control in the same state, a bond as tight, a slider within `tolerance` [m], an object in the
/// container, or not.
std::vector<bool> AreAchieved(const std::vector<Effect>& effects, const Episode& episode,
                              const Counterpart& counterpart, double tolerance);

/// `Lamp from dark to blue`, `Tip fastened to Hole, stage 3`, `Lid slid from 0 to 4 units`, `Cherry
/// taken out of Chest`.
std::string WordsOf(const Effect& effect, double meters_per_unit);
/// With its `kind`: `control`, `bond`, `slide` or `container`; lengths in units.
Json ToJson(const Effect& effect, double meters_per_unit);

}  // namespace smile::task
