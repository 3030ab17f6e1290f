#include "studio/internal_session_state.h"

#include <cmath>
#include <utility>

#include "experiment/brain_setup.h"
#include "recording/view_sample.h"
#include "sim/eye.h"
#include "studio/state_message.h"
#include "texts/user_message.h"

namespace smile::studio {

using texts::Say;
namespace {

/// Returns what pages draw of a simulation.
library::DisplayedState ViewOf(const sim::Simulation& simulation) {
  return {.model = &simulation.model().visual_model(),
          .state = simulation.visual_state(),
          .tick = simulation.tick(),
          .meters_per_unit = simulation.scene().meters_per_unit};
}

}  // namespace

std::optional<texts::UserMessage> WorldState::Unmet(Need need) const {
  const bool is_bound = need == Need::kOtherWorld || need == Need::kShow;
  if (!is_bound || !world_->is_recording()) return std::nullopt;
  return Say("recorder.finishFirst");
}

library::DisplayedState LiveState::view() const { return ViewOf(world().simulation()); }

model::ViewSample LiveState::ViewSampleThrough(model::EyeSpec eye) const {
  return sim::ViewSampleOf(world().simulation(), eye);
}

Json LiveState::Describe() const { return DescribeLive(world().simulation()); }

bool LiveState::Tick(bool is_paused) {
  if (is_paused) return true;
  // A program that thinks stops the simulated time, so that its speed does not influence the
  // result.
  if (!brain_->Drive(&world().simulation())) return false;
  world().Tick();
  return true;
}

ImitatingState::ImitatingState(task::ImitationTask imitation_task, LiveWorld* world,
                               LiveBrain* brain)
    : LiveState(world, brain),
      task_(std::move(imitation_task)),
      observer_(&world->simulation()),
      recording_(world->recording_directory()),
      start_tick_(world->simulation().tick()) {}

bool ImitatingState::is_over() const {
  if (!end_) return !brain().is_running();
  // A program that failed has not finished the task, so nothing needs to stand.
  return end_->brain["status"] != "exited" ||
         sim::SecondsOf(world().simulation().tick() - end_->tick) >= task::kRestSeconds;
}

bool ImitatingState::Tick(bool is_paused) {
  if (!LiveState::Tick(is_paused)) return false;
  if (!brain().is_running() && !end_) end_ = {world().simulation().tick(), brain().Describe()};
  // The time of watching the demonstration does not count.
  const double limit = experiment::kMaxImitationSeconds + sim::SecondsOf(brain().watched_ticks());
  const double seconds = sim::SecondsOf(world().simulation().tick() - start_tick_);
  if (seconds >= limit) brain().Stop(&world().simulation());
  return true;
}

std::optional<Json> ImitatingState::End(double measured_speed) {
  // The user may have finished the recording already, and even started another one.
  // A recording that was finished by hand is complete up to that moment and stays as it is.
  const bool is_recorded = world().is_recording() && world().recording_directory() == recording_;
  if (is_recorded) (void)world().Apply(sim::FinishRecording{});
  const double watched = sim::SecondsOf(brain().watched_ticks());
  const std::uint64_t end_tick = end_ ? end_->tick : world().simulation().tick();
  // The same result as that of `smile imitate`: the time of watching is listed separately, and the
  // achieved speed shows whether the machine kept up.
  Json result = task::ResultOf(task_, observer_.episode(),
                               {.seconds = sim::SecondsOf(end_tick - start_tick_) - watched,
                                .watched_seconds = watched,
                                .realtime_factor = measured_speed,
                                .brain = end_ ? end_->brain : brain().Describe()});
  return Json{{"t", "score"}, {"result", std::move(result)}};
}

std::optional<texts::UserMessage> ClearTableState::Unmet(Need need) const {
  // Commands would change the world behind the copy that is shown, and be invisible.
  const bool must_wait = need == Need::kCommands || need == Need::kShow;
  if (!must_wait) return WorldState::Unmet(need);
  return Say("session.isClearing");
}

library::DisplayedState ClearTableState::view() const { return ViewOf(animation_.simulation()); }

model::ViewSample ClearTableState::ViewSampleThrough(model::EyeSpec eye) const {
  return sim::ViewSampleOf(animation_.simulation(), eye);
}

Json ClearTableState::Describe() const { return DescribeLive(animation_.simulation()); }

bool ClearTableState::Tick(bool is_paused) {
  if (!is_paused) animation_.Tick();
  return true;
}

Json PlaybackState::DescribePlayback() const {
  // Rounded to milliseconds.
  return {{"recording", playback_.id()},
          {"seconds", std::round(1000 * playback_.seconds()) / 1000},
          {"length", playback_.length()},
          {"rate", playback_.rate()}};
}

std::optional<texts::UserMessage> PlaybackState::Unmet(Need need) const {
  // The world is hidden and waits; replacing it is allowed, and ends the playback.
  const bool is_of_world = need == Need::kCommands || need == Need::kTime;
  if (!is_of_world) return std::nullopt;
  return Say("session.isPlayback");
}

library::DisplayedState PlaybackState::view() const {
  library::DisplayedState view = playback_.view();
  view.meters_per_unit = playback_.recording().info.meters_per_unit;
  return view;
}

model::ViewSample PlaybackState::ViewSampleThrough(model::EyeSpec eye) const {
  // A recording is shown through the camera with which it was made.
  eye.camera = playback_.recording().info.eye_camera;
  return recording::ViewSampleAt(playback_.moment(), playback_.model(), eye);
}

Json PlaybackState::Describe() const { return DescribeShown(playback_); }

// `pause` is about the live world; playback has a rate of its own.
bool PlaybackState::Tick(bool /*is_paused*/) {
  playback_.Tick();
  return true;
}

}  // namespace smile::studio
