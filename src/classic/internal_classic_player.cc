// Follows the lines of a checked recording and keeps the state that a trace needs. The texts
// contain no physics: poses jump from line to line, and controls and bonds have the states that
// were written.

#include "classic/internal_classic_player.h"

#include <utility>

#include "base/diagnostic.h"
#include "base/wording.h"
#include "math/angles.h"
#include "scene/controls_of.h"
#include "scene/units.h"

namespace smile::classic {

ClassicPlayer::ClassicPlayer(const ClassicRecording& recording, const model::Model& model,
                             std::map<std::string, std::size_t> objects, bool has_scene)
    : recording_(recording),
      model_(model),
      objects_(std::move(objects)),
      has_scene_(has_scene),
      last_frame_(recording.last_frame()) {
  now_.moment = recording::StartOf(model);
  // Objects appear with their first move.
  for (recording::TracePose& object : now_.moment.objects) object = {.is_present = false};
}

std::optional<ClassicFrame> ClassicPlayer::Next() {
  if (frame_ > last_frame_) return std::nullopt;
  // State carries over from frame to frame, events do not.
  now_.holds.clear();
  now_.events.clear();
  // Applies all lines up to this frame; a frame without lines repeats the state before.
  while (segment_ < recording_.segments.size()) {
    const auto& lines = recording_.segments[segment_].lines;
    if (line_ == lines.size()) {
      ++segment_;
      line_ = 0;
      continue;
    }
    // A picture may be later than all lines; such frames repeat the last state.
    if (lines[line_].frame > frame_) break;
    std::visit([this](const auto& what) { Follow(what); }, lines[line_].what);
    ++line_;
  }
  ++frame_;
  return now_;
}

void ClassicPlayer::Fail(const std::string& message) const {
  const ClassicFile& segment = recording_.segments[segment_];
  throw InputError({segment.file, segment.lines[line_].number, "", message});
}

const std::string& ClassicPlayer::NameOf(const std::string& object) const {
  return model_.id(model::ObjectIndex(objects_.at(object)));
}

void ClassicPlayer::Follow(const ClassicCreate&) {}  // It becomes present with its first move.

void ClassicPlayer::Follow(const ClassicDelete& gone) {
  const model::ObjectIndex object(objects_.at(gone.object));
  // A second create and move may bring it back.
  now_.moment.objects[object] = {.is_present = false};
  // Bonds of a deleted object end on either side.
  for (model::HostIndex host : model_.hosts()) {
    const auto guest = now_.moment.bonds[host].guest;
    if (!guest) continue;
    const bool is_its = model_.host(host).object == object || model_.guest(*guest).object == object;
    if (is_its) SetBond(host, {.is_locked = now_.moment.bonds[host].is_locked});
  }
}

void ClassicPlayer::Follow(const ClassicMove& move) {
  const RigidTransform X_WB(RotationFromFixedAxes(move.angles_deg),
                            scene::FromFileUnits(move.position, model_.scene().meters_per_unit));
  now_.moment.objects[objects_.at(move.object)] =
      // The texts do not contain which objects are awake.
      recording::TracePose::At(X_WB, /*is_awake=*/false);
}

model::ControlIndex ClassicPlayer::FindControl(const std::string& id) const {
  const auto control = model_.FindControl(id);
  if (!control) Fail("the scene has no control " + Quoted(id));
  return *control;
}

void ClassicPlayer::SetControl(model::ControlIndex index, const std::string& recorded) {
  const model::Control& control = model_.control(index);
  model::ControlState& state = now_.moment.controls[index];
  state.override_state = -1;  // the recorded state is the visible one
  // Depends on the present state: a switch that leaves a position and returns to it has advanced.
  const auto next = WithRecordedState(control, state, recorded);
  if (!next) Fail("found state " + Quoted(recorded) + ", which " + control.id() + " does not have");
  state = *next;
}

void ClassicPlayer::Follow(const ClassicControl& control) {
  // Placeholder objects have no controls.
  if (!has_scene_) return;
  const model::ControlIndex index = FindControl(control.control);
  const scene::Part& part = *model_.control(index).part;
  // For custom controls, the original writes names of its own.
  if (!std::holds_alternative<scene::CustomControl>(part.shape) &&
      control.kind != scene::KindOf(part)) {
    Fail(Quoted(control.control) + " is recorded as " + Quoted(control.kind) +
         ", in the scene it is " + Quoted(scene::KindOf(part)));
  }
  SetControl(index, control.state);
}

void ClassicPlayer::Follow(const ClassicControlChange& change) {
  if (has_scene_) SetControl(FindControl(change.control), change.state);
  now_.events.push_back({.kind = sim::EventKind::kControlChanged,
                         .object = NameOf(change.object),
                         .control = change.control,
                         .state = change.state});
}

void ClassicPlayer::Follow(const ClassicAction& action) {
  sim::Event event{.kind = action.kind,
                   .hand = action.hand,
                   .part = action.part,
                   .control = action.control,
                   .tightness = action.tightness,
                   .properties = action.properties};
  if (!action.object.empty()) event.object = NameOf(action.object);
  // Pointing at an object as a whole names it twice; both follow the id of the scene.
  if (action.part == action.object) event.part = event.object;
  if (action.kind == sim::EventKind::kUsed) {
    event.by = event.object;
    event.state = action.verb;
  }
  if (!action.host.empty()) {
    // An event without host and guest would not be a valid bond event, so it appears in the texts
    // only.
    if (!has_scene_) return;
    FollowBond(action, &event);
  }
  // A grasp in segment 0 is a hold from before the start.
  const bool is_hold = segment_ == 0 && action.kind == sim::EventKind::kGrasped;
  (is_hold ? now_.holds : now_.events).push_back(std::move(event));
}

void ClassicPlayer::Follow(const ClassicEffect& effect) {
  sim::Event event{.kind = effect.kind,
                   .arm = effect.arm,
                   .part = effect.part,
                   .control = effect.control,
                   .state = effect.verb};
  if (!effect.by.empty()) event.by = NameOf(effect.by);
  // Which object a tool worked on is in words only, so the event has the tool, as that of a hand.
  event.object = effect.object.empty() ? event.by : NameOf(effect.object);
  now_.events.push_back(std::move(event));
}

void ClassicPlayer::FollowBond(const ClassicAction& action, sim::Event* event) {
  const auto host = model_.FindHost(action.host);
  if (!host) Fail("the scene has no host point " + Quoted(action.host));
  const auto guest = model_.FindGuest(action.guest);
  if (!guest) Fail("the scene has no guest point " + Quoted(action.guest));
  const std::size_t num_stages = model_.host(*host).point->stages.size();
  if (static_cast<std::size_t>(action.tightness) > num_stages) {
    Fail("found tightness " + std::to_string(action.tightness) + ", expected at most " +
         std::to_string(num_stages) + " of " + Quoted(action.host));
  }
  event->host = *host;
  event->guest = *guest;
  model::HostState bond{.is_locked = now_.moment.bonds[*host].is_locked};
  if (action.tightness > 0) {
    bond.guest = event->guest;
    bond.tightness = action.tightness;
  }
  SetBond(*host, bond);
}

void ClassicPlayer::SetBond(model::HostIndex host, const model::HostState& bond) {
  now_.moment.bonds[host] = bond;
  const model::Host& about = model_.host(host);
  // The stage of a bond may lock or unlock another host point.
  if (!about.downstream_lock) return;
  now_.moment.bonds[*about.downstream_lock].is_locked = LocksDownstreamAt(about, bond.tightness);
}

}  // namespace smile::classic
