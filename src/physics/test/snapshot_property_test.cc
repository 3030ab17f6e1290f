// Restore and go on: the same bits as if nothing had happened.

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "base/files.h"
#include "base/state_hash.h"
#include "physics_fixture.h"

namespace smile::physics {
namespace {

constexpr int kTicks = 600;
constexpr int kStepsPerTick = 8;

/// The full state with contacts, so that a difference shows before it moves anything.
std::uint64_t FullHash(const World& world) {
  StateHash hash;
  hash.Add(world.state_hash());
  for (std::byte byte : world.Save().state) hash.Add(static_cast<std::uint64_t>(byte));
  return hash.value();
}

/// Goes on for 600 ticks while the robot sweeps through the pile, a weld comes and goes, and bodies
/// are removed and added; returns the hash of the whole way.
std::uint64_t GoOn(World& world, ArticulationId robot, BodyId held, BodyId removed) {
  PhysicsWorldBuilder verbs;
  StateHash way;
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
      world.AddWeld({.articulation = robot,
                     .link = 2,
                     .body = held,
                     .X_LB = RigidTransform(Vector3(0.02, 0.3, 0)),
                     .links_not_colliding = {2, 3}});
    }
    for (int i = 0; i < kStepsPerTick; ++i) world.Step();
    way.Add(world.state_hash());
  }
  way.Add(FullHash(world));
  return way.value();
}

class SnapshotProperty : public ::testing::TestWithParam<unsigned> {
 protected:
  void SetUp() override {
    builder_.AddTable();
    builder_.AddRobot();
    pile_ = builder_.AddPile(18, GetParam());
    builder_.AddStack({0.6, 0.2, 0}, 4);
    builder_.SwingRobot(GetParam());
    builder_.StepSeconds(1.0);
    builder_.world_.AddWeld({.articulation = builder_.robot_,
                             .link = 6,
                             .body = pile_[4],
                             .X_LB = RigidTransform(Vector3(0, 0.35, 0)),
                             .links_not_colliding = {6, 7}});
    builder_.SwingRobot(GetParam() + 1);
    builder_.StepSeconds(0.4);
    snapshot_ = builder_.world_.Save();
    full_hash_ = FullHash(builder_.world_);
    way_ = GoOn(builder_.world_, builder_.robot_, pile_[1], pile_[0]);
  }

  PhysicsWorldBuilder builder_;
  std::vector<BodyId> pile_;
  Snapshot snapshot_;
  std::uint64_t full_hash_ = 0;
  std::uint64_t way_ = 0;
};

TEST_P(SnapshotProperty, GoesOnExactlyInPlace) {
  builder_.world_.Restore(snapshot_);
  EXPECT_EQ(FullHash(builder_.world_), full_hash_);
  EXPECT_EQ(GoOn(builder_.world_, builder_.robot_, pile_[1], pile_[0]), way_);
}

TEST_P(SnapshotProperty, GoesOnExactlyInAFreshWorld) {
  World fresh;
  fresh.Restore(snapshot_);
  EXPECT_EQ(FullHash(fresh), full_hash_);
  EXPECT_EQ(GoOn(fresh, builder_.robot_, pile_[1], pile_[0]), way_);
}

TEST_P(SnapshotProperty, GoesOnExactlyInAnotherProcess) {
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
    // A process of its own: nothing of this one's worlds is used, only the file.
    const std::string text = ReadFile(file, 1 << 26);
    World world;
    world.Restore(ParseSnapshot(std::as_bytes(std::span(text.data(), text.size()))));
    const std::uint64_t way = GoOn(world, builder_.robot_, pile_[1], pile_[0]);
    _exit(write(result[1], &way, sizeof way) == sizeof way ? 0 : 1);
  }
  std::uint64_t way = 0;
  EXPECT_EQ(read(result[0], &way, sizeof way), static_cast<ssize_t>(sizeof way));
  waitpid(child, nullptr, 0);
  close(result[0]);
  close(result[1]);
  std::filesystem::remove(file);
  EXPECT_EQ(way, way_);
}

INSTANTIATE_TEST_SUITE_P(Seeds, SnapshotProperty, ::testing::Values(1u, 2u));

TEST(Snapshot, RefusesBytesThatAreNotAWholeSnapshot) {
  PhysicsWorldBuilder builder;
  builder.AddTable();
  builder.AddRobot();
  builder.AddPile(6, 1);
  builder.StepSeconds(0.2);
  const std::vector<std::byte> whole = Serialize(builder.world_.Save());
  for (std::size_t size = 0; size < whole.size(); size += 97) {
    EXPECT_THROW(ParseSnapshot(std::span(whole).first(size)), std::runtime_error) << size;
  }
  EXPECT_EQ(Serialize(ParseSnapshot(whole)), whole);
}

}  // namespace
}  // namespace smile::physics
