#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "physics/world.h"

namespace smile::physics {

/// Functions that fill and run a world.
class PhysicsWorldBuilder {
 public:
  static BodySpec BlockSpec(const Vector3& size, const RigidTransform& X_WB, double mass) {
    const std::vector<scene::Solid> solids = {{scene::Block{size}, {}, Color{}, ""}};
    return {.solids = solids, .mass = scene::MassPropertiesOf(solids, mass), .X_WB = X_WB};
  }
  static BodySpec CubeSpec(const Vector3& p_WB, double side) {
    return BlockSpec(Vector3::Constant(side), RigidTransform(p_WB), 1.0);
  }

  void AddTable() {
    world_.AddBody(BlockSpec({2, 1.2, 0.4}, RigidTransform(Vector3(0, 0, -0.2)), 0));
  }
  BodyId AddCube(const Vector3& p_WB, double side) { return world_.AddBody(CubeSpec(p_WB, side)); }
  std::vector<BodyId> AddStack(const Vector3& p_WQ, int height) {
    std::vector<BodyId> stack;
    for (int i = 0; i < height; ++i) {
      stack.push_back(AddCube(p_WQ + Vector3(0, 0, 0.05 + 0.1 * i), 0.1));
    }
    return stack;
  }
  /// Drops blocks, cylinders, balls, composites, frusta and rings at random places above the table.
  std::vector<BodyId> AddPile(int count, unsigned seed) {
    std::mt19937 random(seed);
    const auto uniform = [&random](double low, double high) {
      return low + (high - low) * (random() / 4294967296.0);
    };
    std::vector<BodyId> pile;
    for (int i = 0; i < count; ++i) {
      const Quaternion q = Quaternion(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), 0.5);
      const RigidTransform X_WB(q.normalized(),
                                {uniform(-0.2, 0.2), uniform(-0.2, 0.2), 0.2 + 0.12 * i});
      std::vector<scene::Solid> solids;
      switch (i % 6) {
        case 0:
          solids = {{scene::Block{}, {}, {}, ""}};
          break;
        case 1:
          solids = {{scene::Cylinder{}, {}, {}, ""}};
          break;
        case 2:
          solids = {{scene::Sphere{}, {}, {}, ""}};
          break;
        case 3:
          solids = scene::SolidsOf({.shape = scene::Frustum{.radius_top = 0.03, .sides = 5}});
          break;
        case 4:
          solids = scene::SolidsOf({.shape = scene::Ring{.height = 0.04, .sides = 12}});
          break;
        default:
          solids = {{scene::Block{{0.2, 0.05, 0.05}}, {}, {}, ""},
                    {scene::Cylinder{.radius = 0.03, .length = 0.2},
                     RigidTransform(Vector3(0.08, 0.05, 0)),
                     {},
                     ""}};
      }
      pile.push_back(world_.AddBody(
          {.solids = solids, .mass = scene::MassPropertiesOf(solids, 1.0), .X_WB = X_WB}));
    }
    return pile;
  }
  /// Returns two arms of four links each, the last joint prismatic, over the table.
  ArticulationId AddRobot(bool is_kinematic = false) {
    scene::ArticulationSpec spec{.X_WBase = RigidTransform(Vector3(0, -0.5, 0.3)),
                                 .is_kinematic = is_kinematic};
    spec.base_solids = {{scene::Block{{0.2, 0.1, 0.2}}, {}, {}, ""}};
    for (int arm = 0; arm < 2; ++arm) {
      for (int i = 0; i < 4; ++i) {
        scene::LinkSpec link;
        link.joint_name = "arm" + std::to_string(arm) + "_joint" + std::to_string(i);
        link.parent = i == 0 ? -1 : arm * 4 + i - 1;
        link.X_PJ =
            RigidTransform(i == 0 ? Vector3(arm == 0 ? -0.25 : 0.25, 0.1, 0) : Vector3(0, 0.2, 0));
        link.axis = i % 2 == 0 ? Vector3::UnitZ() : Vector3::UnitX();
        if (i == 3) {
          link.joint_type = scene::JointType::kPrismatic;
          link.axis = Vector3::UnitY();
        }
        link.lower = i == 3 ? 0.0 : -1.5;
        link.upper = i == 3 ? 0.1 : 1.5;
        link.max_velocity = 1.5;
        link.max_effort = 50;
        link.mass = 1.5;
        link.p_LLcm = {0.01, 0.1, 0.005};
        link.inertia << 0.006, 0.0003, 0, 0.0003, 0.002, 0, 0, 0, 0.006;
        link.solids = {{scene::Cylinder{.radius = 0.04, .length = 0.18},
                        RigidTransform(Vector3(0, 0.1, 0)),
                        {},
                        ""}};
        spec.links.push_back(link);
        if (i > 0) spec.never_collide.emplace_back(arm * 4 + i - 1, arm * 4 + i);
      }
      spec.never_collide.emplace_back(-1, arm * 4);
    }
    return robot_ = world_.AddArticulation(spec);
  }
  /// Moves all joints of the robot, differently in each call.
  void SwingRobot(double phase) {
    Articulation& robot = world_.articulation(robot_);
    for (int i = 0; i < robot.num_joints(); ++i) {
      robot.SetVelocityTarget(i, std::sin(phase + 1.7 * i));
    }
  }
  void StepSeconds(double seconds) {
    const auto steps = std::lround(seconds / world_.config().step_seconds);
    for (long i = 0; i < steps; ++i) world_.Step();
  }
  std::vector<RigidTransform> PosesOf(const std::vector<BodyId>& bodies) const {
    std::vector<RigidTransform> poses;
    for (BodyId id : bodies) poses.push_back(world_.body(id).pose_in_world());
    return poses;
  }

  World world_;
  ArticulationId robot_;
};

class PhysicsFixture : public ::testing::Test, public PhysicsWorldBuilder {};

}  // namespace smile::physics
