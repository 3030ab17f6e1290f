#pragma once

#include <BulletDynamics/Featherstone/btMultiBodyConstraint.h>

namespace smile::physics {

/// The motor of one joint of a multibody, and its limits of position and speed, as rows for
/// Bullet's solver.
///
/// Bullet's own motor names its multibody twice, as if it stood between two, and costs twice as
/// much; its own limits know nothing of speed.
class JointDrive : public btMultiBodyConstraint {
 public:
  /// Limits are those in the multibody's link.
  JointDrive(btMultiBody* multibody, int link);

  /// For the next step: the velocity to reach [rad/s or m/s], and the impulse it may take.
  void SetTarget(double velocity, double max_impulse);

  void finalizeMultiDof() override;
  int getIslandIdA() const override;
  int getIslandIdB() const override { return -1; }
  void createConstraintRows(btMultiBodyConstraintArray& rows, btMultiBodyJacobianData& data,
                            const btContactSolverInfo& info) override;
  void debugDraw(btIDebugDraw*) override {}

 private:
  struct Range;
  /// Asks for a velocity, with an impulse within the range.
  void AddRow(int number, double velocity, const Range& impulse, btMultiBodyConstraintArray& rows,
              btMultiBodyJacobianData& data, const btContactSolverInfo& info);

  double velocity_ = 0, max_impulse_ = 0;
};

/// The velocities a joint may have, so that it is not faster than it may be and a step of so many
/// seconds ends within its limits.
struct JointSpeeds {
  double least = 0, most = 0;
};
JointSpeeds AllowedSpeeds(const btMultiBody& multibody, int link, double seconds);

}  // namespace smile::physics
