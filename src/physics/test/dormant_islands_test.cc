// Sleeping islands are left out of a step, and nobody can tell.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

#include "physics_fixture.h"

namespace smile::physics {
namespace {

/// Stacks and a pile at rest, beside a robot if the seed is even, among mechanisms and fixtures if
/// it is above 6, and random things that happen to them.
class EventfulWorld : public PhysicsWorldBuilder {
 public:
  explicit EventfulWorld(unsigned seed) : random_(seed) {
    AddTable();
    if (seed % 2 == 0) AddRobot(/*is_kinematic=*/seed == 8 || seed == 12);
    if (seed > 6) AddMechanisms();
    for (int i = 0; i < 5; ++i) {
      for (BodyId id : AddStack({-0.6 + 0.3 * i, 0.35, 0}, 1 + i % 3)) bodies_.push_back(id);
    }
    for (BodyId id : AddPile(6, seed)) bodies_.push_back(id);
    StepSeconds(4);
  }

  /// Does something to some of the bodies; the same in each world of the same seed.
  void LetSomethingHappen() {
    world_.body(carried_ ? carried_ : AnyBody()).SetCarried(false);
    carried_ = {};
    Body& body = world_.body(AnyBody());
    const RigidTransform above(body.pose_in_world().translation() + Vector3(0, 0, 0.4));
    switch (random_() % (fixtures_.empty() ? 9 : 10)) {
      case 0:
        return body.SetVelocity({Uniform(), Uniform(), 1}, {0, 0, Uniform()});
      case 1:
        return body.SetPose(above);
      case 2:
        bodies_.push_back(AddCube(above.translation(), 0.1));
        return;
      case 3:
        if (bodies_.size() > 10) world_.RemoveBody(Take(body.id()));
        return;
      case 4:
        return world_.ChangeForm(body.id(), {{scene::Block{{0.1, 0.14, 0.1}}, {}, Color{}, ""}},
                                 body.spec().mass);
      case 5:
        if (const BodyId other = AnyBody(); other != body.id()) {
          const RigidTransform X_AB =
              body.pose_in_world().inverse() * world_.body(other).pose_in_world();
          world_.AddJoint(FixedJointSpec{.a = body.id(), .b = other, .X_AB = X_AB});
        }
        return;
      case 6:
        if (const BodyId other = AnyBody(); other != body.id()) {
          world_.IgnoreCollisionUntilSeparated(body.id(), other);
        }
        return;
      case 7:
        if (robot_) SwingRobot(Uniform());
        return;
      case 9:
        return MoveFixture();
      default:
        // Carried through everything at the height of the blocks.
        carried_ = body.id();
        body.SetCarried(true);
        body.SetVelocity({0.8 * Uniform(), 0.8 * Uniform(), 0.05}, Vector3::Zero());
    }
  }

  /// Ends what keeps a world awake.
  void LetAllRest() {
    if (carried_) world_.body(carried_).SetCarried(false);
    carried_ = {};
    for (int i = 0; robot_ && i < world_.articulation(robot_).num_joints(); ++i) {
      world_.articulation(robot_).SetVelocityTarget(i, 0);
    }
  }

  const std::vector<BodyId>& bodies() const { return bodies_; }

 private:
  /// Adds boxes with lids, a cabinet with drawers, a chain, and static posts, one with a rail.
  void AddMechanisms() {
    for (int i = 0; i < 3; ++i) {
      const Vector3 p_WB(-0.7 + 0.25 * i, -0.3, 0.05);
      const BodyId box = AddCube(p_WB, 0.1);
      AddSliderTo(box, p_WB, Vector3(0, 0, 0.07), 0.4 * i);
    }
    const Vector3 p_WC(0.3, -0.3, 0.1);
    const BodyId cabinet = world_.AddBody(BlockSpec({0.1, 0.3, 0.2}, RigidTransform(p_WC), 2.0));
    for (int i = 0; i < 3; ++i) AddSliderTo(cabinet, p_WC, Vector3(0.1, 0.1 * (i - 1), 0), 0.3);
    bodies_.push_back(cabinet);
    for (int i = 0; i < 4; ++i) {
      bodies_.push_back(AddCube({0.6, -0.4 + 0.12 * i, 0.05}, 0.1));
      if (i == 0) continue;
      world_.AddJoint(BallJointSpec{.a = bodies_[bodies_.size() - 2],
                                    .b = bodies_.back(),
                                    .p_AQ = Vector3(0, 0.06, 0),
                                    .p_BQ = Vector3(0, -0.06, 0)});
    }
    for (int i = 0; i < 5; ++i) {
      const Vector3 p_WB(-0.45 + 0.3 * i, 0.2 - 0.1 * (i % 3), 0.06);
      fixtures_.push_back(world_.AddBody(BlockSpec({0.05, 0.05, 0.12}, RigidTransform(p_WB), 0)));
      if (i == 2) AddSliderTo(fixtures_.back(), p_WB, Vector3(0, 0, 0.1), 1.0);
    }
  }
  /// Adds a plate that slides along x on a body.
  void AddSliderTo(BodyId base, const Vector3& p_WB, const Vector3& p_BP, double damping) {
    const RigidTransform X_WP(Vector3(p_WB + p_BP));
    bodies_.push_back(world_.AddBody(BlockSpec({0.08, 0.08, 0.03}, X_WP, 0.3)));
    world_.AddJoint(SliderJointSpec{.a = base,
                                    .b = bodies_.back(),
                                    .X_AJ = RigidTransform(p_BP),
                                    .lower = 0,
                                    .upper = 0.05,
                                    .damping = damping});
  }
  void MoveFixture() {
    Body& fixture = world_.body(fixtures_[random_() % fixtures_.size()]);
    Vector3 p_WB = fixture.pose_in_world().translation();
    p_WB.x() += 0.1 * Uniform();
    fixture.SetPose(RigidTransform(p_WB));
  }
  double Uniform() { return random_() / 2147483648.0 - 1; }
  BodyId AnyBody() { return bodies_[random_() % bodies_.size()]; }
  BodyId Take(BodyId id) {
    std::erase(bodies_, id);
    return id;
  }

  std::mt19937 random_;
  std::vector<BodyId> bodies_, fixtures_;
  BodyId carried_;
};

/// Returns a snapshot that shares nothing with the world.
Snapshot Copy(const Snapshot& snapshot) { return mechanics::ParseSnapshot(Serialize(snapshot)); }

class DormantIslandsProperty : public ::testing::TestWithParam<unsigned> {};

TEST_P(DormantIslandsProperty, LeavingOutSleepersChangesNoBit) {
  constexpr int kRounds = 25, kSteps = 150, kStepsToRest = 1000;
  EventfulWorld usual(GetParam()), complete(GetParam());
  for (int round = 0; round < kRounds; ++round) {
    usual.LetSomethingHappen();
    complete.LetSomethingHappen();
    const bool rests = round % 5 == 4;
    if (rests) usual.LetAllRest(), complete.LetAllRest();
    for (int i = 0; i < (rests ? kStepsToRest : kSteps); ++i) {
      usual.world_.Step();
      // A world that was restored from a copy contains everything, asleep or not.
      if (!complete.world_.is_at_rest()) complete.world_.Restore(Copy(complete.world_.Save()));
      complete.world_.Step();
      ASSERT_EQ(usual.world_.state_hash(), complete.world_.state_hash())
          << "round " << round << ", step " << i;
    }
    // The first save keeps the states of sleepers, which the second one takes.
    for (int i = 0; i < 2; ++i) {
      ASSERT_EQ(Serialize(usual.world_.Save()), Serialize(complete.world_.Save()))
          << "round " << round;
    }
    for (BodyId id : usual.bodies()) {
      EXPECT_EQ(usual.world_.BodiesTouching(id), complete.world_.BodiesTouching(id));
    }
  }
}

/// What is restored in place leaves alone what did not change. It must not matter what there was.
TEST_P(DormantIslandsProperty, GoingBackAndForthInOneWorldIsLikeBeginningAFreshOne) {
  constexpr int kRounds = 30, kSteps = 40;
  EventfulWorld eventful(GetParam());
  World& world = eventful.world_;
  std::mt19937 random(GetParam());
  std::vector<Snapshot> kept = {world.Save()};
  for (int round = 0; round < kRounds; ++round) {
    eventful.LetSomethingHappen();
    for (int i = 0; i < kSteps; ++i) world.Step();
    kept.push_back(world.Save());
    for (int i = 0; i < 3; ++i) {
      const Snapshot& from = kept[random() % kept.size()];
      World fresh;
      fresh.Restore(Copy(from));
      world.Restore(from);
      ASSERT_EQ(Serialize(world.Save()), Serialize(from)) << "round " << round;
      for (int k = 0; k < kSteps; ++k) {
        world.Step();
        fresh.Step();
        ASSERT_EQ(world.state_hash(), fresh.state_hash()) << "round " << round << ", step " << k;
      }
      ASSERT_EQ(Serialize(world.Save()), Serialize(fresh.Save())) << "round " << round;
    }
    // Then on from where the round ended.
    world.Restore(kept.back());
  }
}

/// Poses of all bodies, and the moment at which they were taken.
struct KnownPoses {
  explicit KnownPoses(const World& world) : moment(world.now()) {
    for (const Snapshot::BodyEntry& entry : world.Save().bodies) {
      poses.emplace(entry.id, world.body(entry.id).pose_in_world());
    }
  }

  Moment moment;
  std::map<BodyId, RigidTransform> poses;
};

TEST_P(DormantIslandsProperty, AllThatChangedSinceAMomentIsReported) {
  constexpr int kRounds = 60;
  EventfulWorld eventful(GetParam());
  World& world = eventful.world_;
  std::mt19937 random(GetParam());
  std::vector<Snapshot> kept = {world.Save()};
  KnownPoses known(world);
  const auto step = [&world, &random] {
    // Some bodies fall asleep only in the longer times.
    for (std::size_t i = random() % 4 == 0 ? 800 : random() % 20; i > 0; --i) world.Step();
  };
  int num_unreported = 0, num_removals = 0;
  for (int round = 0; round < kRounds; ++round) {
    eventful.LetSomethingHappen();
    step();
    kept.push_back(world.Save());
    if (random() % 2 == 0) {
      world.Restore(kept[random() % kept.size()]);
      step();
      if (random() % 2 == 0) known = KnownPoses(world);
      // The next event needs the bodies of the last one.
      world.Restore(kept.back());
    }
    if (random() % 2 == 0) continue;
    const std::vector<BodyId> reported = world.BodiesChangedSince(known.moment);
    EXPECT_TRUE(std::ranges::is_sorted(reported));
    const KnownPoses now(world);
    for (const auto& [id, X_WB] : now.poses) {
      const auto before = known.poses.find(id);
      if (std::ranges::binary_search(reported, id)) continue;
      ++num_unreported;
      ASSERT_NE(before, known.poses.end()) << "round " << round << ": body " << id.value;
      ASSERT_EQ(before->second, X_WB) << "round " << round << ": body " << id.value;
    }
    for (const auto& [id, X_WB] : known.poses) {
      if (now.poses.contains(id)) continue;
      ++num_removals;
      ASSERT_TRUE(world.HasRemovedSince(known.moment)) << "round " << round;
    }
    known = now;
  }
  EXPECT_GT(num_unreported, 0);
  EXPECT_GT(num_removals, 0);
}

INSTANTIATE_TEST_SUITE_P(Seeds, DormantIslandsProperty, ::testing::Range(1u, 9u));

TEST(DormantIslands, AStaticBodyThatIsMovedAwayLeavesNoContacts) {
  World usual, complete;
  for (World* world : {&usual, &complete}) {
    PhysicsWorldBuilder builder;
    const BodyId post = world->AddBody(builder.BlockSpec({0.1, 0.1, 0.1}, RigidTransform(), 0));
    world->AddBody(builder.CubeSpec({0, 0, 0.1}, 0.1));
    const BodyId other = world->AddBody(builder.CubeSpec({1, 0, 0.1}, 0.1));
    world->body(other).SetCarried(true);
    for (int i = 0; i < 1000; ++i) world->Step();
    if (world == &complete) world->Restore(Copy(world->Save()));
    world->body(post).SetPose(RigidTransform(Vector3(0, 0, -1)));
    world->Step();
  }
  EXPECT_EQ(Serialize(usual.Save()), Serialize(complete.Save()));
}

TEST(DormantIslands, SnapshotsShareTheStatesOfSleepersOnly) {
  PhysicsWorldBuilder builder;
  builder.AddTable();
  World& world = builder.world_;
  const BodyId cube = builder.AddCube({0, 0, 0.05}, 0.1),
               other = builder.AddCube({1, 0, 0.05}, 0.1);
  const auto state_of = [](const Snapshot& snapshot, BodyId id) {
    return std::ranges::find(snapshot.bodies, id, &Snapshot::BodyEntry::id)->state;
  };
  builder.StepSeconds(3);
  const Snapshot at_rest = world.Save();
  EXPECT_EQ(state_of(world.Save(), cube), state_of(at_rest, cube)) << "all sleep";

  world.body(other).SetCarried(true);
  builder.StepSeconds(0.1);
  const Snapshot carried = world.Save();
  builder.StepSeconds(0.1);
  const Snapshot carried_on = world.Save();
  EXPECT_EQ(state_of(carried_on, cube), state_of(carried, cube));
  EXPECT_NE(state_of(carried_on, other), state_of(carried, other));

  // What was kept ends with the sleep.
  world.body(cube).SetVelocity({0, 0, 0.5}, Vector3::Zero());
  EXPECT_NE(*state_of(world.Save(), cube), *state_of(carried, cube));
  world.Restore(carried);
  EXPECT_EQ(Serialize(world.Save()), Serialize(carried));
}

TEST(DormantIslands, MechanismsAndFixturesAreLeftOutUntilSomethingComesNear) {
  PhysicsWorldBuilder builder;
  builder.AddTable();
  World& world = builder.world_;
  const BodyId box = builder.AddCube({0, 0, 0.05}, 0.1), lid = builder.AddCube({0, 0, 0.12}, 0.04),
               post = world.AddBody(
                   builder.BlockSpec({0.1, 0.1, 0.1}, RigidTransform(Vector3(0, 0.4, 0.05)), 0)),
               other = builder.AddCube({0.6, 0, 0.05}, 0.1);
  world.AddJoint(SliderJointSpec{
      .a = box, .b = lid, .X_AJ = RigidTransform(Vector3(0, 0, 0.07)), .upper = 0.05});
  builder.StepSeconds(3);
  world.body(other).SetCarried(true);
  builder.StepSeconds(0.5);
  const auto changes_in_a_step = [&world] {
    const Moment before = world.now();
    world.Step();
    return world.BodiesChangedSince(before);
  };
  const auto is_among = [](BodyId id, const std::vector<BodyId>& ids) {
    return std::ranges::binary_search(ids, id);
  };
  for (const BodyId id : {box, lid, post}) {
    EXPECT_FALSE(is_among(id, changes_in_a_step())) << "body " << id.value;
  }
  world.body(other).SetPose(RigidTransform(Vector3(0, 0.4, 0.2)));
  world.body(other).SetCarried(false);
  builder.StepSeconds(2);
  EXPECT_NEAR(world.body(other).pose_in_world().translation().z(), 0.15, 1e-3) << "on the post";
  world.body(other).SetPose(RigidTransform(Vector3(0.2, 0, 0.06)));
  world.body(other).SetVelocity({-2, 0, 0}, Vector3::Zero());
  builder.StepSeconds(0.4);
  EXPECT_GT(std::abs(world.body(lid).pose_in_world().translation().x()), 1e-3);
}

TEST(DormantIslands, JointsOfAnIslandAreSolvedInTheOrderThatTheyHaveAmongAllJoints) {
  /// A cabinet among boxes with lids, whose drawers reach their limits in the same step. The joints
  /// were made in a mixed order.
  struct Cabinet : PhysicsWorldBuilder {
    Cabinet() {
      AddTable();
      const Vector3 p_WC(0, -0.2, 0.1);
      const BodyId cabinet = world_.AddBody(BlockSpec({0.1, 0.6, 0.2}, RigidTransform(p_WC), 2.0));
      for (int i = 0; i < 5; ++i) {
        AddBoxWithLid({-0.8 + 0.2 * i, 0.4, 0.05});
        AddBoxWithLid({-0.8 + 0.2 * i, 0.2, 0.05});
        drawers_.push_back(AddSlider(cabinet, p_WC, {0.1, 0.1 * (i - 2), 0.02 * i}, 0.2 + 0.3 * i));
      }
      StepSeconds(3);
    }
    void AddBoxWithLid(const Vector3& p_WB) {
      AddSlider(AddCube(p_WB, 0.1), p_WB, Vector3(0, 0, 0.07), 0.3);
    }
    BodyId AddSlider(BodyId base, const Vector3& p_WB, const Vector3& p_BP, double mass) {
      const RigidTransform X_WP(Vector3(p_WB + p_BP));
      const BodyId plate = world_.AddBody(BlockSpec({0.08, 0.08, 0.03}, X_WP, mass));
      world_.AddJoint(SliderJointSpec{
          .a = base, .b = plate, .X_AJ = RigidTransform(p_BP), .upper = 0.05, .restitution = 0.5});
      return plate;
    }
    std::vector<BodyId> drawers_;
  } usual, complete;
  for (int round = 0; round < 3; ++round) {
    for (Cabinet* one : {&usual, &complete}) {
      for (BodyId id : one->drawers_)
        one->world_.body(id).SetVelocity({1.5, 0, 0}, Vector3::Zero());
    }
    for (int i = 0; i < 150; ++i) {
      usual.world_.Step();
      complete.world_.Restore(Copy(complete.world_.Save()));
      complete.world_.Step();
      ASSERT_EQ(usual.world_.state_hash(), complete.world_.state_hash())
          << "round " << round << ", step " << i;
    }
  }
}

TEST(DormantIslands, AKeptStateEndsWithTheRestInWhichItWasKept) {
  // A single cube comes to rest together with all others, and is not left out.
  PhysicsWorldBuilder builder;
  builder.AddTable();
  const BodyId cube = builder.AddCube({0, 0, 0.05}, 0.1);
  builder.StepSeconds(3);
  const Snapshot before = builder.world_.Save();
  builder.world_.body(cube).SetPose(RigidTransform(Vector3(0.5, 0, 0.05)));
  builder.StepSeconds(3);
  EXPECT_NE(*builder.world_.Save().bodies.back().state, *before.bodies.back().state);
}

class NeighborsTest : public ::testing::Test {
 protected:
  /// Returns the number of blocks that are awake while the first of five in a row is lifted.
  static int NumAwakeWhenOneIsLifted(const WorldConfig& config, double gap) {
    World world(config);
    PhysicsWorldBuilder builder;
    world.AddBody(builder.BlockSpec({2, 1.2, 0.4}, RigidTransform(Vector3(0, 0, -0.2)), 0));
    std::vector<BodyId> row;
    for (int i = 0; i < 5; ++i) {
      row.push_back(world.AddBody(builder.CubeSpec({i * (0.1 + gap), 0, 0.05}, 0.1)));
    }
    for (int i = 0; i < 1000; ++i) world.Step();
    world.body(row[0]).SetCarried(true);
    world.body(row[0]).SetVelocity({0, 0, 0.1}, Vector3::Zero());
    for (int i = 0; i < 10; ++i) world.Step();
    return static_cast<int>(
        std::ranges::count_if(row, [&world](BodyId id) { return world.body(id).is_awake(); }));
  }
};

TEST_F(NeighborsTest, StayAsleepBesideABlockThatIsLifted) {
  EXPECT_EQ(NumAwakeWhenOneIsLifted({}, 0.005), 1);
}

TEST_F(NeighborsTest, AreOneIslandUpToFourCentimetersInRecordingsOfTheFirstTwoPhysicsVersions) {
  EXPECT_EQ(NumAwakeWhenOneIsLifted({.has_close_bounds = false}, 0.035), 5);
  EXPECT_EQ(NumAwakeWhenOneIsLifted({.has_close_bounds = false}, 0.045), 1);
}

}  // namespace
}  // namespace smile::physics
