#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "brain/brain_process.h"
#include "brain/sensor_noise.h"
#include "sim/eye.h"
#include "sim/note.h"
#include "sim/simulation.h"

namespace smile::brain {

/// Values that a brain may read and that take Octave longer at each step than all the rest: a map
/// of trackers, and structs of arms. They are sent only to scripts that may read them.
struct MayRead {
  bool trackers = true;  ///< `sensor.trackerLoc`
  /// `sensor.arms`, beside the classic variables; other robots than classic ones always send it.
  bool arms = true;

  bool operator==(const MayRead&) const = default;
};

/// Searches the scripts of a folder and its subfolders for `trackerLoc` and `.arms`; brains of
/// other kinds, and folders of more than 10,000 entries, may read everything.
MayRead WhatMayBeRead(const std::filesystem::path& brain);

struct BrainDriverOptions {
  sim::Eye* eye = nullptr;      ///< renders its pictures; nullptr for a brain without pictures
  double image_seconds = 0.25;  ///< between pictures, unless the brain requests another period
  MayRead may_read;             ///< values that the brain may read; see WhatMayBeRead()
  std::filesystem::path demonstration;  ///< the recording to imitate; empty for none
  DemonstrationFrames frames;           ///< of that recording; called if a brain requests to watch
  Attention attention;                  ///< of it
  std::optional<TaskPlan> plan;         ///< of it
  SensorNoise noise;                    ///< in all sensor values
  BehaviorVariation variation;          ///< that it is asked for
  /// Gives the brain the true poses of the objects that exist at its start, which no robot has.
  bool gives_poses = false;
  /// Called for each note of the brain, at the tick of the step with which it came.
  std::function<void(const sim::Note& note)> on_note;
};

enum class BrainStatus { kStarting, kRunning, kExited, kFailed };
std::string_view ToString(BrainStatus status);

/// Driver: lets a brain drive the robot of a simulation in lock-step: before each tick it gets the
/// sensor values, and its motor commands are applied to the simulation. So its run is in the log
/// and replays without it. Callers that cannot wait for the brain call NextQuestion() and Take()
/// separately, and must not tick in between: then the run is the same. The robot's face shows the
/// phase: watching (a demonstration), working, and finally done or puzzled.
///
/// An answer may be a chunk: commands for several ticks. These are applied tick by tick, to the
/// same log as single ones, and the brain's next step follows them. If the simulation's clock jumps
/// meanwhile (an undo), the rest of the chunk is dropped: it was made for another situation.
///
/// A brain that requests to watch first gets the demonstration: one step for each frame, at the
/// frame's tick since the brain began. Time advances meanwhile, and the robot stands still.
class BrainDriver {
 public:
  /// The options' eye must outlive this.
  explicit BrainDriver(BrainDriverOptions options) : options_(std::move(options)) {}

  /// Asks the process, if a question is due, and waits for its answer: first to start, then for one
  /// step; to be called before each tick while it is running.
  BrainStatus Drive(BrainProcess* process, sim::Simulation* simulation);

  /// Returns the question that is due, while the brain is starting or running; nullopt between two
  /// frames of the demonstration, and within a chunk, whose command of this tick it applies.
  /// @throws std::invalid_argument if the simulation has no robot with arms.
  std::optional<BrainQuestion> NextQuestion(sim::Simulation* simulation);
  /// Applies the answer: the initial posture of the robot, or the motion of a step. When the brain
  /// ends, for any reason, the robot stops.
  BrainStatus Take(BrainAnswer answer, sim::Simulation* simulation);

  BrainStatus status() const { return status_; }
  /// Returns the reason of a failure; nullopt without one.
  const std::optional<BrainError>& error() const { return error_; }
  /// Returns what it claimed when it ended; nullopt if it claimed nothing, or has not ended.
  const std::optional<Claim>& claim() const { return claim_; }
  /// Returns how long it has watched the demonstration [ticks].
  std::uint64_t watched_ticks() const { return watched_ticks_; }

 private:
  /// Returns true if the general form of arms is sent.
  bool SendsArms(const robot::RobotModel& model) const;
  Aux Describe(const sim::Simulation& simulation) const;
  /// Returns the robot's own sensor values, without pictures.
  Sensor SenseBody(const sim::Simulation& simulation);
  Sensor Sense(const sim::Simulation& simulation);
  /// Returns the next frame of the demonstration, if it is due.
  std::optional<Sensor> SenseDemonstration(const sim::Simulation& simulation);
  void TakeNextFrame(sim::Simulation* simulation);
  /// Applies the chunk's command of this tick. Returns false if there is none, or no chunk.
  bool ContinueChunk(sim::Simulation* simulation);
  /// Returns the time since the previous step [s]; a tick for the first one.
  double SecondsSinceStep(const sim::Simulation& simulation) const;
  /// Returns true if a picture is due, and notes that it is taken.
  bool TakePictureTurn(const sim::Simulation& simulation);
  /// Makes the next picture due after this time from now on [s].
  void ChangeImagePeriod(double seconds, const sim::Simulation& simulation);
  /// Adds new pictures of the eye and the cameras that the brain requested.
  void AddPictures(const sim::Simulation& simulation, Sensor* sensor);
  void Begin(const InitReply& reply, sim::Simulation* simulation);
  void MakeStep(const StepReply& reply, sim::Simulation* simulation);
  void ShowMarkers(const Points& markers, sim::Simulation* simulation);
  void PassOn(const std::vector<sim::Note>& notes) const;
  void Send(const Motor& motor, sim::Simulation* simulation);
  void Fail(BrainError error, sim::Simulation* simulation);
  void StopRobot(sim::Simulation* simulation);
  /// Changes the robot's face, which shows people the phase.
  static void Show(robot::FaceExpression face_expression, sim::Simulation* simulation);

  BrainDriverOptions options_;
  BrainStatus status_ = BrainStatus::kStarting;
  std::optional<BrainError> error_;
  std::optional<Claim> claim_;
  PictureWishes wishes_;
  std::uint64_t begin_tick_ = 0;  ///< at the end of init
  std::size_t num_described_objects_ = 0;
  std::uint64_t watched_ticks_ = 0;
  std::optional<DemonstrationFrame> frame_;      ///< shown next; nullopt unless it watches
  std::optional<std::uint64_t> last_step_tick_;  ///< also while it watches
  /// Answer that covers several ticks.
  struct Chunk {
    std::vector<Motor> motors;
    std::uint64_t first_tick = 0, end_tick = 0;
    std::uint64_t last_tick = 0;  ///< applied last
  };
  std::optional<Chunk> chunk_;
  /// Schedule of pictures: starts with the first step in which the brain acts.
  std::optional<std::uint64_t> image_start_tick_;
  double num_image_periods_ = 0;  ///< from then to the next picture
  bool has_markers_ = false;      ///< removed when it fails
  std::optional<sim::JointVelocities> sent_velocities_;
  std::optional<sim::JointAngles> sent_angles_;
};

}  // namespace smile::brain
