#include "physics/internal_joint_constraint.h"

#include <algorithm>
#include <cmath>

#include "base/overloaded.h"

namespace smile::physics {
namespace {

/// Share of a joint's error that is taken back in a step.
constexpr double kErrorReduction = 0.3;
/// What came apart comes back no faster than this [m/s], [rad/s].
constexpr double kMaxReturnSpeed = 2.0;
constexpr double kMaxReturnTurn = 10.0;
/// Slower than this a slider does not bounce off its limit [m/s].
constexpr double kMinBounce = 0.05;
/// Put elsewhere by more than this, a held slider stays at its new place [m].
constexpr double kMaxHeldError = 0.005;

constexpr int kFirstRailRow = 5;

/// The rotation vector of R [rad].
btVector3 TurnOf(const btMatrix3x3& R) {
  btQuaternion q;
  R.getRotation(q);
  if (q.w() < 0) q = -q;
  const btVector3 v(q.x(), q.y(), q.z());
  const double sine = v.length();
  return sine < 1e-12 ? v * 2 : v * (2 * std::atan2(sine, q.w()) / sine);
}

void PutVector(const btVector3& v, int row, int rowskip, btScalar* to) {
  for (int i = 0; i < 3; ++i) to[row * rowskip + i] = v[i];
}

}  // namespace

std::optional<std::pair<BodyId, BodyId>> BodyPairOf(const JointSpec& spec) {
  return std::visit(
      Overloaded{[](const WeldSpec&) -> std::optional<std::pair<BodyId, BodyId>> { return {}; },
                 [](const auto& pair) -> std::optional<std::pair<BodyId, BodyId>> {
                   return std::pair(pair.a, pair.b);
                 }},
      spec);
}

bool DoCollide(const JointSpec& spec) {
  const auto* slider = std::get_if<SliderJointSpec>(&spec);
  return slider != nullptr && slider->do_collide;
}

struct JointConstraint::Pose {
  btTransform X_WJ, X_WK;
  btVector3 p_AcmK, p_BcmK;  ///< from the centres of mass to K's origin, along world axes

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
  held_offset_ = std::clamp(offset(), rail_.lower, rail_.upper);
}

JointConstraint::Pose JointConstraint::PoseNow() const {
  Pose pose;
  pose.X_WJ = m_rbA.getCenterOfMassTransform() * X_AcmJ_;
  pose.X_WK = m_rbB.getCenterOfMassTransform() * X_BcmK_;
  pose.p_AcmK = pose.X_WK.getOrigin() - m_rbA.getCenterOfMassPosition();
  pose.p_BcmK = pose.X_WK.getOrigin() - m_rbB.getCenterOfMassPosition();
  return pose;
}

void JointConstraint::HoldUnless(bool is_carried) {
  const bool shall_hold = rail_.damping >= 1 && !is_carried;
  const bool was_held = is_held_;
  is_held_ = shall_hold;
  if (is_held_ != was_held) is_pressed_ = {};
  const double now = offset();
  if (!was_held || !is_held_ || std::abs(now - held_offset_) > kMaxHeldError) {
    held_offset_ = std::clamp(now, rail_.lower, rail_.upper);
  }
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
         is_pressed_[row - kFirstRailRow];
}

void JointConstraint::NoteImpulse(int row, double impulse) {
  if (row < kFirstRailRow || kind_ != Kind::kSlider || has_one_place()) return;
  const double inwards = row == kFirstRailRow ? -impulse : impulse;
  is_pressed_[row - kFirstRailRow] = inwards > 0 && !bounces_;
}

void JointConstraint::Save(ByteWriter* out) const {
  out->Put(is_held_);
  out->Put(held_offset_);
  for (bool is_pressed : is_pressed_) out->Put(is_pressed);
}

void JointConstraint::Restore(ByteReader* in) {
  is_held_ = in->Get<bool>();
  held_offset_ = in->Get<double>();
  for (bool& is_pressed : is_pressed_) is_pressed = in->Get<bool>();
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
    LockPoint(pose, 0, p_JK.x() - (is_held_ ? held_offset_ : rail_.lower), row, info);
  } else {
    StopAtLimits(pose, row, info);
  }
}

/// Holds K's origin at its place along an axis of J.
void JointConstraint::LockPoint(const Pose& pose, int axis, double error, int row,
                                btConstraintInfo2* info) const {
  const btVector3 n = pose.axis(axis);
  PutVector(n, row, info->rowskip, info->m_J1linearAxis);
  PutVector(pose.p_AcmK.cross(n), row, info->rowskip, info->m_J1angularAxis);
  PutVector(-n, row, info->rowskip, info->m_J2linearAxis);
  PutVector(-pose.p_BcmK.cross(n), row, info->rowskip, info->m_J2angularAxis);
  info->m_constraintError[row * info->rowskip] =
      std::clamp(kErrorReduction * info->fps * error, -kMaxReturnSpeed, kMaxReturnSpeed);
}

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

/// One row for each limit; either only pushes inwards. A limit out of reach allows just the speed
/// that ends at it.
void JointConstraint::StopAtLimits(const Pose& pose, int first_row, btConstraintInfo2* info) {
  const double offset = pose.p_JK().x();
  const double speed = sliding_speed();
  for (const bool is_lower : {true, false}) {
    const int row = first_row + (is_lower ? 0 : 1);
    const double gap = is_lower ? offset - rail_.lower : rail_.upper - offset;
    const double approach = is_lower ? -speed : speed;
    LockPoint(pose, 0, 0, row, info);
    double inwards =
        gap < 0 ? std::min(-gap * kErrorReduction * info->fps, kMaxReturnSpeed) : -gap * info->fps;
    if (rail_.restitution > 0 && approach > kMinBounce && gap * info->fps <= approach) {
      inwards = std::max(inwards, rail_.restitution * approach);
      bounces_ = true;
    }
    // The row counts A's speed against B's, that is outwards at the upper limit as negative.
    info->m_constraintError[row * info->rowskip] = is_lower ? -inwards : inwards;
    (is_lower ? info->m_upperLimit : info->m_lowerLimit)[row * info->rowskip] = 0;
  }
}

}  // namespace smile::physics
