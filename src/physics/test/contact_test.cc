#include <algorithm>
#include <cmath>
#include <numbers>

#include "physics/test/physics_fixture.h"

namespace smile::physics {
namespace {

constexpr double kEdge = 0.05;
/// Friction of two bodies with the coefficient of a BodySpec, and the angle at which they slip.
constexpr double kFriction = 0.6 * 0.6;
const double kSlipAngle = std::atan(kFriction);

double Radians(double degrees) { return degrees * std::numbers::pi / 180; }

/// Contacts of blocks that never fall asleep, on a plate in place of the table.
class ContactTest : public ::testing::Test {
 protected:
  static BodySpec BlockSpec(const Vector3& size, const RigidTransform& X_WB, double mass) {
    return PhysicsWorldBuilder::BlockSpec(size, X_WB, mass);
  }
  static BodySpec CubeSpec(double edge) {
    return BlockSpec(Vector3::Constant(edge), RigidTransform(Vector3(0, 0, edge / 2)), 0.1);
  }
  /// Adds a static plate whose upper face contains the origin.
  /// @param axis  horizontal axis about which it is turned by `angle`.
  void AddSlope(double angle, const Vector3& axis) {
    R_WS_ = Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
    world_.AddBody(BlockSpec({4, 4, 0.2}, RigidTransform(R_WS_, R_WS_ * Vector3(0, 0, -0.1)), 0));
  }
  /// Adds a block, given in the frame of the slope.
  BodyId AddBlock(const Vector3& size, const Vector3& p_SB) {
    return world_.AddBody(BlockSpec(size, RigidTransform(R_WS_, R_WS_ * p_SB), 0.1));
  }
  std::vector<BodyId> AddBlocks(int height, double x = 0) {
    std::vector<BodyId> stack;
    for (int i = 0; i < height; ++i) {
      stack.push_back(AddBlock(Vector3::Constant(kEdge), {x, 0, (i + 0.5) * kEdge}));
    }
    return stack;
  }
  void StepSeconds(double seconds) {
    const long steps = std::lround(seconds / world_.config().step_seconds);
    for (long i = 0; i < steps; ++i) world_.Step();
  }
  Vector3 PositionOf(BodyId id) const { return world_.body(id).pose_in_world().translation(); }

  Matrix3 R_WS_ = Matrix3::Identity();
  World world_{{.sleep_linear_speed = 0, .sleep_angular_speed = 0}};
};

// The plate tilts slowly, as one that a hand turns. Bullet's contacts hold the block up to 45
// degrees along an edge, and up to 56 across a corner.
TEST_F(ContactTest, ABlockSlipsOffATiltedPlateWhereFrictionEndsInEveryDirection) {
  for (const double yaw : {0.0, 20.0, 45.0}) {
    World world;
    BodySpec plate_spec = BlockSpec({0.6, 0.6, 0.1}, RigidTransform(Vector3(0, 0, -0.05)), 100);
    const BodyId plate = world.AddBody(plate_spec);
    const BodyId block = world.AddBody(CubeSpec(kEdge));
    world.body(plate).SetCarried(true);
    const Vector3 axis(std::sin(Radians(yaw)), std::cos(Radians(yaw)), 0);
    const double speed = Radians(5);
    const auto slid = [&] {
      const RigidTransform X_PlateBlock =
          world.body(plate).pose_in_world().inverse() * world.body(block).pose_in_world();
      return X_PlateBlock.translation().head<2>().norm();
    };
    double angle = 0;
    for (; angle < Radians(60) && slid() < 0.001; angle += speed * world.config().step_seconds) {
      world.body(plate).SetVelocity(Vector3::Zero(), speed * axis);
      world.Step();
    }
    EXPECT_NEAR(angle, kSlipAngle, Radians(1.2)) << "yaw " << yaw;
  }
}

TEST_F(ContactTest, AStackStaysOnASlope) {
  AddSlope(Radians(10), {0.3, 1, 0});
  const std::vector<BodyId> stack = AddBlocks(3);
  StepSeconds(1);
  const Vector3 settled = PositionOf(stack.back());
  StepSeconds(10);
  EXPECT_NEAR((PositionOf(stack.back()) - settled).norm(), 0, 5e-6);
}

// Also where they stand on each other with edges that coincide.
TEST_F(ContactTest, BlocksThatNeverSleepComeToAnExactRest) {
  AddSlope(0, Vector3::UnitX());
  std::vector<BodyId> blocks = AddBlocks(5);
  for (const BodyId id : AddBlocks(3, 0.075)) blocks.push_back(id);
  for (const BodyId id : AddBlocks(3, 0.225)) blocks.push_back(id);
  blocks.push_back(AddBlock({0.2, kEdge, kEdge}, {0.15, 0, 3.5 * kEdge}));
  StepSeconds(3);
  std::vector<Vector3> settled;
  for (const BodyId id : blocks) settled.push_back(PositionOf(id));
  StepSeconds(2);
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    EXPECT_EQ(PositionOf(blocks[i]), settled[i]) << "block " << i;
    // Each contact gives way by a few thousandths of a millimeter.
    EXPECT_TRUE(world_.body(blocks[i]).is_awake());
  }
  EXPECT_NEAR(settled[4].z(), 4.5 * kEdge, 5e-5);
}

// Without LoadSolver, cubes on each other sink by 0.13 mm, and the other two never come to rest.
TEST_F(ContactTest, AHighStackBearsItsWeightAtOnce) {
  constexpr int kHeight = 10;
  constexpr double kStackEdge = 0.1, kMostSag = 1.5e-5;  // [m]
  for (const double shift : {0.0, 0.01}) {
    for (const double turn : {0.0, 0.4}) {
      World world{{.sleep_linear_speed = 0, .sleep_angular_speed = 0}};
      world.AddBody(BlockSpec({4, 4, 0.2}, RigidTransform(Vector3(0, 0, -0.1)), 0));
      std::vector<BodyId> stack;
      for (int i = 0; i < kHeight; ++i) {
        const Quaternion q(Eigen::AngleAxisd(turn * i, Vector3::UnitZ()));
        const Vector3 p_WB(shift * (i % 3), shift * (i % 2), kStackEdge * (i + 0.5));
        stack.push_back(
            world.AddBody(BlockSpec(Vector3::Constant(kStackEdge), RigidTransform(q, p_WB), 1)));
      }
      for (int i = 0; i < 2 * 480; ++i) world.Step();
      for (int i = 0; i < kHeight; ++i) {
        const physics::Body& body = world.body(stack[i]);
        EXPECT_GT(body.pose_in_world().translation().z(), kStackEdge * (i + 0.5) - kMostSag);
        EXPECT_EQ(body.linear_velocity(), Vector3::Zero()) << shift << " " << turn << " " << i;
      }
    }
  }
}

TEST_F(ContactTest, ASlidingBlockStopsWhereFrictionHasTakenItsEnergyAndStaysThere) {
  for (const double yaw : {0.0, 45.0}) {
    World world;
    world.AddBody(BlockSpec({4, 4, 0.2}, RigidTransform(Vector3(0, 0, -0.1)), 0));
    const BodyId block = world.AddBody(CubeSpec(kEdge));
    const Vector3 direction(std::cos(Radians(yaw)), std::sin(Radians(yaw)), 0);
    for (int i = 0; i < 10; ++i) world.Step();
    world.body(block).SetVelocity(direction, Vector3::Zero());
    double farthest = 0;
    const auto distance = [&] {
      return world.body(block).pose_in_world().translation().head<2>().norm();
    };
    for (int i = 0; i < 480; ++i) {
      world.Step();
      farthest = std::max(farthest, distance());
    }
    EXPECT_NEAR(farthest, 1 / (2 * kFriction * 9.81), 0.008) << "yaw " << yaw;
    EXPECT_NEAR(distance(), farthest, 2e-4) << "yaw " << yaw;
  }
}

// The impulses of the last step hold the stack at rest, so that nothing is solved; the push ends
// that.
TEST_F(ContactTest, ABlockAtRestAnswersToAPush) {
  AddSlope(0, Vector3::UnitX());
  const std::vector<BodyId> stack = AddBlocks(2);
  StepSeconds(2);
  ASSERT_EQ(world_.body(stack[1]).linear_velocity(), Vector3::Zero());
  const Vector3 before = PositionOf(stack[1]);
  world_.body(stack[0]).SetVelocity({0.2, 0, 0}, Vector3::Zero());
  StepSeconds(0.1);
  EXPECT_GT(PositionOf(stack[1]).x(), before.x() + 1e-4);
}

}  // namespace
}  // namespace smile::physics
