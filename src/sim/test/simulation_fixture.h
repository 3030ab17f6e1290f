#pragma once

#include <gtest/gtest.h>

#include <memory>

#include "base/files.h"
#include "robot/urdf_reader.h"
#include "sim/simulation.h"

namespace smile::sim {

/// A table with blocks, and Baxter if wanted.
class SimulationFixture : public ::testing::Test {
 protected:
  static scene::ObjectSpec BlockAt(std::string id, const Vector3& p_WB, double mass = 1,
                                   const Vector3& size = {0.1, 0.1, 0.1}) {
    return {
        .whole = {.id = std::move(id), .X_PE = RigidTransform(p_WB), .shape = scene::Block{size}},
        .mass = mass};
  }
  static const robot::RobotModel& Baxter() {
    static const robot::RobotModel kBaxter = robot::ReadRobot(DataFile("robots/baxter.urdf"));
    return kBaxter;
  }
  static std::unique_ptr<Simulation> MakeSimulation(std::vector<scene::ObjectSpec> objects,
                                                    bool with_robot) {
    scene::SceneSpec scene{.name = "test", .objects = std::move(objects)};
    if (!with_robot) return std::make_unique<Simulation>(std::move(scene));
    return std::make_unique<Simulation>(std::move(scene), RobotPlacement{.model = Baxter()});
  }
  static void TickSeconds(Simulation& simulation, double seconds) {
    for (int i = 0; i < seconds * kTicksPerSecond; ++i) simulation.Tick();
  }
  static Vector3 PositionOf(const Simulation& simulation, std::string_view id) {
    return simulation.physics()
        .body(simulation.tabletop().Find(id)->body)
        .pose_in_world()
        .translation();
  }
};

}  // namespace smile::sim
