#include "studio/session.h"

#include <cmath>
#include <utility>

#include "base/files.h"
#include "brain/brain_log.h"
#include "studio/internal_session.h"
#include "studio/scene_message.h"

namespace smile::studio {
namespace {

constexpr std::uint64_t kTicksPerState = 3;  // at most 20 states a second

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
    : options_(std::move(options)), library_(options_.recordings), eye_preview_(options_.eye) {
  if (options_.gallery.empty()) options_.gallery = DataFile("scenes");
  AddRequests();
  Enter(std::make_unique<LiveWorld>(scene_xml::LoadScene(options_.scene, options_.reader),
                                    options_.robot, DeskOptions()));
}

const library::View& Session::Impl::view() const {
  if (!view_) {
    view_ = state().view();
    view_->scene = announcer_.number();
  }
  return *view_;
}

bool Session::Impl::Tick() {
  ++num_calls_;
  view_.reset();
  brain_.Attend(&world_->simulation());
  const bool has_ticked = state().Tick(is_paused_);
  if (has_ticked && !playback_) EndStateIfOver();
  NoteFailure();
  TellConsole();
  if (const auto trouble = eye_preview_.Look(world_.get(), state())) {
    messages_.push_back({{"t", "error"}, {"error", *trouble}});
  }
  TellIfAny(announcer_.TellLooks(view().state.looks));
  TellStateIfDue();
  return has_ticked;
}

void Session::Impl::EndStateIfOver() {
  if (!world_state_->is_over()) return;
  if (auto score = world_state_->End(measured_speed_)) {
    score_ = *std::move(score);
    messages_.push_back(score_);
  }
  world_state_ = std::make_unique<LiveState>(world_.get(), &brain_);
}

void Session::Impl::NoteFailure() {
  if (auto failure = world_->TakeFailure()) {
    failure_ = *std::move(failure);
  } else if (world_->is_recording()) {
    failure_ = nullptr;
  }
}

void Session::Impl::TellIfAny(std::optional<Json> message) {
  if (message) messages_.push_back(*std::move(message));
}

void Session::Impl::TellConsole() {
  const std::vector<ConsoleLine> lines = brain_.TakeLines();
  if (!lines.empty() && world_->is_recording()) {
    brain::BrainLog log(world_->recording_directory());
    for (const ConsoleLine& line : lines) log.Write(line.text);
  }
  TellIfAny(console_.Tell(lines));
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
  Json state_message = {{"t", "state"}};
  state_message.update(state().Describe());
  state_message["mode"] = state().mode();
  state_message["allowed"] = DescribeAllowed();
  state_message["paused"] = is_paused_;
  state_message["speed"] = std::round(100 * measured_speed_) / 100;
  state_message["recording"] = world_->DescribeRecording();
  state_message["failure"] = failure_;
  state_message["playback"] = playback_ ? playback_->DescribePlayback() : Json();
  state_message["restoring"] = restoring_ ? Json(restoring_->recording()) : Json();
  state_message["brain"] = brain_.Describe();
  state_message["snap"] = NamesOf(snapper_.to);
  state_message["markers"] = Json::array();
  for (const Vector3& point : world_->markers()) {
    state_message["markers"].push_back(PointInUnits(point, unit));
  }
  return state_message;
}

/// What is shown is another scene from now on.
void Session::Impl::TellAllOfScene() {
  view_.reset();
  eye_preview_.Forget();
  told_state_ = nullptr;
  messages_.push_back(announcer_.Announce(state().model(), state().view().state.looks));
}

News Session::Impl::TakeNews() {
  // Hands and recordings do something also while time stands still.
  for (Json& event : world_->TakeEvents()) messages_.push_back(std::move(event));
  News news{.messages = std::exchange(messages_, {})};
  if (auto picture = eye_preview_.Take()) {
    news.view = std::move(picture->image);
    news.is_view_recorded = picture->is_recorded;
  }
  return news;
}

std::vector<Json> Session::Impl::Everything() const {
  eye_preview_.Forget();
  const std::vector<int>& looks = view().state.looks;
  std::vector<Json> all = {announcer_.Describe(state().model(), looks), LooksMessage(looks)};
  if (auto lines = console_.Everything()) all.push_back(*std::move(lines));
  if (!score_.is_null()) all.push_back(score_);
  all.push_back(DescribeState());
  return all;
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
