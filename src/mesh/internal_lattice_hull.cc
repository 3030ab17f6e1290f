// Quickhull and merging of its triangles, on integers. A height above a face is a dot product of a
// normal (41 bits) and a difference of points (20 bits), summed over three axes: below 2^63, hence
// exact. Decisions that are exact cannot contradict each other, so none of the usual repairs of
// floating-point hulls is needed. Ties are broken by the order of points, which are sorted first.

#include "mesh/internal_lattice_hull.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace smile::mesh {
namespace {

/// Sorts points by x, y and z, and leaves out equal ones.
void SortUnique(std::vector<LatticePoint>* points) {
  // As one number per point, which compares like its coordinates, and much faster.
  constexpr int kBits = 21;
  static_assert(kLatticeSteps < std::int64_t{1} << kBits);
  std::vector<std::uint64_t> keys;
  keys.reserve(points->size());
  for (const LatticePoint& point : *points) {
    const Eigen::Matrix<std::uint64_t, 3, 1> p = point.cast<std::uint64_t>();
    keys.push_back(p.x() << 2 * kBits | p.y() << kBits | p.z());
  }
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  points->clear();
  constexpr std::uint64_t kCoordinate = (std::uint64_t{1} << kBits) - 1;
  for (const std::uint64_t key : keys) {
    const Eigen::Matrix<std::uint64_t, 3, 1> p(key >> 2 * kBits, key >> kBits & kCoordinate,
                                               key & kCoordinate);
    points->push_back(p.cast<std::int64_t>());
  }
}

double LengthOf(const LatticePoint& v) { return v.cast<double>().norm(); }

/// Quickhull on lattice points. Faces that a new point can see are replaced by a cone from their
/// horizon to the point. Points not yet enclosed are stored with the face they are farthest outside
/// of.
class Quickhull {
 public:
  Quickhull(std::vector<LatticePoint> points, double tolerance)
      : points_(std::move(points)), tolerance_(tolerance) {
    // Sorted and unique: the result depends on the set of points only.
    SortUnique(&points_);
  }

  std::optional<LatticeHull> Run(int max_corners) {
    if (!Begin()) return std::nullopt;
    for (int num_corners = 4; num_corners < max_corners; ++num_corners) {
      // The farthest point of all faces, not of one after the other: a hull that stops at
      // `max_corners` is then as close to the true one as possible.
      std::optional<Farthest> farthest = FarthestOutside();
      if (!farthest) {
        // Stored points were assigned when their face was new; a later face may be the one they are
        // far outside of.
        Reassign();
        farthest = FarthestOutside();
      }
      if (!farthest) break;
      Extend(*farthest);
    }
    return Result();
  }

 private:
  struct Face {
    std::array<int, 3> corners;
    std::array<int, 3> neighbours;  // across the edge from corner i to the next
    LatticePoint normal;
    double length;
    std::vector<int> outside;  // points
    // The first of the farthest of them: its distance [steps], 0 if there is none, and its number.
    double most = 0;
    int farthest = -1;
    bool is_alive = true;
  };
  struct Farthest {
    int face, point;
  };
  struct Edge {
    int from, to, beyond;  // the hidden face across the edge
  };

  /// Returns the height of a point above a face, times the length of its normal; exact.
  std::int64_t Height(const Face& face, int point) const {
    return face.normal.dot(points_[point] - points_[face.corners[0]]);
  }

  int AddFace(int a, int b, int c) {
    const LatticePoint normal = NormalOf(points_[a], points_[b], points_[c]);
    faces_.push_back({{a, b, c}, {-1, -1, -1}, normal, LengthOf(normal)});
    return static_cast<int>(faces_.size()) - 1;
  }

  /// Returns the first point with the greatest measure.
  template <class Measure>
  int ArgMax(Measure measure) const {
    int best = 0;
    auto greatest = measure(points_.front());
    for (int i = 1; i < static_cast<int>(points_.size()); ++i) {
      const auto measured = measure(points_[i]);
      if (measured <= greatest) continue;
      greatest = measured;
      best = i;
    }
    return best;
  }

  /// Builds the first tetrahedron from the farthest points; returns false if all points lie in a
  /// plane, within the tolerance.
  bool Begin() {
    if (points_.size() < 4) return false;
    // The first point in sorted order is always a corner of the hull. From it: the farthest point,
    // then the one that spans the largest triangle, then the highest above it.
    const LatticePoint a = points_.front();
    const int ib = ArgMax([&](const LatticePoint& p) { return (p - a).squaredNorm(); });
    const LatticePoint b = points_[ib];
    const int ic = ArgMax([&](const LatticePoint& p) { return LengthOf(NormalOf(a, b, p)); });
    const LatticePoint c = points_[ic];
    const LatticePoint normal = NormalOf(a, b, c);
    const auto height = [&](const LatticePoint& p) { return std::abs(normal.dot(p - a)); };
    const int id = ArgMax(height);
    if (static_cast<double>(height(points_[id])) <= tolerance_ * LengthOf(normal)) return false;
    if (height(points_[id]) == 0) return false;
    // Order the base so that its normal points away from the fourth point.
    const bool is_above = normal.dot(points_[id] - a) > 0;
    const int p = 0, q = is_above ? ic : ib, r = is_above ? ib : ic, s = id;
    AddFace(p, q, r);
    AddFace(p, s, q);
    AddFace(q, s, r);
    AddFace(r, s, p);
    // Neighbors across the edges of each face, in the order of its corners.
    faces_[0].neighbours = {1, 2, 3};
    faces_[1].neighbours = {3, 2, 0};
    faces_[2].neighbours = {1, 3, 0};
    faces_[3].neighbours = {2, 1, 0};
    std::vector<int> all;
    for (int i = 0; i < static_cast<int>(points_.size()); ++i) all.push_back(i);
    Assign(all, 0);
    return true;
  }

  /// Assigns each point to the face it is farthest outside of, among those from `first` on. Points
  /// outside none of them are inside the hull and are dropped for good: a hull only grows.
  void Assign(const std::vector<int>& points, std::size_t first) {
    for (const int point : points) {
      double most = 0;
      Face* best = nullptr;
      for (std::size_t i = first; i < faces_.size(); ++i) {
        Face& face = faces_[i];
        if (!face.is_alive) continue;
        // Heights are exact; the distance is only used to compare points, and rounding cannot make
        // an outside point an inside one.
        const std::int64_t height = Height(face, point);
        if (height <= 0) continue;
        const double distance = static_cast<double>(height) / face.length;
        if (distance > most) {
          most = distance;
          best = &face;
        }
      }
      if (best == nullptr) continue;
      best->outside.push_back(point);
      if (most <= best->most) continue;
      best->most = most;
      best->farthest = point;
    }
  }

  /// Assigns all stored points again, to all faces.
  void Reassign() {
    std::vector<int> left;
    for (Face& face : faces_) {
      left.insert(left.end(), face.outside.begin(), face.outside.end());
      face.outside.clear();
      face.most = 0;
    }
    Assign(left, 0);
  }

  /// Returns the point farthest outside of its face, if it is farther than the tolerance.
  std::optional<Farthest> FarthestOutside() const {
    double most = tolerance_;
    std::optional<Farthest> farthest;
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      if (faces_[i].most <= most) continue;
      most = faces_[i].most;
      farthest = {static_cast<int>(i), faces_[i].farthest};
    }
    return farthest;
  }

  /// Removes the faces that see a point and closes the hole by a cone to the point.
  void Extend(const Farthest& farthest) {
    std::vector<int> visible{farthest.face};
    faces_[farthest.face].is_alive = false;
    std::vector<Edge> horizon;
    // Visible faces are connected: search from the first across shared edges.
    for (std::size_t k = 0; k < visible.size(); ++k) {
      for (int side = 0; side < 3; ++side) {
        const Face& face = faces_[visible[k]];
        const int neighbour = face.neighbours[side];
        if (!faces_[neighbour].is_alive) continue;  // seen already
        if (Height(faces_[neighbour], farthest.point) > 0) {
          faces_[neighbour].is_alive = false;
          visible.push_back(neighbour);
        }
      }
    }
    // The horizon is made of the edges between visible and hidden faces, in the direction of the
    // visible ones, so that new faces run counter-clockwise, too.
    for (const int gone : visible) {
      for (int side = 0; side < 3; ++side) {
        const int neighbour = faces_[gone].neighbours[side];
        if (!faces_[neighbour].is_alive) continue;
        horizon.push_back(
            {faces_[gone].corners[side], faces_[gone].corners[(side + 1) % 3], neighbour});
      }
    }
    // One new face per horizon edge, linked with the hidden face across it.
    const std::size_t first = faces_.size();
    std::map<int, int> starting_at, ending_at;  // the new face at a corner of the horizon
    // Each corner of the horizon belongs to two of its edges; the maps find the neighbor of a new
    // face on either side.
    for (const Edge& edge : horizon) {
      const int face = AddFace(edge.from, edge.to, farthest.point);
      faces_[face].neighbours[0] = edge.beyond;
      Face& beyond = faces_[edge.beyond];
      for (int side = 0; side < 3; ++side) {
        if (beyond.corners[side] == edge.to && beyond.corners[(side + 1) % 3] == edge.from) {
          beyond.neighbours[side] = face;
        }
      }
      starting_at[edge.from] = ending_at[edge.to] = face;
    }
    for (const Edge& edge : horizon) {
      const int face = starting_at[edge.from];
      // Edge 1 goes from `to` to the apex, edge 2 from the apex to `from`.
      faces_[face].neighbours[1] = starting_at[edge.to];
      faces_[face].neighbours[2] = ending_at[edge.from];
    }
    // Only the new faces can have the points of the removed ones outside.
    std::vector<int> orphans;
    for (const int gone : visible) {
      for (const int point : faces_[gone].outside) {
        if (point != farthest.point) orphans.push_back(point);
      }
      faces_[gone].outside = {};
      faces_[gone].most = 0;
    }
    Assign(orphans, first);
  }

  LatticeHull Result() const {
    LatticeHull hull;
    std::map<int, int> numbers;
    for (const Face& face : faces_) {
      if (!face.is_alive) continue;
      Eigen::Vector3i triangle;
      for (int i = 0; i < 3; ++i) {
        // Numbered in order of first use by living faces: inner points get no number.
        const auto [entry, is_new] =
            numbers.try_emplace(face.corners[i], static_cast<int>(hull.corners.size()));
        if (is_new) hull.corners.push_back(points_[face.corners[i]]);
        triangle[i] = entry->second;
      }
      hull.triangles.push_back(triangle);
      // Signed tetrahedra from one corner of the hull.
      hull.volume +=
          static_cast<double>(face.normal.dot(points_[face.corners[0]] - points_.front())) / 6;
    }
    return hull;
  }

  std::vector<LatticePoint> points_;
  double tolerance_;
  std::vector<Face> faces_;
};

/// Merges triangles of a hull into flat faces: each grows from its largest triangle, whose plane is
/// least affected by rounding.
class FaceJoiner {
 public:
  explicit FaceJoiner(const LatticeHull& hull) : hull_(hull), face_of_(hull.triangles.size(), -1) {
    for (int t = 0; t < static_cast<int>(hull.triangles.size()); ++t) {
      const Eigen::Vector3i& corners = hull.triangles[t];
      // Each edge occurs once in each direction, so a directed edge names the triangle on its left.
      for (int i = 0; i < 3; ++i) across_[{corners[i], corners[(i + 1) % 3]}] = t;
    }
  }

  std::vector<std::vector<std::uint32_t>> Run() {
    std::vector<std::pair<double, int>> by_area;
    for (int t = 0; t < static_cast<int>(face_of_.size()); ++t) {
      by_area.emplace_back(-LengthOf(Normal(t)), t);
    }
    std::sort(by_area.begin(), by_area.end());  // the largest have the best planes
    std::vector<std::vector<std::uint32_t>> faces;
    for (const auto& [area, seed] : by_area) {
      if (face_of_[seed] >= 0) continue;
      const std::vector<int> members = Grow(seed);
      std::vector<std::uint32_t> outline = OutlineOf(members);
      if (!outline.empty()) {
        faces.push_back(std::move(outline));
        continue;
      }
      // Not a simple polygon: keep the triangles.
      for (const int member : members) faces.push_back(Corners(member));
    }
    return faces;
  }

 private:
  LatticePoint Normal(int t) const {
    const Eigen::Vector3i& c = hull_.triangles[t];
    return NormalOf(hull_.corners[c[0]], hull_.corners[c[1]], hull_.corners[c[2]]);
  }

  std::vector<std::uint32_t> Corners(int t) const {
    const Eigen::Vector3i& c = hull_.triangles[t];
    return {static_cast<std::uint32_t>(c[0]), static_cast<std::uint32_t>(c[1]),
            static_cast<std::uint32_t>(c[2])};
  }

  /// Returns the triangles connected with a seed whose corners are all within a few steps of its
  /// plane.
  std::vector<int> Grow(int seed) {
    constexpr double kFlatSteps = 3;
    const LatticePoint normal = Normal(seed);
    const double allowed = kFlatSteps * LengthOf(normal);
    const LatticePoint& origin = hull_.corners[hull_.triangles[seed][0]];
    std::vector<int> members{seed};
    face_of_[seed] = seed;
    for (std::size_t k = 0; k < members.size(); ++k) {
      const Eigen::Vector3i corners = hull_.triangles[members[k]];
      for (int i = 0; i < 3; ++i) {
        const int next = across_.at({corners[(i + 1) % 3], corners[i]});
        const Eigen::Vector3i& others = hull_.triangles[next];
        // All corners must be near the plane of the seed, so that errors do not accumulate from
        // neighbor to neighbor.
        const auto is_flat = [&](int corner) {
          return std::abs(static_cast<double>(normal.dot(hull_.corners[corner] - origin))) <=
                 allowed;
        };
        if (face_of_[next] >= 0 || Normal(next).cast<double>().dot(normal.cast<double>()) <= 0 ||
            !is_flat(others[0]) || !is_flat(others[1]) || !is_flat(others[2])) {
          continue;
        }
        face_of_[next] = seed;
        members.push_back(next);
      }
    }
    return members;
  }

  /// Returns the outline of some triangles, counter-clockwise; empty if it has more than one loop.
  std::vector<std::uint32_t> OutlineOf(const std::vector<int>& members) const {
    std::map<int, int> next;
    for (const int t : members) {
      const Eigen::Vector3i& corners = hull_.triangles[t];
      for (int i = 0; i < 3; ++i) {
        const int from = corners[i], to = corners[(i + 1) % 3];
        if (face_of_[across_.at({to, from})] == face_of_[t]) continue;
        // Two edges from one corner: the face touches itself there.
        if (!next.emplace(from, to).second) return {};
      }
    }
    std::vector<std::uint32_t> outline;
    int corner = next.begin()->first;
    do {
      // Follows the boundary from corner to corner; a second loop leaves edges unused, which the
      // count shows.
      outline.push_back(static_cast<std::uint32_t>(corner));
      corner = next.at(corner);
    } while (corner != next.begin()->first && outline.size() <= next.size());
    if (outline.size() != next.size()) outline.clear();
    return outline;
  }

  const LatticeHull& hull_;
  std::vector<int> face_of_;                   // the seed of each triangle's face
  std::map<std::pair<int, int>, int> across_;  // the triangle left of an edge
};

}  // namespace

LatticePoint NormalOf(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c) {
  return (b - a).cross(c - a);
}

std::optional<LatticeHull> HullOf(std::vector<LatticePoint> points, int max_corners,
                                  double tolerance) {
  return Quickhull(std::move(points), tolerance).Run(max_corners);
}

std::vector<std::vector<std::uint32_t>> FacesOf(const LatticeHull& hull) {
  return FaceJoiner(hull).Run();
}

}  // namespace smile::mesh
