#include "picture/surface_probe.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "mesh/primitives.h"

// Measures objects along lines, as a hand would feel them: where a line enters and leaves the
// visible surfaces of an object. Visible meshes are used and not collision shapes, since fingers
// must touch what is seen.

namespace smile::picture {
namespace {

/// Tolerance in barycentric coordinates: a line through an edge between two triangles must not miss
/// both. Double hits are merged later.
constexpr double kOnEdge = 1e-9;

/// Returns the parameter of a line at which it meets a triangle, negative ones included; nullopt if
/// it misses. Source: T. Moeller, B. Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection"
/// (1997).
std::optional<double> Meet(const Vector3& p, const Vector3& direction, const Vector3& a,
                           const Vector3& b, const Vector3& c) {
  const Vector3 ab = b - a, ac = c - a;
  const Vector3 h = direction.cross(ac);
  const double determinant = ab.dot(h);
  // Parallel to the triangle.
  if (std::abs(determinant) < 1e-15) return std::nullopt;
  const Vector3 s = p - a;
  const double u = s.dot(h) / determinant;
  const Vector3 q = s.cross(ab);
  const double v = direction.dot(q) / determinant;
  if (u < -kOnEdge || v < -kOnEdge || u + v > 1 + kOnEdge) return std::nullopt;
  return ac.dot(q) / determinant;
}

/// Returns the parts of a line inside a closed surface, by pairing entries and exits.
std::vector<Span> Within(const mesh::TriangleMesh& mesh, const Vector3& p,
                         const Vector3& direction) {
  constexpr double kSame = 1e-7;
  std::vector<double> in, out;
  const auto corner = [&mesh](std::uint32_t k) {
    return Vector3(mesh.positions[k].cast<double>());
  };
  for (const auto& [i, j, k] : mesh.triangles) {
    const Vector3 a = corner(i), b = corner(j), c = corner(k);
    const auto t = Meet(p, direction, a, b, c);
    if (!t) continue;
    // Against the outward normal, the line enters.
    ((b - a).cross(c - a).dot(direction) < 0 ? in : out).push_back(*t);
  }
  // Sorts, and merges hits on a shared edge.
  const auto tidy = [](std::vector<double>* values) {
    std::sort(values->begin(), values->end());
    const auto end = std::unique(values->begin(), values->end(),
                                 [](double a, double b) { return b - a < kSame; });
    values->erase(end, values->end());
  };
  tidy(&in);
  tidy(&out);
  std::vector<Span> spans;
  auto exit = out.begin();
  for (const double entry : in) {
    // The next exit that is not before the entry. An unpaired one, of a surface with a hole, is
    // skipped.
    exit = std::lower_bound(exit, out.end(), entry);
    if (exit == out.end()) break;
    spans.push_back({entry, *exit});
  }
  return spans;
}

}  // namespace

SurfaceProbe::SurfaceProbe(const model::Model& model) : visual_model_(model.visual_model()) {
  for (const scene::Visual& visual : visual_model_.visuals) {
    const model::FrameIndex frame(static_cast<std::size_t>(visual.frame));
    const bool is_felt = model.object_of(frame).has_value();
    meshes_.push_back(is_felt ? mesh::MeshOf(visual.shape) : mesh::TriangleMesh());
  }
}

std::vector<Span> SurfaceProbe::Along(model::FrameIndex frame, const std::vector<int>& variants,
                                      const Vector3& p_FQ, const Vector3& direction) const {
  std::vector<Span> spans;
  for (std::size_t i = 0; i < meshes_.size(); ++i) {
    const scene::Visual& visual = visual_model_.visuals[i];
    if (visual.frame != static_cast<int>(frame)) continue;
    if (visual.choice >= 0 && variants[static_cast<std::size_t>(visual.choice)] != visual.variant) {
      continue;
    }
    const RigidTransform X_VF = visual.X_FV.inverse();
    const auto more = Within(meshes_[i], X_VF * p_FQ, X_VF.rotation() * direction);
    spans.insert(spans.end(), more.begin(), more.end());
  }
  std::sort(spans.begin(), spans.end(),
            [](const Span& a, const Span& b) { return a.from < b.from; });
  // Pieces that touch are one body for the hand.
  constexpr double kTouching = 1e-4;
  std::vector<Span> merged;
  for (const Span& span : spans) {
    if (merged.empty() || span.from > merged.back().to + kTouching) {
      merged.push_back(span);
    } else {
      merged.back().to = std::max(merged.back().to, span.to);
    }
  }
  return merged;
}

Span SurfaceProbe::Around(model::FrameIndex frame, const std::vector<int>& variants,
                          const Vector3& p_FQ, const Vector3& direction) const {
  constexpr double kOnSurface = 1e-3;
  for (const Span& span : Along(frame, variants, p_FQ, direction)) {
    // A point on the surface counts as inside, in spite of rounding.
    if (span.from <= kOnSurface && span.to >= -kOnSurface) {
      return {std::min(span.from, 0.0), std::max(span.to, 0.0)};
    }
  }
  return {};
}

Vector3 SurfaceProbe::PointWithin(model::FrameIndex frame, const std::vector<int>& variants,
                                  const Vector3& p_FQ) const {
  // Depth of the point below the surface: about the radius of a fingertip [m].
  constexpr double kBelow = 0.012;
  const Span up = Around(frame, variants, p_FQ, Vector3::UnitZ());
  if (up.to > up.from) return p_FQ;
  double nearest = std::numeric_limits<double>::infinity();
  Vector3 found = p_FQ;
  // Searches along 13 lines in both directions: axes, diagonals of faces and of space, encoded as
  // ternary numbers (half of the 26 neighbors). Horizontal lines come first: in a box, the wall is
  // chosen and not the bottom.
  constexpr int kFirst = 14, kFirstSteep = 18, kEnd = 27;
  for (int k = kFirst; k < kEnd; ++k) {
    if (k == kFirstSteep && std::isfinite(nearest)) break;
    const Vector3 direction =
        Eigen::Vector3i(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1).cast<double>().normalized();
    for (const Span& span : Along(frame, variants, p_FQ, direction)) {
      const bool is_ahead = span.from > 0;
      const double distance = is_ahead ? span.from : -span.to;
      if (distance >= nearest) continue;
      nearest = distance;
      // A point inside, not on the surface, so that later lines through it have a span.
      const double deep = std::min(kBelow, (span.to - span.from) / 2);
      found = p_FQ + (is_ahead ? span.from + deep : span.to - deep) * direction;
    }
  }
  return found;
}

}  // namespace smile::picture
