// Random hands in a scene with one of each mechanism: everything can be undone exactly.

#include <map>

#include "event_counter.h"
#include "everything_scene.h"
#include "random_hands.h"
#include "simulation_fixture.h"

namespace smile::sim {
namespace {

class MechanismsProperty : public SimulationFixture,
                           public ::testing::WithParamInterface<unsigned> {};

INSTANTIATE_TEST_SUITE_P(Seeds, MechanismsProperty, testing::Range(11u, 16u));

TEST_P(MechanismsProperty, EverythingDoneCanBeTakenBackAndDoneAgain) {
  struct Moment {
    SimulationState state;
    std::uint64_t hash;
    Command command;
  };
  const scene::SceneSpec scene = EverythingScene::MakeWithTools();
  Simulation simulation(scene);
  RandomHands hands(GetParam());
  std::vector<Moment> moments;
  std::map<std::size_t, int> num_done;  // of each kind of command
  EventCounter counter;
  simulation.AddListener(&counter);
  for (int i = 0; i < 120; ++i) {
    const Command command = hands.Next(simulation);
    moments.push_back({simulation.Save(), simulation.state_hash(), command});
    const std::uint64_t before = simulation.state_hash();
    if (simulation.Apply(command)) {
      EXPECT_EQ(simulation.state_hash(), before) << "a refused command changed something";
    } else {
      ++num_done[command.index()];
    }
    for (int tick = 0; tick < 5; ++tick) simulation.Tick();
  }
  EXPECT_GT(num_done[Command(Trigger{}).index()], 0);
  EXPECT_GT(num_done[Command(Fasten{}).index()] + num_done[Command(Loosen{}).index()], 0);
  EXPECT_GT(num_done[Command(Use{}).index()], 0);
  EXPECT_GT(num_done[Command(Plane{}).index()], 0);
  EXPECT_GT(num_done[Command(MoveTo{}).index()], 0);
  // Some release because another hand needs them.
  EXPECT_GT(counter.num_events[EventKind::kReleased], num_done[Command(Release{}).index()]);
  EXPECT_GT(counter.num_events[EventKind::kFell], 0);
  EXPECT_GT(counter.num_events[EventKind::kAttended], 0);
  EXPECT_GT(counter.num_events[EventKind::kPressed], 0);
  EXPECT_GT(counter.num_events[EventKind::kUsed], 0);
  const std::uint64_t end = simulation.state_hash();

  for (auto moment = moments.rbegin(); moment != moments.rend(); ++moment) {
    simulation.Restore(moment->state);
    ASSERT_EQ(simulation.state_hash(), moment->hash);
  }
  const auto do_again = [&](Simulation& other, std::size_t from) {
    for (std::size_t i = from; i < moments.size(); ++i) {
      ASSERT_EQ(other.state_hash(), moments[i].hash) << "before command " << i;
      (void)other.Apply(moments[i].command);
      for (int tick = 0; tick < 5; ++tick) other.Tick();
    }
    EXPECT_EQ(other.state_hash(), end);
  };
  do_again(simulation, 0);
  Simulation elsewhere(scene);
  elsewhere.Restore(moments[40].state);
  do_again(elsewhere, 40);
}

}  // namespace
}  // namespace smile::sim
