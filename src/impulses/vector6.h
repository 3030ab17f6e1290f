#pragma once

#include "math/rigid_transform.h"

namespace smile::impulses {

/// Velocity of body A relative to B at a point, or an impulse there that acts on A and, in the
/// opposite direction, on B: linear part, then angular. A solver's sweep consists of little else
/// than these operations, and Eigen's vectors of this size are not inlined at -O2.
struct Vector6 {
  using Pair = double __attribute__((vector_size(16)));
  Pair xy{}, zr{}, pq{};

  static Vector6 Of(const Vector3& linear, const Vector3& angular) {
    return {Pair{linear.x(), linear.y()}, Pair{linear.z(), angular.x()},
            Pair{angular.y(), angular.z()}};
  }
  Vector3 linear() const { return {xy[0], xy[1], zr[0]}; }
  Vector3 angular() const { return {zr[1], pq[0], pq[1]}; }
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

}  // namespace smile::impulses
