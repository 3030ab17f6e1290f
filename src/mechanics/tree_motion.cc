#include "mechanics/tree_motion.h"

#include <cmath>

namespace smile::mechanics {
namespace {

// Products of matrix and vector by columns, since Eigen's are not inlined at -O2.

Vector3 Times(const Matrix3& m, const Vector3& v) {
  return m.col(0) * v.x() + m.col(1) * v.y() + m.col(2) * v.z();
}
Vector3 TransposedTimes(const Matrix3& m, const Vector3& v) {
  return {m.col(0).dot(v), m.col(1).dot(v), m.col(2).dot(v)};
}

/// Returns the acceleration of a point relative to another one of a turning body.
Vector3 Relative(const Vector3& w, const Vector3& w_dot, const Vector3& arm) {
  return w_dot.cross(arm) + w.cross(w.cross(arm));
}

}  // namespace

bool TreeMotion::Solve(double seconds) {
  next_.resize(links.size());
  accelerations_.resize(links.size());
  for (std::size_t i = 0; i < links.size(); ++i) {
    const JointGoal& goal = goals[i];
    if (goal.leader >= 0) continue;
    if (goal.wanted < goal.allowed.least || goal.wanted > goal.allowed.most) return false;
    next_[i] = goal.wanted;
  }
  for (std::size_t i = 0; i < links.size(); ++i) {
    const JointGoal& goal = goals[i];
    if (goal.leader >= 0) next_[i] = goal.ratio * next_[goal.leader] + goal.wanted;
    accelerations_[i] = (next_[i] - goal.v) / seconds;
  }
  EffortsFor(accelerations_);
  // The motor of a leader also moves what follows.
  for (std::size_t i = 0; i < links.size(); ++i) {
    const JointGoal& goal = goals[i];
    if (goal.leader >= 0) efforts_[goal.leader] += goal.ratio * efforts_[i];
  }
  for (std::size_t i = 0; i < links.size(); ++i) {
    const JointGoal& goal = goals[i];
    if (goal.leader < 0 && std::abs(efforts_[i]) * seconds > goal.max_impulse) return false;
  }
  return true;
}

std::span<const double> TreeMotion::EffortsFor(std::span<const double> accelerations) {
  states_.resize(links.size());
  efforts_.resize(links.size());
  // From the base outwards: how each link moves, and what that takes.
  for (std::size_t i = 0; i < links.size(); ++i) {
    const TreeLink& link = links[i];
    LinkState& own = states_[i];
    if (link.parent >= 0) {
      const LinkState& parent = states_[link.parent];
      own.w = Times(link.R_LP, parent.w);
      own.w_dot = Times(link.R_LP, parent.w_dot);
      own.a = Times(link.R_LP, parent.a);
    } else {
      own.w.setZero(), own.w_dot.setZero(), own.a.setZero();
    }
    const Vector3 velocity = goals[i].v * link.axis, acceleration = accelerations[i] * link.axis;
    if (link.is_revolute) {
      own.a += Relative(own.w, own.w_dot, link.p_PL - link.p_JL);
      own.w_dot += acceleration + own.w.cross(velocity);
      own.w += velocity;
      own.a += Relative(own.w, own.w_dot, link.p_JL);
    } else {
      own.a += Relative(own.w, own.w_dot, link.p_PL) + 2 * own.w.cross(velocity) + acceleration;
    }
    own.force = link.mass * own.a;
    const Vector3 momentum = link.inertia.cwiseProduct(own.w);
    own.torque = link.inertia.cwiseProduct(own.w_dot) + own.w.cross(momentum);
  }
  // And back: what each joint transmits.
  for (std::size_t i = links.size(); i-- > 0;) {
    const TreeLink& link = links[i];
    const LinkState& own = states_[i];
    const Vector3 about_joint = own.torque + link.p_JL.cross(own.force);
    efforts_[i] = link.axis.dot(link.is_revolute ? about_joint : own.force);
    if (link.parent < 0) continue;
    LinkState& parent = states_[link.parent];
    parent.force += TransposedTimes(link.R_LP, own.force);
    parent.torque += TransposedTimes(link.R_LP, own.torque + link.p_PL.cross(own.force));
  }
  return efforts_;
}

}  // namespace smile::mechanics
