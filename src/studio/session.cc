#include "studio/session.h"

#include <cmath>
#include <utility>

#include "base/files.h"
#include "brain/brain_log.h"
#include "experiment/brain_setup.h"
#include "recording/sight.h"
#include "studio/internal_session.h"
#include "studio/scene_message.h"
#include "studio/state_message.h"

namespace smile::studio {
namespace {

constexpr std::uint64_t kTicksPerState = 3;     // at most 20 states a second
constexpr std::uint64_t kTicksPerPicture = 15;  // 4 a second, as classic recordings have them
/// So much of what was printed do those see who come later.
constexpr std::size_t kMaxConsoleLines = 200;

/// A state message without what goes on while nothing happens: time alone is no news, but that a
/// recording is a second longer.
Json WithoutTime(Json state) {
  state.erase("tick");
  Json& recording = state["recording"];
  if (!recording.is_object()) return state;
  recording["seconds"] = std::floor(recording["seconds"].get<double>());
  recording["segments"].back().erase("seconds");
  return state;
}

}  // namespace

Session::Impl::Impl(SessionOptions options)
    : options_(std::move(options)),
      library_(options_.recordings),
      loaded_(scene_xml::LoadScene(options_.scene, options_.reader)) {
  if (options_.gallery.empty()) options_.gallery = DataFile("scenes");
  AddRequests();
  Enter(MakeWorld(loaded_, options_.robot));
}

const sim::Simulation& Session::Impl::shown() const {
  return rage_ ? rage_->simulation() : world_->simulation();
}

const library::View& Session::Impl::view() const {
  if (view_) return *view_;
  if (playback_) {
    view_ = playback_->view();
    view_->meters_per_unit = playback_->recording().info.meters_per_unit;
  } else {
    view_ = library::View{.model = &shown().model().visual_model(),
                          .state = shown().visual_state(),
                          .tick = shown().tick(),
                          .meters_per_unit = shown().scene().meters_per_unit};
  }
  view_->scene = scene_number_;
  return *view_;
}

bool Session::Impl::Tick() {
  ++num_calls_;
  view_.reset();
  brain_.Attend(&world_->simulation());
  bool has_ticked = true;
  if (playback_) {
    playback_->Tick();
  } else if (!is_paused_) {
    has_ticked = TickLive();
  }
  NoteFailure();
  TellConsole();
  LookThroughEye();
  TellLooks();
  TellStateIfDue();
  return has_ticked;
}

void Session::Impl::NoteFailure() {
  if (auto failure = world_->TakeFailure()) {
    failure_ = *std::move(failure);
  } else if (world_->is_recording()) {
    failure_ = nullptr;
  }
}

bool Session::Impl::TickLive() {
  if (rage_) {
    rage_->Tick();
    if (rage_->is_over()) rage_.reset();
    return true;
  }
  if (!brain_.Drive(&world_->simulation())) return false;
  world_->simulation().Tick();
  if (!imitation_) return true;
  const double seconds = sim::SecondsOf(world_->simulation().tick() - imitation_->start_tick);
  if (seconds >= experiment::kMaxImitationSeconds) brain_.Stop(&world_->simulation());
  if (!brain_.is_running()) EndImitation();
  return true;
}

void Session::Impl::EndImitation() {
  if (!imitation_) return;
  const Imitation ended = *std::move(imitation_);
  imitation_.reset();
  const bool is_recorded =
      world_->is_recording() && world_->recording_directory() == ended.recording;
  if (is_recorded) (void)world_->Apply(sim::FinishRecording{});
  Json result =
      task::ResultOf(ended.exercise, ended.witness->course(),
                     {.seconds = sim::SecondsOf(world_->simulation().tick() - ended.start_tick),
                      .realtime_factor = measured_speed_,
                      .brain = brain_.Describe()});
  score_ = {{"t", "score"}, {"result", std::move(result)}};
  messages_.push_back(score_);
}

void Session::Impl::TellConsole() {
  const std::vector<ConsoleLine> lines = brain_.TakeLines();
  if (lines.empty()) return;
  Json told = Json::array();
  std::optional<brain::BrainLog> log;
  if (world_->is_recording()) log.emplace(world_->recording_directory());
  for (const ConsoleLine& line : lines) {
    Json one = {{"text", line.text}};
    if (!line.file.empty()) one.update({{"file", line.file}, {"line", line.line}});
    told.push_back(one);
    console_.push_back(std::move(one));
    if (log) log->Write(line.text);
  }
  while (console_.size() > kMaxConsoleLines) console_.pop_front();
  messages_.push_back({{"t", "console"}, {"lines", std::move(told)}});
}

void Session::Impl::LookThroughEye() {
  if (options_.eye == nullptr || is_eye_broken_) return;
  if (auto recorded = world_->eye()->Take()) {
    picture_ = std::move(recorded);
    is_picture_recorded_ = true;
    seen_ = sim::SightOf(world_->simulation(), options_.eye->spec());
    return;
  }
  if (num_calls_ % kTicksPerPicture != 0) return;
  sim::Sight sight = SightNow();
  if (seen_ == sight) return;
  try {
    picture_ = options_.eye->Draw(*view().model, sight);
  } catch (const std::runtime_error& error) {
    is_eye_broken_ = true;
    messages_.push_back({{"t", "error"}, {"error", error.what()}});
    return;
  }
  is_picture_recorded_ = false;
  seen_ = std::move(sight);
}

/// A recording is seen with the eye it was made with, where that can be.
sim::Sight Session::Impl::SightNow() const {
  sim::EyeSpec spec = options_.eye->spec();
  if (!playback_) return sim::SightOf(shown(), spec);
  spec.camera = playback_->recording().info.eye_camera;
  return recording::SightAt(playback_->moment(), playback_->model(), spec);
}

void Session::Impl::TellLooks() {
  if (view().state.looks == told_looks_) return;
  told_looks_ = view().state.looks;
  messages_.push_back({{"t", "looks"}, {"looks", told_looks_}});
}

void Session::Impl::TellStateIfDue() {
  if (num_calls_ % kTicksPerState != 0) return;
  Json state = DescribeState();
  Json what_counts = WithoutTime(state);
  if (what_counts == told_state_) return;
  told_state_ = std::move(what_counts);
  messages_.push_back(std::move(state));
}

Json Session::Impl::DescribeState() const {
  const double unit = world_->simulation().scene().meters_per_unit;
  Json state = {{"t", "state"}};
  state.update(playback_ ? DescribeNothingLive(view().tick) : DescribeLive(shown()));
  state["mode"] = playback_ ? "playback" : rage_ ? "rage" : "live";
  state["paused"] = is_paused_;
  state["speed"] = std::round(100 * measured_speed_) / 100;
  state["recording"] = world_->DescribeRecording();
  if (world_->is_recording()) {
    // What was before its start cannot be undone in it.
    if (state["recording"]["segments"].size() < 2) state["undo"] = false;
  }
  state["failure"] = failure_;
  state["playback"] = nullptr;
  if (playback_) {
    state["playback"] = {{"recording", playback_->id()},
                         {"seconds", std::round(1000 * playback_->seconds()) / 1000},
                         {"length", playback_->length()},
                         {"rate", playback_->rate()}};
  }
  state["brain"] = brain_.Describe();
  state["snap"] = NamesOf(snapper_.to);
  state["markers"] = Json::array();
  for (const Vector3& point : world_->markers()) {
    state["markers"].push_back(PointInUnits(point, unit));
  }
  return state;
}

Json Session::Impl::DescribeScene() const {
  const model::Model& model = playback_ ? playback_->model() : world_->simulation().model();
  return SceneMessage(scene_number_, model, *present_meshes_, view().state.looks);
}

/// What is shown is another scene from now on.
void Session::Impl::TellAllOfScene() {
  ++scene_number_;
  view_.reset();
  seen_.reset();
  present_meshes_ = meshes_.Add(scene_number_, *view().model);
  told_looks_ = view().state.looks;
  told_state_ = nullptr;
  messages_.push_back(DescribeScene());
}

News Session::Impl::TakeNews() {
  // Hands and recordings do something also while time stands still.
  for (Json& event : world_->TakeEvents()) messages_.push_back(std::move(event));
  News news{.messages = std::exchange(messages_, {}),
            .view = std::exchange(picture_, std::nullopt),
            .is_view_recorded = is_picture_recorded_};
  return news;
}

std::vector<Json> Session::Impl::Everything() const {
  seen_.reset();
  std::vector<Json> all = {DescribeScene(), {{"t", "looks"}, {"looks", view().state.looks}}};
  if (!console_.empty()) {
    all.push_back({{"t", "console"},
                   {"all", true},
                   {"lines", Json(Json::array_t(console_.begin(), console_.end()))}});
  }
  if (!score_.is_null()) all.push_back(score_);
  all.push_back(DescribeState());
  return all;
}

std::optional<std::string> Session::Impl::MeshBytes(std::uint32_t scene, std::size_t mesh) const {
  const auto meshes = meshes_.Find(scene);
  return meshes ? meshes->Bytes(mesh) : std::nullopt;
}

Session::Session(SessionOptions options) : impl_(std::make_unique<Impl>(std::move(options))) {}
Session::~Session() = default;
page::RequestTable& Session::requests() { return impl_->requests(); }
const page::RequestTable& Session::requests() const { return impl_->requests(); }
double Session::speed_factor() const { return impl_->speed_factor(); }
void Session::SetMeasuredSpeed(double factor) { impl_->SetMeasuredSpeed(factor); }
bool Session::Tick() { return impl_->Tick(); }
library::View Session::view() const { return impl_->view(); }
News Session::TakeNews() { return impl_->TakeNews(); }
std::vector<Json> Session::Everything() const { return impl_->Everything(); }
std::optional<std::string> Session::MeshBytes(std::uint32_t scene, std::size_t mesh) const {
  return impl_->MeshBytes(scene, mesh);
}

}  // namespace smile::studio
