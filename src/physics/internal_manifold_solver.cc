#include "physics/internal_manifold_solver.h"

#include <BulletCollision/CollisionDispatch/btManifoldResult.h>

#include <algorithm>
#include <limits>

#include "impulses/reduction.h"

namespace smile::physics {
namespace {

/// Friction of a point without any [N s]; its square is not 0.
constexpr double kBarelyOutside = std::numeric_limits<float>::min();

impulses::Contact ContactOf(const btManifoldPoint& point) {
  return {.p_WB = FromBullet(point.m_positionWorldOnB),
          .p_BA_W = FromBullet(point.m_positionWorldOnA - point.m_positionWorldOnB),
          .normal = FromBullet(point.m_normalWorldOnB),
          .distance = point.getDistance(),
          .restitution = point.m_combinedRestitution,
          .rolling_friction = point.m_combinedRollingFriction,
          .impulse = point.m_appliedImpulse,
          .friction = FromBullet(point.m_appliedImpulseLateral1 * point.m_lateralFrictionDir1 +
                                 point.m_appliedImpulseLateral2 * point.m_lateralFrictionDir2)};
}

/// Stores the impulses of a contact.
/// @param friction  coefficient of the bodies.
void Store(const impulses::Contact& contact, double friction, btManifoldPoint* point) {
  const double impulse = contact.friction.norm();
  point->m_appliedImpulse = contact.impulse;
  point->m_appliedImpulseLateral1 = impulse;
  point->m_appliedImpulseLateral2 = 0;
  point->m_lateralFrictionDir1 =
      impulse > 0 ? ToBullet(contact.friction) / impulse : btVector3(0, 0, 0);
  point->m_lateralFrictionDir2.setZero();
  // Bullet keeps a point as it was first found while its friction lies within the cone. One that
  // does not stick is to be taken as it is found in the next step: outside of a cone of no width.
  point->m_combinedFriction = contact.sticks ? friction : 0;
  if (impulse == 0 && !contact.sticks) point->m_appliedImpulseLateral1 = kBarelyOutside;
}

}  // namespace

void ManifoldSolver::Begin(std::span<const SolverManifold> manifolds, bool may_rest,
                           const btContactSolverInfo& info,
                           std::span<const impulses::Body> bodies) {
  bodies_ = bodies;
  patches_.clear();
  contacts_.clear();
  points_.clear();
  spare_points_.clear();
  // Manifolds of the same two bodies follow each other.
  for (std::size_t i = 0, end = 0; i < manifolds.size(); i = end) {
    while (end < manifolds.size() && manifolds[end].a == manifolds[i].a &&
           manifolds[end].b == manifolds[i].b) {
      ++end;
    }
    AddPatch(manifolds.subspan(i, end - i));
  }
  const impulses::ContactSolver::Config config{.step_seconds = info.m_timeStep,
                                               .warm_start = info.m_warmstartingFactor,
                                               .bounce_speed = info.m_restitutionVelocityThreshold,
                                               .finds_loads = finds_loads_};
  const bool is_at_rest = solver_.Begin(config, bodies_, patches_, contacts_, may_rest);
  // What rests keeps the impulses that hold it.
  if (is_at_rest) {
    patches_.clear();
    spare_points_.clear();
  }
}

void ManifoldSolver::AddPatch(std::span<const SolverManifold> of_two_bodies) {
  const auto& [first_manifold, a, b] = of_two_bodies.front();
  if (!bodies_[a].is_movable() && !bodies_[b].is_movable()) return;
  candidates_.clear();
  candidate_points_.clear();
  for (const SolverManifold& one : of_two_bodies) {
    const btScalar threshold = one.manifold->getContactProcessingThreshold();
    for (int k = 0; k < one.manifold->getNumContacts(); ++k) {
      btManifoldPoint& point = one.manifold->getContactPoint(k);
      if (point.getDistance() > threshold) continue;
      candidates_.push_back(ContactOf(point));
      candidate_points_.push_back(&point);
    }
  }
  if (candidates_.empty()) return;
  const std::vector<int> chosen = impulses::ChooseContacts(candidates_);
  patches_.push_back({a, b, static_cast<int>(contacts_.size()), static_cast<int>(chosen.size()),
                      btManifoldResult::calculateCombinedFriction(first_manifold->getBody0(),
                                                                  first_manifold->getBody1())});
  for (int i = 0; i < static_cast<int>(candidates_.size()); ++i) {
    const bool is_chosen = std::ranges::binary_search(chosen, i);
    (is_chosen ? points_ : spare_points_).push_back(candidate_points_[i]);
    if (is_chosen) contacts_.push_back(candidates_[i]);
  }
}

void ManifoldSolver::End() {
  solver_.End();
  for (const impulses::Patch& patch : patches_) {
    for (int i = patch.first; i < patch.first + patch.count; ++i) {
      Store(contacts_[i], patch.friction, points_[i]);
    }
  }
  for (btManifoldPoint* point : spare_points_) Store({}, 0, point);
}

}  // namespace smile::physics
