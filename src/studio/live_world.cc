#include "studio/live_world.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "base/diagnostic.h"
#include "editing/re_simulation.h"
#include "replay/log_player.h"
#include "scene/solid.h"
#include "studio/event_message.h"
#include "texts/user_message.h"

// A simulation with what the session needs around it: the recorder, the eye whose pictures people
// see, and messages about events. It listens to its simulation, so commands of brains and undo
// update it like those of pages.

namespace smile::studio {

using texts::Say;
namespace {

/// Limits the messages of one batch: a brain may be refused continuously.
constexpr std::size_t kMaxEvents = 200;

/// Rounds to tenths, so that displayed values change at most ten times a second.
double ToTenths(double seconds) { return std::round(10 * seconds) / 10; }

std::optional<CapturingEye> CapturingEyeOf(sim::Eye* eye) {
  return eye != nullptr ? std::optional<CapturingEye>(eye) : std::nullopt;
}

recorder::RecordingController::Options Through(CapturingEye* eye,
                                               recorder::RecordingController::Options options) {
  options.eye = eye;
  return options;
}

}  // namespace

LiveWorld::LiveWorld(scene::SceneSpec scene, std::optional<sim::RobotPlacement> robot,
                     recorder::RecordingController::Options options)
    : eye_(CapturingEyeOf(options.eye)),
      simulation_(std::move(scene), std::move(robot)),
      controller_(&simulation_, Through(eye(), options)),
      usual_title_(options.recording.title) {
  // Called for its exception: a scene without the camera is refused now, and not when a recording
  // begins.
  if (eye_) sim::EyeView(simulation_, eye_->spec());
  simulation_.AddListener(this);
  FollowModel();
}

void LiveWorld::FollowModel() {
  if (std::exchange(marked_, simulation_.start_model()) != simulation_.start_model()) {
    markers_.clear();
  }
  // Bounds depend only on shapes, so they are computed once per model.
  if (bounded_ == simulation_.shared_model()) return;
  bounded_ = simulation_.shared_model();
  bounds_.clear();
  solids_.clear();
  for (const scene::ObjectSpec& object : bounded_->scene().objects) {
    solids_.push_back(scene::SolidsOf(object.whole));
    bounds_.push_back(scene::BoundsOf(solids_.back(), RigidTransform()));
  }
}

std::optional<sim::Refusal> LiveWorld::Apply(const sim::Command& command) {
  // The sender of a command gets its refusal as the answer; OnEvent() must not report it again.
  is_applying_ = true;
  auto refusal = ApplyToOwn(command);
  is_applying_ = false;
  const auto* start = std::get_if<sim::StartRecording>(&command);
  if (start != nullptr && !refusal) {
    take_ = {.title = start->title.empty() ? usual_title_ : start->title,
             .before = simulation_.history().current().id,
             .start_tick = simulation_.tick()};
  }
  if (tracks_ && !is_recording()) EndTracks();
  return refusal;
}

void LiveWorld::EndTracks() {
  std::error_code error;
  // A recording that ended because its directory was removed has no place for them.
  if (std::filesystem::exists(recording_directory(), error)) {
    recording::WriteConflicts(recording_directory(), tracks_->conflicts());
  }
  tracks_.reset();
}

std::optional<sim::Refusal> LiveWorld::ApplyToOwn(const sim::Command& command) {
  const bool is_undo = std::holds_alternative<sim::Undo>(command);
  const bool is_redo = std::holds_alternative<sim::Redo>(command);
  if (is_undo && is_recording() && simulation_.history().current().id == take_.kept) {
    return Say("recorder.isCorrection");
  }
  const auto is_played = [this] {
    return tracks_ && tracks_->HasPlayed(simulation_.history().current().id);
  };
  bool has_returned = false;
  while (is_undo && is_played() && !simulation_.Apply(command)) has_returned = true;
  if (has_returned && simulation_.Refuse(command)) return std::nullopt;  // the user did nothing yet
  auto refusal = simulation_.Apply(command);
  while (is_redo && !refusal && is_played() && !simulation_.Apply(command)) {
  }
  return refusal;
}

void LiveWorld::Tick() {
  if (tracks_ && is_recording()) tracks_->ApplyDue(&simulation_);
  simulation_.Tick();
}

void LiveWorld::Continue(const recording::Recording& recording, const recording::HistoryPoint& from,
                         const recording::Progress& progress) {
  controller_.Continue(recording.directory, from, &simulation_, progress);
  TakeUp(recording, recording.info.title);
}

void LiveWorld::Correct(const recording::Recording& recording, double seconds,
                        const recording::Progress& progress) {
  controller_.Correct(recording, seconds, {}, &simulation_, progress);
  TakeUp(recording, recording::CorrectedTitleOf(recording));
  take_.corrects = Json{{"title", recording::TitleOf(recording)}, {"seconds", ToTenths(seconds)}};
  take_.kept = simulation_.history().current().id;
}

void LiveWorld::TakeUp(const recording::Recording& recording, const std::string& title) {
  // The recording began after that many actions of its history.
  const auto num_before =
      std::ranges::count_if(recording.log.PathTo(recording.info.start.line),
                            [](const auto& logged) { return sim::IsAction(logged.command); });
  take_ = {.title = title,
           .before = simulation_.history().done()[static_cast<std::size_t>(num_before)].id,
           .start_tick = recording.info.start.tick};
  // The events of the repeated path are news to no client.
  events_.clear();
}

void LiveWorld::RecordOver(const recording::Recording& recording, const editing::KeptTracks& kept,
                           const recording::Progress& progress) {
  const recording::Demonstration demonstration = recording::DemonstrationOf(recording);
  replay::LogPlayer past(demonstration.past, demonstration.start);
  editing::RunToStart(recording, &past, &simulation_);
  const std::string title = recording::TitleOf(recording) + " (over)";
  if (auto refusal = Apply(sim::StartRecording{.title = title})) {
    throw InputError({recording.directory.string(), 0, "", *refusal});
  }
  tracks_.emplace(demonstration, kept);
  try {
    RunToBegin(progress);
  } catch (...) {
    (void)Apply(sim::FinishRecording{});
    std::error_code ignored;
    std::filesystem::remove_all(recording_directory(), ignored);
    throw;
  }
  // The events so far are news to no client.
  events_.clear();
}

void LiveWorld::RunToBegin(const recording::Progress& progress) {
  const double total = sim::SecondsOf(tracks_->begin() - take_.start_tick);
  while (simulation_.tick() < tracks_->begin()) {
    Tick();
    if (!is_recording()) throw std::runtime_error(*controller_.failure());
    const double done = sim::SecondsOf(simulation_.tick() - take_.start_tick);
    if (progress && !progress(done, total)) throw std::runtime_error("it was canceled");
  }
}

std::filesystem::path LiveWorld::recording_directory() const {
  return controller_.directories().empty() ? std::filesystem::path()
                                           : controller_.directories().back();
}

Json LiveWorld::DescribeRecording() const {
  if (!is_recording()) return nullptr;
  return {{"id", recording_directory().filename().string()},
          {"title", take_.title},
          {"seconds", ToTenths(sim::SecondsOf(simulation_.tick() - take_.start_tick))},
          {"segments", DescribeSegments()},
          {"over", tracks_ ? tracks_->Describe() : Json()},
          {"corrects", take_.corrects}};
}

Json LiveWorld::DescribeSegments() const {
  Json segments = Json::array();
  const auto actions = simulation_.history().done();
  std::uint64_t begin = take_.start_tick;
  for (std::size_t i = 0; i < actions.size(); ++i) {
    // Ids increase, so this skips what was done before the recording.
    if (actions[i].id < take_.before) continue;
    const bool is_last = i + 1 == actions.size();
    const std::uint64_t end = is_last ? simulation_.tick() : actions[i + 1].tick;
    // The first segment is the rest of an action that began before the recording; it has no
    // summary.
    segments.push_back({{"number", segments.size()},
                        {"deed", segments.empty() ? Json() : sim::ToJson(actions[i].summary)},
                        {"seconds", ToTenths(sim::SecondsOf(end - begin))}});
    begin = end;
  }
  return segments;
}

std::optional<Json> LiveWorld::TakeFailure() {
  // A failure ends the recording within a tick or a command; here it is noticed once.
  const bool has_ended = std::exchange(was_recording_, is_recording()) && !is_recording();
  if (!has_ended || !controller_.failure()) return std::nullopt;
  const std::filesystem::path directory = recording_directory();
  std::error_code error;
  return Json{{"recording", directory.filename().string()},
              {"title", take_.title},
              {"error", *controller_.failure()},
              {"kept", std::filesystem::exists(directory / "demo.json", error)}};
}

void LiveWorld::OnMove(const sim::Simulation& simulation, sim::ActionId, sim::ActionId) {
  FollowModel();
  if (tracks_) tracks_->Follow(simulation);
}

void LiveWorld::OnCommand(const sim::Simulation&, const sim::Command& command) {
  FollowModel();
  if (const auto* marks = std::get_if<sim::Markers>(&command)) markers_ = marks->points_in_world;
}

void LiveWorld::OnEvent(const sim::Simulation& simulation, const sim::Event& event) {
  if (event.kind == sim::EventKind::kCommandRefused) {
    // The sender has its answer. A repeated refusal of a brain is reported once.
    if (is_applying_ || event.reason == last_refusal_) return;
    last_refusal_ = event.reason;
  }
  if (events_.size() < kMaxEvents) {
    events_.push_back(EventMessage(event, simulation.tick(), simulation.model()));
  }
}

}  // namespace smile::studio
