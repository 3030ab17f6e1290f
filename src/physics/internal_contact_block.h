#pragma once

#include <BulletDynamics/ConstraintSolver/btContactSolverInfo.h>
#include <BulletDynamics/ConstraintSolver/btSolverBody.h>

#include <array>
#include <span>
#include <vector>

#include "physics/internal_bullet.h"

namespace smile::physics {

/// Velocity of body A relative to B at a point, or an impulse there that acts on A and, in the
/// opposite direction, on B: linear part, then angular. A solver's sweep consists of little else
/// than these operations, and Eigen's vectors of this size are not inlined at -O2.
struct Vector6 {
  using Pair = double __attribute__((vector_size(16)));
  Pair xy{}, zr{}, pq{};

  static Vector6 Of(const btVector3& linear, const btVector3& angular) {
    return {Pair{linear.x(), linear.y()}, Pair{linear.z(), angular.x()},
            Pair{angular.y(), angular.z()}};
  }
  btVector3 linear() const { return {xy[0], xy[1], zr[0]}; }
  btVector3 angular() const { return {zr[1], pq[0], pq[1]}; }
  double Dot(const Vector6& other) const {
    const Pair sum = xy * other.xy + zr * other.zr + pq * other.pq;
    return sum[0] + sum[1];
  }
  void Add(double factor, const Vector6& other) {
    xy += factor * other.xy;
    zr += factor * other.zr;
    pq += factor * other.pq;
  }
};

/// Contact manifold with the indices of its bodies among the solver's.
struct Contacts {
  btPersistentManifold* manifold;
  int a, b;
};

/// Iterative solver for the contacts between free bodies, in place of Bullet's
/// (WorldConfig::has_firm_contacts).
///
/// The contact points of two bodies form a patch. A sweep through the points of a patch needs only
/// the relative velocity of the bodies, 6 numbers, where single rows need both bodies' 12. A point
/// has one normal impulse, and one friction impulse in the plane, at most friction times normal in
/// whatever direction; Bullet bounds two directions one by one, or only that of the present
/// sliding.
class ContactBlock {
 public:
  /// Begins a step of an island with the impulses of the last step.
  ///
  /// If these hold every body of the island at rest, as they are, nothing is left to do: the bodies
  /// stand still, and there are no points to sweep.
  /// @param may_rest  false if anything but contacts acts on the island.
  void Begin(std::span<const Contacts> contacts, bool may_rest, const btContactSolverInfo& info,
             btAlignedObjectArray<btSolverBody>* bodies);
  /// Sweeps once through all patches, in their order.
  /// @returns the greatest change of a normal impulse [N s], 0 once nothing changes.
  double Sweep();
  /// Stores the impulses in the manifolds, for the next step.
  void NoteImpulses() const;

 private:
  /// What one body contributes to a patch.
  struct Side {
    int body;
    double inverse_mass;
    btMatrix3x3 inverse_inertia;  ///< in the world
    btVector3 arm;                ///< from its center of mass to the patch's center
  };
  struct Patch {
    std::array<Side, 2> sides;
    int first, count;  ///< of its points
    double friction;   ///< coefficient
  };
  /// Friction against sliding or rolling: two unit impulses, and the velocity along them.
  struct Friction {
    std::array<Vector6, 2> axes;
    std::array<Vector6, 2> responses;  ///< relative velocity that each causes
    std::array<double, 3> inverse;     ///< of the matrix of responses along the axes: xx, xy, yy
    std::array<double, 2> wanted;      ///< change of velocity
    std::array<double, 2> impulse;     ///< so far
  };
  struct Point {
    Vector6 normal;    ///< unit impulse along the normal
    Vector6 response;  ///< relative velocity that it causes
    double inverse;    ///< of the response along the normal
    double wanted;     ///< change of velocity [m/s]
    double impulse;    ///< so far [N s]
    Friction sliding;
    int rolling;  ///< index among rolling_; -1: rolls freely
    btManifoldPoint* source;
  };
  struct Rolling {
    double lever;  ///< torque per normal force [m]
    Friction friction;
  };
  /// Relative velocity at a patch's center that each unit impulse there causes.
  using Responses = std::array<Vector6, 6>;

  bool StayAtRest(std::span<const Contacts> contacts);
  void AddPatch(const Contacts& contacts);
  void AddPoint(const Patch& patch, const Responses& responses, const btVector3& center,
                btManifoldPoint* source);
  Side SideOf(int body, const btVector3& center) const;
  btVector3 VelocityAt(const Patch& patch, const btVector3& from_center, bool with_forces) const;
  static Responses ResponsesOf(const Patch& patch);
  static Vector6 ResponseTo(const Vector6& impulse, const Responses& responses);
  static Friction FrictionAlong(const Vector6& axis_1, const Vector6& axis_2,
                                const Responses& responses);
  static void Sweep(Friction* friction, double limit, Vector6* velocity, Vector6* impulse);
  double Sweep(Point* point, double coefficient, Vector6* velocity, Vector6* impulse);
  void Apply(const Patch& patch, const Vector6& impulse);

  btContactSolverInfo info_;
  btAlignedObjectArray<btSolverBody>* bodies_ = nullptr;
  std::vector<Patch> patches_;
  std::vector<Point> points_;
  std::vector<Rolling> rolling_;
  std::vector<bool> is_held_;  ///< by body; scratch space of StayAtRest()
};

}  // namespace smile::physics
