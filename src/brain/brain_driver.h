#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "brain/brain_process.h"
#include "brain/sensor_noise.h"
#include "sim/eye.h"
#include "sim/simulation.h"

namespace smile::brain {

struct BrainDriverOptions {
  sim::Eye* eye = nullptr;              ///< takes its pictures; nullptr for a blind brain
  double image_seconds = 0.25;          ///< between fresh pictures, unless the brain wishes another
  bool has_trackers = true;             ///< tell it `sensor.trackerLoc` too; see MayReadTrackers()
  std::filesystem::path demonstration;  ///< the recording to imitate; empty for none
  DemonstrationFrames frames;           ///< of it, called when a brain asks to watch
  Attention attention;                  ///< of it
  SensorNoise noise;                    ///< in all it is told
};

/// False for a folder none of whose scripts names `trackerLoc`. In Octave its map costs more time
/// than all the rest of a step, so only those pay who read it.
bool MayReadTrackers(const std::filesystem::path& brain);

enum class BrainStatus { kStarting, kRunning, kExited, kFailed };
std::string_view ToString(BrainStatus status);

/// Lets a brain drive the robot of a simulation, in lock-step: before each tick it is told what the
/// robot senses, and what it wants is sent through the simulation's door. So its run is in the log
/// and replays without it. Whoever cannot wait for the brain asks and takes its answer apart, and
/// does not let the simulation tick in between: then it is the same run. Meanwhile the robot's face
/// is watching (a demonstration), working, and in the end done or puzzled.
///
/// A brain that asks to watch is first shown the demonstration: one step for each frame, at the
/// frame's tick since the brain began. Time passes meanwhile, and the robot stands still.
class BrainDriver {
 public:
  /// The options' eye must outlive this.
  explicit BrainDriver(BrainDriverOptions options) : options_(std::move(options)) {}

  /// Asks the process, if it is to be asked now, and waits for its answer: at first to start, from
  /// then on for one step, to be called before each tick while it is running.
  BrainStatus Drive(BrainProcess* process, sim::Simulation* simulation);

  /// What the brain is to be asked now, while it is starting or running; nullopt between two frames
  /// of the demonstration.
  /// @throws std::invalid_argument if the simulation has no robot with two arms of seven joints.
  std::optional<BrainQuestion> Ask(sim::Simulation* simulation);
  /// Does what was answered to that: puts the robot where the brain wants to begin, moves it for a
  /// step. When the brain ends, by itself or not, the robot stops.
  BrainStatus Take(BrainAnswer answer, sim::Simulation* simulation);

  BrainStatus status() const { return status_; }
  /// Why it failed; empty unless it did.
  const std::optional<BrainError>& error() const { return error_; }
  /// How long it has watched the demonstration.
  std::uint64_t watched_ticks() const { return watched_ticks_; }

 private:
  Aux Describe(const sim::Simulation& simulation) const;
  /// What the robot itself senses now, but for pictures.
  Sensor SenseBody(const sim::Simulation& simulation) const;
  Sensor Sense(const sim::Simulation& simulation);
  /// The next frame of the demonstration, if it is due.
  std::optional<Sensor> Watch(const sim::Simulation& simulation);
  void TakeNextFrame(sim::Simulation* simulation);
  bool IsPictureDue(const sim::Simulation& simulation) const;
  /// Adds fresh pictures of the eye and the cameras the brain asked for.
  void Look(const sim::Simulation& simulation, Sensor* sensor);
  void Begin(const InitReply& reply, sim::Simulation* simulation);
  void MakeStep(const StepReply& reply, sim::Simulation* simulation);
  void ShowMarkers(const Points& markers, sim::Simulation* simulation);
  void Send(const Motor& motor, sim::Simulation* simulation);
  void Fail(BrainError error, sim::Simulation* simulation);
  void StopRobot(sim::Simulation* simulation);
  /// Changes the robot's face, for people to see how it fares.
  static void Show(robot::FaceExpression face_expression, sim::Simulation* simulation);

  BrainDriverOptions options_;
  BrainStatus status_ = BrainStatus::kStarting;
  std::optional<BrainError> error_;
  PictureWishes wishes_;
  std::uint64_t begin_tick_ = 0;  ///< when init had ended
  std::uint64_t watched_ticks_ = 0;
  std::optional<DemonstrationFrame> frame_;  ///< to be shown next; nullopt unless it watches
  std::optional<std::uint64_t> last_frame_tick_;
  std::optional<std::uint64_t> first_tick_;  ///< of the steps in which it acts
  std::uint64_t num_images_ = 0;
  bool has_markers_ = false;  ///< to be taken away when it fails
  std::optional<sim::JointVelocities> sent_velocities_;
  std::optional<sim::JointAngles> sent_angles_;
};

}  // namespace smile::brain
