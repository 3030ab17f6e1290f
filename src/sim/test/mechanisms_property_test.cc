// Whatever hands do to a scene with one of every mechanism, it can be taken back exactly.

#include <map>
#include <random>

#include "everything_scene.h"
#include "simulation_fixture.h"

namespace smile::sim {
namespace {

class RandomHands {
 public:
  explicit RandomHands(unsigned seed) : random_(seed) {}

  Command Next(const Simulation& simulation) {
    const HandName hand = Pick(std::vector{HandName::kLeft, HandName::kRight});
    const std::string object = Pick(simulation.tabletop().objects()).id();
    switch (random_() % 10) {
      case 0:
      case 1:
        // The panel stays: whoever destroys it takes all controls away.
        return Grasp{.hand = hand, .object = object == "panel" ? "ball" : object};
      case 2:
        return MoveTo{.hand = hand, .p_WH = {Uniform(0.6), Uniform(0.4), 0.1 + Uniform(0.1)}};
      case 3:
        return Rotate{.hand = hand, .angles_deg = {Uniform(90), Uniform(90), Uniform(90)}};
      case 4:
        return Release{.hand = hand};
      // The hand that never holds anything, so that it can.
      case 5:
        return Trigger{.hand = HandName::kAny,
                       .control = Pick(std::vector<std::string>{"power", "lamps", "dial"})};
      case 6:
        return Fasten{.hand = HandName::kAny, .object = Pick(kScrews)};
      case 7:
        return Loosen{.hand = HandName::kAny, .object = Pick(kScrews)};
      case 8:
        return Point{.hand = hand, .part = object};
      default:
        if (random_() % 4 == 0) return Destroy{.hand = hand};
        return MoveTo{.hand = hand, .p_WH = {Uniform(0.6), Uniform(0.4), 0.2}, .speed = 0.3};
    }
  }

 private:
  inline static const std::vector<std::string> kScrews = {"screw", "spare"};

  template <class T>
  const T& Pick(const std::vector<T>& things) {
    return things[random_() % things.size()];
  }
  double Uniform(double limit) { return std::uniform_real_distribution(-limit, limit)(random_); }

  std::mt19937 random_;
};

class MechanismsProperty : public SimulationFixture,
                           public ::testing::WithParamInterface<unsigned> {};

INSTANTIATE_TEST_SUITE_P(Seeds, MechanismsProperty, testing::Range(11u, 16u));

TEST_P(MechanismsProperty, EverythingDoneCanBeTakenBackAndDoneAgain) {
  struct Moment {
    SimulationState state;
    std::uint64_t hash;
    Command command;
  };
  Simulation simulation(EverythingScene::Make());
  RandomHands hands(GetParam());
  std::vector<Moment> moments;
  std::map<std::size_t, int> num_done;  // of each kind of command
  for (int i = 0; i < 80; ++i) {
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
  Simulation elsewhere(EverythingScene::Make());
  elsewhere.Restore(moments[40].state);
  do_again(elsewhere, 40);
}

}  // namespace
}  // namespace smile::sim
