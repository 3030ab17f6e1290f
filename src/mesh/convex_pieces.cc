// Convex decomposition by recursive cuts across the axes, best first, followed by merging. The
// lattice (mesh/internal_lattice_hull.h) makes each geometric decision exact, and cost is counted
// in triangles instead of time, so that the result is the same on each machine. Steps and
// measurements: docs/decisions/meshes.md.

#include "mesh/convex_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "mesh/internal_lattice_hull.h"
#include "mesh/internal_lattice_solid.h"

namespace smile::mesh {
namespace {

// Fractions of a hull's volume that may lie outside the solid (excess volume).
constexpr double kConvexExcess = 0.01;   // of the whole: below this it counts as convex
constexpr double kPieceExcess = 0.04;    // of a piece
constexpr double kLeastExcess = 0.0005;  // of the whole: less is not worth a cut

constexpr double kExactTolerance = 3;  // [steps], effect of rounding to the lattice
// Points of pieces may lie this far outside their hull [steps].
constexpr double kTolerance = 0.001 * static_cast<double>(kLatticeSteps);
constexpr std::int64_t kThinnest = kLatticeSteps / 200;  // least distance of two cuts [steps]
// Places tried per axis, and corners of the rough hulls that compare them.
constexpr int kCutsPerAxis = 8, kRoughCorners = 48;
constexpr std::size_t kMaxTrianglesToCut = 20'000;
constexpr std::size_t kMaxWork = 60'000'000;  // triangles visited: a few seconds

using Points = std::vector<LatticePoint>;

/// A box of the lattice and the part of the solid in it.
struct Cell {
  LatticeBox box;
  LatticeSolid::Numbers touching, above;
  LatticeHull hull;
  double volume = 0;  // of the solid

  double excess() const { return hull.volume - volume; }
};

/// Splits the solid into cells whose hulls are the pieces.
class Decomposition {
 public:
  Decomposition(LatticeSolid solid, const PieceLimits& limits)
      : solid_(std::move(solid)), limits_(limits) {}

  /// Returns the hulls of all pieces.
  /// @param whole  the hull of the solid.
  std::vector<LatticeHull> Run(LatticeHull whole) {
    least_excess_ = kLeastExcess * whole.volume;
    cells_.push_back(
        {solid_.bounds(), solid_.All(), solid_.All(), std::move(whole), solid_.volume()});
    // Best first: each cut goes where it can remove the most excess volume, so that stopping early
    // at a limit leaves the least.
    while (cells_.size() < limits_.max_pieces && solid_.work() < kMaxWork) {
      const auto worst = Worst();
      if (!worst) break;
      Split(*worst);
    }
    Join();
    std::vector<LatticeHull> pieces;
    for (Cell& cell : cells_) pieces.push_back(std::move(cell.hull));
    return pieces;
  }

 private:
  struct Plane {
    int axis;
    std::int64_t place;
  };

  /// Returns true if a cell has much excess volume, relative to itself and to the whole, and is
  /// wide enough to cut.
  bool IsWorthACut(const Cell& cell) const {
    return cell.excess() > std::max(kPieceExcess * cell.hull.volume, least_excess_) &&
           (cell.box.high - cell.box.low).maxCoeff() > 2 * kThinnest;
  }

  /// Returns the cell with the largest excess volume among those worth a cut.
  std::optional<std::size_t> Worst() const {
    std::optional<std::size_t> worst;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      if (!IsWorthACut(cells_[i])) continue;
      if (!worst || cells_[i].excess() > cells_[*worst].excess()) worst = i;
    }
    return worst;
  }

  /// Replaces a cell by its two halves; an empty half is dropped.
  void Split(std::size_t number) {
    const Cell cell = std::move(cells_[number]);
    cells_.erase(cells_.begin() + static_cast<std::ptrdiff_t>(number));
    // Both halves choose from the triangles of the parent, so lists become shorter with each cut.
    const Plane plane = BestPlane(cell);
    for (const bool is_high : {false, true}) {
      LatticeBox box = cell.box;
      (is_high ? box.low : box.high)[plane.axis] = plane.place;
      if (std::optional<Cell> half = MakeCell(box, cell)) cells_.push_back(*std::move(half));
    }
  }

  /// Returns the cell of a box within its parent, or nothing if the solid in it is flat or empty.
  /// The hull of the solid in a box is that of its clipped surface and of the box corners inside
  /// the solid.
  std::optional<Cell> MakeCell(LatticeBox box, const Cell& parent) const {
    LatticeSolid::Numbers touching = solid_.Touching(box, parent.touching);
    LatticeSolid::Numbers above = solid_.Above(box, parent.above);
    Points points;
    solid_.AppendSurface(box, touching, &points);
    for (int corner = 0; corner < 8; ++corner) {
      if (solid_.Fills(box, corner, above)) points.push_back(CornerOf(box, corner));
    }
    std::optional<LatticeHull> hull = HullOf(std::move(points), limits_.max_corners, kTolerance);
    if (!hull) return std::nullopt;
    const double volume = solid_.VolumeWithin(box, above);
    return Cell{box, std::move(touching), std::move(above), *std::move(hull), volume};
  }

  /// Returns places to cut at, ascending: in each of kCutsPerAxis equal parts the place with the
  /// most vertices, since the solid's own faces are there.
  std::vector<std::int64_t> PlacesToCut(const Cell& cell, int axis) const {
    // Cuts through faces of the solid leave boxes that the solid fills exactly; a cut beside them
    // leaves a sliver on one side.
    const std::int64_t low = cell.box.low[axis], high = cell.box.high[axis];
    if (high - low < 2 * kThinnest) return {};
    std::vector<std::int64_t> vertices;
    for (const std::uint32_t i : cell.touching) {
      for (const LatticePoint& corner : solid_.triangles()[i]) {
        if (corner[axis] > low && corner[axis] < high) vertices.push_back(corner[axis]);
      }
    }
    std::sort(vertices.begin(), vertices.end());
    // Without a vertex, the middle of the part.
    std::vector<std::int64_t> places;
    auto vertex = vertices.begin();
    for (int part = 0; part < kCutsPerAxis; ++part) {
      const std::int64_t begin = low + (high - low) * part / kCutsPerAxis;
      const std::int64_t end = low + (high - low) * (part + 1) / kCutsPerAxis;
      std::int64_t best = (begin + end) / 2;
      std::ptrdiff_t most = 0;
      // Vertices are sorted: count each group of equal ones.
      while (vertex != vertices.end() && *vertex < end) {
        const auto next = std::upper_bound(vertex, vertices.end(), *vertex);
        if (next - vertex > most) {
          most = next - vertex;
          best = *vertex;
        }
        vertex = next;
      }
      // Drop places that would leave a thin slab.
      const std::int64_t before = places.empty() ? low : places.back();
      if (best - before >= kThinnest && high - best >= kThinnest) places.push_back(best);
    }
    return places;
  }

  /// Returns the plane whose two sides have the smallest hulls together; among similar ones, the
  /// one that cuts most evenly.
  Plane BestPlane(const Cell& cell) const {
    constexpr double kEvenness = 0.03;
    // If no place qualifies: halve the longest side.
    Plane best{.axis = 0, .place = 0};
    (cell.box.high - cell.box.low).maxCoeff(&best.axis);
    best.place = (cell.box.low[best.axis] + cell.box.high[best.axis]) / 2;
    double least = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
      const std::vector<std::int64_t> places = PlacesToCut(cell, axis);
      const auto volumes = HullVolumes(cell, axis, places);
      for (std::size_t i = 0; i < places.size(); ++i) {
        const auto [low, high] = volumes[i];
        const double cost = low + high + kEvenness * std::abs(low - high);
        if (cost >= least) continue;
        least = cost;
        best = {.axis = axis, .place = places[i]};
      }
    }
    return best;
  }

  /// Returns the approximate hull volumes [steps3] on both sides of each place. Slab by slab, each
  /// is added to the hull of those before, so n places cost 2 n hulls of few points instead of 2 n
  /// hulls of the whole.
  std::vector<std::pair<double, double>> HullVolumes(
      const Cell& cell, int axis, const std::vector<std::int64_t>& places) const {
    // Triangles needed to test the slabs' corners: the same for all corners on one edge of the
    // cell.
    std::array<LatticeSolid::Numbers, 8> near;
    for (int corner = 0; corner < 8 && !places.empty(); ++corner) {
      if (corner >> axis & 1) continue;
      LatticeBox edge = LatticeSolid::SmallBoxAt(corner, cell.box);
      edge.low[axis] = cell.box.low[axis];
      edge.high[axis] = cell.box.high[axis];
      near[corner] = near[corner | 1 << axis] = solid_.Above(edge, cell.above);
    }
    std::vector<Points> slabs;
    for (std::size_t i = 0; i <= places.size(); ++i) {
      LatticeBox box = cell.box;
      if (i > 0) box.low[axis] = places[i - 1];
      if (i < places.size()) box.high[axis] = places[i];
      slabs.push_back(SpanOf(box, cell.touching, near));
    }
    std::vector<std::pair<double, double>> volumes(places.size());
    Points low, high;
    for (std::size_t i = 0; i < places.size(); ++i) {
      // Grow the low side upwards and the high side downwards.
      volumes[i].first = Add(slabs[i], &low);
      const std::size_t j = places.size() - 1 - i;
      volumes[j].second = Add(slabs[j + 1], &high);
    }
    return volumes;
  }

  /// Returns the hull corners of the solid in a box; all points if they are flat.
  Points SpanOf(const LatticeBox& box, const LatticeSolid::Numbers& touching,
                const std::array<LatticeSolid::Numbers, 8>& near) const {
    Points points;
    solid_.AppendSurface(box, solid_.Touching(box, touching), &points);
    for (int corner = 0; corner < 8; ++corner) {
      if (solid_.Fills(box, corner, near[corner])) points.push_back(CornerOf(box, corner));
    }
    if (auto hull = HullOf(points, kRoughCorners, kTolerance)) return std::move(hull->corners);
    return points;
  }

  /// Adds points, reduces the result to its hull corners and returns the hull's volume [steps3].
  static double Add(const Points& more, Points* points) {
    points->insert(points->end(), more.begin(), more.end());
    auto hull = HullOf(*points, kRoughCorners, kTolerance);
    if (!hull) return 0;
    *points = std::move(hull->corners);
    return hull->volume;
  }

  /// Merges neighbors while their common hull has hardly more volume than both. A cut goes all the
  /// way through a cell, so it also splits parts that were convex.
  void Join() {
    while (cells_.size() > 1) {
      std::optional<std::pair<std::size_t, std::size_t>> best;
      // Greatest excess volume of a merge, relative to the common hull.
      double least = 0.01;
      LatticeHull joined;
      for (std::size_t i = 0; i < cells_.size(); ++i) {
        for (std::size_t j = i + 1; j < cells_.size(); ++j) {
          if (!DoTouch(cells_[i].box, cells_[j].box)) continue;
          auto hull = HullOfBoth(cells_[i].hull, cells_[j].hull);
          if (!hull) continue;
          const double filled = cells_[i].hull.volume + cells_[j].hull.volume;
          const double excess = (hull->volume - filled) / hull->volume;
          if (excess >= least) continue;
          least = excess;
          best = {i, j};
          joined = *std::move(hull);
        }
      }
      // Merge the best pair, then search again: its hull has changed.
      if (!best) return;
      Cell& kept = cells_[best->first];
      const Cell& gone = cells_[best->second];
      // `touching` and `above` of the merged cell are not updated: there are no cuts after merging.
      kept.hull = std::move(joined);
      kept.volume += gone.volume;
      kept.box = {kept.box.low.cwiseMin(gone.box.low), kept.box.high.cwiseMax(gone.box.high)};
      cells_.erase(cells_.begin() + static_cast<std::ptrdiff_t>(best->second));
    }
  }

  /// Returns true if two boxes overlap or share a face, an edge or a corner.
  static bool DoTouch(const LatticeBox& a, const LatticeBox& b) {
    return ((a.low - b.high).array() <= 0).all() && ((b.low - a.high).array() <= 0).all();
  }

  std::optional<LatticeHull> HullOfBoth(const LatticeHull& a, const LatticeHull& b) const {
    Points points = a.corners;
    points.insert(points.end(), b.corners.begin(), b.corners.end());
    return HullOf(std::move(points), limits_.max_corners, kTolerance);
  }

  LatticeSolid solid_;
  PieceLimits limits_;
  double least_excess_ = 0;
  std::vector<Cell> cells_;
};

/// Returns a hull with polygonal faces, in the mesh's units. Corners in the middle of merged faces
/// are dropped.
scene::Hull Finish(const LatticeHull& hull, const LatticeSolid& solid) {
  scene::Polyhedron polyhedron{.faces = FacesOf(hull)};
  constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> numbers(hull.corners.size(), kUnused);
  for (scene::Polyhedron::Face& face : polyhedron.faces) {
    for (std::uint32_t& corner : face) {
      std::uint32_t& number = numbers[corner];
      if (number == kUnused) {
        number = static_cast<std::uint32_t>(polyhedron.corners.size());
        polyhedron.corners.push_back(solid.PlaceOf(hull.corners[corner]));
      }
      corner = number;
    }
  }
  return scene::Hull(std::move(polyhedron));
}

Points VerticesOf(const LatticeSolid& solid) {
  Points points;
  for (const LatticeSolid::Triangle& triangle : solid.triangles()) {
    points.insert(points.end(), triangle.begin(), triangle.end());
  }
  return points;
}

}  // namespace

std::vector<scene::Hull> ConvexPieces(const scene::SurfaceMesh& mesh, const PieceLimits& limits) {
  if (mesh.triangles.size() > limits.max_triangles) {
    throw std::invalid_argument("found " + std::to_string(mesh.triangles.size()) +
                                " triangles, expected at most " +
                                std::to_string(limits.max_triangles) + " to make convex pieces of");
  }
  const LatticeSolid solid(mesh);
  // The hull of all vertices decides whether there is anything to cut.
  std::optional<LatticeHull> whole = HullOf(VerticesOf(solid), limits.max_corners, kExactTolerance);
  if (!whole) {
    throw std::invalid_argument("found all triangles in a plane, expected a body with a volume");
  }
  // A surface that is folded flat, or two that cancel, has a hull but hardly a volume of its own.
  constexpr double kNothing = 1e-4;
  const bool has_inside = solid.is_closed() && solid.volume() > kNothing * whole->volume;
  std::vector<LatticeHull> pieces;
  if (!has_inside || whole->volume - solid.volume() <= kConvexExcess * whole->volume) {
    pieces.push_back(*std::move(whole));
  } else {
    // The hull comes from the full mesh; cutting works on a simplified one.
    pieces = Decomposition(solid.Simplified(kMaxTrianglesToCut), limits).Run(*std::move(whole));
  }
  std::vector<scene::Hull> hulls;
  for (const LatticeHull& piece : pieces) hulls.push_back(Finish(piece, solid));
  return hulls;
}

}  // namespace smile::mesh
