#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "brain/brain_driver.h"
#include "brain/brain_thread.h"
#include "motion/articulation_probe.h"
#include "picture/rendered_eye.h"

namespace smile::python {

/// Calibrated camera without distortion.
struct RobotCamera {
  brain::CameraDescription description;  ///< its pose has a translation in units
  bool has_depth = false;
};

/// Measured state of an arm.
struct MeasuredArm {
  std::vector<double> joints;      ///< [rad; m]
  std::vector<double> velocities;  ///< [rad/s; m/s]
  std::optional<double> opening;   ///< of its gripper [m]; nullopt without one
  bool holds = false;              ///< something, of which the name is not known
};

struct RobotBrainOptions {
  std::optional<RobotCamera> camera;  ///< nullopt for a brain without pictures
  /// Returns a picture of that camera when one is due for the brain; called by Ask().
  std::function<Image()> look;
  std::filesystem::path demonstration;  ///< recording to imitate; empty for none
  double timeout = brain::kCallbackSeconds;
};

/// Brain that drives a robot outside of the simulator.
///
/// A simulation of the robot alone stands in for it: in each tick it is put where the robot was
/// measured, brain::BrainDriver asks the brain as in any simulation, and what the driver commands
/// is read. All that a brain sees is therefore made by the same code; only measured velocities,
/// openings, grasps and pictures take the place of simulated ones. What no robot can do is a
/// failure of the brain.
class RobotBrain : public sim::Listener {
 public:
  /// @param model  scene and robot; its objects are left out.
  /// @throws as brain::BrainProcess and experiment::DriverOptionsFor() do.
  RobotBrain(const model::Model& model, const std::filesystem::path& brain,
             const RobotBrainOptions& options);
  ~RobotBrain() override;

  /// Puts arms where they were measured; one per arm of the model.
  /// @throws std::invalid_argument if a number is not finite or one is missing.
  void Sense(std::vector<MeasuredArm> arms);
  /// Asks the brain, if its next step is due; false within a chunk, and between two frames of a
  /// demonstration. Throws what `look` throws; then no further calls may follow.
  bool Ask();
  /// Takes the answer. Returns false if there is none within wall-clock time [s].
  bool Take(double seconds);
  /// Advances the clock of the brain by a tick.
  void Tick() { stand_in_.Tick(); }

  brain::BrainStatus status() const { return driver_.status(); }
  std::optional<brain::BrainError> error() const { return driver_.error(); }
  std::optional<brain::Claim> claim() const { return driver_.claim(); }
  double seconds() const { return stand_in_.seconds(); }
  /// Returns the posture in which an arm is to begin; nullopt if any will do.
  std::optional<std::vector<double>> InitialJoints(int arm) const;
  /// Returns the commanded velocities of an arm [rad/s; m/s].
  std::vector<double> Velocities(int arm) const;
  /// Returns the commanded rate of the opening of an arm's gripper [m/s].
  double OpeningRate(int arm) const;
  /// Returns which links would touch each other or the table, with arms at these joints.
  std::optional<std::string> Touch(const std::vector<std::vector<double>>& joints);
  /// Returns the lines that the brain has printed or noted since the last call.
  std::vector<std::string> TakeLines();

  void OnCommand(const sim::Simulation& simulation, const sim::Command& command) override;

 private:
  /// Eye that shows pictures of a real camera.
  struct CameraEye : model::Eye {
    const Image& Draw(const scene::VisualModel& /*model*/,
                      const model::ViewSample& /*sample*/) override {
      return picture = look();
    }
    const model::EyeSpec& spec() const override { return size; }

    model::EyeSpec size;
    std::function<Image()> look;
    Image picture;
  };

  brain::BrainDriverOptions DriverOptions(const std::filesystem::path& brain,
                                          const RobotBrainOptions& options);
  brain::BrainOptions ProcessOptions(double timeout);
  /// Replaces what the stand-in cannot know.
  void Correct(brain::Aux* aux) const;
  void Correct(brain::Sensor* sensor) const;
  /// Returns why a robot cannot do what an answer asks for.
  std::optional<brain::BrainError> WhyImpossible(const brain::InitReply& reply) const;
  std::optional<brain::BrainError> WhyImpossible(const brain::StepReply& reply) const;
  void AddLine(std::string_view line);

  std::optional<RobotCamera> camera_;
  CameraEye eye_;
  picture::RenderedEye demonstration_eye_;
  sim::Simulation stand_in_;
  motion::ArticulationProbe probe_;  ///< of the robot and the table
  std::vector<MeasuredArm> measured_;
  std::vector<std::optional<std::vector<double>>> initial_joints_;
  bool is_ours_ = false;            ///< the command comes from here, not from the brain
  sim::JointVelocities commanded_;  ///< by the brain
  std::mutex mutex_;                ///< of the lines, which come from other threads
  std::vector<std::string> lines_;
  brain::BrainDriver driver_;
  brain::BrainThread thread_;  ///< last: ends first
};

}  // namespace smile::python
