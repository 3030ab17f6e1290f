#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "interchange/exported_world.h"
#include "recording/recording.h"
#include "recording/time_range.h"

namespace smile::interchange {

/// Visuals of one frame that appear and vanish together.
struct MovingVisuals {
  int choice = -1, variant = 0;        ///< see scene::Visual
  std::vector<scene::Visual> visuals;  ///< X_FV is in the frame
  /// Moments at which they appear or vanish, the first one 0. Between them nothing changes.
  std::vector<std::pair<std::uint32_t, bool>> shown;
};

/// A frame F of the world, an object or a link, and how it moves.
struct MovingFrame {
  std::string name;
  /// Moments of its poses, ascending. Between two it moves linearly; before the first and after the
  /// last one it rests. Where it rests for long, only the ends are listed.
  std::vector<std::uint32_t> moments;
  std::vector<RigidTransform> X_WF;  ///< one for each; at least one
  std::vector<MovingVisuals> visuals;

  /// Returns the rotations of its poses: of the two quaternions of each, the one nearer to that
  /// before it, so that the short way lies between them.
  std::vector<Quaternion> Rotations() const;
};

/// What is seen of a world, and how it moves: in a recording, or at one moment.
struct ExportedMotion {
  std::vector<double> seconds;  ///< of each moment since the first one
  /// As those of the visual model: the world, the objects, then the robot's base and links.
  std::vector<MovingFrame> frames;

  bool is_animated() const { return seconds.size() > 1; }
};

/// A world, and how it moves.
struct ExportedScene {
  ExportedWorld world;
  ExportedMotion motion;
};

/// Returns the present world of a simulation, at rest.
ExportedScene SceneOf(const sim::RunningModel& running);

/// Returns the world of a model after simulated time, without commands.
/// @param seconds  of simulated time, rounded to ticks.
ExportedScene SceneAfter(double seconds, std::shared_ptr<const model::Model> model);

/// Returns the motion in a part of a recording, with the world at its first moment. Objects that
/// are added later are hidden until then.
/// @param rate  moments per second; the last tick is always one.
/// @throws InputError if the trace cannot be read or there would be too many poses;
///         std::invalid_argument if the range is not within the recording.
ExportedScene SceneOf(const recording::Recording& recording, const recording::TimeRange& range,
                      double rate);

}  // namespace smile::interchange
