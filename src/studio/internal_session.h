#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "library/brain_choices.h"
#include "library/library.h"
#include "page/request_fields.h"
#include "studio/internal_console_news.h"
#include "studio/internal_eye_preview.h"
#include "studio/internal_restoring.h"
#include "studio/internal_scene_announcer.h"
#include "studio/internal_session_state.h"
#include "studio/live_brain.h"
#include "studio/live_world.h"
#include "studio/rehearsal.h"
#include "studio/resting_place.h"
#include "studio/session.h"
#include "studio/snapping.h"

namespace smile::studio {

class Session::Impl {
 public:
  explicit Impl(SessionOptions options);

  page::RequestTable& requests() { return requests_; }
  double speed_factor() const { return speed_factor_; }
  void SetMeasuredSpeed(double factor) { measured_speed_ = factor; }
  bool Tick();
  const library::View& view() const;
  News TakeNews();
  std::vector<Json> Everything() const;
  std::optional<std::string> MeshBytes(std::uint32_t scene, std::size_t mesh) const {
    return announcer_.MeshBytes(scene, mesh);
  }

 private:
  // What may be asked (session_requests.cc).

  using Needs = std::vector<Need>;
  using Handler = Json (Impl::*)(const page::RequestFields&);
  /// Further reasons to refuse a request, by its fields.
  using Refuser = std::optional<std::string> (Impl::*)(const page::RequestFields&);
  struct RequestRow {
    const char* what;
    Handler handle;
    Needs needs = {};
    bool is_for_anyone = false;
    Refuser refuse = nullptr;
  };
  static const std::vector<RequestRow>& RequestRows();
  void AddRequests();
  /// Why it is not met; nullopt if it is.
  std::optional<std::string> Unmet(Need need) const;
  std::optional<std::string> FirstUnmet(const Needs& needs) const;
  std::optional<std::string> RefusalOf(const RequestRow& row, const page::Request& request);
  /// Of a command, as far as the simulation has no part in it.
  std::optional<std::string> RefusalInSession(const sim::Command& command) const;
  /// As far as it does not depend on hands, objects and robot.
  std::optional<std::string> RefusalOf(const sim::Command& command) const;
  /// Of any request, without carrying it out.
  std::optional<std::string> RefusalOf(const Json& wanted);
  /// `allowed` of a state message.
  Json DescribeAllowed() const;

  Json Allowed(const page::RequestFields& fields);
  std::optional<std::string> RefuseStartBrain(const page::RequestFields& fields);
  std::optional<std::string> RefuseClear(const page::RequestFields& fields);
  Json Command(const page::RequestFields& fields);
  /// Through the one door. If the scene is another one then, or has more or fewer objects, pages
  /// are told it anew.
  /// @throws page::RequestError if it is refused.
  void Apply(const sim::Command& command);
  /// What a page's `command` means now, snapped unless it is to be exact.
  sim::Command MeantBy(const Json& wanted, bool is_exact);
  Json Pause(const page::RequestFields& fields);
  Json Resume(const page::RequestFields& fields);
  Json SetSpeed(const page::RequestFields& fields);
  Json SetSnap(const page::RequestFields& fields);
  Json AnswerRestingPlace(const page::RequestFields& fields);
  Json Load(const page::RequestFields& fields);
  Json Reload(const page::RequestFields& fields);
  Json Check(const page::RequestFields& fields);
  Json FindSupport(const page::RequestFields& fields);
  Json Show(const page::RequestFields& fields);
  Json Play(const page::RequestFields& fields);
  Json GoLive(const page::RequestFields& fields);
  Json Branch(const page::RequestFields& fields);

  // Robot programs (session_brains.cc).
  Json DescribeBrains(const page::RequestFields& fields);
  Json StartBrain(const page::RequestFields& fields);
  Json StopBrain(const page::RequestFields& fields);
  Json Imitate(const page::RequestFields& fields);
  library::BrainChoice FindBrain(const std::string& name) const;
  std::vector<library::BrainChoice> Brains() const;
  void RunBrain(const library::BrainChoice& choice, const std::filesystem::path& demonstration);
  /// Begins to record the imitation that starts now; its directory.
  std::filesystem::path RecordImitation(const recording::Recording& demonstration);

  // Scenes (session_scenes.cc).
  scene::SceneSpec ReadNamedScene(const std::string& name) const;
  scene_xml::SceneReading ReadText(const page::RequestFields& fields) const;
  scene::SceneSpec ReadSceneOf(const page::RequestFields& fields) const;
  recorder::RecordingDesk::Options DeskOptions() const;
  void Enter(std::unique_ptr<LiveWorld> world);
  /// The world is in another scene: what belonged to the one before ends, and pages are told.
  void BeginScene();
  /// @throws page::RequestError if it is refused.
  void LoadScene(scene::SceneSpec scene);
  Json Spawn(const page::RequestFields& fields);
  Json Clear(const page::RequestFields& fields);

  // States and news (session.cc).
  SessionState& state() { return playback_ ? *playback_ : *world_state_; }
  const SessionState& state() const { return playback_ ? *playback_ : *world_state_; }
  void EndStateIfOver();
  /// Of a recording that ended by itself.
  void NoteFailure();
  void TellAllOfScene();
  void TellIfAny(std::optional<Json> message);
  void TellStateIfDue();
  void TellConsole();
  Json DescribeState() const;

  SessionOptions options_;
  library::Library library_;
  std::unique_ptr<LiveWorld> world_;
  LiveBrain brain_;
  std::unique_ptr<SessionState> world_state_;  ///< of the world: live, imitating or rage
  std::unique_ptr<PlaybackState> playback_;    ///< over it; nullptr unless a recording is shown
  std::shared_ptr<Restoring> restoring_;       ///< nullptr unless it goes on; see Branch()
  Rehearsal rehearsal_;
  RestingPlace resting_place_;
  Snapper snapper_;
  bool is_paused_ = false;
  double speed_factor_ = 1, measured_speed_ = 1;

  page::RequestTable requests_;
  std::vector<Json> messages_;
  EyePreview eye_preview_;
  ConsoleNews console_;
  SceneAnnouncer announcer_;
  Json score_;                                 ///< the last one that was told; null before
  Json failure_;                               ///< `failure` of a state message
  Json told_state_;                            ///< without the time
  std::uint64_t num_calls_ = 0;                ///< of Tick()
  mutable std::optional<library::View> view_;  ///< nullopt when something may have moved since
};

}  // namespace smile::studio
