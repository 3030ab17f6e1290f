#include "task/effects.h"

#include <algorithm>
#include <cmath>

#include "base/overloaded.h"
#include "model/relations.h"
#include "scene/bond_points.h"
#include "scene/controls_of.h"
#include "task/object_error.h"
#include "task/symmetry.h"

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

/// True if a control of an object was pressed or triggered, by a hand or by contact.
bool WasPressed(const Episode& episode, const std::string& object, const std::string& control) {
  return std::ranges::any_of(episode.contacts, [&](const ContactEvent& contact) {
    const bool is_press = contact.event.kind == sim::EventKind::kTriggered ||
                          contact.event.kind == sim::EventKind::kPressed;
    return is_press && contact.event.object == object && contact.event.control == control;
  });
}

/// Returns the ids of the controls that a control drives.
std::vector<std::string> DrivenBy(const std::string& control, const scene::SceneSpec& scene) {
  for (const scene::ObjectSpec& object : scene.objects) {
    for (const scene::Part* part : scene::ControlsOf(object.whole)) {
      if (part->id != control) continue;
      return std::visit(
          [](const auto& shape) -> std::vector<std::string> {
            if constexpr (requires { shape.downstream; }) return shape.downstream;
            return {};
          },
          part->shape);
    }
  }
  return {};
}

/// True if a control that is driven by another one is left in another state: that tells of the
/// press.
bool HasDriven(const ControlEffect& control, const Episode& episode,
               const std::vector<Effect>& effects) {
  const std::vector<std::string> driven = DrivenBy(control.control, episode.scene);
  return std::ranges::any_of(effects, [&](const Effect& effect) {
    const auto* change = std::get_if<ControlEffect>(&effect);
    return change != nullptr && std::ranges::find(driven, change->control) != driven.end();
  });
}

/// Appends the controls that were pressed to no lasting effect: they are in the same state again,
/// and so is what they drive. AppendControlEffects() appends the others.
void AppendPressedEffects(const Episode& episode, std::vector<Effect>* effects) {
  const std::vector<ControlEffect> before = ControlsAt(episode.scene, episode.begin);
  const std::vector<ControlEffect> after = ControlsAt(episode.scene, episode.end);
  for (std::size_t i = 0; i < before.size(); ++i) {
    const ControlEffect& control = before[i];
    if (control.from != after[i].from || !IsThere(episode.scene, episode.end, control.object) ||
        !WasPressed(episode, control.object, control.control) ||
        HasDriven(control, episode, *effects)) {
      continue;
    }
    effects->push_back(
        PressedEffect{control.object, control.number, control.control, control.from});
  }
}

/// True if the object is on the table or above it, and not on the floor.
bool IsAboveFloor(const scene::SceneSpec& scene, const recording::TraceTick& moment,
                  const std::string& object) {
  // The table top is at z = 0.
  return IsThere(scene, moment, object) && PosesAt(scene, moment).at(object).translation().z() >= 0;
}

/// Appends the rotations of the objects that hands took. Mechanisms and bonds have effects of their
/// own.
void AppendOrientedEffects(const Episode& episode, std::vector<Effect>* effects) {
  const ObjectPoses begin = PosesAt(episode.scene, episode.begin);
  const ObjectPoses end = PosesAt(episode.scene, episode.end);
  std::vector<std::string> joined;
  for (const auto* moment : {&episode.begin, &episode.end}) {
    for (const BondEffect& bond : BondsAt(episode.scene, *moment)) {
      joined.push_back(bond.guest_object);
    }
  }
  for (const std::string& id : TouchedByHands(episode)) {
    const scene::ObjectSpec& object =
        *std::ranges::find(episode.scene.objects, id, &scene::ObjectSpec::id);
    if (!IsThere(episode.scene, episode.begin, id) ||
        !IsAboveFloor(episode.scene, episode.end, id) ||
        std::ranges::find(joined, id) != joined.end()) {
      continue;
    }
    const Symmetry symmetry = SymmetryOf(object);
    const Matrix3 from = begin.at(id).rotation(), to = end.at(id).rotation();
    const double tilt = symmetry.TiltBetween(from, to);
    const Vector3 shift = end.at(id).translation() - begin.at(id).translation();
    const bool is_tilt = tilt > kAngleTolerance;
    const double angle = is_tilt ? tilt : symmetry.AngleBetween(from, to);
    // What was carried elsewhere may be turned about the vertical on the way; that is no goal of
    // its own, as the pose of the object tells it.
    const bool is_in_place = shift.head<2>().norm() <= kTolerance;
    if (is_tilt || (is_in_place && angle > kAngleTolerance)) {
      effects->push_back(OrientedEffect{id, angle, is_tilt});
    }
  }
}

/// True if a hand released the object last beyond the edge of the table.
bool WasDropped(const Episode& episode, const std::string& object) {
  bool is_beyond = false;
  for (const ContactEvent& contact : episode.contacts) {
    if (contact.event.object != object || contact.event.kind != sim::EventKind::kReleased) continue;
    const Vector3 p = contact.X_WB.translation();
    is_beyond = std::abs(p.x()) > episode.scene.table.x_span / 2 ||
                std::abs(p.y()) > episode.scene.table.y_span / 2;
  }
  return is_beyond;
}

/// Appends the objects that hands destroyed or dropped from the table. What fell by accident is no
/// goal.
void AppendDestroyedEffects(const Episode& episode, std::vector<Effect>* effects) {
  const std::vector<std::string> fallen = FallenObjects(episode);
  for (const scene::ObjectSpec& object : episode.scene.objects) {
    const std::string& id = object.id();
    if (!IsThere(episode.scene, episode.begin, id)) continue;
    const bool was_destroyed =
        std::ranges::any_of(episode.contacts, [&](const ContactEvent& contact) {
          return contact.event.kind == sim::EventKind::kDestroyed && contact.event.object == id;
        });
    const bool has_fallen = std::ranges::find(fallen, id) != fallen.end();
    if (was_destroyed || (has_fallen && WasDropped(episode, id))) {
      effects->push_back(DestroyedEffect{id});
    }
  }
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

  bool IsAs(const PressedEffect& wanted) const {
    return std::ranges::any_of(controls_, [&](const ControlEffect& control) {
      return control.object == counterpart_(wanted.object) && control.number == wanted.number &&
             control.from == wanted.state && WasPressed(episode_, control.object, control.control);
    });
  }

  bool IsAs(const OrientedEffect&) const { return true; }

  bool IsAs(const DestroyedEffect& wanted) const {
    return IsRemoved(episode_, counterpart_(wanted.object));
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

bool IsRemoved(const Episode& episode, const std::string& object) {
  return !IsAboveFloor(episode.scene, episode.end, object) &&
         !HeldInTheEnd(episode).contains(object);
}

std::vector<Effect> EffectsOf(const Episode& episode) {
  std::vector<Effect> effects;
  // Container effects come last, since they leave out what bond effects state.
  AppendControlEffects(episode, &effects);
  AppendBondEffects(episode, &effects);
  AppendSlideEffects(episode, &effects);
  AppendContainerEffects(episode, &effects);
  AppendCutEffects(episode, &effects);
  AppendPressedEffects(episode, &effects);
  AppendOrientedEffects(episode, &effects);
  AppendDestroyedEffects(episode, &effects);
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
                               [](const CutEffect& cut) { return Ids{cut.object}; },
                               [](const PressedEffect& pressed) { return Ids{pressed.object}; },
                               [](const OrientedEffect& oriented) { return Ids{oriented.object}; },
                               [](const DestroyedEffect& gone) { return Ids{gone.object}; }},
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

}  // namespace smile::task
