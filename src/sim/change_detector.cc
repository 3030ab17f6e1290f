// Only state that a command may change is captured before it: capturing all of it would be too
// expensive for frequent commands.

#include "sim/change_detector.h"

#include <algorithm>

#include "base/overloaded.h"
#include "sim/action_summary.h"

namespace smile::sim {
namespace {

template <class... Kinds>
bool IsOneOf(const Command& command) {
  return (std::holds_alternative<Kinds>(command) || ...);
}

/// Returns true for commands that fasten or loosen.
bool TurnsBonds(const Command& command) { return IsOneOf<Fasten, Loosen>(command); }

/// Returns the name of the arm that a link belongs to; `robot` for other links.
std::string ArmOfLink(const robot::RobotModel& robot, int link) {
  for (const robot::Arm& arm : robot.arms) {
    const auto& gripper = arm.gripper;
    const bool is_finger =
        gripper && (link == gripper->left_finger || link == gripper->right_finger);
    if (is_finger || std::ranges::find(arm.joints, link) != arm.joints.end()) return arm.name;
  }
  return "robot";
}

}  // namespace

ChangeDetector::ChangeDetector(const RunningModel* running)
    : running_(*running), held_by_grippers_(running->HeldByGrippers()) {
  const world::Tabletop& tabletop = running->tabletop();
  // In a tick, they change only by contact and by tools.
  if (tabletop.has_pressable_controls() || tabletop.has_tools()) {
    mechanisms_.controls = tabletop.controls().states();
  }
  if (tabletop.has_tools()) mechanisms_.bonds = tabletop.bonds().states();
}

ChangeDetector::ChangeDetector(const RunningModel* running, const Command& command)
    : ChangeDetector(running) {
  const world::Tabletop& tabletop = running_.tabletop();
  // After a release or a destruction, the hand no longer knows the object.
  if (const auto hand = HandOf(command)) {
    const world::Object* held = tabletop.Find(running_.demonstrator().hand(*hand).held);
    if (held != nullptr) held_by_hand_ = held->id();
  }
  if (TurnsBonds(command) || IsOneOf<Trigger, Use, Destroy, Remove, Clear>(command)) {
    mechanisms_ = tabletop.state();
  }
  if (!IsOneOf<Spawn, Remove, Clear>(command)) return;
  for (const world::Object& object : tabletop.objects()) {
    were_present_.push_back(tabletop.IsPresent(object));
  }
}

std::vector<Event> ChangeDetector::EventsOf(const Command& command) const {
  std::vector<Event> events;
  // The order is part of recordings: cause first, then its consequences.
  AppendOwn(command, &events);
  AppendBonds(TurnsBonds(command) ? HandOf(command) : std::nullopt, &events);
  AppendControls(&events);
  AppendGrippers(&events);
  return events;
}

std::vector<Event> ChangeDetector::EventsOfTick(const TickReport& report) const {
  std::vector<Event> events;
  AppendGrippers(&events);
  for (const world::Press& press : report.presses) AppendPress(press, &events);
  for (const world::ToolUse& use : report.uses) events.push_back(EventOf(use));
  if (!report.uses.empty()) AppendBonds(/*hand=*/std::nullopt, &events);
  if (!report.presses.empty() || !report.uses.empty()) AppendControls(&events);
  return events;
}

Event ChangeDetector::EventOf(const world::ToolUse& use) const {
  const model::Model& model = *running_.model();
  return {.kind = EventKind::kUsed,
          .arm = use.arm >= 0 ? model.robot()->arms[use.arm].name : "",
          .object = model.id(use.object),
          .part = use.target,
          .state = use.verb,
          .by = model.id(model.tool(use.tool).object)};
}

void ChangeDetector::AppendPress(const world::Press& press, std::vector<Event>* events) const {
  const model::Model& model = *running_.model();
  const model::Control& control = model.control(press.control);
  Event event{
      .kind = EventKind::kPressed, .object = model.id(control.object), .control = control.id()};
  if (press.by_link >= 0) event.arm = ArmOfLink(*model.robot(), press.by_link);
  if (const world::Object* by = running_.tabletop().Find(press.by)) event.by = by->id();
  events->push_back(std::move(event));
}

std::vector<std::string> ChangeDetector::ChangedObjects() const {
  const world::Tabletop& tabletop = running_.tabletop();
  std::vector<std::string> changed;
  for (const world::Object& object : tabletop.objects()) {
    // Objects that a command added have no entry before it.
    const bool was_present = object.index < were_present_.size() && were_present_[object.index];
    if (was_present != tabletop.IsPresent(object)) changed.push_back(object.id());
  }
  return changed;
}

void ChangeDetector::AppendOwn(const Command& command, std::vector<Event>* events) const {
  const world::Tabletop& tabletop = running_.tabletop();
  // At most one event per command; commands without one of their own report nothing here.
  const auto event = std::visit(
      Overloaded{
          [](const Grasp& grasp) -> std::optional<Event> {
            return Event{.kind = EventKind::kGrasped, .hand = grasp.hand, .object = grasp.object};
          },
          [&](const Release& release) -> std::optional<Event> {
            return Event{
                .kind = EventKind::kReleased, .hand = release.hand, .object = held_by_hand_};
          },
          [&](const Destroy& destroy) -> std::optional<Event> {
            return Event{
                .kind = EventKind::kDestroyed, .hand = destroy.hand, .object = held_by_hand_};
          },
          [&](const Attend& attend) -> std::optional<Event> {
            // The hand still holds it, as the command succeeded.
            const world::Object& object = *tabletop.Find(held_by_hand_);
            return Event{.kind = EventKind::kAttended,
                         .hand = attend.hand,
                         .object = object.id(),
                         .properties = running_.demonstrator().PropertiesThatMatter(object)};
          },
          [&](const Point& point) -> std::optional<Event> {
            return Event{.kind = EventKind::kPointed,
                         .hand = point.hand,
                         .object = tabletop.FindPointable(point.part)->id(),
                         .part = point.part};
          },
          [&](const Trigger& trigger) -> std::optional<Event> {
            const model::Model& model = *running_.model();
            const auto control = model.FindControl(trigger.control);
            return Event{.kind = EventKind::kTriggered,
                         .hand = trigger.hand,
                         .object = model.id(model.control(*control).object),
                         .control = trigger.control};
          },
          [&](const Use& use) -> std::optional<Event> {
            Event used = EventOf(running_.last_use());
            used.hand = use.hand;
            return used;
          },
          [&](const Spawn&) -> std::optional<Event> {
            return Event{.kind = EventKind::kAdded, .objects = ChangedObjects()};
          },
          [&](const Remove&) -> std::optional<Event> {
            return Event{.kind = EventKind::kRemoved, .objects = ChangedObjects()};
          },
          [&](const Displace& displace) -> std::optional<Event> {
            return Event{.kind = EventKind::kDisplaced, .objects = displace.objects};
          },
          [&](const Clear&) -> std::optional<Event> {
            return Event{.kind = EventKind::kCleared, .objects = ChangedObjects()};
          },
          [](const auto&) -> std::optional<Event> { return std::nullopt; }},
      command);
  if (event) events->push_back(*event);
}

void ChangeDetector::AppendBonds(const std::optional<HandName>& hand,
                                 std::vector<Event>* events) const {
  const auto& before = mechanisms_.bonds;
  const model::Model& model = *running_.model();
  // Over the hosts before the command: `before` is empty unless the command may change bonds.
  for (model::HostIndex host : IndexRange<model::HostIndex>(before.size())) {
    const world::BondState& was = before[host];
    const world::BondState& is = running_.tabletop().bonds().states()[host];
    if (was.tightness == is.tightness) continue;
    // A host that became free had its guest before.
    const model::GuestIndex guest = is.guest ? *is.guest : *was.guest;
    events->push_back(
        {.kind = is.tightness > was.tightness ? EventKind::kFastened : EventKind::kLoosened,
         .hand = hand,
         .object = model.id(model.guest(guest).object),
         .guest = guest,
         .host = host,
         .tightness = is.tightness});
  }
}

void ChangeDetector::AppendControls(std::vector<Event>* events) const {
  const auto& before = mechanisms_.controls;
  const world::Tabletop& tabletop = running_.tabletop();
  const model::Model& model = *running_.model();
  for (model::ControlIndex i : IndexRange<model::ControlIndex>(before.size())) {
    const model::ControlState& now = tabletop.controls().states()[i];
    if (before[i] == now || !tabletop.IsPresent(i)) continue;
    const model::Control& control = model.control(i);
    const std::string state = RecordedState(control, now);
    // Recordings write visible states: hidden changes, such as those below an override, are no
    // events.
    if (state == RecordedState(control, before[i])) continue;
    events->push_back({.kind = EventKind::kControlChanged,
                       .object = model.id(control.object),
                       .control = control.id(),
                       .state = state});
  }
}

void ChangeDetector::AppendGrippers(std::vector<Event>* events) const {
  const auto now = running_.HeldByGrippers();
  // The usual case, in every tick.
  if (now == held_by_grippers_) return;
  for (std::size_t arm = 0; arm < now.size(); ++arm) {
    // Differences of two short lists: a gripper holds few bodies.
    const auto append_missing = [&](const auto& from, const auto& in, EventKind kind) {
      for (physics::BodyId body : from) {
        if (std::find(in.begin(), in.end(), body) != in.end()) continue;
        events->push_back({.kind = kind,
                           .arm = running_.robot()->body().model().arms[arm].name,
                           .object = running_.tabletop().Find(body)->id()});
      }
    };
    // Releases are reported before grasps.
    append_missing(held_by_grippers_[arm], now[arm], EventKind::kGripperReleased);
    append_missing(now[arm], held_by_grippers_[arm], EventKind::kGripperHolds);
  }
}

}  // namespace smile::sim
