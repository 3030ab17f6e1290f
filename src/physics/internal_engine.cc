#include "physics/internal_engine.h"

#include "physics/internal_kept_contacts.h"

namespace smile::physics {

Engine::Engine(const WorldConfig& config)
    : dispatcher(&collision_configuration),
      broadphase(config.has_close_bounds),
      solver(config.has_firm_contacts, config.finds_loads),
      world(&dispatcher, &broadphase, &solver, &collision_configuration),
      dormant_islands(world, dispatcher, broadphase) {
  world.SetDormantIslands(&dormant_islands);
  world.SetTurnsNormals(config.has_firm_contacts);
  world.SetMovesFreeTrees(config.moves_free_trees);
  compound_pairs.RegisterWith(&dispatcher);
  if (config.has_firm_contacts) dispatcher.setNearCallback(KeepOrCollide);
  world.setGravity(btVector3(0, 0, -config.gravity));
  world.getDispatchInfo().m_deterministicOverlappingPairs = true;

  // Values and their measurements: docs/decisions/physics.md.
  btContactSolverInfo& solving = world.getSolverInfo();
  solving.m_numIterations = config.solver_iterations;
  solving.m_erp = 0.2;
  // Each island alone, since one may rest while another moves.
  if (config.has_firm_contacts) solving.m_minimumSolverBatchSize = 1;
  solving.m_erp2 = 0.2;
  solving.m_globalCfm = 0;
  solving.m_splitImpulse = false;
  solving.m_linearSlop = 0;
  solving.m_frictionERP = 0.2;
  solving.m_warmstartingFactor = 0.85;
  // No early end of the iterations at a small residual.
  solving.m_leastSquaresResidualThreshold = 0;
  // Without SOLVER_RANDMIZE_ORDER, which would shuffle rows.
  solving.m_solverMode = SOLVER_SIMD | SOLVER_USE_WARMSTARTING;

  // Bullet has one such value per process. Not written again, since other threads may read it.
  if (gDeactivationTime != config.sleep_after_seconds) {
    gDeactivationTime = config.sleep_after_seconds;
  }
}

}  // namespace smile::physics
