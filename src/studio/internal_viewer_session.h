#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "studio/internal_scene_announcer.h"
#include "studio/internal_state_announcer.h"
#include "studio/pose_stream.h"
#include "studio/session_interface.h"
#include "studio/watched_simulation.h"

namespace smile::studio {

/// Session of a viewer: shows a watched simulation, and refuses all requests that would change it.
/// Belongs to one thread, except Show() and MeshBytes().
class ViewerSession : public SessionInterface {
 public:
  explicit ViewerSession(std::shared_ptr<WatchedSimulation> simulation);

  /// Shows another simulation from the next tick on. From any thread.
  void Show(std::shared_ptr<WatchedSimulation> simulation);
  /// See Session::MeshBytes(). From any thread.
  std::optional<std::string> MeshBytes(std::uint32_t scene, std::size_t mesh) const {
    return scene_announcer_.MeshBytes(scene, mesh);
  }

  const page::RequestTable& requests() const override { return table_; }
  /// Takes the newest moment; it does not advance the simulation.
  bool Tick() override;
  SessionUpdates TakeUpdates() override;
  std::vector<Json> Everything() const override;
  double speed_factor() const override { return 1; }
  /// Does nothing: that of the loop is not the simulation's.
  void SetMeasuredSpeed(double) override {}
  page::Poses NextPoses() override;

 private:
  Json DescribeState() const;

  page::RequestTable table_;
  std::mutex mutex_;  ///< of `wanted_`
  std::shared_ptr<WatchedSimulation> wanted_;
  std::shared_ptr<WatchedSimulation> simulation_;
  std::shared_ptr<const WatchedMoment> moment_;  ///< that is shown
  SceneAnnouncer scene_announcer_;
  StateAnnouncer state_announcer_;
  PoseStream poses_;
  std::vector<Json> messages_;
  std::uint64_t num_ticks_ = 0;
  std::uint64_t tick_before_ = 0;  ///< of the simulation, at the last measurement of its speed
  double speed_ = 0;
};

}  // namespace smile::studio
