#include "scene/hull.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

namespace smile::scene {
namespace {

/// Throws std::invalid_argument unless all corners are finite and all faces refer to existing
/// corners.
void Check(const Polyhedron& polyhedron) {
  const std::size_t num_corners = polyhedron.corners.size();
  for (const Vector3& corner : polyhedron.corners) {
    if (!corner.allFinite()) throw std::invalid_argument("hull: a corner is not finite");
  }
  for (const Polyhedron::Face& face : polyhedron.faces) {
    if (face.size() < 3) {
      throw std::invalid_argument("hull: a face has " + std::to_string(face.size()) +
                                  " corners, expected at least 3");
    }
    for (const std::uint32_t corner : face) {
      if (corner >= num_corners) {
        throw std::invalid_argument("hull: a face has corner " + std::to_string(corner) +
                                    ", expected one below " + std::to_string(num_corners));
      }
    }
  }
}

/// Lexicographic comparison of coordinates.
std::weak_ordering Compare(const Vector3& a, const Vector3& b) {
  for (int i = 0; i < 3; ++i) {
    if (const auto order = std::weak_order(a[i], b[i]); order != 0) return order;
  }
  return std::weak_ordering::equivalent;
}

}  // namespace

Vector3 Polyhedron::AreaVectorOf(const Face& face) const {
  // Sum over a fan of triangles from the first corner; each cross product is twice a triangle's
  // area.
  Vector3 twice = Vector3::Zero();
  const Vector3& a = corners[face[0]];
  for (std::size_t k = 2; k < face.size(); ++k) {
    twice += (corners[face[k - 1]] - a).cross(corners[face[k]] - a);
  }
  return twice / 2;
}

Hull::Hull(Polyhedron polyhedron) {
  Check(polyhedron);
  shared_ = std::make_shared<const Polyhedron>(std::move(polyhedron));
}

const Polyhedron& Hull::polyhedron() const {
  static const Polyhedron kNothing;
  return shared_ ? *shared_ : kNothing;
}

bool Hull::operator==(const Hull& other) const {
  return shared_ == other.shared_ || polyhedron() == other.polyhedron();
}

std::weak_ordering Hull::operator<=>(const Hull& other) const {
  // Shared hulls are common, so the pointer comparison saves most of the work.
  if (shared_ == other.shared_) return std::weak_ordering::equivalent;
  const Polyhedron &a = polyhedron(), &b = other.polyhedron();
  const auto corners = std::lexicographical_compare_three_way(
      a.corners.begin(), a.corners.end(), b.corners.begin(), b.corners.end(), Compare);
  return corners != 0 ? corners : a.faces <=> b.faces;
}

Hull Scaled(const Hull& hull, double factor) {
  Polyhedron scaled = hull.polyhedron();
  for (Vector3& corner : scaled.corners) corner *= factor;
  return Hull(std::move(scaled));
}

VolumeMoments MomentsOf(const Hull& hull) {
  const Polyhedron& polyhedron = hull.polyhedron();
  // Integrates about the mean of the corners, O, so that a body far from its frame's origin loses
  // no digits.
  Vector3 p_SO = Vector3::Zero();
  for (const Vector3& corner : polyhedron.corners) p_SO += corner;
  if (!polyhedron.corners.empty()) p_SO /= static_cast<double>(polyhedron.corners.size());

  double volume = 0;
  Vector3 first = Vector3::Zero();   // the integral of p
  Matrix3 second = Matrix3::Zero();  // the integral of p p'
  for (const Polyhedron::Face& face : polyhedron.faces) {
    const Vector3 a = polyhedron.corners[face[0]] - p_SO;
    for (std::size_t k = 2; k < face.size(); ++k) {
      const Vector3 b = polyhedron.corners[face[k - 1]] - p_SO;
      const Vector3 c = polyhedron.corners[face[k]] - p_SO;
      // Signed volume of the tetrahedron (O, a, b, c), and the closed forms of its integrals of p
      // and p p'.
      const double tetrahedron = a.cross(b).dot(c) / 6;
      const Vector3 sum = a + b + c;
      volume += tetrahedron;
      first += tetrahedron / 4 * sum;
      second += tetrahedron / 20 *
                (sum * sum.transpose() + a * a.transpose() + b * b.transpose() + c * c.transpose());
    }
  }
  // Flat, or its faces are oriented inwards.
  if (!(volume > 0)) return {};
  const Vector3 p_OCenter = first / volume;
  // Covariance of the volume about its center; the inertia tensor is trace(covariance) I -
  // covariance.
  const Matrix3 spread = second / volume - p_OCenter * p_OCenter.transpose();
  return {.volume = volume,
          .center = p_SO + p_OCenter,
          .unit_inertia = spread.trace() * Matrix3::Identity() - spread};
}

}  // namespace smile::scene
