#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "brain/brain_values.h"
#include "brain/internal_matrix_reader.h"

namespace smile::brain {

/// Reader of the commands for arms in a message: in the classic variables or in the general form,
/// never in both.
class MotorReader {
 public:
  /// @param arms  as in Aux; must outlive this.
  MotorReader(std::span<const ArmDescription> arms, MatrixReader* reader);

  /// Takes a field of `motor`; an unknown one is an error.
  void Take(const NamedArray& field);
  /// Checks that no field is missing, and sets the commands of a reply and their duration.
  void Finish(StepReply* reply);

  /// Takes an initial posture: `initJointAngles`, or `armJoints` and `armsAtJoints`.
  /// @returns one for each arm that has one; empty if there is none.
  static std::vector<std::optional<std::vector<double>>> ReadPosture(
      const Message& message, std::span<const ArmDescription> arms, MatrixReader* reader);

 private:
  using Posture = std::vector<std::optional<std::vector<double>>>;

  int num_arms() const { return static_cast<int>(arms_.size()); }
  /// Takes a field of the classic variables; false if it is none.
  bool TakeClassic(const NamedArray& field);
  /// Takes a field of the general form; false if it is none.
  bool TakeGeneral(const NamedArray& field);
  void TakeGrippers(const NamedArray& field);
  /// Checks that there are joints if, and only if, an arm is put at them.
  void CheckPosture();

  std::span<const ArmDescription> arms_;
  MatrixReader* reader_;
  /// One column per tick: of all joints, arm by arm, and of each gripper.
  std::optional<Eigen::MatrixXd> velocities_, gripper_velocities_;
  std::optional<Eigen::VectorXd> joints_;
  std::vector<bool> at_joints_;  ///< arms that are put at `joints_`
  std::optional<Eigen::MatrixXd> head_velocities_;
  std::optional<int> ticks_;
  const char* classic_ = nullptr;  ///< name of a field of the classic variables that was taken
  bool has_general_ = false;
};

}  // namespace smile::brain
