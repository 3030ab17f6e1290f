#pragma once

#include <array>

#include "mechanics/rail_state.h"
#include "physics/definitions.h"
#include "physics/internal_bullet.h"

namespace smile::physics {

/// Fixed, slider or ball joint as rows for Bullet's solver: frame K of B against frame J of A.
///
/// All its rows hold exactly (ConstraintSolver), except those of limits that were not pressed in
/// the last step. The pressed limits are state and part of a snapshot.
class JointConstraint : public btTypedConstraint {
 public:
  /// @param order  its place among all joints.
  /// @param X_AcmA, X_BcmB  the bodies' own frames in the frames that Bullet moves.
  JointConstraint(int order, const JointSpec& spec, btRigidBody& a, const RigidTransform& X_AcmA,
                  btRigidBody& b, const RigidTransform& X_BcmB);

  /// Call before each step: a slider with damping 1 is held at its offset, unless a hand moves it.
  void HoldUnless(bool is_carried) { state_.HoldUnless(is_carried, offset(), rail_); }

  double offset() const;         ///< K's x in J of a slider [m]
  double sliding_speed() const;  ///< speed of K along the rail [m/s]
  /// Changes the sliding speed by equal and opposite impulses [N s] along the rail.
  void Push(double impulse);

  /// Returns true for rows that hold in both directions, and for a limit that was pressed.
  bool IsHeld(int row) const;
  /// Returns the speed with which a row corrects its position error in this step [m/s] or [rad/s].
  double return_speed(int row) const { return return_speeds_[static_cast<std::size_t>(row)]; }
  /// Reports the impulse of a row after a step [N s] or [N m s]; decides which limits count as
  /// pressed.
  void NoteImpulse(int row, double impulse);
  /// Place in the order in which Bullet solves the joints of an island; those of equal place are in
  /// order.
  int place = 0;
  double held_offset() const { return state_.held_offset; }
  void Save(ByteWriter* out) const { state_.Save(out); }
  void Restore(ByteReader* in) { state_.Restore(in); }

  void getInfo1(btConstraintInfo1* info) override;
  void getInfo2(btConstraintInfo2* info) override;
  void setParam(int, btScalar, int) override {}
  btScalar getParam(int, int) const override { return 0; }

 private:
  enum class Kind { kFixed, kSlider, kBall };
  struct Pose;

  Pose PoseNow() const;
  int num_rows() const;
  void FillRows(btConstraintInfo2* info);
  void LockPoint(const Pose& pose, int axis, double error, int row, btConstraintInfo2* info) const;
  void LockTurning(const Pose& pose, int first_row, btConstraintInfo2* info) const;
  void StopAtLimits(const Pose& pose, int first_row, btConstraintInfo2* info);
  bool has_one_place() const { return state_.is_held || rail_.lower == rail_.upper; }

  Kind kind_ = Kind::kBall;
  btTransform X_AcmJ_, X_BcmK_;
  SliderJointSpec rail_;
  mechanics::RailState state_;
  std::array<double, 7> return_speeds_{};  ///< in this step
  bool bounces_ = false;                   ///< rebounds from a limit in this step
};

}  // namespace smile::physics
