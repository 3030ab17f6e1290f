#pragma once

#include "physics/definitions.h"
#include "physics/internal_compound_pairs.h"
#include "physics/internal_constraint_solver.h"
#include "physics/internal_dormant_islands.h"
#include "physics/internal_exact_world.h"
#include "physics/internal_overlap_probe.h"
#include "physics/internal_stateless_broadphase.h"

namespace smile::physics {

/// Bullet's objects behind a World, configured for it.
struct Engine {
  explicit Engine(const WorldConfig& config);

  btDefaultCollisionConfiguration collision_configuration;
  CompoundPairAlgorithm::CreateFunc compound_pairs;
  Dispatcher dispatcher;
  StatelessBroadphase broadphase;
  ConstraintSolver solver;
  ExactWorld world;
  DormantIslands dormant_islands;
  OverlapProbe overlap_probe;
};

}  // namespace smile::physics
