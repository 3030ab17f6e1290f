#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "scene/visual_model.h"

namespace smile::sharing {

/// Pose track: the poses of all frames at each tick of a recording, as the differences between
/// ticks, in few bytes. docs/studio-protocol.md specifies them.
class PoseTrack {
 public:
  /// Steps per unit of a position, and of a number of a unit quaternion.
  static constexpr double kPositionSteps = 1e4, kRotationSteps = 3e4;
  static constexpr std::size_t kMaxTicks = std::size_t{60} * 3600;  ///< an hour
  static constexpr std::size_t kMaxPoses = 4'000'000;

  /// @param file  from which the poses come, for messages.
  PoseTrack(std::string file, double meters_per_unit)
      : file_(std::move(file)), meters_per_unit_(meters_per_unit) {}

  /// Adds a tick. Frame 0 is the world, which never moves.
  /// @param poses  in the world [m]; as many at each tick.
  /// @throws InputError if the track would exceed a limit, or a pose is far out of the world.
  void Add(const scene::FramePoses& poses);

  std::size_t num_ticks() const { return num_ticks_; }
  /// Returns the bytes of all ticks.
  const std::string& bytes() const { return bytes_; }

 private:
  using Steps = std::vector<std::int64_t>;  ///< seven a frame

  Steps StepsOf(const RigidTransform& X_WF) const;
  /// @throws InputError if there are too many.
  std::int64_t Rounded(double steps) const;
  [[noreturn]] void Fail(const std::string& message) const;
  void Put(std::uint64_t number);
  void PutDifference(std::int64_t difference);

  std::string file_;
  double meters_per_unit_;
  std::vector<Steps> sent_;  ///< of each frame
  std::string bytes_;
  std::size_t num_ticks_ = 0, num_poses_ = 0;
};

}  // namespace smile::sharing
