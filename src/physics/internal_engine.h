#pragma once

#include <BulletDynamics/Featherstone/btMultiBodyFixedConstraint.h>

#include <map>
#include <memory>

#include "physics/internal_compound_pairs.h"
#include "physics/internal_exact_world.h"
#include "physics/internal_joint_constraint.h"
#include "physics/internal_joint_solver.h"
#include "physics/internal_overlap_probe.h"
#include "physics/internal_stateless_broadphase.h"
#include "physics/world.h"

namespace smile::physics {

/// The Bullet objects behind a World, set to its configuration.
struct World::Engine {
  explicit Engine(const WorldConfig& config);

  btDefaultCollisionConfiguration collision_configuration;
  CompoundPairAlgorithm::CreateFunc compound_pairs;
  btCollisionDispatcher dispatcher;
  StatelessBroadphase broadphase;
  JointSolver solver;
  ExactWorld world;
  std::map<JointId, std::unique_ptr<btMultiBodyFixedConstraint>> welds;
  std::map<JointId, std::unique_ptr<JointConstraint>> joints;  ///< between bodies
  OverlapProbe overlap_probe;
};

}  // namespace smile::physics
