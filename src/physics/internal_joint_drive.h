#pragma once

#include <BulletDynamics/Featherstone/btMultiBodyConstraint.h>

#include <optional>

#include "mechanics/tree_motion.h"

namespace smile::physics {

/// Another joint of the same multibody that a joint follows, with a fixed ratio of velocities.
struct JointLeader {
  int link = -1;
  double multiplier = 1;
};

/// Motor of one joint of a multibody, with its limits of position and speed, as rows for Bullet's
/// solver. A joint that follows another has a coupling with it instead of the three: the limits of
/// its leader bound it, too.
///
/// Bullet's own motor names its multibody twice, as if it stood between two, and costs twice as
/// much; its own limits ignore speed.
class JointDrive : public btMultiBodyConstraint {
 public:
  /// Makes a motor; its limits are those in the multibody's link.
  JointDrive(btMultiBody* multibody, int link, std::optional<JointLeader> leader = {});

  /// Sets the velocity to reach in the next step [rad/s or m/s], and the impulse available for it
  /// [N m s or N s]. The velocity of a joint that follows another is relative to that of its leader
  /// times the multiplier, and its impulse is practically unlimited.
  void SetTarget(double velocity, double max_impulse);

  int link() const { return m_linkA; }
  /// Returns what is to be reached in a step.
  mechanics::JointGoal GoalFor(double seconds) const;

  void finalizeMultiDof() override;
  int getIslandIdA() const override;
  int getIslandIdB() const override { return -1; }
  void createConstraintRows(btMultiBodyConstraintArray& rows, btMultiBodyJacobianData& data,
                            const btContactSolverInfo& info) override;
  void debugDraw(btIDebugDraw*) override {}

 private:
  struct Range;
  /// Adds a row that reaches a velocity with an impulse within the range.
  void AddRow(int number, double velocity, const Range& impulse, btMultiBodyConstraintArray& rows,
              btMultiBodyJacobianData& data, const btContactSolverInfo& info);

  std::optional<JointLeader> leader_;
  double velocity_ = 0, max_impulse_ = 0;
};

/// Returns the velocities with which a joint respects its speed limit and ends a step of `seconds`
/// within its position limits.
mechanics::JointSpeeds AllowedSpeeds(const btMultiBody& multibody, int link, double seconds);

}  // namespace smile::physics
