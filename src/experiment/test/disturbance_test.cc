#include "experiment/disturbance.h"

#include <gtest/gtest.h>

#include "experiment_fixture.h"
#include "math/angles.h"

namespace smile::experiment {
namespace {

class DisturbanceTest : public ExperimentTest {
 protected:
  /// A pile `a` of two, a block `c` beside it, and a fixture.
  static scene::SceneSpec Pile() {
    return SceneOf(
        "<block id=\"a\" location=\"(0, -3, 0.5)\"/><block id=\"b\" location=\"(0, -3, 1.5)\"/>"
        "<block id=\"c\" location=\"(3, -3, 0.5)\"/>"
        "<block id=\"d\" location=\"(-3, -3, 0.5)\" mass=\"0\"/>");
  }
  static void Tick(int ticks, int from, Disturber* disturber, sim::Simulation* simulation) {
    for (int k = 0; k < ticks; ++k) {
      disturber->Advance(static_cast<std::uint64_t>(from + k), simulation);
      simulation->Tick();
    }
  }
};

TEST_F(DisturbanceTest, DisplacesTheOnlyLooseObjectAndLetsItRest) {
  for (const double choice : {0.0, 0.999999}) {
    sim::Simulation simulation(Pile());
    Disturber disturber({.seconds = 0.5, .choice = choice, .direction_deg = 90, .distance = 0.5});
    Tick(30, 0, &disturber, &simulation);
    EXPECT_TRUE(disturber.json().is_null());
    Tick(120, 30, &disturber, &simulation);
    const Json done = disturber.json();
    EXPECT_EQ(done["tick"], 30);
    EXPECT_EQ(done["object"], "c");
    EXPECT_NEAR(done["to"][1].get<double>(), -2.5, 0.01);
    const auto& object = *simulation.tabletop().Find("c");
    const Vector3 p_WB = simulation.tabletop().PoseOf(object)->translation();
    EXPECT_TRUE(p_WB.isApprox(Vector3(0.3, -0.25, 0.05), 0.01)) << p_WB.transpose();
    EXPECT_FALSE(simulation.demonstrator().hand(sim::HandName::kLeft).is_holding());
  }
}

TEST_F(DisturbanceTest, WaitsForALooseObject) {
  sim::Simulation simulation(Pile());
  ASSERT_FALSE(simulation.Apply(sim::Grasp{.hand = sim::HandName::kRight, .object = "c"}));
  Disturber disturber({.seconds = 0, .distance = 0.3});
  Tick(60, 0, &disturber, &simulation);
  EXPECT_TRUE(disturber.json().is_null());
  ASSERT_FALSE(simulation.Apply(sim::Release{.hand = sim::HandName::kRight}));
  Tick(60, 60, &disturber, &simulation);
  EXPECT_EQ(disturber.json()["object"], "c");
}

}  // namespace
}  // namespace smile::experiment
