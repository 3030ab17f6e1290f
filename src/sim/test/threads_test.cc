// Simulations in one process share nothing that changes: those on other threads cannot be noticed.

#include <barrier>
#include <thread>

#include "everything_scene.h"
#include "random_hands.h"
#include "random_robot.h"
#include "simulation_fixture.h"

namespace smile::sim {
namespace {

/// Returns the hash of each tick of a simulation with one of every mechanism, random hands that
/// also add and remove objects, and a robot with random commands. It is saved and restored now and
/// then.
std::vector<std::uint64_t> HashesOfARun(unsigned seed) {
  Simulation simulation(EverythingScene::MakeWithTools(),
                        RobotPlacement{.model = robot::ReadRobot(DataFile("robots/baxter.urdf"))});
  RandomHands hands(seed, /*changes_objects=*/true);
  RandomRobot robot(seed);
  std::vector<std::uint64_t> hashes;
  for (int i = 0; i < 60; ++i) {
    (void)simulation.Apply(hands.Next(simulation));
    if (i % 4 == 0) (void)simulation.Apply(robot.Next(simulation));
    if (i % 7 == 0) simulation.Restore(simulation.Save());
    for (int tick = 0; tick < 4; ++tick) {
      simulation.Tick();
      hashes.push_back(simulation.state_hash());
    }
  }
  return hashes;
}

TEST(Threads, TwoSimulationsAtOnceGiveTheHashesOfOneAfterTheOther) {
  const std::vector<std::uint64_t> first = HashesOfARun(1), second = HashesOfARun(2);
  ASSERT_NE(first, second);
  std::vector<std::uint64_t> first_at_once, second_at_once;
  std::barrier start(2);
  std::thread thread([&] {
    start.arrive_and_wait();
    second_at_once = HashesOfARun(2);
  });
  start.arrive_and_wait();
  first_at_once = HashesOfARun(1);
  thread.join();
  EXPECT_EQ(first_at_once, first);
  EXPECT_EQ(second_at_once, second);
}

}  // namespace
}  // namespace smile::sim
