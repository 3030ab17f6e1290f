#include "mechanics/joint_motors.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "base/bytes.h"
#include "base/state_hash.h"

namespace smile::mechanics {
namespace {

/// A joint below this speed and this close to its reference is at rest [rad/s or m/s; rad or m].
constexpr double kRest = 1e-7;

/// Fraction of the error of a coupling that is corrected in each physics step. It may be more than
/// that of motors, since nothing that gives way is behind it.
constexpr double kCouplingGain = 0.5;

}  // namespace

JointMotors::JointMotors(std::shared_ptr<const scene::ArticulationSpec> spec,
                         const MotorConfig& config)
    : spec_(std::move(spec)),
      config_(config),
      velocity_targets_(spec_->links.size(), 0.0),
      position_references_(spec_->links.size(), 0.0),
      is_overloaded_(spec_->links.size(), false) {}

void JointMotors::CheckJoint(int joint) const {
  if (joint < 0 || joint >= num_joints()) {
    throw std::invalid_argument("joint is " + std::to_string(joint) + ", expected 0 to " +
                                std::to_string(num_joints() - 1));
  }
}

double JointMotors::MaxLead(int joint) const {
  return spec_->links[joint].joint_type == scene::JointType::kRevolute ? config_.max_lead_angle
                                                                       : config_.max_lead_length;
}

void JointMotors::SetVelocityTarget(int joint, double velocity, std::span<const double> q) {
  CheckJoint(joint);
  const scene::LinkSpec& link = spec_->links[joint];
  if (!std::isfinite(velocity)) {
    throw std::invalid_argument(link.joint_name + ": velocity is not finite");
  }
  if (link.mimic) {
    throw std::invalid_argument(link.joint_name + ": it mimics " +
                                spec_->links[link.mimic->leader].joint_name +
                                ", expected a joint with a motor");
  }
  const double target = std::clamp(velocity, -link.max_velocity, link.max_velocity);
  // A lead above half its bound means that the joint is blocked; ordinary lag is smaller.
  const double lead = position_references_[joint] - q[joint];
  const bool is_blocked = std::abs(lead) > MaxLead(joint) / 2;
  // Drops the lead when a blocked joint is commanded to stop or reverse: it would continue to push
  // until the reference had come back.
  if (is_blocked && target != velocity_targets_[joint] && lead * target <= 0) HoldStill(joint, q);
  velocity_targets_[joint] = target;
}

void JointMotors::HoldStill(int joint, std::span<const double> q) {
  CheckJoint(joint);
  velocity_targets_[joint] = 0;
  position_references_[joint] = q[joint];
}

/// Moves references along with the joints: otherwise motors would pull them back.
std::vector<int> JointMotors::Place(std::span<const int> joints, std::span<const double> positions,
                                    std::span<double> q) {
  if (positions.size() != joints.size()) {
    throw std::invalid_argument("positions are " + std::to_string(positions.size()) +
                                ", expected one for each of " + std::to_string(joints.size()) +
                                " joints");
  }
  for (std::size_t i = 0; i < joints.size(); ++i) {
    CheckJoint(joints[i]);
    if (!std::isfinite(positions[i])) {
      throw std::invalid_argument(spec_->links[joints[i]].joint_name + ": position is not finite");
    }
  }
  std::vector<bool> is_named(num_joints(), false);
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const scene::LinkSpec& link = spec_->links[joints[i]];
    q[joints[i]] = std::clamp(positions[i], link.lower, link.upper);
    is_named[joints[i]] = true;
  }
  std::vector<double> followed(q.begin(), q.end());
  scene::FollowLeaders(spec_->links, followed);
  std::vector<int> moved;
  for (int i = 0; i < num_joints(); ++i) {
    const auto& mimic = spec_->links[i].mimic;
    if (!is_named[i] && !(mimic && is_named[mimic->leader])) continue;
    position_references_[i] = q[i] = followed[i];
    moved.push_back(i);
  }
  return moved;
}

bool JointMotors::is_at_rest(std::span<const double> q, std::span<const double> v) const {
  for (int i = 0; i < num_joints(); ++i) {
    if (velocity_targets_[i] != 0 || std::abs(v[i]) > kRest ||
        std::abs(q[i] - position_references_[i]) > kRest) {
      return false;
    }
  }
  return true;
}

/// Marks all joints from the link to the base: each of them bears its weight.
void JointMotors::NoteOverload(int link) {
  for (int i = link; i >= 0; i = spec_->links[i].parent) is_overloaded_[i] = true;
}

std::vector<DriveTarget> JointMotors::Drive(std::span<const double> q, double step_seconds) {
  std::vector<DriveTarget> targets(num_joints());
  for (int i = 0; i < num_joints(); ++i) {
    targets[i] = spec_->links[i].mimic ? DriveCoupling(i, q, step_seconds)
                                       : DriveMotor(i, q[i], step_seconds);
  }
  // Noted again before each step, as long as a weld bears too much.
  is_overloaded_.assign(is_overloaded_.size(), false);
  return targets;
}

DriveTarget JointMotors::DriveMotor(int joint, double q, double step_seconds) {
  const scene::LinkSpec& link = spec_->links[joint];
  const double max_lead = MaxLead(joint);
  // The reference advances with the commanded speed, but leads the joint by a bounded amount only,
  // and stays within the limits.
  const double wanted = position_references_[joint] + velocity_targets_[joint] * step_seconds;
  const double reference =
      std::clamp(std::clamp(wanted, q - max_lead, q + max_lead), link.lower, link.upper);
  // At a limit or when blocked, the reference stops, and so does the commanded speed.
  const double speed = reference == wanted
                           ? velocity_targets_[joint]
                           : (reference - position_references_[joint]) / step_seconds;
  position_references_[joint] = reference;

  // Velocity feedforward plus proportional correction; the solver provides the force, up to the
  // effort.
  const double return_speed = config_.position_gain * (reference - q) / step_seconds;
  const double effort = link.max_effort * (is_overloaded_[joint] ? 1.0 : config_.effort_scale);
  return {speed + return_speed, effort * step_seconds};
}

/// A coupling keeps the ratio of velocities, and corrects what remains of errors of position.
DriveTarget JointMotors::DriveCoupling(int joint, std::span<const double> q, double step_seconds) {
  const scene::Mimic& mimic = *spec_->links[joint].mimic;
  const double reference = mimic.multiplier * q[mimic.leader] + mimic.offset;
  position_references_[joint] = reference;
  return {kCouplingGain * (reference - q[joint]) / step_seconds, 0};
}

void JointMotors::AdvanceKinematic(std::span<const double> q, double step_seconds) {
  for (int i = 0; i < num_joints(); ++i) {
    const scene::LinkSpec& link = spec_->links[i];
    position_references_[i] =
        std::clamp(q[i] + velocity_targets_[i] * step_seconds, link.lower, link.upper);
  }
  scene::FollowLeaders(spec_->links, position_references_);
}

void JointMotors::Save(int joint, ByteWriter* out) const {
  out->Put(velocity_targets_[joint]);
  out->Put(position_references_[joint]);
}

void JointMotors::Restore(int joint, ByteReader* in) {
  velocity_targets_[joint] = in->Get<double>();
  position_references_[joint] = in->Get<double>();
}

void JointMotors::AddTo(StateHash* hash) const {
  // Overloads are not hashed: each step sets them before it uses them.
  hash->Add(velocity_targets_);
  hash->Add(position_references_);
}

}  // namespace smile::mechanics
