// A state that went through bytes continues with the same bits; other bytes are refused.

#include "checkpoint/checkpoint.h"

#include <gtest/gtest.h>

#include <map>

#include "sim/test/everything_scene.h"
#include "sim/test/random_hands.h"
#include "sim/test/random_robot.h"
#include "sim/test/simulation_fixture.h"

namespace smile::checkpoint {
namespace {

using sim::Simulation;

class CheckpointProperty : public sim::SimulationFixture,
                           public ::testing::WithParamInterface<unsigned> {
 protected:
  static std::unique_ptr<Simulation> Make() {
    return std::make_unique<Simulation>(sim::EverythingScene::MakeWithTools(),
                                        sim::RobotPlacement{.model = Baxter()});
  }
};

INSTANTIATE_TEST_SUITE_P(Seeds, CheckpointProperty, testing::Range(1u, 5u));

TEST_P(CheckpointProperty, ContinuesExactlyInAnotherSimulation) {
  struct Moment {
    std::vector<std::byte> bytes;
    std::uint64_t hash;
  };
  const auto simulation = Make();
  sim::RandomHands hands(GetParam(), /*changes_objects=*/true);
  sim::RandomRobot robot(GetParam());
  std::vector<sim::Command> commands;
  std::vector<Moment> moments;
  const auto advance = [](Simulation& one, const sim::Command& command) {
    (void)one.Apply(command);
    for (int tick = 0; tick < 3; ++tick) one.Tick();
  };
  for (int i = 0; i < 60; ++i) {
    moments.push_back({Serialize(simulation->Save()), simulation->state_hash()});
    commands.push_back(i % 2 == 0 ? hands.Next(*simulation) : robot.Next(*simulation));
    advance(*simulation, commands.back());
  }
  ASSERT_GT(simulation->model().objects().size(), simulation->start_model()->objects().size())
      << "objects were to be added";

  for (std::size_t from = 0; from < moments.size(); from += 19) {
    const auto elsewhere = Make();
    elsewhere->Restore(ParseState(moments[from].bytes, elsewhere->start_model()));
    for (std::size_t i = from; i < moments.size(); ++i) {
      ASSERT_EQ(elsewhere->state_hash(), moments[i].hash) << "from " << from << " to " << i;
      ASSERT_EQ(Serialize(elsewhere->Save()), moments[i].bytes) << "from " << from << " to " << i;
      advance(*elsewhere, commands[i]);
    }
    EXPECT_EQ(elsewhere->state_hash(), simulation->state_hash());
  }
}

using CheckpointTest = sim::SimulationFixture;

TEST_F(CheckpointTest, RefusesWhatIsNotAStateOfItsModel) {
  const auto refuses = [](std::vector<std::byte> bytes, const Simulation& simulation,
                          const std::string& reason) {
    try {
      (void)ParseState(bytes, simulation.start_model());
      ADD_FAILURE() << "accepted: " << reason;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
    }
  };
  const auto simulation = MakeSimulation({BlockAt("a", {0, 0, 0.05})}, false);
  const auto other = MakeSimulation({BlockAt("b", {0, 0, 0.05})}, false);
  const std::vector<std::byte> bytes = Serialize(simulation->Save());
  refuses(bytes, *other, "another scene or robot");
  refuses({}, *simulation, "not a state of a simulation");
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::vector<std::byte> damaged = bytes;
    damaged[i] ^= std::byte{1};
    refuses(damaged, *simulation, "saved state: ");
  }
  refuses({bytes.begin(), bytes.end() - 1}, *simulation, "truncated or damaged");
}

}  // namespace
}  // namespace smile::checkpoint
