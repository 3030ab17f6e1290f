// Commands for arms. Both forms become one: all joints in a column, arm by arm. Messages pack the
// general form like that; errors name the variables that scripts have.

#include "brain/internal_motor_reader.h"

#include <algorithm>

#include "base/wording.h"

namespace smile::brain {
namespace {

int NumJoints(std::span<const ArmDescription> arms) {
  int count = 0;
  for (const ArmDescription& arm : arms) count += arm.num_joints();
  return count;
}

/// Returns the first of an arm's joints among all.
int FirstJoint(std::span<const ArmDescription> arms, int arm) { return NumJoints(arms.first(arm)); }

/// Returns the arm that has a joint of all.
int ArmOf(std::span<const ArmDescription> arms, int joint) {
  int arm = 0;
  while (joint >= FirstJoint(arms, arm + 1)) ++arm;
  return arm;
}

/// Returns a name like `arms(2).velocities(3,1)`: of joint 3 in the first tick.
MatrixReader::NameElement NamesOfJoints(std::span<const ArmDescription> arms, const char* field) {
  return [arms, field](const NamedArray& array, Eigen::Index element) {
    const int joint = static_cast<int>(element % NumJoints(arms));
    const int arm = ArmOf(arms, joint);
    std::string name = "arms(" + std::to_string(arm + 1) + ")." + field + "(" +
                       std::to_string(joint - FirstJoint(arms, arm) + 1);
    if (array.dims[1] > 1) name += "," + std::to_string(element / NumJoints(arms) + 1);
    return name + ")";
  };
}

MatrixReader::NameElement NamesOfGrippers(std::size_t num_arms) {
  return [num_arms](const NamedArray&, Eigen::Index element) {
    return "arms(" + std::to_string(static_cast<std::size_t>(element) % num_arms + 1) +
           ").gripperVelocity";
  };
}

/// Returns 2x7 matrices, one per column in column-major order, as joints arm by arm.
Eigen::MatrixXd ArmByArm(const Eigen::MatrixXd& matrices) {
  Eigen::MatrixXd joints(matrices.rows(), matrices.cols());
  for (Eigen::Index tick = 0; tick < matrices.cols(); ++tick) {
    for (int arm = 0; arm < kLimbCount; ++arm) {
      for (int i = 0; i < kJointCount; ++i) {
        joints(arm * kJointCount + i, tick) = matrices(i * kLimbCount + arm, tick);
      }
    }
  }
  return joints;
}

/// Returns the part of each arm that is in the list; nullopt for the others.
std::vector<std::optional<std::vector<double>>> PostureOf(std::span<const ArmDescription> arms,
                                                          const Eigen::VectorXd& joints,
                                                          const std::vector<bool>& at_joints) {
  std::vector<std::optional<std::vector<double>>> posture(arms.size());
  for (int arm = 0; arm < static_cast<int>(arms.size()); ++arm) {
    if (!at_joints[arm]) continue;
    const auto values = joints.segment(FirstJoint(arms, arm), arms[arm].num_joints());
    posture[arm].emplace(values.begin(), values.end());
  }
  return posture;
}

/// Returns a list like `panda (7 joints), tray (1 joint)`.
std::string ListOf(std::span<const ArmDescription> arms) {
  std::string list;
  for (const ArmDescription& arm : arms) {
    list += (list.empty() ? "" : ", ") + arm.name + " (" + std::to_string(arm.num_joints()) +
            (arm.num_joints() == 1 ? " joint)" : " joints)");
  }
  return list;
}

/// Reports that a classic variable needs another robot, and its counterpart for this one.
void RefuseClassic(const std::string& field, const char* instead,
                   std::span<const ArmDescription> arms, MatrixReader* reader) {
  reader->Fail(field + " is for two arms of seven joints, but this robot has " + ListOf(arms) +
               ": use " + instead);
}

}  // namespace

MotorReader::MotorReader(std::span<const ArmDescription> arms, MatrixReader* reader)
    : arms_(arms), reader_(reader), at_joints_(arms.size()) {}

void MotorReader::Take(const NamedArray& field) {
  if (field.name == "headVelocity") {
    head_velocities_ = reader_->ReadTicks(field, 1, 1);
  } else if (field.name == "ticks") {
    ticks_ = reader_->ReadCount(field, kMaxChunkTicks);
  } else if (TakeClassic(field)) {
    classic_ = field.name == "jointAngles" ? "jointAngles" : "jointVelocities";
  } else if (TakeGeneral(field)) {
    has_general_ = true;
  } else {
    reader_->Fail(
        field.name + " is unknown, expected " +
        (IsClassic(arms_) ? "jointVelocities, gripperVelocities, jointAngles, arms, " : "arms, ") +
        "headVelocity or ticks");
  }
  if (classic_ != nullptr && has_general_) {
    reader_->Fail(std::string(classic_) + " and motor.arms are both set, expected one of them");
  }
}

bool MotorReader::TakeClassic(const NamedArray& field) {
  const bool is_classic = IsClassic(arms_);
  if (field.name == "jointVelocities") {
    if (!is_classic) RefuseClassic(field.name, "motor.arms(k).velocities", arms_, reader_);
    if (is_classic) velocities_ = ArmByArm(reader_->ReadTicks(field, kLimbCount, kJointCount));
  } else if (field.name == "gripperVelocities") {
    if (!is_classic) RefuseClassic(field.name, "motor.arms(k).gripperVelocity", arms_, reader_);
    // A row is accepted as well, since sensor.gripperOpening is one.
    const bool is_row = field.dims.size() == 2 && field.dims[0] == 1 && field.dims[1] == kLimbCount;
    if (is_classic) {
      gripper_velocities_ = is_row ? Eigen::MatrixXd(reader_->Read(field, 1, 2).transpose())
                                   : reader_->ReadTicks(field, kLimbCount, 1);
    }
  } else if (field.name == "jointAngles") {
    if (!is_classic) RefuseClassic(field.name, "motor.arms(k).joints", arms_, reader_);
    if (is_classic) {
      joints_ = ArmByArm(reader_->Read(field, kLimbCount, kJointCount).reshaped(14, 1));
      at_joints_.assign(arms_.size(), true);
    }
  } else {
    return false;
  }
  return true;
}

bool MotorReader::TakeGeneral(const NamedArray& field) {
  if (field.name == "armVelocities") {
    velocities_ =
        reader_->ReadTicks(field, NumJoints(arms_), 1, NamesOfJoints(arms_, "velocities"));
  } else if (field.name == "armGripperVelocities") {
    TakeGrippers(field);
  } else if (field.name == "armJoints") {
    joints_ = reader_->Read(field, NumJoints(arms_), 1, NamesOfJoints(arms_, "joints"));
  } else if (field.name == "armsAtJoints") {
    const Eigen::MatrixXd flags = reader_->Read(field, num_arms(), 1);
    for (int arm = 0; arm < num_arms(); ++arm) at_joints_[arm] = flags(arm, 0) != 0;
  } else {
    return false;
  }
  return true;
}

void MotorReader::TakeGrippers(const NamedArray& field) {
  gripper_velocities_ = reader_->ReadTicks(field, num_arms(), 1, NamesOfGrippers(arms_.size()));
  for (int arm = 0; arm < num_arms(); ++arm) {
    if (arms_[arm].gripper || gripper_velocities_->row(arm).isZero(0)) continue;
    reader_->Fail("arms(" + std::to_string(arm + 1) + ").gripperVelocity is set, but the arm " +
                  Quoted(arms_[arm].name) + " has no gripper");
  }
}

void MotorReader::CheckPosture() {
  const bool has_arms = std::ranges::find(at_joints_, true) != at_joints_.end();
  if (joints_.has_value() != has_arms) {
    reader_->Fail("armJoints and armsAtJoints belong together, found one of them");
  }
}

void MotorReader::Finish(StepReply* reply) {
  const bool is_general = has_general_ || !IsClassic(arms_);
  // With all arms at given joints their velocities are ignored, so only then may they be absent.
  const bool needs_velocities = std::ranges::find(at_joints_, false) != at_joints_.end();
  if (!velocities_ && needs_velocities) {
    reader_->Fail(is_general ? "arms is missing, expected an element for each arm"
                             : "jointVelocities is missing, expected 2x7");
  }
  if (!gripper_velocities_) {
    reader_->Fail(is_general ? "arms is missing, expected gripperVelocity in each element"
                             : "gripperVelocities is missing, expected 2x1");
  }
  CheckPosture();
  if (!reader_->ok()) return;
  if (!velocities_) velocities_ = Eigen::MatrixXd::Zero(NumJoints(arms_), 1);
  const Eigen::Index head_ticks = head_velocities_ ? head_velocities_->cols() : 0;
  const Eigen::Index longest =
      std::max({velocities_->cols(), gripper_velocities_->cols(), head_ticks});
  reply->ticks = ticks_.value_or(static_cast<int>(longest));
  const Posture posture = joints_ ? PostureOf(arms_, *joints_, at_joints_) : Posture(arms_.size());
  // The last value of each field remains in effect while others change.
  const auto at = [](const Eigen::MatrixXd& values, Eigen::Index tick) {
    return values.col(std::min(tick, values.cols() - 1));
  };
  reply->motors.clear();
  // A chunk may be longer than its `ticks`: the brain replans before its end.
  for (Eigen::Index tick = 0; tick < std::min<Eigen::Index>(longest, reply->ticks); ++tick) {
    Motor& motor = reply->motors.emplace_back();
    for (int arm = 0; arm < num_arms(); ++arm) {
      const auto velocities =
          at(*velocities_, tick).segment(FirstJoint(arms_, arm), arms_[arm].num_joints());
      motor.arms.push_back({.velocities = {velocities.begin(), velocities.end()},
                            .gripper_velocity = at(*gripper_velocities_, tick)[arm],
                            .joints = posture[arm]});
    }
    if (head_velocities_) motor.head_velocity = at(*head_velocities_, tick)[0];
  }
}

std::vector<std::optional<std::vector<double>>> MotorReader::ReadPosture(
    const Message& message, std::span<const ArmDescription> arms, MatrixReader* reader) {
  MotorReader motor(arms, reader);
  const NamedArray* classic = message.Find("initJointAngles");
  if (classic != nullptr && !IsClassic(arms)) {
    RefuseClassic(classic->name, "aux.arms(k).initJoints", arms, reader);
  } else if (classic != nullptr) {
    motor.joints_ = ArmByArm(reader->Read(*classic, kLimbCount, kJointCount).reshaped(14, 1));
    motor.at_joints_.assign(arms.size(), true);
  }
  for (const char* name : {"armJoints", "armsAtJoints"}) {
    const NamedArray* field = message.Find(name);
    if (field == nullptr) continue;
    if (classic != nullptr) reader->Fail("initJointAngles and aux.arms(k).initJoints are both set");
    motor.TakeGeneral(*field);
  }
  motor.CheckPosture();
  if (!motor.joints_ || !reader->ok()) return {};
  return PostureOf(arms, *motor.joints_, motor.at_joints_);
}

}  // namespace smile::brain
