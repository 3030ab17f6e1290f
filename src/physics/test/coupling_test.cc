#include "physics/test/physics_fixture.h"

namespace smile::physics {
namespace {

/// A slider along x, and another one, on the base as well, that mimics it.
class Coupling : public testing::TestWithParam<bool>, protected PhysicsWorldBuilder {
 protected:
  Coupling() {
    scene::LinkSpec link{.joint_type = scene::JointType::kPrismatic,
                         .axis = Vector3::UnitX(),
                         .lower = -1,
                         .upper = 1,
                         .max_velocity = 1,
                         .max_effort = 20,
                         .mass = 1};
    link.inertia = 0.01 * Matrix3::Identity();
    spec_.links = {link, link};
    spec_.links[0].mimic = scene::Mimic{.leader = 1, .multiplier = -0.5, .offset = 0.1};
    spec_.links[0].solids = {{scene::Block{{0.1, 0.1, 0.1}}, {}, {}, ""}};
    spec_.links[0].X_PJ = RigidTransform(Vector3(0, 0, 0.06));
    spec_.links[1].X_PJ = RigidTransform(Vector3(0, 1, 0));
    spec_.is_kinematic = GetParam();
  }
  static void ExpectCoupled(const Articulation& sliders, double tolerance) {
    const std::vector<double> q = sliders.positions();
    EXPECT_NEAR(q[0], -0.5 * q[1] + 0.1, tolerance);
  }

  scene::ArticulationSpec spec_;
};

TEST_P(Coupling, KeepsTheRatioWhileTheLeaderMoves) {
  Articulation& sliders = world_.articulation(world_.AddArticulation(spec_));
  sliders.SetVelocityTarget(1, 0.4);
  for (int i = 0; i < 100; ++i) {
    world_.Step();
    ExpectCoupled(sliders, 1e-5);
  }
  EXPECT_NEAR(sliders.positions()[1], 0.4 * 100 / 480, 0.005);
  sliders.SetVelocityTarget(1, 0);
  StepSeconds(1);
  EXPECT_TRUE(sliders.is_at_rest());
  EXPECT_THROW(sliders.SetVelocityTarget(0, 0.1), std::invalid_argument);
}

TEST_P(Coupling, HoldsForPositionsThatAreSetAtOnce) {
  Articulation& sliders = world_.articulation(world_.AddArticulation(spec_));
  ExpectCoupled(sliders, 0);
  sliders.SetPositions(std::vector{1}, std::vector{0.6});
  EXPECT_EQ(sliders.positions(), (std::vector{-0.5 * 0.6 + 0.1, 0.6}));
  sliders.SetPositions(std::vector{0, 1}, std::vector{0.7, 0.2});
  ExpectCoupled(sliders, 0);
}

TEST_P(Coupling, MovesTheLoadOfTheFollowerByTheLeader) {
  Articulation& sliders = world_.articulation(world_.AddArticulation(spec_));
  // In the way of the follower, which moves to -x.
  AddTable();
  const BodyId block = AddCube({-0.05, 0, 0.05}, 0.1);
  sliders.SetVelocityTarget(1, 0.5);
  for (int i = 0; i < 240; ++i) {
    world_.Step();
    ExpectCoupled(sliders, 1e-3);
  }
  EXPECT_LT(world_.body(block).pose_in_world().translation().x(), -0.1) << "it is pushed";
}

TEST_P(Coupling, IsPartOfASnapshot) {
  Articulation& sliders = world_.articulation(world_.AddArticulation(spec_));
  sliders.SetVelocityTarget(1, 0.4);
  StepSeconds(0.2);
  const Snapshot snapshot = mechanics::ParseSnapshot(mechanics::Serialize(world_.Save()));
  EXPECT_EQ(*snapshot.articulations[0].spec, spec_);
  StepSeconds(0.3);
  const std::uint64_t hash = world_.state_hash();
  World other;
  other.Restore(snapshot);
  for (int i = 0; i < 144; ++i) other.Step();
  EXPECT_EQ(other.state_hash(), hash);
  // Of leaders that follow or do not exist, there is none.
  for (const int leader : {0, 2, -1}) {
    Snapshot bad = snapshot;
    scene::ArticulationSpec broken = spec_;
    broken.links[0].mimic->leader = leader;
    bad.articulations[0].spec = std::make_shared<scene::ArticulationSpec>(broken);
    EXPECT_THROW(World().Restore(bad), std::invalid_argument) << leader;
  }
}

INSTANTIATE_TEST_SUITE_P(Each, Coupling, testing::Values(false, true),
                         [](const auto& is_kinematic) {
                           return is_kinematic.param ? "Kinematic" : "Dynamic";
                         });

}  // namespace
}  // namespace smile::physics
