#include "studio/session.h"

#include <cmath>
#include <functional>
#include <utility>

#include "base/files.h"
#include "brain/brain_log.h"
#include "library/library.h"
#include "model/chosen_eye.h"
#include "page/scene_message.h"
#include "studio/internal_brain_requests.h"
#include "studio/internal_console_updates.h"
#include "studio/internal_eye_preview.h"
#include "studio/internal_playback_requests.h"
#include "studio/internal_scene_announcer.h"
#include "studio/internal_scene_requests.h"
#include "studio/internal_scene_source.h"
#include "studio/internal_session_requests.h"
#include "studio/internal_state_announcer.h"
#include "studio/internal_state_machine.h"
#include "studio/internal_world_requests.h"
#include "texts/user_message.h"

namespace smile::studio {

using texts::Say;
namespace {

constexpr std::uint64_t kTicksPerState = 3;  // at most 20 states a second

/// @param eye  records in place of that of the options; nullptr: nothing does.
SessionOptions WithDefaults(SessionOptions options, sim::Eye* eye) {
  options.eye = eye;
  if (options.scene_folder.empty()) options.scene_folder = DataFile("scenes");
  return options;
}

/// Binds a member function to its object, which may be constructed later.
template <class Requests, class Member>
auto Bound(Requests* requests, Member member) {
  return
      [requests, member](const page::RequestFields& fields) { return (requests->*member)(fields); };
}

}  // namespace

/// Connects the parts: states, requests, and the updates of both. Every change is collected in
/// messages_, which TakeUpdates() returns in order.
class Session::Impl : private StateMachine::Listener {
 public:
  explicit Impl(SessionOptions options);

  SessionRequests& requests() { return requests_; }
  Pace& pace() { return states_.pace(); }
  bool Tick();
  const library::DisplayedState& view() const;
  SessionUpdates TakeUpdates();
  std::vector<Json> Everything() const;
  std::optional<std::string> MeshBytes(std::uint32_t scene, std::size_t mesh) const {
    return scene_announcer_.MeshBytes(scene, mesh);
  }

 private:
  /// Returns the table of all requests with their needs.
  std::vector<RequestRow> RequestRows();

  void OnOtherWorld() override { world_requests_.Reset(); }
  void OnOtherScene() override;
  void OnScore(Json score) override;
  /// Updates `failure` after a recording ended by an error.
  void NoteFailure();
  void SendConsole();
  void SendIfAny(std::optional<Json> message);
  Json DescribeState() const;

  /// Returns the cameras whose pictures can be recorded.
  std::vector<std::string_view> EyeCameras() const;
  std::optional<texts::UserMessage> RefuseEye(const page::RequestFields& fields) const;
  Json ChooseEye(const page::RequestFields& fields);

  std::optional<model::ChosenEye> eye_;  ///< nullopt for no pictures
  const SessionOptions options_;
  library::Library library_;
  SceneSource scene_source_;
  StateMachine states_;
  SceneRequests scene_requests_;
  WorldRequests world_requests_;
  PlaybackRequests playback_requests_;
  BrainRequests brain_requests_;
  SessionRequests requests_;

  std::vector<Json> messages_;
  SceneAnnouncer scene_announcer_;
  StateAnnouncer state_announcer_;
  EyePreview eye_preview_;
  ConsoleUpdates console_;
  Json score_;    ///< last score that was sent; null before
  Json failure_;  ///< `failure` of a state message
  mutable std::optional<library::DisplayedState>
      view_;  ///< nullopt if something may have moved since
};

Session::Impl::Impl(SessionOptions options)
    : eye_(options.eye != nullptr ? std::optional<model::ChosenEye>(options.eye) : std::nullopt),
      options_(WithDefaults(std::move(options), eye_ ? &*eye_ : nullptr)),
      library_(options_.recordings),
      scene_source_(options_.scene_folder, options_.reader),
      states_(options_.robot.has_value(), this),
      scene_requests_(&scene_source_, &states_),
      world_requests_(&states_),
      playback_requests_(&options_, &library_, &states_),
      brain_requests_(&options_, &library_, &scene_source_, &scene_requests_, &states_),
      // A request may change the view, which is cached per tick.
      requests_(&states_, RequestRows(), [this] { view_.reset(); }),
      eye_preview_(options_.eye) {
  // Last, as entering a world calls the listener, which needs all members.
  states_.Enter(std::make_unique<LiveWorld>(scene_xml::LoadScene(options_.scene, options_.reader),
                                            options_.robot, RecordingOptionsOf(options_)));
}

std::vector<RequestRow> Session::Impl::RequestRows() {
  // One row per request. The same rows refuse a request that arrives, answer `allowed`, and enable
  // or disable the page's buttons by the state message, so these cannot differ. `start_brain` needs
  // another world only if it has a scene, which is why RefuseStart() decides that itself.
  SceneRequests* scenes = &scene_requests_;
  WorldRequests* world = &world_requests_;
  PlaybackRequests* playback = &playback_requests_;
  BrainRequests* brains = &brain_requests_;
  return {
      {"allowed", Bound(&requests_, &SessionRequests::Allowed)},
      {.what = "command",
       .handle = Bound(world, &WorldRequests::Command),
       .needs = {Need::kCommands},
       .try_out = Bound(world, &WorldRequests::TryCommand)},
      {"pause", Bound(world, &WorldRequests::Pause), {Need::kTime}},
      {"resume", Bound(world, &WorldRequests::Resume), {Need::kTime}},
      {"speed", Bound(world, &WorldRequests::SetSpeed)},
      {"snap", Bound(world, &WorldRequests::SetSnap)},
      {"support", Bound(world, &WorldRequests::FindSupport), {Need::kCommands}},
      {"resting_place", Bound(world, &WorldRequests::AnswerRestingPlace), {Need::kCommands}},
      {"spawn", Bound(world, &WorldRequests::Spawn), {Need::kCommands}},
      {.what = "clear",
       .handle = Bound(world, &WorldRequests::Clear),
       .needs = {Need::kCommands},
       .refuse = Bound(world, &WorldRequests::RefuseClear)},
      {"load", Bound(scenes, &SceneRequests::Load), {Need::kOtherWorld}},
      {"reload", Bound(scenes, &SceneRequests::Reload), {Need::kOtherWorld}},
      {.what = "eye",
       .handle = Bound(this, &Impl::ChooseEye),
       .needs = {Need::kNewRecording, Need::kNoProgram},
       .refuse = Bound(this, &Impl::RefuseEye)},
      {"check", Bound(scenes, &SceneRequests::Check), {}, /*is_for_anyone=*/true},
      {"show", Bound(playback, &PlaybackRequests::Show), {Need::kShow}},
      {"play", Bound(playback, &PlaybackRequests::Play), {Need::kPlayback}},
      {"live", Bound(playback, &PlaybackRequests::GoLive), {Need::kPlayback}},
      {"branch", Bound(playback, &PlaybackRequests::Branch), {Need::kOtherWorld}},
      {"record_over", Bound(playback, &PlaybackRequests::RecordOver), {Need::kOtherWorld}},
      {"correct", Bound(playback, &PlaybackRequests::Correct), {Need::kOtherWorld}},
      {"brains", Bound(brains, &BrainRequests::Describe), {}, /*is_for_anyone=*/true},
      {.what = "start_brain",
       .handle = Bound(brains, &BrainRequests::Start),
       .needs = {Need::kRobot, Need::kNoProgram},
       .refuse = Bound(brains, &BrainRequests::RefuseStart)},
      {"stop_brain", Bound(brains, &BrainRequests::Stop), {Need::kProgram}},
      {"imitate",
       Bound(brains, &BrainRequests::Imitate),
       {Need::kOtherWorld, Need::kRobot, Need::kNoProgram}},
  };
}

std::vector<std::string_view> Session::Impl::EyeCameras() const {
  if (!eye_) return {};
  if (!options_.robot) return {model::kEyeCamera};
  return {model::kEyeCamera, model::kHeadCamera};
}

std::optional<texts::UserMessage> Session::Impl::RefuseEye(const page::RequestFields&) const {
  if (!eye_) return Say("eye.isMissing");
  if (states_.world().is_recording()) return Say("recorder.finishFirst");
  return std::nullopt;
}

Json Session::Impl::ChooseEye(const page::RequestFields& fields) {
  const std::vector<std::string_view> cameras = EyeCameras();
  eye_->Choose(fields.Word("camera", cameras));
  eye_preview_.Reset();
  return Json::object();
}

const library::DisplayedState& Session::Impl::view() const {
  // Made at most once per tick and request: the pose stream, new clients and variants all use it.
  if (!view_) {
    view_ = states_.shown().view();
    view_->scene = scene_announcer_.number();
  }
  return *view_;
}

bool Session::Impl::Tick() {
  view_.reset();
  const bool has_ticked = states_.Tick();
  NoteFailure();
  SendConsole();
  // The preview comes after the tick, so that it shows its result.
  if (const auto trouble = eye_preview_.Update(&states_.world(), states_.shown())) {
    messages_.push_back({{"t", "error"}, {"error", *trouble}});
  }
  SendIfAny(scene_announcer_.UpdateVariants(view().state.variants));
  // State messages are limited in rate; they are sent only if something other than time has
  // changed.
  if (states_.num_ticks() % kTicksPerState == 0)
    SendIfAny(state_announcer_.Update(DescribeState()));
  return has_ticked;
}

void Session::Impl::OnOtherScene() {
  view_.reset();
  eye_preview_.Reset();
  state_announcer_.Reset();
  // Pages need the scene before its poses and state; the announcer counts it.
  const SessionState& shown = states_.shown();
  // The complete state follows with the next state message, as the announcer has forgotten the last
  // one.
  messages_.push_back(scene_announcer_.Announce(shown.model(), shown.view().state.variants));
}

void Session::Impl::OnScore(Json score) {
  score_ = std::move(score);
  messages_.push_back(score_);
}

void Session::Impl::NoteFailure() {
  LiveWorld& world = states_.world();
  if (auto failure = world.TakeFailure()) {
    failure_ = *std::move(failure);
    // A new recording clears the failure of the one before.
  } else if (world.is_recording()) {
    failure_ = nullptr;
  }
}

void Session::Impl::SendConsole() {
  const std::vector<ConsoleLine> lines = states_.brain().TakeLines();
  // The output of a program during a recording belongs to it.
  if (!lines.empty() && states_.world().is_recording()) {
    // Opened for each batch of lines, since the recording may end between two of them.
    brain::BrainLog log(states_.world().recording_directory());
    for (const ConsoleLine& line : lines) log.Write(line.text);
  }
  SendIfAny(console_.Add(lines));
}

void Session::Impl::SendIfAny(std::optional<Json> message) {
  if (message) messages_.push_back(*std::move(message));
}

Json Session::Impl::DescribeState() const {
  const LiveWorld& world = states_.world();
  const PlaybackState* playback = states_.playback();
  const Restoring* restoring = states_.restoring();
  const double unit = world.simulation().scene().meters_per_unit;
  // The part that depends on the state comes from that state; the rest is the same for all states.
  Json state_message = {{"t", "state"}};
  state_message.update(states_.shown().Describe());
  state_message["mode"] = states_.shown().mode();
  state_message["allowed"] = {{"requests", page::AllowedRequests(requests_.table())},
                              {"commands", world_requests_.DescribeAllowedCommands()}};
  state_message["paused"] = states_.pace().is_paused;
  state_message["speed"] = std::round(100 * states_.pace().measured_speed) / 100;
  state_message["recording"] = world.DescribeRecording();
  state_message["failure"] = failure_;
  state_message["playback"] = playback != nullptr ? playback->DescribePlayback() : Json();
  state_message["restoring"] = restoring != nullptr ? Json(restoring->recording()) : Json();
  state_message["brain"] = states_.brain().Describe();
  state_message["snap"] = world_requests_.snap();
  state_message["eye"] =
      eye_ ? Json{{"camera", eye_->spec().camera}, {"cameras", EyeCameras()}} : Json();
  // Markers are points for people; in playback they remain those of the live world.
  state_message["markers"] = Json::array();
  for (const Vector3& point : world.markers()) {
    state_message["markers"].push_back(page::PointInUnits(point, unit));
  }
  return state_message;
}

SessionUpdates Session::Impl::TakeUpdates() {
  // Events occur also while time is paused: hands act and recordings start.
  for (Json& event : states_.world().TakeEvents()) messages_.push_back(std::move(event));
  SessionUpdates updates{.messages = std::exchange(messages_, {})};
  if (auto picture = eye_preview_.Take()) {
    updates.view = std::move(picture->image);
    updates.is_view_recorded = picture->is_recorded;
  }
  return updates;
}

std::vector<Json> Session::Impl::Everything() const {
  // A new client needs a picture even if the view does not change.
  eye_preview_.Reset();
  const std::vector<int>& variants = view().state.variants;
  // In the order in which a page can use them: the scene before its variants, and the state last.
  std::vector<Json> all = {scene_announcer_.Describe(states_.shown().model(), variants),
                           LooksMessage(variants)};
  if (auto lines = console_.Everything()) all.push_back(*std::move(lines));
  if (!score_.is_null()) all.push_back(score_);
  all.push_back(DescribeState());
  return all;
}

Session::Session(SessionOptions options) : impl_(std::make_unique<Impl>(std::move(options))) {}
Session::~Session() = default;
page::RequestTable& Session::requests() { return impl_->requests().table(); }
const page::RequestTable& Session::requests() const { return impl_->requests().table(); }
double Session::speed_factor() const { return impl_->pace().speed_factor; }
void Session::SetMeasuredSpeed(double factor) { impl_->pace().measured_speed = factor; }
bool Session::Tick() { return impl_->Tick(); }
library::DisplayedState Session::view() const { return impl_->view(); }
SessionUpdates Session::TakeUpdates() { return impl_->TakeUpdates(); }
std::vector<Json> Session::Everything() const { return impl_->Everything(); }
std::optional<std::string> Session::MeshBytes(std::uint32_t scene, std::size_t mesh) const {
  return impl_->MeshBytes(scene, mesh);
}

}  // namespace smile::studio
