#include "task/effects.h"

#include <algorithm>
#include <cmath>

#include "base/overloaded.h"
#include "base/wording.h"
#include "scene/bond_points.h"
#include "scene/controls_of.h"
#include "scene/units.h"
#include "task/relations.h"

namespace smile::task {
namespace {

/// What slid less has not moved [m].
constexpr double kSlid = 0.01;

bool IsThere(const scene::SceneSpec& scene, const record::TraceTick& moment,
             const std::string& object) {
  const auto spec = std::ranges::find(scene.objects, object, &scene::ObjectSpec::id);
  return spec != scene.objects.end() &&
         moment.objects[static_cast<std::size_t>(spec - scene.objects.begin())].is_present;
}

/// The controls of all objects in scene order, as the trace has them; `from` as they are, `to`
/// empty.
std::vector<ControlEffect> ControlsAt(const scene::SceneSpec& scene,
                                      const record::TraceTick& moment) {
  std::vector<ControlEffect> controls;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    std::size_t number = 0;
    for (const scene::Part* part : scene::ControlsOf(scene.objects[i].whole)) {
      const world::Control control{
          .part = std::make_shared<const scene::Part>(*part), .object = i, .downstream = {}};
      controls.push_back({.object = scene.objects[i].id(),
                          .number = number++,
                          .control = part->id,
                          .from = RecordedState(control, moment.controls[controls.size()]),
                          .to = {}});
    }
  }
  return controls;
}

/// A bond point of a scene, by the object it belongs to.
struct PointPlace {
  std::string object;
  std::size_t number = 0;
  std::string id;
};

template <class PointsOf>
std::vector<PointPlace> PointsIn(const scene::SceneSpec& scene, const PointsOf& points_of) {
  std::vector<PointPlace> places;
  for (const scene::ObjectSpec& object : scene.objects) {
    std::size_t number = 0;
    for (const auto& placed : points_of(object.whole)) {
      places.push_back({object.id(), number++, placed.point->id});
    }
  }
  return places;
}

/// What is fastened at a moment.
std::vector<BondEffect> BondsAt(const scene::SceneSpec& scene, const record::TraceTick& moment) {
  const std::vector<PointPlace> guests = PointsIn(scene, scene::GuestsOf);
  const std::vector<PointPlace> hosts = PointsIn(scene, scene::HostsOf);
  std::vector<BondEffect> bonds;
  for (std::size_t i = 0; i < hosts.size(); ++i) {
    const record::TraceBond& bond = moment.bonds[i];
    if (bond.guest < 0) continue;
    const PointPlace& guest = guests[static_cast<std::size_t>(bond.guest)];
    bonds.push_back({.guest_object = guest.object,
                     .host_object = hosts[i].object,
                     .guest_number = guest.number,
                     .host_number = hosts[i].number,
                     .guest = guest.id,
                     .host = hosts[i].id,
                     .tightness = bond.tightness});
  }
  return bonds;
}

bool IsSamePair(const BondEffect& a, const BondEffect& b) {
  return a.guest_object == b.guest_object && a.guest_number == b.guest_number &&
         a.host_object == b.host_object && a.host_number == b.host_number;
}

/// How far out a slider's second member is [m]: its way in the first one's frame, along -x of the
/// rail J.
double OffsetOf(const scene::SliderSpec& slider, const record::TraceTick& moment) {
  const RigidTransform X_WA = moment.objects[slider.first_object].pose_in_world();
  const RigidTransform X_WB = moment.objects[slider.first_object + 1].pose_in_world();
  const RigidTransform X_JB = slider.X_JA * X_WA.inverse() * X_WB;
  return slider.X_JB.translation().x() - X_JB.translation().x();
}

std::vector<Relation> ContentsAt(const scene::SceneSpec& scene, const record::TraceTick& moment) {
  std::vector<Relation> relations = RelationsOf(scene.table, ObjectsAt(scene, moment));
  std::erase_if(relations,
                [](const Relation& relation) { return relation.kind != Relation::Kind::kIn; });
  return relations;
}

void AppendControlEffects(const Course& course, std::vector<Effect>* effects) {
  std::vector<ControlEffect> controls = ControlsAt(course.scene, course.begin);
  const std::vector<ControlEffect> after = ControlsAt(course.scene, course.end);
  for (std::size_t i = 0; i < controls.size(); ++i) {
    controls[i].to = after[i].from;
    if (controls[i].from == controls[i].to) continue;
    if (IsThere(course.scene, course.end, controls[i].object)) effects->push_back(controls[i]);
  }
}

void AppendBondEffects(const Course& course, std::vector<Effect>* effects) {
  const std::vector<BondEffect> before = BondsAt(course.scene, course.begin);
  const std::vector<BondEffect> after = BondsAt(course.scene, course.end);
  for (const BondEffect& bond : after) {
    if (std::ranges::find(before, bond) == before.end()) effects->push_back(bond);
  }
  for (BondEffect bond : before) {
    const bool is_kept =
        std::ranges::any_of(after, [&](const BondEffect& now) { return IsSamePair(bond, now); });
    const bool are_there = IsThere(course.scene, course.end, bond.guest_object) &&
                           IsThere(course.scene, course.end, bond.host_object);
    if (is_kept || !are_there) continue;
    bond.tightness = 0;
    effects->push_back(bond);
  }
}

void AppendSlideEffects(const Course& course, std::vector<Effect>* effects) {
  for (const scene::SliderSpec& slider : course.scene.sliders) {
    const std::string& first = course.scene.objects[slider.first_object].id();
    const std::string& second = course.scene.objects[slider.first_object + 1].id();
    if (!IsThere(course.scene, course.end, first) || !IsThere(course.scene, course.end, second)) {
      continue;
    }
    const double from = OffsetOf(slider, course.begin), to = OffsetOf(slider, course.end);
    if (std::abs(to - from) > kSlid) effects->push_back(SlideEffect{second, from, to});
  }
}

/// True of a drawer and what it slides in, and of a screw and its nut: of these other effects tell.
bool AreJoined(const Relation& relation, const Course& course, const std::vector<Effect>& effects) {
  const auto are_these = [&](const std::string& a, const std::string& b) {
    return (a == relation.object && b == relation.support) ||
           (a == relation.support && b == relation.object);
  };
  const auto& objects = course.scene.objects;
  for (const scene::SliderSpec& slider : course.scene.sliders) {
    const std::size_t first = slider.first_object;
    if (are_these(objects[first].id(), objects[first + 1].id())) return true;
  }
  return std::ranges::any_of(effects, [&](const Effect& effect) {
    const auto* bond = std::get_if<BondEffect>(&effect);
    return bond != nullptr && are_these(bond->guest_object, bond->host_object);
  });
}

void AppendContainerEffects(const Course& course, std::vector<Effect>* effects) {
  const std::vector<Relation> before = ContentsAt(course.scene, course.begin);
  const std::vector<Relation> after = ContentsAt(course.scene, course.end);
  const auto append_missing = [&](const std::vector<Relation>& from,
                                  const std::vector<Relation>& in, bool is_inside) {
    for (const Relation& relation : from) {
      if (std::ranges::find(in, relation) != in.end()) continue;
      if (AreJoined(relation, course, *effects)) continue;
      const bool are_there = IsThere(course.scene, course.end, relation.object) &&
                             IsThere(course.scene, course.end, relation.support);
      if (!are_there) continue;
      effects->push_back(ContainerEffect{relation.object, relation.support, is_inside});
    }
  };
  append_missing(after, before, /*is_inside=*/true);
  append_missing(before, after, /*is_inside=*/false);
}

bool HoldsOf(const ControlEffect& wanted, const Course& course, const Counterpart& counterpart,
             double) {
  return std::ranges::any_of(ControlsAt(course.scene, course.end),
                             [&](const ControlEffect& control) {
                               return control.object == counterpart(wanted.object) &&
                                      control.number == wanted.number && control.from == wanted.to;
                             });
}

bool HoldsOf(BondEffect wanted, const Course& course, const Counterpart& counterpart, double) {
  wanted.guest_object = counterpart(wanted.guest_object);
  wanted.host_object = counterpart(wanted.host_object);
  for (const BondEffect& bond : BondsAt(course.scene, course.end)) {
    if (IsSamePair(bond, wanted)) return bond.tightness == wanted.tightness;
  }
  return wanted.tightness == 0;
}

bool HoldsOf(const SlideEffect& wanted, const Course& course, const Counterpart& counterpart,
             double tolerance) {
  return std::ranges::any_of(course.scene.sliders, [&](const scene::SliderSpec& slider) {
    return course.scene.objects[slider.first_object + 1].id() == counterpart(wanted.object) &&
           std::abs(OffsetOf(slider, course.end) - wanted.to) <= tolerance;
  });
}

bool HoldsOf(const ContainerEffect& wanted, const Course& course, const Counterpart& counterpart,
             double) {
  const bool is_inside =
      std::ranges::any_of(ContentsAt(course.scene, course.end), [&](const Relation& relation) {
        return relation.object == counterpart(wanted.object) &&
               relation.support == counterpart(wanted.container);
      });
  return is_inside == wanted.is_inside;
}

double InUnits(double length, double meters_per_unit) { return length / meters_per_unit; }

}  // namespace

std::vector<Effect> EffectsOf(const Course& course) {
  std::vector<Effect> effects;
  AppendControlEffects(course, &effects);
  AppendBondEffects(course, &effects);
  AppendSlideEffects(course, &effects);
  AppendContainerEffects(course, &effects);
  return effects;
}

std::vector<std::string> ObjectsOf(const Effect& effect) {
  using Ids = std::vector<std::string>;
  return std::visit(Overloaded{[](const ControlEffect& control) { return Ids{control.object}; },
                               [](const BondEffect& bond) {
                                 return Ids{bond.guest_object, bond.host_object};
                               },
                               [](const SlideEffect& slide) { return Ids{slide.object}; },
                               [](const ContainerEffect& in) {
                                 return Ids{in.object, in.container};
                               }},
                    effect);
}

bool IsAchieved(const Effect& effect, const Course& course, const Counterpart& counterpart,
                double tolerance) {
  return std::visit(
      [&](const auto& wanted) { return HoldsOf(wanted, course, counterpart, tolerance); }, effect);
}

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
            const auto tenths = [&](double offset) {
              return NumberText(std::round(10 * InUnits(offset, meters_per_unit)) / 10 + 0.0);
            };
            return slide.object + " slid from " + tenths(slide.from) + " to " + tenths(slide.to) +
                   " units";
          },
          [](const ContainerEffect& in) {
            return in.object + (in.is_inside ? " put into " : " taken out of ") + in.container;
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
                               }},
                    effect);
}

}  // namespace smile::task
