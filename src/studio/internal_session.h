#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "library/library.h"
#include "library/playback.h"
#include "page/request_fields.h"
#include "studio/live_brain.h"
#include "studio/live_world.h"
#include "studio/rage.h"
#include "studio/resting_place.h"
#include "studio/scene_meshes.h"
#include "studio/session.h"
#include "studio/snapping.h"
#include "task/imitation_result.h"

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
  std::optional<std::string> MeshBytes(std::uint32_t scene, std::size_t mesh) const;

 private:
  /// An imitation that is watched live.
  struct Imitation {
    task::Exercise exercise;
    std::unique_ptr<task::CourseWitness> witness;
    std::filesystem::path recording;  ///< its directory
    std::uint64_t start_tick = 0;
  };

  // What may be asked (session_requests.cc).
  void AddRequests();
  void AddWorldRequests();
  void AddSceneRequests();
  void AddRecordingRequests();
  void AddBrainRequests();
  Json Command(const page::Request& request);
  /// What a page's `command` means now, snapped unless it is to be exact.
  sim::Command MeantBy(const Json& wanted, bool is_exact);
  Json Load(const page::RequestFields& fields);
  Json Check(const page::RequestFields& fields) const;
  Json Spawn(const page::RequestFields& fields);
  Json Clear(const page::RequestFields& fields);
  Json FindSupport(const page::RequestFields& fields);
  Json FindRestingPlace(const page::RequestFields& fields);
  Json Show(const page::RequestFields& fields);
  Json Branch(const page::Request& request);
  Json DescribeBrains() const;
  Json StartBrain(const page::RequestFields& fields);
  Json Imitate(const page::RequestFields& fields);

  // Scenes (session_scenes.cc).
  scene::SceneSpec ReadNamedScene(const std::string& name) const;
  scene_xml::SceneReading ReadText(const page::RequestFields& fields) const;
  scene::SceneSpec ReadSceneOf(const page::RequestFields& fields) const;
  recorder::RecordingDesk::Options DeskOptions() const;
  std::unique_ptr<LiveWorld> MakeWorld(scene::SceneSpec scene,
                                       std::optional<sim::RobotPlacement> robot);
  /// What is there becomes another world, in which hands and robot go on.
  void Recompose(scene::SceneSpec scene);
  void Enter(std::unique_ptr<LiveWorld> world);
  /// With a preset's objects, none of them in the robot.
  std::unique_ptr<LiveWorld> WorldWith(const std::string& preset, std::uint64_t seed);

  /// Throw a RequestError with the reason.
  void RequireLive() const;
  void RequireNoBranching() const;
  void RequireNoRecording() const;
  void RequireIdleRobot() const;

  /// Of a recording that ended by itself.
  void NoteFailure();
  bool TickLive();
  void EndImitation();
  void TellAllOfScene();
  void TellLooks();
  void TellStateIfDue();
  void TellConsole();
  void LookThroughEye();
  sim::Sight SightNow() const;
  Json DescribeScene() const;
  Json DescribeState() const;
  const sim::Simulation& shown() const;
  library::BrainChoice FindBrain(const std::string& name) const;
  std::vector<library::BrainChoice> Brains() const;
  void RunBrain(const library::BrainChoice& choice, const std::filesystem::path& demonstration);
  /// Begins to record the imitation that starts now; its directory.
  std::filesystem::path RecordImitation(const recording::Recording& demonstration);

  SessionOptions options_;
  library::Library library_;
  scene::SceneSpec loaded_;  ///< what a reload gives
  std::unique_ptr<LiveWorld> world_;
  std::unique_ptr<library::Playback> playback_;  ///< nullptr unless a recording is shown
  std::unique_ptr<Rage> rage_;                   ///< nullptr unless the robot clears the table
  bool is_branching_ = false;  ///< the world that goes on with a recording is in the making
  LiveBrain brain_;
  std::optional<Imitation> imitation_;
  RestingPlace resting_place_;
  Json resting_answer_;
  std::uint64_t resting_call_ = 0, resting_tick_ = 0;
  Snapper snapper_;
  bool is_paused_ = false;
  double speed_factor_ = 1, measured_speed_ = 1;

  page::RequestTable requests_;
  std::vector<Json> messages_;
  std::optional<Image> picture_;
  bool is_picture_recorded_ = false;
  /// Through the eye, at last; nullopt when somebody waits for a picture.
  mutable std::optional<sim::Sight> seen_;
  bool is_eye_broken_ = false;  ///< it cannot draw; that was told
  std::deque<Json> console_;    ///< the last lines that robot programs printed
  Json score_;                  ///< the last one that was told; null before
  Json failure_;                ///< `failure` of a state message
  Json told_state_;             ///< without the time
  std::vector<int> told_looks_;
  std::uint64_t num_calls_ = 0;  ///< of Tick()
  std::uint32_t scene_number_ = 0;
  SceneMeshes meshes_;
  std::shared_ptr<const PageMeshes> present_meshes_;
  mutable std::optional<library::View> view_;  ///< nullopt when something may have moved since
};

}  // namespace smile::studio
