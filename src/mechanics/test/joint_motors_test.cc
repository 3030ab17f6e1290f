#include "mechanics/joint_motors.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "base/bytes.h"

namespace smile::mechanics {
namespace {

constexpr double kStepSeconds = 1.0 / 480;
constexpr MotorConfig kConfig;

/// A revolute joint, a slide, and a slide that mirrors the one before.
std::shared_ptr<const scene::ArticulationSpec> Arm() {
  scene::ArticulationSpec spec;
  scene::LinkSpec turn;
  turn.joint_name = "turn";
  turn.lower = -1;
  turn.upper = 1;
  turn.max_velocity = 2;
  turn.max_effort = 10;
  scene::LinkSpec slide = turn;
  slide.joint_name = "slide";
  slide.joint_type = scene::JointType::kPrismatic;
  slide.parent = 0;
  scene::LinkSpec mirror = slide;
  mirror.joint_name = "mirror";
  mirror.mimic = scene::Mimic{.leader = 1, .multiplier = -1, .offset = 0.25};
  spec.links = {turn, slide, mirror};
  return std::make_shared<const scene::ArticulationSpec>(spec);
}

/// Positions at which the mirror is where its leader takes it.
constexpr std::array<double, 3> kHome = {0, 0, 0.25};

/// Commands the joint and does not let it move.
void Block(int joint, double velocity, JointMotors* motors) {
  motors->SetVelocityTarget(joint, velocity, kHome);
  for (int step = 0; step < 480; ++step) motors->Drive(kHome, kStepSeconds);
}

template <class Call>
std::string MessageOf(Call call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(JointMotors, LeadsAreBounded) {
  JointMotors motors(Arm(), kConfig);
  Block(0, 2, &motors);
  Block(1, -2, &motors);
  EXPECT_EQ(motors.position_references()[0], kConfig.max_lead_angle);
  EXPECT_EQ(motors.position_references()[1], -kConfig.max_lead_length);
  // The reference stands still, so that only the correction of the error remains.
  const std::vector<DriveTarget> targets = motors.Drive(kHome, kStepSeconds);
  EXPECT_EQ(targets[0].velocity, kConfig.position_gain * kConfig.max_lead_angle / kStepSeconds);
}

TEST(JointMotors, ABlockedJointDropsItsLeadWhenToldToStopOrReverse) {
  for (const double velocity : {0.0, -1.0}) {
    JointMotors motors(Arm(), kConfig);
    Block(0, 2, &motors);
    motors.SetVelocityTarget(0, velocity, kHome);
    EXPECT_EQ(motors.position_references()[0], kHome[0]);
    EXPECT_EQ(motors.velocity_targets()[0], velocity);
  }
  JointMotors motors(Arm(), kConfig);
  Block(0, 2, &motors);
  motors.SetVelocityTarget(0, 1, kHome);
  EXPECT_EQ(motors.position_references()[0], kConfig.max_lead_angle) << "same direction";
}

TEST(JointMotors, TargetsAreClamped) {
  JointMotors motors(Arm(), kConfig);
  motors.SetVelocityTarget(0, 5, kHome);
  motors.SetVelocityTarget(1, -std::numeric_limits<double>::max(), kHome);
  EXPECT_EQ(motors.velocity_targets()[0], 2);
  EXPECT_EQ(motors.velocity_targets()[1], -2);
  EXPECT_EQ(motors.Drive(kHome, kStepSeconds)[0].velocity, 2 + kConfig.position_gain * 2);
}

TEST(JointMotors, ReferencesStayWithinLimits) {
  JointMotors motors(Arm(), kConfig);
  std::array<double, 3> q = kHome;
  EXPECT_EQ(motors.Place(std::array{0}, std::array{7.0}, q), (std::vector<int>{0}));
  EXPECT_EQ(q[0], 1);
  motors.SetVelocityTarget(0, 2, q);
  EXPECT_EQ(motors.Drive(q, kStepSeconds)[0].velocity, 0);
  motors.AdvanceKinematic(q, kStepSeconds);
  EXPECT_EQ(motors.position_references()[0], 1);
}

TEST(JointMotors, RefusesWhatIsNoCommandByTheNameOfTheJoint) {
  JointMotors motors(Arm(), kConfig);
  const double nan = std::nan("");
  EXPECT_EQ(MessageOf([&] { motors.SetVelocityTarget(0, nan, kHome); }),
            "turn: velocity is not finite");
  EXPECT_EQ(MessageOf([&] { motors.SetVelocityTarget(2, 1, kHome); }),
            "mirror: it mimics slide, expected a joint with a motor");
  EXPECT_EQ(MessageOf([&] { motors.HoldStill(3, kHome); }), "joint is 3, expected 0 to 2");
  std::array<double, 3> q = kHome;
  EXPECT_EQ(MessageOf([&] {
              motors.Place(std::array{0, 1}, std::array{0.5, nan}, q);
            }),
            "slide: position is not finite");
  EXPECT_EQ(q, kHome) << "a refused command changes nothing";
}

TEST(JointMotors, FollowersGoWhereTheirLeadersAre) {
  JointMotors motors(Arm(), kConfig);
  std::array<double, 3> q = kHome;
  EXPECT_EQ(motors.Place(std::array{1}, std::array{0.5}, q), (std::vector<int>{1, 2}));
  EXPECT_EQ(q, (std::array{0.0, 0.5, -0.25}));
  q[2] = -0.5;
  const DriveTarget coupling = motors.Drive(q, kStepSeconds)[2];
  EXPECT_GT(coupling.velocity, 0);
  EXPECT_EQ(motors.position_references()[2], -0.25);
}

TEST(JointMotors, AnOverloadLeavesTheListedEffortForOneStep) {
  JointMotors motors(Arm(), kConfig);
  motors.NoteOverload(1);
  for (const double scale : {1.0, kConfig.effort_scale}) {
    const std::vector<DriveTarget> targets = motors.Drive(kHome, kStepSeconds);
    EXPECT_EQ(targets[0].max_impulse, 10 * scale * kStepSeconds);
    EXPECT_EQ(targets[1].max_impulse, 10 * scale * kStepSeconds);
  }
}

TEST(JointMotors, GoesBackToASavedState) {
  JointMotors motors(Arm(), kConfig);
  Block(0, 2, &motors);
  ByteWriter out;
  for (int joint = 0; joint < 3; ++joint) motors.Save(joint, &out);
  JointMotors other(Arm(), kConfig);
  ByteReader in(out.bytes());
  for (int joint = 0; joint < 3; ++joint) other.Restore(joint, &in);
  EXPECT_EQ(other.velocity_targets()[0], 2);
  EXPECT_EQ(other.Drive(kHome, kStepSeconds)[0].velocity,
            motors.Drive(kHome, kStepSeconds)[0].velocity);
  EXPECT_FALSE(other.is_at_rest(kHome, std::array{0.0, 0.0, 0.0}));
}

}  // namespace
}  // namespace smile::mechanics
