// A restored world continues with the same bits as the original.

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <thread>

#include "base/files.h"
#include "base/state_hash.h"
#include "math/angles.h"
#include "physics_fixture.h"

namespace smile::physics {
namespace {

constexpr int kTicks = 600;
constexpr int kStepsPerTick = 8;

/// Hash of the full state with contacts, so that a difference shows before anything moves.
std::uint64_t FullHash(const World& world) {
  StateHash hash;
  hash.Add(world.state_hash());
  for (std::byte byte : world.Save().state) hash.Add(static_cast<std::uint64_t>(byte));
  return hash.value();
}

/// Continues for 600 ticks while the robot sweeps through the pile, a weld is made and removed, and
/// bodies are removed and added; returns the hash of the whole run.
std::uint64_t RunOn(World& world, ArticulationId robot, BodyId held, BodyId removed) {
  PhysicsWorldBuilder verbs;
  StateHash hash;
  Articulation& arms = world.articulation(robot);
  JointId weld = world.joints().empty() ? JointId{} : world.joints().front().id;
  for (int tick = 0; tick < kTicks; ++tick) {
    if (tick % 30 == 0) {
      for (int i = 0; i < arms.num_joints(); ++i) {
        arms.SetVelocityTarget(i, std::sin(0.1 * tick + 1.7 * i));
      }
    }
    if (tick == 50 && weld) world.RemoveJoint(weld);
    if (tick == 100) world.RemoveBody(removed);
    if (tick == 150) world.AddBody(verbs.CubeSpec({0.05, 0.02, 0.9}, 0.1));
    if (tick == 200) {
      world.AddJoint(WeldSpec{.articulation = robot,
                              .link = 2,
                              .body = held,
                              .X_LB = RigidTransform(Vector3(0.02, 0.3, 0)),
                              .links_not_colliding = {2, 3}});
    }
    for (int i = 0; i < kStepsPerTick; ++i) world.Step();
    hash.Add(world.state_hash());
  }
  hash.Add(FullHash(world));
  return hash.value();
}

/// Seed, and true for a kinematic robot.
class SnapshotProperty : public ::testing::TestWithParam<std::pair<unsigned, bool>> {
 protected:
  void SetUp() override {
    const auto [seed, is_kinematic] = GetParam();
    builder_.AddTable();
    builder_.AddRobot(is_kinematic);
    pile_ = builder_.AddPile(18, seed);
    builder_.AddStack({0.6, 0.2, 0}, 4);
    builder_.SwingRobot(seed);
    builder_.StepSeconds(1.0);
    builder_.world_.AddJoint(WeldSpec{.articulation = builder_.robot_,
                                      .link = 6,
                                      .body = pile_[4],
                                      .X_LB = RigidTransform(Vector3(0, 0.35, 0)),
                                      .links_not_colliding = {6, 7}});
    builder_.SwingRobot(seed + 1);
    builder_.StepSeconds(0.4);
    snapshot_ = builder_.world_.Save();
    full_hash_ = FullHash(builder_.world_);
    hash_ = RunOn(builder_.world_, builder_.robot_, pile_[1], pile_[0]);
  }

  PhysicsWorldBuilder builder_;
  std::vector<BodyId> pile_;
  Snapshot snapshot_;
  std::uint64_t full_hash_ = 0;
  std::uint64_t hash_ = 0;
};

TEST_P(SnapshotProperty, ContinuesExactlyInPlace) {
  builder_.world_.Restore(snapshot_);
  EXPECT_EQ(FullHash(builder_.world_), full_hash_);
  EXPECT_EQ(RunOn(builder_.world_, builder_.robot_, pile_[1], pile_[0]), hash_);
}

TEST_P(SnapshotProperty, ContinuesExactlyInAFreshWorld) {
  World fresh;
  fresh.Restore(snapshot_);
  EXPECT_EQ(FullHash(fresh), full_hash_);
  EXPECT_EQ(RunOn(fresh, builder_.robot_, pile_[1], pile_[0]), hash_);
}

TEST_P(SnapshotProperty, ContinuesExactlyInAnotherProcess) {
  const auto file = std::filesystem::temp_directory_path() /
                    ("smile_snapshot_" + std::to_string(getpid()) + ".bin");
  const std::vector<std::byte> bytes = Serialize(snapshot_);
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
  int result[2];
  ASSERT_EQ(pipe(result), 0);
  const pid_t child = fork();
  if (child == 0) {
    // A separate process uses only the file, nothing of this process's worlds.
    const std::string text = ReadFile(file, 1 << 26);
    World world;
    world.Restore(mechanics::ParseSnapshot(std::as_bytes(std::span(text.data(), text.size()))));
    const std::uint64_t hash = RunOn(world, builder_.robot_, pile_[1], pile_[0]);
    _exit(write(result[1], &hash, sizeof hash) == sizeof hash ? 0 : 1);
  }
  // A child that ends without a result ends the wait for it.
  close(result[1]);
  std::uint64_t hash = 0;
  EXPECT_EQ(read(result[0], &hash, sizeof hash), static_cast<ssize_t>(sizeof hash));
  waitpid(child, nullptr, 0);
  close(result[0]);
  std::filesystem::remove(file);
  EXPECT_EQ(hash, hash_);
}

INSTANTIATE_TEST_SUITE_P(Seeds, SnapshotProperty,
                         ::testing::Values(std::pair(1u, false), std::pair(2u, false),
                                           std::pair(1u, true), std::pair(2u, true)));

/// A world in which everything is jointed: a chain between posts, a damped drawer, a soft slider
/// bouncing at its limits, a held lid, fixed rows, a hand that carries a lid, a robot that carries
/// a box by its lid, a hub with guests, and a loop.
class JointedWorld : public PhysicsWorldBuilder {
 public:
  explicit JointedWorld(unsigned seed) : random_(seed) {
    AddTable();
    AddRobot();
    AddPile(6, seed);
    HangChain();
    for (int i = 0; i < 3; ++i) AddBoxWithLid(i);
    AddHub();
    StepSeconds(0.3);
    Carry();
    SwingRobot(seed);
    StepSeconds(0.4);
    PutIntoOneAnother();
    StepSeconds(0.02);
  }

  /// Continues while joints are made and removed, forms change, and hands take and release.
  static std::uint64_t RunOn(World& world, const JointedWorld& made) {
    StateHash hash;
    const auto& lids = made.lids_;
    for (int tick = 0; tick < 400; ++tick) {
      if (tick == 20) world.RemoveJoint(made.fixed_);
      if (tick == 20) world.IgnoreCollisionUntilSeparated(made.posts_[0], made.links_[0]);
      if (tick == 60) Widen(world, made.boxes_[1]);
      if (tick == 90) world.body(lids[0]).SetCarried(false);
      if (tick == 120) world.RemoveBody(made.links_[4]);
      if (tick == 40) world.RemoveBody(made.links_.back());
      if (tick == 150) world.RemoveJoint(world.joints().front().id);
      if (tick == 180) {
        world.AddJoint(BallJointSpec{.a = made.boxes_[2], .b = lids[1], .p_AQ = {0, 0, 0.4}});
      }
      if (tick == 210) world.body(made.boxes_[2]).SetCarried(true);
      for (int i = 0; i < kStepsPerTick; ++i) {
        for (BodyId id : {lids[0], made.boxes_[2]}) {
          if (!world.body(id).is_carried()) continue;
          world.body(id).SetVelocity({0.1 * std::sin(0.1 * tick), 0, 0.3 * std::sin(0.05 * tick)},
                                     {0, 0, 0.5});
        }
        world.Step();
      }
      hash.Add(world.state_hash());
    }
    hash.Add(FullHash(world));
    for (BodyId id : made.boxes_) {
      // NaNs would be equal, too. One body may fall off the table.
      EXPECT_LT(world.body(id).pose_in_world().translation().head<2>().norm(), 10);
    }
    return hash.value();
  }

 private:
  static void Widen(World& world, BodyId id) {
    const std::vector<scene::Solid> solids = {
        {scene::Block{{0.24, 0.1, 0.1}}, {}, {}, ""},
        {scene::Block{{0.05, 0.05, 0.2}}, RigidTransform(Vector3(0.1, 0.03, 0)), {}, ""}};
    world.ChangeForm(id, solids, scene::MassPropertiesOf(solids, 2.0));
  }

  double Uniform(double low, double high) {
    return low + (high - low) * (random_() / 4294967296.0);
  }
  BodyId AddBlock(const Vector3& size, const Vector3& p_WB, double mass) {
    return world_.AddBody(BlockSpec(size, RigidTransform(p_WB), mass));
  }
  void HangChain() {
    posts_.push_back(AddBlock({0.05, 0.05, 0.05}, {-0.6, 0.4, 0.5}, 0));
    for (int i = 0; i < 10; ++i) {
      links_.push_back(AddBlock({0.09, 0.03, 0.03}, {-0.55 + 0.1 * i, 0.4, 0.5}, 0.2));
    }
    posts_.push_back(AddBlock({0.05, 0.05, 0.05}, {0.4, 0.4, 0.5}, 0));
    const auto join = [this](BodyId a, BodyId b, double a_x, double b_x) {
      world_.AddJoint(BallJointSpec{.a = a, .b = b, .p_AQ = {a_x, 0, 0}, .p_BQ = {b_x, 0, 0}});
    };
    for (int i = 0; i + 1 < 10; ++i) join(links_[i], links_[i + 1], 0.05, -0.05);
    join(links_.back(), posts_[1], 0.05, 0);
    fixed_ = world_.AddJoint(FixedJointSpec{
        .a = posts_[0], .b = links_[0], .X_AB = RigidTransform(Vector3(0.05, 0, 0))});
    // A second fetter between two links: a loop of redundant joints.
    world_.AddJoint(
        FixedJointSpec{.a = links_[6], .b = links_[7], .X_AB = RigidTransform(Vector3(0.1, 0, 0))});
  }
  void AddBoxWithLid(int i) {
    const Vector3 place(-0.5 + 0.3 * i, -0.2, 0.15 + Uniform(0, 0.2));
    boxes_.push_back(AddBlock({0.2, 0.1, 0.1}, place, Uniform(0.5, 5)));
    lids_.push_back(AddBlock({0.2, 0.1, 0.02}, place + Vector3(0, 0, 0.07), Uniform(0.2, 2)));
    const Matrix3 R_AJ(Quaternion::FromTwoVectors(
        Vector3::UnitX(), i == 2 ? Vector3(Vector3::UnitZ()) : Vector3(Vector3::UnitX())));
    world_.AddJoint(SliderJointSpec{.a = boxes_.back(),
                                    .b = lids_.back(),
                                    .X_AJ = RigidTransform(R_AJ, Vector3(0, 0, 0.07)),
                                    .X_BK = RigidTransform(R_AJ, Vector3::Zero()),
                                    .lower = -0.02,
                                    .upper = 0.05,
                                    .do_collide = i == 1,
                                    .damping = i == 2 ? 1.0 : 0.3 * i,
                                    .restitution = i == 0 ? 0.7 : 0.0,
                                    .softness = i == 1 ? 0.4 : 1.0});
    world_.body(lids_.back()).SetVelocity({Uniform(-1, 1), 0, 0}, {0, 0, 0});
  }
  /// Guests on a bar that falls onto the pile.
  void AddHub() {
    const Vector3 place(0.3, 0, 0.9);
    const BodyId hub = AddBlock({0.3, 0.05, 0.05}, place, 2);
    for (int i = 0; i < 6; ++i) {
      const Vector3 p_HG(-0.125 + 0.05 * i, i % 2 == 0 ? 0.08 : -0.08, Uniform(0, 0.02));
      links_.push_back(AddBlock({0.04, 0.04, 0.04}, place + p_HG, Uniform(0.1, 1)));
      world_.AddJoint(FixedJointSpec{.a = hub, .b = links_.back(), .X_AB = RigidTransform(p_HG)});
    }
  }
  void Carry() {
    world_.body(lids_[0]).SetCarried(true);
    world_.AddJoint(WeldSpec{.articulation = robot_,
                             .link = 2,
                             .body = lids_[1],
                             .X_LB = RigidTransform(Vector3(0.02, 0.3, 0)),
                             .links_not_colliding = {2, 3}});
  }

  void PutIntoOneAnother() {
    world_.IgnoreCollisionUntilSeparated(boxes_[0], boxes_[2]);
    world_.body(boxes_[2]).SetPose(RigidTransform(
        Vector3(world_.body(boxes_[0]).pose_in_world().translation() + Vector3(0.05, 0.02, 0.03))));
  }

  std::mt19937 random_;
  std::vector<BodyId> posts_, links_, boxes_, lids_;
  JointId fixed_;
};

class JointedSnapshotProperty : public ::testing::TestWithParam<unsigned> {};

TEST_P(JointedSnapshotProperty, ContinuesExactlyInPlaceInAFreshWorldFromBytesAndInAThread) {
  JointedWorld made(GetParam());
  const Snapshot saved = made.world_.Save();
  EXPECT_FALSE(saved.passing.empty()) << "or the test tests less than it says";
  const std::uint64_t full_hash = FullHash(made.world_);
  const std::uint64_t hash = JointedWorld::RunOn(made.world_, made);

  made.world_.Restore(saved);
  EXPECT_EQ(FullHash(made.world_), full_hash);
  EXPECT_EQ(JointedWorld::RunOn(made.world_, made), hash) << "in place";
  const auto run_on_fresh = [&](std::uint64_t* fresh_hash) {
    World fresh;
    fresh.Restore(mechanics::ParseSnapshot(Serialize(saved)));
    *fresh_hash = JointedWorld::RunOn(fresh, made);
  };
  std::uint64_t hashes[2] = {};
  std::thread thread(run_on_fresh, &hashes[0]);
  run_on_fresh(&hashes[1]);
  thread.join();
  EXPECT_EQ(hashes[0], hash) << "in a fresh world, in a thread";
  EXPECT_EQ(hashes[1], hash) << "in a fresh world";
}

/// A snapshot is complete without running a step.
TEST(Snapshot, OfAJustPlacedBodyContinuesTheSame) {
  World world;
  const auto block = [](const Vector3& size, const Vector3& p_WB) {
    return PhysicsWorldBuilder::BlockSpec(size, RigidTransform(p_WB), 0.2);
  };
  const BodyId plank = world.AddBody(block({0.6, 0.05, 0.02}, {0, 0, 1}));
  const BodyId cube = world.AddBody(block({0.1, 0.1, 0.1}, {0, 0.3, 1}));
  world.body(plank).SetPose(
      {Matrix3(RotationFromFixedAxes(Vector3(20, 50, 70))), Vector3(0, 0, 1)});
  world.AddJoint(
      FixedJointSpec{.a = plank, .b = cube, .X_AB = RigidTransform(Vector3(0.3, 0.1, 0))});
  World fresh;
  fresh.Restore(world.Save());
  world.Step();
  fresh.Step();
  EXPECT_EQ(FullHash(fresh), FullHash(world));
}

TEST_P(JointedSnapshotProperty, SavesWhatItRestored) {
  JointedWorld made(GetParam());
  for (int i = 0; i < 40; ++i) {
    World fresh;
    const Snapshot saved = made.world_.Save();
    fresh.Restore(saved);
    ASSERT_EQ(Serialize(fresh.Save()), Serialize(saved));
    fresh.Step();
    made.world_.Step();
    ASSERT_EQ(FullHash(fresh), FullHash(made.world_)) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, JointedSnapshotProperty, ::testing::Range(1u, 7u));

TEST(StateHash, DependsOnAPressedLimit) {
  World world;
  PhysicsWorldBuilder verbs;
  const BodyId a = world.AddBody(verbs.CubeSpec({0, 0, 1}, 0.1));
  const BodyId b = world.AddBody(verbs.CubeSpec({0.5, 0, 1}, 0.1));
  world.AddJoint(SliderJointSpec{.a = a, .b = b, .lower = 0, .upper = 1});
  const Snapshot saved = world.Save();
  Snapshot pressed = saved;
  // Before the random number (8 bytes) and the number of contacts (4): the upper limit.
  std::byte& is_pressed = pressed.state[pressed.state.size() - 13];
  ASSERT_EQ(is_pressed, std::byte{0});
  is_pressed = std::byte{1};
  world.Restore(saved);
  const std::uint64_t hash = world.state_hash();
  world.Restore(pressed);
  EXPECT_NE(world.state_hash(), hash);
  EXPECT_EQ(world.Save().state, pressed.state) << "nothing else was touched";
}

TEST(StateHash, DependsOnTheStateOfAWeld) {
  const auto hash_of = [](double y, const std::vector<int>& links_not_colliding) {
    PhysicsWorldBuilder builder;
    builder.AddRobot();
    const BodyId cube = builder.AddCube({0, 0.5, 0.3}, 0.1);
    builder.world_.AddJoint(WeldSpec{.articulation = builder.robot_,
                                     .link = 1,
                                     .body = cube,
                                     .X_LB = RigidTransform(Vector3(0, y, 0)),
                                     .links_not_colliding = links_not_colliding});
    return builder.world_.state_hash();
  };
  EXPECT_EQ(hash_of(0.3, {1}), hash_of(0.3, {1}));
  EXPECT_NE(hash_of(0.3, {1}), hash_of(0.31, {1}));
  EXPECT_NE(hash_of(0.3, {1}), hash_of(0.3, {1, 2}));
}

/// Replaces the entry of a body.
void SetBody(Snapshot* snapshot, std::size_t index, const Snapshot::BodyEntry& entry) {
  snapshot->bodies.Set({{index, entry}});
}

TEST(Snapshot, RefusesWhatContradictsItselfAndLeavesTheWorldAsItWas) {
  PhysicsWorldBuilder builder;
  builder.AddTable();
  const BodyId cube = builder.AddCube({0, 0, 0.5}, 0.1), other = builder.AddCube({0, 0, 0.7}, 0.1);
  builder.AddRobot();
  World& world = builder.world_;
  world.AddJoint(FixedJointSpec{.a = cube, .b = other});
  world.AddJoint(WeldSpec{.articulation = builder.robot_, .link = 1, .body = cube});
  const Snapshot good = world.Save();
  world.RemoveBody(other);
  world.AddBody(PhysicsWorldBuilder::CubeSpec({0.3, 0, 0.5}, 0.1));
  builder.StepSeconds(0.1);
  const std::vector<std::byte> before = Serialize(world.Save());
  const double nan = std::nan("");
  const std::vector<std::function<void(Snapshot*)>> spoilers = {
      [](Snapshot* s) {
        s->bodies.Set({{0, s->bodies[1]}, {1, s->bodies[0]}});
      },
      [](Snapshot* s) {
        SetBody(s, 1, {s->bodies[0].id, s->bodies[1].spec, s->bodies[1].state});
      },
      [](Snapshot* s) {
        const BodyId of_a_link{s->articulations[0].id.value + 2};
        SetBody(s, s->bodies.size() - 1,
                {of_a_link, s->bodies.back().spec, s->bodies.back().state});
      },
      [](Snapshot* s) {
        SetBody(s, 1, {s->bodies[1].id, nullptr, s->bodies[1].state});
      },
      [](Snapshot* s) { s->next_id = 3; },
      [](Snapshot* s) { s->next_joint_id = 1; },
      [](Snapshot* s) { s->articulations.clear(); },
      [](Snapshot* s) { std::swap(s->joints[0], s->joints[1]); },
      [](Snapshot* s) { std::get<FixedJointSpec>(s->joints[0].spec).b = BodyId{999}; },
      [](Snapshot* s) { std::get<WeldSpec>(s->joints[1].spec).link = 99; },
      [](Snapshot* s) { std::get<WeldSpec>(s->joints[1].spec).articulation.value = 99; },
      [](Snapshot* s) { std::get<WeldSpec>(s->joints[1].spec).links_not_colliding = {-2}; },
      [nan](Snapshot* s) {
        std::get<WeldSpec>(s->joints[1].spec).X_LB = RigidTransform(Vector3(nan, 0, 0));
      },
      [](Snapshot* s) {
        s->passing = {{BodyId{1}, BodyId{1}}};
      },
      [](Snapshot* s) {
        s->passing = {{BodyId{1}, BodyId{999}}};
      },
      [](Snapshot* s) {
        auto spec = std::make_shared<scene::ArticulationSpec>(*s->articulations[0].spec);
        spec->links[1].parent = 5;
        s->articulations[0].spec = spec;
      },
  };
  const auto expect_refusals = [&](const std::vector<std::byte>& state) {
    for (std::size_t i = 0; i < spoilers.size(); ++i) {
      Snapshot spoilt = good;
      spoilers[i](&spoilt);
      EXPECT_THROW(world.Restore(spoilt), std::invalid_argument) << i;
      EXPECT_TRUE(Serialize(world.Save()) == state) << i;
    }
  };
  expect_refusals(before);
  world.Restore(good);
  EXPECT_TRUE(Serialize(world.Save()) == Serialize(good));
  // Now the world has the list of bodies that the spoilt ones are made of.
  expect_refusals(Serialize(good));
}

TEST(Snapshot, RefusesBytesThatAreNotAWholeSnapshot) {
  PhysicsWorldBuilder builder;
  builder.AddTable();
  builder.AddRobot();
  builder.AddPile(6, 1);
  builder.StepSeconds(0.2);
  const std::vector<std::byte> whole = Serialize(builder.world_.Save());
  for (std::size_t size = 0; size < whole.size(); size += 97) {
    EXPECT_THROW(mechanics::ParseSnapshot(std::span(whole).first(size)), std::runtime_error)
        << size;
  }
  EXPECT_EQ(Serialize(mechanics::ParseSnapshot(whole)), whole);
}

TEST(Snapshot, AContactThatIsListedWithAnotherBodyIsRefusedAndTheWorldGoesBackToAGoodState) {
  PhysicsWorldBuilder builder;
  builder.AddTable();
  const std::vector<BodyId> stack = builder.AddStack({0, 0, 0}, 2);
  builder.StepSeconds(0.1);
  World& world = builder.world_;
  const Snapshot good = world.Save();
  Snapshot bad = good;
  // The upper body owns its contact with the lower one.
  SetBody(&bad, 1, {stack[0], good.bodies[1].spec, good.bodies[2].state});
  builder.StepSeconds(0.1);
  EXPECT_THROW(world.Restore(bad), std::invalid_argument);
  world.Restore(good);
  EXPECT_EQ(Serialize(world.Save()), Serialize(good));
}

}  // namespace
}  // namespace smile::physics
