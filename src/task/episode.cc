#include "task/episode.h"

#include <algorithm>
#include <set>

#include "model/relations.h"
#include "recording/commanded_events.h"
#include "recording/trace_reader.h"
#include "scene/bounds.h"
#include "scene/solid.h"

namespace smile::task {
namespace {

/// Smallest change of pose that counts as a move. An object released nearer to where it was grasped
/// has not been placed.
constexpr recording::PoseGap kStayed{.distance = 0.01, .angle = DegreesToRadians(5.0)};

/// True for events that change who holds or fastens an object, and for falls and presses.
bool IsContact(sim::EventKind kind) {
  using enum sim::EventKind;
  return kind == kGrasped || kind == kReleased || kind == kFastened || kind == kLoosened ||
         kind == kFell || kind == kGripperHolds || kind == kGripperReleased || kind == kUsed ||
         kind == kTriggered || kind == kPressed || kind == kDestroyed;
}

/// Returns the ids of the objects beneath or around an object at a moment.
std::vector<std::string> SupportsOf(const std::string& id, const recording::TraceTick& now,
                                    const scene::SceneSpec& scene) {
  constexpr double kNear = 0.01;  // [m]
  const auto bounds_of = [](const scene::ObjectSpec& object) {
    return scene::BoundsOf(scene::SolidsOf(object.whole), object.pose_in_world());
  };
  std::vector<scene::ObjectSpec> near = ObjectsAt(scene, now);
  const auto object = std::ranges::find(near, id, &scene::ObjectSpec::id);
  if (object == near.end()) return {};
  // Only what is near it can be a support: relations of all pairs would take long.
  const scene::Bounds bounds = bounds_of(*object);
  std::erase_if(near, [&](const auto& other) { return !bounds_of(other).Meets(bounds, kNear); });
  std::vector<std::string> supports;
  for (const model::Relation& relation : model::RelationsOf(scene, near)) {
    if (relation.object == id && !relation.support.empty()) supports.push_back(relation.support);
  }
  return supports;
}

/// Returns the contact of an event with the object's pose at `now`; nullopt for other events and
/// for objects that are not in the scene.
std::optional<ContactEvent> ContactOf(const sim::Event& event, const recording::TraceTick& now,
                                      const scene::SceneSpec& scene) {
  if (!IsContact(event.kind)) return std::nullopt;
  const auto object = std::ranges::find(scene.objects, event.object, &scene::ObjectSpec::id);
  if (object == scene.objects.end()) return std::nullopt;
  const auto index = static_cast<std::size_t>(object - scene.objects.begin());
  ContactEvent contact{event, now.tick, now.objects[index].pose_in_world()};
  if (event.kind == sim::EventKind::kGrasped || event.kind == sim::EventKind::kGripperHolds) {
    contact.supports = SupportsOf(event.object, now, scene);
  }
  return contact;
}

/// Actions from the log of an old recording, whose trace contains no events.
class LoggedActions {
 public:
  explicit LoggedActions(const recording::Recording& recording) : commands_(recording.commands) {}

  /// Returns the events up to this tick that were not returned before.
  std::vector<sim::Event> UpTo(std::uint64_t tick) {
    std::vector<sim::Event> events;
    for (; next_ < commands_.size() && commands_[next_].tick <= tick; ++next_) {
      if (auto event = commanded_.Next(commands_[next_].command)) events.push_back(*event);
    }
    return events;
  }

 private:
  const std::vector<recording::LoggedCommand>& commands_;
  std::size_t next_ = 0;
  recording::CommandedEvents commanded_;
};

/// Returns a key for the hand or gripper of an event; hands and arms of equal name stay distinct.
std::string HolderOf(const sim::Event& event) {
  return event.hand ? "hand " + std::string(ToString(*event.hand)) : "arm " + event.arm;
}

recording::TracePose TracePoseOf(const RigidTransform& X_WB) {
  const Quaternion q = X_WB.quaternion();
  return {.position = X_WB.translation(), .rotation = {q.w(), q.x(), q.y(), q.z()}};
}

/// Replays touches: the pose at which each holder took each object, and the objects that were
/// placed, the latest last.
class PlacementOrder {
 public:
  void Note(const ContactEvent& contact) {
    using enum sim::EventKind;
    const std::string& object = contact.event.object;
    switch (contact.event.kind) {
      case kGrasped:
      case kGripperHolds:
        holds_[{HolderOf(contact.event), object}] = contact.X_WB;
        return;
      // A release places the object only if the holder has moved it.
      case kReleased:
      case kGripperReleased: {
        const auto hold = holds_.find({HolderOf(contact.event), object});
        if (hold == holds_.end()) return;
        if (HasMoved(hold->second, contact.X_WB)) Put(object);
        holds_.erase(hold);
        return;
      }
      // A hand turns a fastening in place: that places the guest although nothing was grasped.
      // Physics can loosen a bond too; such an event has no hand and places nothing.
      case kFastened:
      case kLoosened:
        if (contact.event.hand) Put(object);
        return;
      default:
        return;
    }
  }

  // An object that is still held and has moved since has left its last place.
  std::vector<std::string> InTheEnd(const ObjectPoses& end) && {
    for (const auto& [who, X_WB] : holds_) {
      if (HasMoved(X_WB, end.at(who.second))) std::erase(order_, who.second);
    }
    return std::move(order_);
  }

 private:
  /// Appends the object; a later placement replaces an earlier one.
  void Put(const std::string& object) {
    std::erase(order_, object);
    order_.push_back(object);
  }

  std::map<std::pair<std::string, std::string>, RigidTransform> holds_;  ///< by holder and object
  std::vector<std::string> order_;
};

}  // namespace

Episode EpisodeOf(const recording::Recording& recording) {
  recording::TraceReader trace(recording);
  // The scene at the end of the path has all objects that were ever present on it; objects not yet
  // added are absent.
  Episode episode{.scene = recording.scene(), .begin = {}, .end = {}, .contacts = {}};
  LoggedActions logged(recording);
  const auto note = [&episode](const std::vector<sim::Event>& events) {
    for (const sim::Event& event : events) {
      if (auto contact = ContactOf(event, episode.end, episode.scene)) {
        episode.contacts.push_back(*std::move(contact));
      }
    }
  };
  bool has_begun = false;
  while (const auto moment = trace.Next()) {
    episode.end = *moment;
    // Holds and falls from before the start still matter: they precede the touches of the first
    // tick.
    if (!has_begun) {
      episode.begin = *moment;
      note(trace.events_before_start());
      has_begun = true;
    }
    note(trace.has_events() ? moment->events : logged.UpTo(moment->tick));
  }
  // A trace without a single whole record: the recording was interrupted at once.
  if (!has_begun) episode.begin = episode.end = recording::StartOf(*recording.model);
  return episode;
}

EpisodeObserver::EpisodeObserver(sim::Simulation* simulation)
    : simulation_(simulation), begin_(recording::Observe(*simulation)) {
  simulation_->AddListener(this);
}

EpisodeObserver::~EpisodeObserver() { simulation_->RemoveListener(this); }

void EpisodeObserver::OnEvent(const sim::Simulation& simulation, const sim::Event& event) {
  if (!IsContact(event.kind)) return;
  auto contact = ContactOf(event, recording::Observe(simulation), simulation.scene());
  if (!contact) return;
  const sim::Action& action = simulation.history().current();
  // Contacts belong to the current action, so an undo removes them together with the action.
  contacts_[action.id].push_back({*std::move(contact), action.events.size()});
}

void EpisodeObserver::OnMove(const sim::Simulation& simulation, sim::ActionId from,
                             sim::ActionId to) {
  std::vector<NumberedContact>* contacts = contacts_.Find(from);
  if (to < from || contacts == nullptr) return;
  // A redo leads to an action that began before the undo: touches recorded in `from` since then are
  // not in its past and are removed. The number of events that the history keeps for `from`
  // identifies them.
  const auto done = simulation.history().done();
  const std::size_t num_events = done[done.size() - 2].events.size();
  std::erase_if(*contacts, [&](const NumberedContact& one) { return one.num_events > num_events; });
}

Episode EpisodeObserver::episode() const {
  // Objects that were added since the begin are absent in its state.
  Episode episode{.scene = simulation_->scene(),
                  .begin = recording::WithAbsent(begin_, simulation_->model()),
                  .end = recording::Observe(*simulation_),
                  .contacts = {}};
  for (const sim::Action& action : simulation_->history().done()) {
    const std::vector<NumberedContact>* contacts = contacts_.Find(action.id);
    if (contacts == nullptr) continue;
    for (const NumberedContact& one : *contacts) episode.contacts.push_back(one.contact);
  }
  return episode;
}

void EpisodeObserver::Continue(std::vector<ContactEvent> contacts) {
  contacts_ = {};
  std::vector<NumberedContact>& before = contacts_[simulation_->history().current().id];
  for (ContactEvent& contact : contacts) before.push_back({.contact = std::move(contact)});
}

Episode AtBegin(const Episode& episode) {
  return {.scene = episode.scene, .begin = episode.begin, .end = episode.begin, .contacts = {}};
}

bool HasMoved(const RigidTransform& from, const RigidTransform& to) {
  return GapBetween(TracePoseOf(from), TracePoseOf(to)).IsBeyond(kStayed);
}

std::vector<scene::ObjectSpec> ObjectsAt(const scene::SceneSpec& scene,
                                         const recording::TraceTick& moment) {
  std::vector<scene::ObjectSpec> objects;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    if (!moment.objects[i].is_present) continue;
    objects.push_back(scene.objects[i]);
    objects.back().whole.X_PE = moment.objects[i].pose_in_world();
  }
  return objects;
}

ObjectPoses PosesAt(const scene::SceneSpec& scene, const recording::TraceTick& moment) {
  ObjectPoses poses = StartOf(scene);
  for (const scene::ObjectSpec& object : ObjectsAt(scene, moment)) {
    poses[object.id()] = object.pose_in_world();
  }
  return poses;
}

ObjectPoses StartOf(const scene::SceneSpec& scene) {
  ObjectPoses poses;
  for (const scene::ObjectSpec& object : scene.objects) {
    poses[object.id()] = object.pose_in_world();
  }
  return poses;
}

std::vector<std::string> TouchedByHands(const Episode& episode) {
  std::vector<std::string> touched;
  for (const ContactEvent& contact : episode.contacts) {
    const bool counts = contact.event.kind == sim::EventKind::kGrasped ||
                        contact.event.kind == sim::EventKind::kFastened ||
                        contact.event.kind == sim::EventKind::kLoosened;
    if (!counts || !contact.event.hand) continue;
    if (std::ranges::find(touched, contact.event.object) == touched.end()) {
      touched.push_back(contact.event.object);
    }
  }
  return touched;
}

std::vector<std::string> FallenObjects(const Episode& episode) {
  std::vector<std::string> fallen;
  for (const ContactEvent& contact : episode.contacts) {
    // Events of the first tick report objects that lay on the floor before.
    if (contact.event.kind != sim::EventKind::kFell || contact.tick == episode.begin.tick) continue;
    if (std::ranges::find(fallen, contact.event.object) == fallen.end()) {
      fallen.push_back(contact.event.object);
    }
  }
  return fallen;
}

std::set<std::string> HeldInTheEnd(const Episode& episode) {
  std::set<std::pair<std::string, std::string>> holds;  // holder and object
  for (const ContactEvent& contact : episode.contacts) {
    const std::pair hold(HolderOf(contact.event), contact.event.object);
    switch (contact.event.kind) {
      case sim::EventKind::kGrasped:
      case sim::EventKind::kGripperHolds:
        holds.insert(hold);
        break;
      case sim::EventKind::kReleased:
      case sim::EventKind::kDestroyed:
      case sim::EventKind::kGripperReleased:
        holds.erase(hold);
        break;
      default:
        break;
    }
  }
  std::set<std::string> held;
  for (const auto& [holder, object] : holds) held.insert(object);
  return held;
}

Work WorkOf(const Episode& episode) {
  Work work;
  std::map<std::string, int> holders;  // of what was ever held: by how many grippers now
  for (const ContactEvent& contact : episode.contacts) {
    const std::string& object = contact.event.object;
    if (contact.event.kind == sim::EventKind::kGripperHolds) {
      ++work.grasps;
      // A retry is a grasp of an object that was held before and is held by no gripper now.
      const auto held = holders.find(object);
      if (held != holders.end() && held->second == 0) ++work.retries;
      ++holders[object];
    } else if (contact.event.kind == sim::EventKind::kGripperReleased) {
      holders[object] = std::max(0, holders[object] - 1);
    }
  }
  return work;
}

std::vector<std::string> PlacementsOf(const Episode& episode) {
  PlacementOrder order;
  for (const ContactEvent& contact : episode.contacts) order.Note(contact);
  return std::move(order).InTheEnd(PosesAt(episode.scene, episode.end));
}

}  // namespace smile::task
