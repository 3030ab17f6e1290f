// Effects as text for people and as JSON.

#include <cmath>

#include "base/overloaded.h"
#include "math/angles.h"
#include "task/effects.h"

namespace smile::task {
namespace {

using texts::Say;

/// Converts a length [m] to units of the scene file.
double InUnits(double length, double meters_per_unit) { return length / meters_per_unit; }

}  // namespace

texts::UserMessage WordsOf(const Effect& effect, double meters_per_unit) {
  return std::visit(
      Overloaded{
          [](const ControlEffect& control) {
            return Say("effects.control",
                       {{"control", control.control}, {"from", control.from}, {"to", control.to}});
          },
          [](const BondEffect& bond) {
            return bond.tightness == 0
                       ? Say("effects.loosened", {{"guest", bond.guest}, {"host", bond.host}})
                       : Say("effects.fastened", {{"guest", bond.guest},
                                                  {"host", bond.host},
                                                  {"stage", bond.tightness}});
          },
          [&](const SlideEffect& slide) {
            // Adding 0.0 turns -0 into 0.
            const auto tenths = [&](double offset) {
              return std::round(10 * InUnits(offset, meters_per_unit)) / 10 + 0.0;
            };
            return Say(
                "effects.slid",
                {{"object", slide.object}, {"from", tenths(slide.from)}, {"to", tenths(slide.to)}});
          },
          [](const ContainerEffect& in) {
            const texts::UserMessage object(in.object), container(in.container);
            return in.is_inside
                       ? Say("effects.putInto", {{"object", object}, {"container", container}})
                       : Say("effects.takenOut", {{"object", object}, {"container", container}});
          },
          [](const CutEffect& cut) {
            return Say("effects.cut", {{"where", cut.where}, {"tool", cut.tool}});
          },
          [](const PressedEffect& pressed) {
            return Say("effects.pressed", {{"control", pressed.control}});
          },
          [](const OrientedEffect& oriented) {
            const double degrees = std::round(RadiansToDegrees(oriented.angle));
            return oriented.is_tilt
                       ? Say("effects.tilted", {{"object", oriented.object}, {"degrees", degrees}})
                       : Say("effects.turned", {{"object", oriented.object}, {"degrees", degrees}});
          },
          [](const DestroyedEffect& gone) {
            return Say("effects.removed", {{"object", gone.object}});
          }},
      effect);
}

Json ToJson(const Effect& effect, double meters_per_unit) {
  return std::visit(Overloaded{[](const ControlEffect& control) -> Json {
                                 return {{"kind", "control"},
                                         {"object", control.object},
                                         {"control", control.control},
                                         {"from", control.from},
                                         {"to", control.to}};
                               },
                               [](const BondEffect& bond) -> Json {
                                 return {{"kind", "bond"},
                                         {"object", bond.guest_object},
                                         {"guest", bond.guest},
                                         {"host", bond.host},
                                         {"tightness", bond.tightness}};
                               },
                               [&](const SlideEffect& slide) -> Json {
                                 return {{"kind", "slide"},
                                         {"object", slide.object},
                                         {"from", InUnits(slide.from, meters_per_unit)},
                                         {"to", InUnits(slide.to, meters_per_unit)}};
                               },
                               [](const ContainerEffect& in) -> Json {
                                 return {{"kind", "container"},
                                         {"object", in.object},
                                         {"container", in.container},
                                         {"inside", in.is_inside}};
                               },
                               [](const CutEffect& cut) -> Json {
                                 return {{"kind", "cut"},
                                         {"object", cut.object},
                                         {"where", cut.where},
                                         {"tool", cut.tool}};
                               },
                               [](const PressedEffect& pressed) -> Json {
                                 return {{"kind", "pressed"},
                                         {"object", pressed.object},
                                         {"control", pressed.control},
                                         {"state", pressed.state}};
                               },
                               [](const OrientedEffect& oriented) -> Json {
                                 return {{"kind", "oriented"},
                                         {"object", oriented.object},
                                         {"degrees", RadiansToDegrees(oriented.angle)},
                                         {"tilted", oriented.is_tilt}};
                               },
                               [](const DestroyedEffect& gone) -> Json {
                                 return {{"kind", "destroyed"}, {"object", gone.object}};
                               }},
                    effect);
}

}  // namespace smile::task
