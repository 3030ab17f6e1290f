#pragma once

#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "base/json.h"
#include "task/episode.h"
#include "texts/user_message.h"

namespace smile::task {

// Effects: changes of a demonstration other than poses of objects. Effects name objects of their
// own scene; mechanisms of counterparts are found by their number within the object.

/// Change of the state of a switch, light or custom control.
struct ControlEffect {
  std::string object;    ///< that the control belongs to
  std::size_t number;    ///< of the control within the object, from 0
  std::string control;   ///< id
  std::string from, to;  ///< in the form of model::RecordedState()

  bool operator==(const ControlEffect&) const = default;
};

/// Change of a bond: a plug was fastened to a hole, tightened, or loosened; or turned and turned
/// back.
struct BondEffect {
  std::string guest_object, host_object;
  std::size_t guest_number = 0, host_number = 0;  ///< within their objects
  std::string guest, host;                        ///< ids of the points
  int tightness = 0;                              ///< at the end; 0: it came free

  bool operator==(const BondEffect&) const = default;
};

/// Displacement of a drawer or lid on its slider.
struct SlideEffect {
  std::string object;       ///< the second member
  double from = 0, to = 0;  ///< offset [m]

  bool operator==(const SlideEffect&) const = default;
};

/// Change of containment: an object was put into a container, or taken out of it.
struct ContainerEffect {
  std::string object, container;
  bool is_inside = true;

  bool operator==(const ContainerEffect&) const = default;
};

/// Cut of a chain between two of its pieces.
struct CutEffect {
  std::string object;  ///< a piece beside the cut
  std::string where;   ///< in words: `Rope between link 4 and 5`
  std::string tool;    ///< id

  bool operator==(const CutEffect&) const = default;
};

/// Press of a switch or control that is in the same state afterwards, as is what it drives: a bell,
/// or a switch that was turned and turned back.
struct PressedEffect {
  std::string object;   ///< that the control belongs to
  std::size_t number;   ///< of the control within the object, from 0
  std::string control;  ///< id
  std::string state;    ///< before and after, in the form of model::RecordedState()

  bool operator==(const PressedEffect&) const = default;
};

/// Rotation of an object that a hand took: put upright, laid on its side, or turned in place.
struct OrientedEffect {
  std::string object;
  double angle = 0;      ///< visible rotation from begin to end [rad]
  bool is_tilt = false;  ///< false: about the vertical only, in place

  bool operator==(const OrientedEffect&) const = default;
};

/// Removal of an object from the table: a hand destroyed it, or released it beyond the edge.
struct DestroyedEffect {
  std::string object;

  bool operator==(const DestroyedEffect&) const = default;
};

using Effect = std::variant<ControlEffect, BondEffect, SlideEffect, ContainerEffect, CutEffect,
                            PressedEffect, OrientedEffect, DestroyedEffect>;

/// Returns the effects of an episode, in the order of the kinds above, each in scene order.
std::vector<Effect> EffectsOf(const Episode& episode);

/// Returns true if an object is not on the table at the end: destroyed, or on the floor.
bool IsRemoved(const Episode& episode, const std::string& object);

/// Returns the bonds at a moment, in the order of the hosts.
std::vector<BondEffect> BondsAt(const scene::SceneSpec& scene, const recording::TraceTick& moment);

/// Returns the ids of the objects that an effect refers to.
std::vector<std::string> ObjectsOf(const Effect& effect);

/// Function that maps the id of a demonstrated object to the id of its counterpart.
using Counterpart = std::function<std::string(const std::string& object)>;

/// Returns for each effect whether it is achieved at the end of another episode: a control in the
/// same state, a bond as tight, a slider within `tolerance` [m], an object in the container, or
/// not, the same chain cut anywhere, a control pressed, an object no longer on the table. An
/// orientation always is: it depends on where the structure stands, see CompareWith().
std::vector<bool> AreAchieved(const std::vector<Effect>& effects, const Episode& episode,
                              const Counterpart& counterpart, double tolerance);

/// Returns a description for people: `Lamp from dark to blue`, `Tip fastened to Hole, stage 3`,
/// `Lid slid from 0 to 4 units`, `Cherry taken out of Chest`,
/// `Rope between link 4 and 5 cut with Scissors`, `Bell pressed`, `Plank tilted by 90 degrees`,
/// `Peel removed from the table`.
texts::UserMessage WordsOf(const Effect& effect, double meters_per_unit);
/// Returns JSON with a `kind`: `control`, `bond`, `slide`, `container`, `cut`, `pressed`,
/// `oriented` or `destroyed`; lengths in units, angles in degrees.
Json ToJson(const Effect& effect, double meters_per_unit);

}  // namespace smile::task
