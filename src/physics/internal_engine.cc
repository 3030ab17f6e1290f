#include "physics/internal_engine.h"

namespace smile::physics {

Engine::Engine(const WorldConfig& config)
    : dispatcher(&collision_configuration),
      world(&dispatcher, &broadphase, &solver, &collision_configuration) {
  compound_pairs.RegisterWith(&dispatcher);
  world.setGravity(btVector3(0, 0, -config.gravity));
  world.getDispatchInfo().m_deterministicOverlappingPairs = true;

  btContactSolverInfo& solving = world.getSolverInfo();
  solving.m_numIterations = config.solver_iterations;
  solving.m_erp = 0.2;
  solving.m_erp2 = 0.2;
  solving.m_globalCfm = 0;
  solving.m_splitImpulse = false;
  solving.m_linearSlop = 0;
  solving.m_frictionERP = 0.2;
  solving.m_warmstartingFactor = 0.85;
  solving.m_leastSquaresResidualThreshold = 0;
  solving.m_solverMode = SOLVER_SIMD | SOLVER_USE_WARMSTARTING;

  // Bullet keeps this one for the whole process.
  gDeactivationTime = config.sleep_after_seconds;
}

}  // namespace smile::physics
