#pragma once

#include <BulletDynamics/ConstraintSolver/btContactSolverInfo.h>

#include <span>
#include <vector>

#include "impulses/contact_solver.h"
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
  explicit ManifoldSolver(bool finds_loads) : finds_loads_(finds_loads) {}

  /// Begins a step of an island. See ContactSolver for this and the next two.
  /// @param bodies  stay the caller's until End().
  void Begin(std::span<const SolverManifold> manifolds, bool may_rest,
             const btContactSolverInfo& info, std::span<const impulses::Body> bodies);
  double Sweep() { return solver_.Sweep(); }
  /// Stores the impulses in the manifolds, for the next step.
  void End();

 private:
  void AddPatch(std::span<const SolverManifold> of_two_bodies);

  bool finds_loads_;
  std::span<const impulses::Body> bodies_;
  std::vector<impulses::Patch> patches_;
  std::vector<impulses::Contact> contacts_;
  std::vector<btManifoldPoint*> points_;        ///< of contacts_
  std::vector<btManifoldPoint*> spare_points_;  ///< those that bear nothing, beside others
  std::vector<impulses::Contact> candidates_;   ///< scratch space of AddPatch()
  std::vector<btManifoldPoint*> candidate_points_;
  impulses::ContactSolver solver_;
};

}  // namespace smile::physics
