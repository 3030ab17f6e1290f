#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/bytes.h"
#include "record/append_file.h"
#include "record/recording.h"
#include "sim/simulation.h"

namespace smile::record {

/// Where an object is: position [m] and unit quaternion (w, x, y, z).
struct TracePose {
  bool is_present = true;  ///< false once it is destroyed; position and rotation then say nothing
  Vector3 position = Vector3::Zero();
  Eigen::Vector4d rotation{1, 0, 0, 0};

  RigidTransform pose_in_world() const {
    return {Quaternion(rotation[0], rotation[1], rotation[2], rotation[3]), position};
  }
  bool operator==(const TracePose&) const = default;
};

/// What a host point holds.
struct TraceBond {
  int guest = -1;  ///< index of the guest point, in scene order; -1: none
  int tightness = 0;
  bool is_locked = false;

  bool operator==(const TraceBond&) const = default;
};

/// One moment of a recording, as far as it can be seen.
struct TraceTick {
  std::uint64_t tick = 0;
  std::uint64_t hash = 0;                     ///< Simulation::state_hash()
  std::vector<TracePose> objects;             ///< in scene order
  std::vector<world::ControlState> controls;  ///< in scene order
  std::vector<TraceBond> bonds;               ///< one per host point, in scene order
  std::vector<double> joints;                 ///< q of the robot [rad or m]; empty without one
  bool is_robot_shown = true;
};

/// The present moment of a simulation.
TraceTick Observe(const sim::Simulation& simulation);

/// `trace.bin`: look and render without physics. docs/recording-format.md describes every byte.
///
/// A header names objects and joints; one record per tick follows with what changed since the one
/// before.
class TraceWriter {
 public:
  /// @throws std::runtime_error with path and reason, as Add() does.
  TraceWriter(const std::filesystem::path& path, const sim::Simulation& simulation);

  void Add(const TraceTick& tick);

 private:
  AppendFile file_;
  std::optional<TraceTick> last_;
};

/// What a trace of a scene may say of its controls and bonds.
struct TraceLimits {
  std::vector<int> num_states;     ///< of each control
  std::vector<int> max_tightness;  ///< of each host point
  int num_guests = 0;

  explicit TraceLimits(const scene::SceneSpec& scene);
  bool Allow(std::size_t control, const world::ControlState& state) const;
  bool Allow(std::size_t host, const TraceBond& bond) const;
};

/// Reads a trace, tick by tick. A file cut in the middle of a record ends with the last whole one.
class TraceReader {
 public:
  /// @throws InputError if this is not a trace of this format version, or not one of the
  /// recording's
  ///         objects and robot.
  explicit TraceReader(const Recording& recording);

  const std::vector<std::string>& object_names() const { return object_names_; }
  const std::vector<std::string>& joint_names() const { return joint_names_; }

  /// The next moment; nullopt after the last one.
  /// @throws InputError if a record contradicts the header or the record before it.
  std::optional<TraceTick> Next();
  /// True when bytes were left over at the end: the recording was interrupted.
  bool is_cut() const { return is_cut_; }

 private:
  std::filesystem::path path_;
  std::string bytes_;
  ByteReader rest_;
  std::vector<std::string> object_names_, joint_names_;
  TraceLimits limits_;
  TraceTick now_;
  bool has_begun_ = false;
  bool is_cut_ = false;
};

}  // namespace smile::record
