#include "task/effects.h"

#include <algorithm>
#include <cmath>

#include "base/overloaded.h"
#include "base/wording.h"
#include "model/relations.h"
#include "scene/bond_points.h"
#include "scene/controls_of.h"
#include "scene/units.h"

namespace smile::task {
namespace {

using model::Relation;

/// Shortest displacement of a slider that counts as an effect [m].
constexpr double kSlid = 0.01;

/// True if the object exists at that moment: it has been added and not been destroyed.
bool IsThere(const scene::SceneSpec& scene, const recording::TraceTick& moment,
             const std::string& object) {
  const auto spec = std::ranges::find(scene.objects, object, &scene::ObjectSpec::id);
  return spec != scene.objects.end() &&
         moment.objects[static_cast<std::size_t>(spec - scene.objects.begin())].is_present;
}

/// Returns the controls of all objects, in the order of the trace (scene order). `from` is the
/// state at that moment; `to` is empty.
std::vector<ControlEffect> ControlsAt(const scene::SceneSpec& scene,
                                      const recording::TraceTick& moment) {
  std::vector<ControlEffect> controls;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    std::size_t number = 0;
    for (const scene::Part* part : scene::ControlsOf(scene.objects[i].whole)) {
      const model::Control control{.part = part, .object = model::ObjectIndex(i)};
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

/// Returns the bond points of all objects, in the order of the trace. `points_of` selects guests or
/// hosts.
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

bool IsSamePair(const BondEffect& a, const BondEffect& b) {
  return a.guest_object == b.guest_object && a.guest_number == b.guest_number &&
         a.host_object == b.host_object && a.host_number == b.host_number;
}

/// Returns the offset of a slider [m]: the displacement of its second member B, relative to the
/// first member A, along -x of the rail frame J.
double OffsetOf(const scene::SliderSpec& slider, const recording::TraceTick& moment) {
  const RigidTransform X_WA = moment.objects[slider.first_object].pose_in_world();
  const RigidTransform X_WB = moment.objects[slider.first_object + 1].pose_in_world();
  const RigidTransform X_JB = slider.X_JA * X_WA.inverse() * X_WB;
  return slider.X_JB.translation().x() - X_JB.translation().x();
}

/// Returns the relations "object in container" at that moment.
std::vector<Relation> ContentsAt(const scene::SceneSpec& scene,
                                 const recording::TraceTick& moment) {
  std::vector<Relation> relations = model::RelationsOf(scene, ObjectsAt(scene, moment));
  std::erase_if(relations,
                [](const Relation& relation) { return relation.kind != Relation::Kind::kIn; });
  return relations;
}

/// Appends the controls whose state differs between begin and end, unless their object is gone.
void AppendControlEffects(const Episode& episode, std::vector<Effect>* effects) {
  std::vector<ControlEffect> controls = ControlsAt(episode.scene, episode.begin);
  const std::vector<ControlEffect> after = ControlsAt(episode.scene, episode.end);
  for (std::size_t i = 0; i < controls.size(); ++i) {
    controls[i].to = after[i].from;
    if (controls[i].from == controls[i].to) continue;
    if (IsThere(episode.scene, episode.end, controls[i].object)) effects->push_back(controls[i]);
  }
}

/// True if a guest of the object was fastened or loosened meanwhile.
bool WasTurned(const Episode& episode, const std::string& object) {
  return std::ranges::any_of(episode.contacts, [&object](const ContactEvent& contact) {
    const bool is_turn = contact.event.kind == sim::EventKind::kFastened ||
                         contact.event.kind == sim::EventKind::kLoosened;
    return is_turn && contact.event.object == object;
  });
}

/// Appends the bonds that are new, have another tightness or were turned meanwhile, in the order of
/// the hosts, then those that came free. A bond does not count as loosened if one of its objects
/// was destroyed.
void AppendBondEffects(const Episode& episode, std::vector<Effect>* effects) {
  const std::vector<BondEffect> before = BondsAt(episode.scene, episode.begin);
  const std::vector<BondEffect> after = BondsAt(episode.scene, episode.end);
  for (const BondEffect& bond : after) {
    const bool is_kept = std::ranges::find(before, bond) != before.end();
    // A cover is opened to be closed again: its screws must be tight in the end.
    if (!is_kept || WasTurned(episode, bond.guest_object)) effects->push_back(bond);
  }
  for (BondEffect bond : before) {
    const bool is_kept =
        std::ranges::any_of(after, [&](const BondEffect& now) { return IsSamePair(bond, now); });
    const bool are_there = IsThere(episode.scene, episode.end, bond.guest_object) &&
                           IsThere(episode.scene, episode.end, bond.host_object);
    if (is_kept || !are_there) continue;
    bond.tightness = 0;
    effects->push_back(bond);
  }
}

/// Returns the chain with this link, or nullptr.
const scene::ChainSpec* ChainOf(const std::string& link, const scene::SceneSpec& scene) {
  const auto chain = std::ranges::find_if(scene.chains, [&](const scene::ChainSpec& one) {
    return std::ranges::find(one.link_ids, link) != one.link_ids.end();
  });
  return chain == scene.chains.end() ? nullptr : &*chain;
}

/// Returns the chain that the use of a tool parted; nullptr for any other event.
const scene::ChainSpec* CutChain(const sim::Event& event, const scene::SceneSpec& scene) {
  if (event.kind != sim::EventKind::kUsed || event.state != "cut") return nullptr;
  return ChainOf(event.object, scene);
}

/// Appends the sliders that moved by more than kSlid.
void AppendSlideEffects(const Episode& episode, std::vector<Effect>* effects) {
  for (const scene::SliderSpec& slider : episode.scene.sliders) {
    const std::string& first = episode.scene.objects[slider.first_object].id();
    const std::string& second = episode.scene.objects[slider.first_object + 1].id();
    if (!IsThere(episode.scene, episode.end, first) ||
        !IsThere(episode.scene, episode.end, second)) {
      continue;
    }
    const double from = OffsetOf(slider, episode.begin), to = OffsetOf(slider, episode.end);
    if (std::abs(to - from) > kSlid) effects->push_back(SlideEffect{second, from, to});
  }
}

/// Appends the cuts of chains, in their order. Those of bonds and parts are effects of their own.
void AppendCutEffects(const Episode& episode, std::vector<Effect>* effects) {
  for (const ContactEvent& contact : episode.contacts) {
    const sim::Event& event = contact.event;
    if (CutChain(event, episode.scene)) {
      effects->push_back(CutEffect{event.object, event.part, event.by});
    }
  }
}

/// True if a slider or a bond connects the two objects, such as a drawer and its cabinet or a screw
/// and its nut. The geometric relation "in" between them would repeat the slide or bond effect.
bool AreJoined(const Relation& relation, const Episode& episode,
               const std::vector<Effect>& effects) {
  const auto are_these = [&](const std::string& a, const std::string& b) {
    return (a == relation.object && b == relation.support) ||
           (a == relation.support && b == relation.object);
  };
  const auto& objects = episode.scene.objects;
  for (const scene::SliderSpec& slider : episode.scene.sliders) {
    const std::size_t first = slider.first_object;
    if (are_these(objects[first].id(), objects[first + 1].id())) return true;
  }
  return std::ranges::any_of(effects, [&](const Effect& effect) {
    const auto* bond = std::get_if<BondEffect>(&effect);
    return bond != nullptr && are_these(bond->guest_object, bond->host_object);
  });
}

/// Appends the objects that came to lie in a container, then those that left one. Depends on the
/// bond effects appended before, see AreJoined().
void AppendContainerEffects(const Episode& episode, std::vector<Effect>* effects) {
  const std::vector<Relation> before = ContentsAt(episode.scene, episode.begin);
  const std::vector<Relation> after = ContentsAt(episode.scene, episode.end);
  const auto append_missing = [&](const std::vector<Relation>& from,
                                  const std::vector<Relation>& in, bool is_inside) {
    for (const Relation& relation : from) {
      if (std::ranges::find(in, relation) != in.end()) continue;
      if (AreJoined(relation, episode, *effects)) continue;
      const bool are_there = IsThere(episode.scene, episode.end, relation.object) &&
                             IsThere(episode.scene, episode.end, relation.support);
      if (!are_there) continue;
      effects->push_back(ContainerEffect{relation.object, relation.support, is_inside});
    }
  };
  append_missing(after, before, /*is_inside=*/true);
  append_missing(before, after, /*is_inside=*/false);
}

/// State at the end of an episode, to compare with the goals of effects.
class Ending {
 public:
  Ending(const Episode& episode, const Counterpart& counterpart, double tolerance)
      : episode_(episode),
        counterpart_(counterpart),
        tolerance_(tolerance),
        controls_(ControlsAt(episode.scene, episode.end)),
        bonds_(BondsAt(episode.scene, episode.end)),
        contents_(ContentsAt(episode.scene, episode.end)) {}

  bool IsAs(const ControlEffect& wanted) const {
    return std::ranges::any_of(controls_, [&](const ControlEffect& control) {
      return control.object == counterpart_(wanted.object) && control.number == wanted.number &&
             control.from == wanted.to;
    });
  }

  // A bond that came free (tightness 0) is achieved if the pair is not fastened. A fastened one may
  // be in any hole of the object: four equal screws around an object that looks the same from two
  // sides have no holes of their own. Whether they are in the right places, their poses decide.
  bool IsAs(BondEffect wanted) const {
    wanted.guest_object = counterpart_(wanted.guest_object);
    wanted.host_object = counterpart_(wanted.host_object);
    const auto is_it = [&wanted](BondEffect bond) {
      if (wanted.tightness > 0) bond.host_number = wanted.host_number;
      return IsSamePair(bond, wanted);
    };
    const auto bond = std::ranges::find_if(bonds_, is_it);
    return (bond == bonds_.end() ? 0 : bond->tightness) == wanted.tightness;
  }

  bool IsAs(const SlideEffect& wanted) const {
    return std::ranges::any_of(episode_.scene.sliders, [&](const scene::SliderSpec& slider) {
      return episode_.scene.objects[slider.first_object + 1].id() == counterpart_(wanted.object) &&
             std::abs(OffsetOf(slider, episode_.end) - wanted.to) <= tolerance_;
    });
  }

  bool IsAs(const CutEffect& wanted) const {
    return std::ranges::any_of(episode_.contacts, [&](const ContactEvent& contact) {
      const scene::ChainSpec* chain = CutChain(contact.event, episode_.scene);
      return chain && chain == ChainOf(counterpart_(wanted.object), episode_.scene);
    });
  }

  bool IsAs(const ContainerEffect& wanted) const {
    const bool is_inside = std::ranges::any_of(contents_, [&](const Relation& relation) {
      return relation.object == counterpart_(wanted.object) &&
             relation.support == counterpart_(wanted.container);
    });
    return is_inside == wanted.is_inside;
  }

 private:
  const Episode& episode_;
  const Counterpart& counterpart_;
  double tolerance_;  ///< [m]
  std::vector<ControlEffect> controls_;
  std::vector<BondEffect> bonds_;
  std::vector<Relation> contents_;
};

/// Converts a length [m] to units of the scene file.
double InUnits(double length, double meters_per_unit) { return length / meters_per_unit; }

}  // namespace

std::vector<BondEffect> BondsAt(const scene::SceneSpec& scene, const recording::TraceTick& moment) {
  // The trace stores one state per host point, with the index of the guest point that is fastened
  // to it.
  const std::vector<PointPlace> guests = PointsIn(scene, scene::GuestsOf);
  const std::vector<PointPlace> hosts = PointsIn(scene, scene::HostsOf);
  std::vector<BondEffect> bonds;
  for (std::size_t i = 0; i < hosts.size(); ++i) {
    const model::HostState& bond = moment.bonds[i];
    if (!bond.guest) continue;
    const PointPlace& guest = guests[*bond.guest];
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

std::vector<Effect> EffectsOf(const Episode& episode) {
  std::vector<Effect> effects;
  // Container effects come last, since they leave out what bond effects state.
  AppendControlEffects(episode, &effects);
  AppendBondEffects(episode, &effects);
  AppendSlideEffects(episode, &effects);
  AppendContainerEffects(episode, &effects);
  AppendCutEffects(episode, &effects);
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
                               },
                               [](const CutEffect& cut) { return Ids{cut.object}; }},
                    effect);
}

std::vector<bool> AreAchieved(const std::vector<Effect>& effects, const Episode& episode,
                              const Counterpart& counterpart, double tolerance) {
  const Ending ending(episode, counterpart, tolerance);
  std::vector<bool> achieved;
  for (const Effect& effect : effects) {
    achieved.push_back(std::visit([&](const auto& wanted) { return ending.IsAs(wanted); }, effect));
  }
  return achieved;
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
          [](const CutEffect& cut) { return cut.where + " cut with " + cut.tool; }},
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
                               }},
                    effect);
}

}  // namespace smile::task
