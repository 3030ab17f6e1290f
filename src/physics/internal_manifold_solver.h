#pragma once

#include <BulletDynamics/ConstraintSolver/btContactSolverInfo.h>
#include <BulletDynamics/ConstraintSolver/btSolverBody.h>

#include <span>
#include <vector>

#include "contacts/contact_solver.h"
#include "physics/internal_bullet.h"

namespace smile::physics {

/// Contact manifold with the indices of its bodies among the solver's.
struct SolverManifold {
  btPersistentManifold* manifold;
  int a, b;
};

/// Solves Bullet's contacts between free bodies by ContactSolver (WorldConfig::has_firm_contacts).
class ManifoldSolver {
 public:
  /// Begins a step of an island. See ContactSolver for this and the next two.
  /// @param bodies  the solver's, whose velocities change.
  void Begin(std::span<const SolverManifold> manifolds, bool may_rest,
             const btContactSolverInfo& info, std::span<btSolverBody> bodies);
  double Sweep() { return solver_.Sweep(); }
  /// Stores the impulses in the manifolds, for the next step.
  void End();

 private:
  void AddPatch(std::span<const SolverManifold> of_two_bodies);

  std::vector<contacts::Body> bodies_;
  std::vector<contacts::Patch> patches_;
  std::vector<contacts::Contact> contacts_;
  std::vector<btManifoldPoint*> points_;        ///< of contacts_
  std::vector<btManifoldPoint*> spare_points_;  ///< those that bear nothing, beside others
  std::vector<contacts::Contact> candidates_;   ///< scratch space of AddPatch()
  std::vector<btManifoldPoint*> candidate_points_;
  contacts::ContactSolver solver_;
};

}  // namespace smile::physics
