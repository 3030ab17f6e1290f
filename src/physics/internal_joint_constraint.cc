// Rows of a joint, in this order:
//   ball:   x, y, z of K's origin in J
//   fixed:  the same, then rotation about x, y, z of J
//   slider: y, z, rotation about x, y, z, then the rail: one row if it has a single possible place,
//           otherwise one row per limit
// A row measures the speed of A minus the speed of B along its axis. Position errors are corrected
// by adding a fraction of the error per step to the wanted speed (J. Baumgarte, Stabilization of
// constraints and integrals of motion in dynamical systems, 1972).

#include "physics/internal_joint_constraint.h"

#include <algorithm>
#include <cmath>

#include "base/overloaded.h"

namespace smile::physics {
namespace {

/// Fraction of a joint's position error that is corrected in a step.
constexpr double kErrorReduction = 0.3;
/// Upper bounds of the correction speed [m/s], [rad/s].
constexpr double kMaxReturnSpeed = 2.0;
constexpr double kMaxReturnTurn = 10.0;
/// Minimum approach speed for a rebound from a limit [m/s].
constexpr double kMinBounce = 0.05;

/// First row of a slider that acts along its rail.
constexpr int kFirstRailRow = 5;

/// Returns the rotation vector of R: axis times angle [rad], the angle at most pi.
btVector3 TurnOf(const btMatrix3x3& R) {
  btQuaternion q;
  R.getRotation(q);
  // q and -q are the same rotation; the one with w >= 0 has the smaller angle.
  if (q.w() < 0) q = -q;
  const btVector3 v(q.x(), q.y(), q.z());
  const double sine = v.length();
  return sine < 1e-12 ? v * 2 : v * (2 * std::atan2(sine, q.w()) / sine);
}

/// Writes a vector to a row of one of Bullet's Jacobians.
void PutVector(const btVector3& v, int row, int rowskip, btScalar* to) {
  for (int i = 0; i < 3; ++i) to[row * rowskip + i] = v[i];
}

}  // namespace

/// Present poses of both joint frames in the world.
struct JointConstraint::Pose {
  btTransform X_WJ, X_WK;
  btVector3 p_AcmK, p_BcmK;  ///< from the centers of mass to K's origin, along world axes

  btVector3 axis(int i) const { return X_WJ.getBasis().getColumn(i); }
  btVector3 p_JK() const { return X_WJ.invXform(X_WK.getOrigin()); }
};

JointConstraint::JointConstraint(int order, const JointSpec& spec, btRigidBody& a,
                                 const RigidTransform& X_AcmA, btRigidBody& b,
                                 const RigidTransform& X_BcmB)
    : btTypedConstraint(D6_CONSTRAINT_TYPE, a, b) {
  setUserConstraintId(order);
  RigidTransform X_AJ, X_BK;
  if (const auto* fixed = std::get_if<FixedJointSpec>(&spec)) {
    kind_ = Kind::kFixed;
    X_AJ = fixed->X_AB;
  } else if (const auto* slider = std::get_if<SliderJointSpec>(&spec)) {
    kind_ = Kind::kSlider;
    rail_ = *slider;
    X_AJ = slider->X_AJ;
    X_BK = slider->X_BK;
  } else {
    const auto& ball = std::get<BallJointSpec>(spec);
    X_AJ = RigidTransform(ball.p_AQ);
    X_BK = RigidTransform(ball.p_BQ);
  }
  X_AcmJ_ = ToBullet(X_AcmA * X_AJ);
  X_BcmK_ = ToBullet(X_BcmB * X_BK);
  // A slider with damping 1 is held where it is when the joint is made.
  state_.held_offset = std::clamp(offset(), rail_.lower, rail_.upper);
}

JointConstraint::Pose JointConstraint::PoseNow() const {
  Pose pose;
  pose.X_WJ = m_rbA.getCenterOfMassTransform() * X_AcmJ_;
  pose.X_WK = m_rbB.getCenterOfMassTransform() * X_BcmK_;
  pose.p_AcmK = pose.X_WK.getOrigin() - m_rbA.getCenterOfMassPosition();
  pose.p_BcmK = pose.X_WK.getOrigin() - m_rbB.getCenterOfMassPosition();
  return pose;
}

double JointConstraint::offset() const { return PoseNow().p_JK().x(); }

double JointConstraint::sliding_speed() const {
  const Pose pose = PoseNow();
  return pose.axis(0).dot(m_rbB.getVelocityInLocalPoint(pose.p_BcmK) -
                          m_rbA.getVelocityInLocalPoint(pose.p_AcmK));
}

void JointConstraint::Push(double impulse) {
  const Pose pose = PoseNow();
  m_rbB.applyImpulse(pose.axis(0) * impulse, pose.p_BcmK);
  m_rbA.applyImpulse(pose.axis(0) * -impulse, pose.p_AcmK);
}

bool JointConstraint::IsHeld(int row) const {
  return row < kFirstRailRow || kind_ != Kind::kSlider || has_one_place() ||
         state_.is_pressed[row - kFirstRailRow];
}

void JointConstraint::NoteImpulse(int row, double impulse) {
  if (row < kFirstRailRow || kind_ != Kind::kSlider || has_one_place()) return;
  const bool is_upper = row != kFirstRailRow;
  state_.NoteImpulse(is_upper, is_upper ? impulse : -impulse, bounces_);
}

int JointConstraint::num_rows() const {
  switch (kind_) {
    case Kind::kFixed:
      return 6;
    case Kind::kSlider:
      return has_one_place() ? 6 : 7;
    case Kind::kBall:
      return 3;
  }
  return 0;
}

void JointConstraint::getInfo1(btConstraintInfo1* info) {
  info->nub = 0;
  info->m_numConstraintRows = num_rows();
}

void JointConstraint::getInfo2(btConstraintInfo2* info) {
  FillRows(info);
  for (int row = 0; row < num_rows(); ++row) {
    return_speeds_[static_cast<std::size_t>(row)] = info->m_constraintError[row * info->rowskip];
  }
}

void JointConstraint::FillRows(btConstraintInfo2* info) {
  const Pose pose = PoseNow();
  const btVector3 p_JK = pose.p_JK();
  int row = 0;
  for (int axis = kind_ == Kind::kSlider ? 1 : 0; axis < 3; ++axis) {
    LockPoint(pose, axis, p_JK[axis], row++, info);
  }
  if (kind_ == Kind::kBall) return;
  LockTurning(pose, row, info);
  row += 3;
  if (kind_ == Kind::kFixed) return;
  bounces_ = false;
  if (has_one_place()) {
    LockPoint(pose, 0, p_JK.x() - (state_.is_held ? state_.held_offset : rail_.lower), row, info);
  } else {
    StopAtLimits(pose, row, info);
  }
}

/// Holds K's origin at its place along an axis of J.
void JointConstraint::LockPoint(const Pose& pose, int axis, double error, int row,
                                btConstraintInfo2* info) const {
  const btVector3 n = pose.axis(axis);
  PutVector(n, row, info->rowskip, info->m_J1linearAxis);
  // Both lever arms end at K's origin, so that the impulses are equal, opposite and on one line.
  PutVector(pose.p_AcmK.cross(n), row, info->rowskip, info->m_J1angularAxis);
  PutVector(-n, row, info->rowskip, info->m_J2linearAxis);
  PutVector(-pose.p_BcmK.cross(n), row, info->rowskip, info->m_J2angularAxis);
  info->m_constraintError[row * info->rowskip] =
      std::clamp(kErrorReduction * info->fps * error, -kMaxReturnSpeed, kMaxReturnSpeed);
}

/// Holds the orientation of K in J, one row per axis of J. Rows without linear parts stay zero
/// there.
void JointConstraint::LockTurning(const Pose& pose, int first_row, btConstraintInfo2* info) const {
  const btVector3 turn = TurnOf(pose.X_WJ.getBasis().transposeTimes(pose.X_WK.getBasis()));
  for (int axis = 0; axis < 3; ++axis) {
    const int row = first_row + axis;
    PutVector(pose.axis(axis), row, info->rowskip, info->m_J1angularAxis);
    PutVector(-pose.axis(axis), row, info->rowskip, info->m_J2angularAxis);
    info->m_constraintError[row * info->rowskip] =
        std::clamp(kErrorReduction * info->fps * turn[axis], -kMaxReturnTurn, kMaxReturnTurn);
  }
}

/// Adds one row per limit, which can only push inwards. A limit out of reach allows exactly the
/// speed that reaches it at the end of the step.
void JointConstraint::StopAtLimits(const Pose& pose, int first_row, btConstraintInfo2* info) {
  const double offset = pose.p_JK().x();
  const double speed = sliding_speed();
  for (const bool is_lower : {true, false}) {
    const int row = first_row + (is_lower ? 0 : 1);
    const double gap = is_lower ? offset - rail_.lower : rail_.upper - offset;
    const double approach = is_lower ? -speed : speed;
    LockPoint(pose, 0, 0, row, info);
    // Behind the limit: return inwards at a bounded speed. Within the range: allow the outward
    // speed (negative inwards) that ends at the limit.
    double inwards =
        gap < 0 ? std::min(-gap * kErrorReduction * info->fps, kMaxReturnSpeed) : -gap * info->fps;
    // Rebound in the step in which the slider would reach the limit.
    if (rail_.restitution > 0 && approach > kMinBounce && gap * info->fps <= approach) {
      inwards = std::max(inwards, rail_.restitution * approach);
      bounces_ = true;
    }
    // The row measures A's speed minus B's, the negative sliding speed.
    info->m_constraintError[row * info->rowskip] = is_lower ? -inwards : inwards;
    (is_lower ? info->m_upperLimit : info->m_lowerLimit)[row * info->rowskip] = 0;
  }
}

}  // namespace smile::physics
