#include "physics/internal_joint_drive.h"

#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>

#include <algorithm>

namespace smile::physics {
namespace {

enum { kMotorRow, kLowerRow, kUpperRow, kNumRows };

/// Impulse available to a limit or a coupling: practically unlimited [N m s or N s].
constexpr double kLimitImpulse = 100;
/// A limit gets a row when the joint is within this fraction of its highest speed of the allowed
/// range. Other limits cost nothing.
constexpr double kWatch = 0.05;

}  // namespace

struct JointDrive::Range {
  double lower, upper;
};

mechanics::JointSpeeds AllowedSpeeds(const btMultiBody& multibody, int link, double seconds) {
  const btMultibodyLink& joint = multibody.getLink(link);
  const double q = multibody.getJointPos(link);
  return {.least = std::max(-joint.m_jointMaxVelocity, (joint.m_jointLowerLimit - q) / seconds),
          .most = std::min(joint.m_jointMaxVelocity, (joint.m_jointUpperLimit - q) / seconds)};
}

JointDrive::JointDrive(btMultiBody* multibody, int link, std::optional<JointLeader> leader)
    : btMultiBodyConstraint(multibody, /*bodyB=*/nullptr, link, /*linkB=*/-1, kNumRows,
                            /*isUnilateral=*/true, MULTIBODY_CONSTRAINT_1DOF_JOINT_MOTOR),
      leader_(leader) {}

void JointDrive::SetTarget(double velocity, double max_impulse) {
  velocity_ = velocity;
  max_impulse_ = max_impulse;
}

mechanics::JointGoal JointDrive::GoalFor(double seconds) const {
  return {.v = m_bodyA->getJointVel(m_linkA),
          .wanted = velocity_,
          .allowed = AllowedSpeeds(*m_bodyA, m_linkA, seconds),
          .max_impulse = max_impulse_,
          .leader = leader_ ? leader_->link : -1,
          .ratio = leader_ ? leader_->multiplier : 1};
}

void JointDrive::finalizeMultiDof() {
  allocateJacobiansMultiDof();
  // The six columns of the base precede those of the joints, also for a fixed base.
  const int column = 6 + m_bodyA->getLink(m_linkA).m_dofOffset;
  for (int row = 0; row < kNumRows; ++row) jacobianA(row)[column] = 1;
  // The row of the motor becomes that of the coupling: its velocity is v - multiplier * v_leader.
  if (leader_) {
    jacobianA(kMotorRow)[6 + m_bodyA->getLink(leader_->link).m_dofOffset] = -leader_->multiplier;
  }
  m_numDofsFinalized = m_jacSizeBoth;
}

int JointDrive::getIslandIdA() const {
  const btMultiBodyLinkCollider* collider = m_bodyA->getLink(m_linkA).m_collider;
  return collider != nullptr ? collider->getIslandTag() : -1;
}

void JointDrive::createConstraintRows(btMultiBodyConstraintArray& rows,
                                      btMultiBodyJacobianData& data,
                                      const btContactSolverInfo& info) {
  if (m_numDofsFinalized != m_jacSizeBoth) finalizeMultiDof();
  if (leader_) {
    AddRow(kMotorRow, velocity_, {-kLimitImpulse, kLimitImpulse}, rows, data, info);
    return;
  }
  if (max_impulse_ > 0) {
    AddRow(kMotorRow, velocity_, {-max_impulse_, max_impulse_}, rows, data, info);
  }
  // Limits count as velocities: the speed that would reach the position limit at the end of the
  // step.
  const mechanics::JointSpeeds allowed = AllowedSpeeds(*m_bodyA, m_linkA, info.m_timeStep);
  const double v = m_bodyA->getJointVel(m_linkA);
  const double near = kWatch * m_bodyA->getLink(m_linkA).m_jointMaxVelocity;
  if (v < allowed.least + near) {
    AddRow(kLowerRow, allowed.least, {0, kLimitImpulse}, rows, data, info);
  }
  if (v > allowed.most - near) {
    AddRow(kUpperRow, allowed.most, {-kLimitImpulse, 0}, rows, data, info);
  }
}

void JointDrive::AddRow(int number, double velocity, const Range& impulse,
                        btMultiBodyConstraintArray& rows, btMultiBodyJacobianData& data,
                        const btContactSolverInfo& info) {
  btMultiBodySolverConstraint& row = rows.expandNonInitializing();
  row.m_orgConstraint = this;
  row.m_orgDofIndex = number;
  // There is no rigid body at either end: the row acts on the multibody alone.
  row.m_solverBodyIdA = row.m_solverBodyIdB = data.m_fixedBodyId;
  const btVector3 none(0, 0, 0);
  fillMultiBodyConstraint(row, data, jacobianA(number), jacobianB(number), none, none, none, none,
                          /*posError=*/0, info, impulse.lower, impulse.upper,
                          /*angConstraint=*/false, /*relaxation=*/1, /*isFriction=*/false,
                          velocity);
  row.m_contactNormal1 = row.m_contactNormal2 = none;
  row.m_relpos1CrossNormal = row.m_relpos2CrossNormal = none;
}

}  // namespace smile::physics
