// Effects as text for people and as JSON.

#include <cmath>

#include "base/overloaded.h"
#include "base/wording.h"
#include "math/angles.h"
#include "task/effects.h"

namespace smile::task {
namespace {

/// Converts a length [m] to units of the scene file.
double InUnits(double length, double meters_per_unit) { return length / meters_per_unit; }

}  // namespace

std::string WordsOf(const Effect& effect, double meters_per_unit) {
  return std::visit(
      Overloaded{
          [](const ControlEffect& control) {
            return control.control + " from " + control.from + " to " + control.to;
          },
          [](const BondEffect& bond) {
            return bond.tightness == 0 ? bond.guest + " loosened from " + bond.host
                                       : bond.guest + " fastened to " + bond.host + ", stage " +
                                             std::to_string(bond.tightness);
          },
          [&](const SlideEffect& slide) {
            // Adding 0.0 turns -0 into 0.
            const auto tenths = [&](double offset) {
              return NumberText(std::round(10 * InUnits(offset, meters_per_unit)) / 10 + 0.0);
            };
            return slide.object + " slid from " + tenths(slide.from) + " to " + tenths(slide.to) +
                   " units";
          },
          [](const ContainerEffect& in) {
            return in.object + (in.is_inside ? " put into " : " taken out of ") + in.container;
          },
          [](const CutEffect& cut) { return cut.where + " cut with " + cut.tool; },
          [](const PressedEffect& pressed) { return pressed.control + " pressed"; },
          [](const OrientedEffect& oriented) {
            const std::string by =
                " by " + NumberText(std::round(RadiansToDegrees(oriented.angle))) + " degrees";
            return oriented.object + (oriented.is_tilt ? " tilted" + by : " turned in place" + by);
          },
          [](const DestroyedEffect& gone) { return gone.object + " removed from the table"; }},
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
