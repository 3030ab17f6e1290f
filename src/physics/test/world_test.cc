#include "physics/world.h"

#include <gtest/gtest.h>

#include <thread>

#include "physics_fixture.h"

namespace smile::physics {
namespace {

class WorldTest : public PhysicsFixture {};

TEST_F(WorldTest, ATenHighStackStandsForAMinute) {
  constexpr double kMaxSettling = 0.0002, kMaxDrift = 0.0001;  // [m]
  AddTable();
  const std::vector<BodyId> stack = AddStack({0, 0, 0}, 10);
  const std::vector<RigidTransform> built = PosesOf(stack);
  StepSeconds(0.5);
  const std::vector<RigidTransform> settled = PosesOf(stack);
  StepSeconds(59.5);
  const std::vector<RigidTransform> after = PosesOf(stack);
  for (std::size_t i = 0; i < stack.size(); ++i) {
    // Built in the air without a gap, it takes its weight in the first tenths of a second.
    EXPECT_LT((after[i].translation() - built[i].translation()).norm(), kMaxSettling) << i;
    EXPECT_LT((after[i].translation() - settled[i].translation()).norm(), kMaxDrift) << i;
  }
}

TEST_F(WorldTest, AStackFallsAsleepAndStaysExactlyWhereItIs) {
  AddTable();
  const std::vector<BodyId> stack = AddStack({0, 0, 0}, 3);
  StepSeconds(4);
  EXPECT_TRUE(world_.is_at_rest());
  const std::uint64_t asleep = world_.state_hash();
  StepSeconds(1);
  EXPECT_EQ(world_.state_hash(), asleep);
}

TEST_F(WorldTest, ABlockFallsLikeAStone) {
  const BodyId block = AddCube({0, 0, 10}, 0.1);
  StepSeconds(1);
  // 0.2 of the velocity is lost per second, hence a little less than g/2.
  EXPECT_NEAR(10 - world_.body(block).pose_in_world().translation().z(), 9.81 / 2, 0.35);
}

TEST_F(WorldTest, ABodyThatLeanedOnARemovedOneWakesUp) {
  AddTable();
  const std::vector<BodyId> stack = AddStack({0, 0, 0}, 3);
  StepSeconds(4);
  world_.RemoveBody(stack[0]);
  StepSeconds(2);
  EXPECT_NEAR(world_.body(stack[1]).pose_in_world().translation().z(), 0.05, 0.001);
}

TEST_F(WorldTest, ACompositeTurnsAboutItsOriginNotItsShape) {
  // The only piece lies off the origin: thrown, the origin flies straight and the piece circles it.
  const std::vector<scene::Solid> solids = {
      {scene::Block{}, RigidTransform(Vector3(0.3, 0.1, 0)), Color{}, ""}};
  const BodyId id =
      world_.AddBody({.solids = solids, .mass = scene::MassPropertiesOf(solids, 1.0)});
  world_.body(id).SetCarried(true);  // weightless
  world_.body(id).SetVelocity(Vector3(0, 0, 0), Vector3(0, 0, 3));
  StepSeconds(0.5);
  EXPECT_LT(world_.body(id).pose_in_world().translation().norm(), 1e-9);
  EXPECT_GT(world_.body(id).pose_in_world().rotation()(1, 0), 0.9);
}

TEST_F(WorldTest, SameInputsGiveTheSameBits) {
  const auto run = [] {
    PhysicsWorldBuilder builder;
    builder.AddTable();
    builder.AddRobot();
    builder.AddPile(12, /*seed=*/7);
    builder.StepSeconds(2);
    return builder.world_.state_hash();
  };
  EXPECT_EQ(run(), run());
}

TEST_F(WorldTest, WorldsInThreadsDoNotDisturbOneAnother) {
  const auto run = [](std::uint64_t* hash) {
    PhysicsWorldBuilder builder;
    builder.AddTable();
    builder.AddRobot();
    builder.AddPile(12, /*seed=*/7);
    builder.SwingRobot(1);
    builder.StepSeconds(1);
    builder.world_.Restore(builder.world_.Save());
    builder.StepSeconds(1);
    *hash = builder.world_.state_hash();
  };
  std::uint64_t alone = 0, together[3] = {};
  run(&alone);
  std::vector<std::thread> threads;
  for (std::uint64_t& hash : together) threads.emplace_back(run, &hash);
  for (std::thread& thread : threads) thread.join();
  for (std::uint64_t hash : together) EXPECT_EQ(hash, alone);
}

TEST_F(WorldTest, ReportsWhichBodiesTouch) {
  const BodyId table =
      world_.AddBody(BlockSpec({2, 1.2, 0.4}, RigidTransform(Vector3(0, 0, -0.2)), 0));
  const BodyId low = AddCube({0, 0, 0.05}, 0.1), high = AddCube({0, 0, 0.15}, 0.1);
  AddCube({0.5, 0, 0.06}, 0.1);
  StepSeconds(1.0 / 480);
  EXPECT_EQ(world_.BodiesTouching(table), std::vector{low}) << "one is still 10 mm above it";
  EXPECT_EQ(world_.BodiesTouching(low), (std::vector{table, high}));
}

TEST_F(WorldTest, ABounceCountsAsContact) {
  for (int i = 0; i < 30; ++i) {
    World world;
    BodySpec ground = BlockSpec({1, 1, 0.1}, RigidTransform(Vector3(0, 0, -0.05)), 0);
    BodySpec cube = CubeSpec({0, 0, 0.2 + 0.03 * i}, 0.1);
    ground.restitution = cube.restitution = 1;
    const BodyId ground_id = world.AddBody(ground), cube_id = world.AddBody(cube);
    while (world.body(cube_id).linear_velocity().z() <= 0) {
      EXPECT_TRUE(world.BodiesTouching(ground_id).empty());
      world.Step();
    }
    EXPECT_EQ(world.BodiesTouching(ground_id), std::vector{cube_id}) << "dropped from " << i;
  }
}

TEST_F(WorldTest, AJointTurnsWithoutContacts) {
  scene::LinkSpec link{.max_velocity = 2, .max_effort = 50, .mass = 1};
  link.lower = -2;
  link.upper = 2;
  link.inertia = 0.01 * Matrix3::Identity();
  // One link in the way of another, if it had a shape.
  scene::ArticulationSpec spec{.links = {link, link}};
  spec.links[1].parent = 0;
  spec.links[1].solids = {{scene::Block{{0.1, 0.1, 0.1}}, {}, {}, ""}};
  Articulation& arm = world_.articulation(world_.AddArticulation(spec));
  arm.SetVelocityTarget(0, 1);
  arm.SetVelocityTarget(1, -0.5);
  StepSeconds(1);
  EXPECT_NEAR(arm.positions()[0], 1, 0.01);
  EXPECT_NEAR(arm.positions()[1], -0.5, 0.01);
}

TEST_F(WorldTest, RefusesWhatIsNotABody) {
  BodySpec bad = CubeSpec({0, 0, 0}, 0.1);
  bad.mass.mass = -1;
  EXPECT_THROW(world_.AddBody(bad), std::invalid_argument);
  EXPECT_THROW(world_.body(BodyId{99}), std::logic_error);
}

}  // namespace
}  // namespace smile::physics
